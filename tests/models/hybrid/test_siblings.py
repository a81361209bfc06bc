"""Siblings of a joint: what their fits show, what they teach, which one is odd, and how a run takes them over."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pipeline.device.parameters import NOMINAL, TABLE1
from pipeline.errors import CorruptArtifactError, InputError
from pipeline.models.hybrid.identify import NOISE_INFLATION, _Search
from pipeline.models.hybrid.model import HybridModel
from pipeline.models.hybrid.parameters import DEVIATIONS, NAMES
from pipeline.models.hybrid.problem import CondensedJoint
from pipeline.models.hybrid.siblings import column, from_tree, information_of, learn, to_tree, usual_prior
from pipeline.models.hybrid.start import prior_root
from pipeline.numerics.arrays import FloatArray
from pipeline.settings.prototype import load_prototype
from pipeline.store.run_folder import RunFolder
from pipeline.store.trees import write_tree
from pipeline.workflow.prior_knowledge import known_inputs, prior_knowledge_of
from pipeline.workflow.run import run_prototype
from tests.prototypes import Silent, motion, settings, write_csv

COUNT, TAU, NOISE = len(NAMES), 20.0, 0.05
JOINT = CondensedJoint(NOMINAL, np.array([-0.02, 0.01, 0.01]), 0, 3000.0, 1.25)
ODD = NAMES.index("left.log C0")


def fitted(truth: FloatArray, seed: int, centres: int = 0) -> HybridModel:
    """The fit of a joint whose logs are linear in θ: where the misfit and the prior balance, and its posterior."""
    rng, joint = np.random.default_rng(seed), replace(JOINT, centres=centres)
    root = prior_root(centres)
    jacobian = rng.standard_normal((4 * len(truth), len(truth))) * np.geomspace(3.0, 0.02, len(truth))
    target = jacobian @ truth + NOISE * rng.standard_normal(len(jacobian)) * np.sqrt(TAU)
    hessian, prior = jacobian.T @ jacobian, root.T @ root
    theta = np.linalg.solve(
        hessian / (NOISE * NOISE_INFLATION) ** 2 + prior, jacobian.T @ target / (NOISE * NOISE_INFLATION) ** 2
    )
    spread = np.linalg.cholesky(np.linalg.inv(hessian / (NOISE**2 * TAU) + prior))
    return HybridModel.of(joint, theta, spread, spread, diagnostics={"integrated_correlation_time": TAU})


def siblings(count: int, odd: float = 0.0) -> dict[str, HybridModel]:
    rng = np.random.default_rng(3)
    alike = np.linalg.cholesky(usual_prior().covariance)  # as both membranes are cut from one film
    truths = 0.5 + 0.2 * rng.standard_normal((count, COUNT)) @ alike.T
    truths[1, ODD] += odd
    return {f"J{i}": fitted(truth, i) for i, truth in enumerate(truths)}


def test_a_fit_is_taken_apart_into_its_logs_and_its_prior() -> None:
    model = fitted(np.full(COUNT, 0.5), 1)
    member, prior = information_of(model), usual_prior()
    both = member.precision + np.linalg.inv(prior.covariance)
    assert np.linalg.inv(both) == pytest.approx(model.spread @ model.spread.T, abs=1e-9)
    best = np.linalg.solve(member.precision + 1e-9 * np.eye(COUNT), member.vector)
    well = np.arange(COUNT) < 20
    error = np.sqrt(np.diag(np.linalg.inv(member.precision + 1e-9 * np.eye(COUNT))))
    assert np.all(np.abs(best - 0.5)[well] < 4.5 * error[well])  # the truth, and not what the prior pulls it to


def test_siblings_teach_what_they_share_and_an_odd_one_is_named() -> None:
    usual, with_odd = learn(siblings(9)), learn(siblings(9, odd=4.0))
    assert not usual.odd and np.median(list(usual.gains.values())) > 5.0
    assert usual.quantities[0].share < 0.6 < usual.quantities[-1].share
    assert usual.population.mean[:10] == pytest.approx(np.full(10, 0.5), abs=0.3)
    (odd,) = with_odd.odd
    assert (odd.name, odd.quantity, odd.unit) == ("J1", "left capacitance", "%")
    truth = 100.0 * np.expm1(4.0 * DEVIATIONS[ODD].prior_std)
    assert odd.size == pytest.approx(truth, abs=4.0 * odd.error)


def test_the_prior_of_a_fit_is_the_population_of_its_siblings() -> None:
    population = learn(siblings(6)).population
    for centres in (0, 6):
        prior = _Search((), population).prior(COUNT + 9 * centres)
        assert np.linalg.norm(prior.residual(np.append(population.mean, np.zeros(9 * centres)))) < 1e-9
        covariance = np.linalg.inv(prior.matrix.T @ prior.matrix)
        assert covariance[:COUNT, :COUNT] == pytest.approx(population.covariance, rel=1e-6, abs=1e-9)


def test_what_is_filed_reads_back_and_what_is_none_is_refused() -> None:
    learnt = learn(siblings(5))
    tree = to_tree(learnt, NOMINAL, {"J0": "abc"})
    parameters, population, names = from_tree(tree)
    assert parameters == NOMINAL and names == ["J0"]
    assert np.array_equal(population.covariance, learnt.population.covariance)
    for change in (
        {"covariance": -learnt.population.covariance},
        {"mean": learnt.population.mean[1:]},
        {"deviations": "log length"},
    ):
        with pytest.raises(CorruptArtifactError, match="siblings"):
            from_tree(tree | change)


def test_a_run_files_its_siblings_and_the_fit_takes_them(tmp_path: Path) -> None:
    write_tree(tmp_path / "siblings.h5", to_tree(learn(siblings(5)), NOMINAL, {}), column)
    write_csv(tmp_path / "log.csv", *motion(10.0, 200.0, 1, noise=3e-6))
    text = settings("")
    (tmp_path / "P.toml").write_text(text + '[plant]\nparameters = "nominal"\nsiblings = "siblings.h5"\n')
    run_prototype(tmp_path / "P.toml", tmp_path / "run", Silent(), only="ingest")
    run, prototype = RunFolder.open(tmp_path / "run"), load_prototype(tmp_path / "P.toml")
    assert known_inputs(prototype) == ("siblings.h5",)
    population = prior_knowledge_of(run, prototype, NOMINAL).siblings
    assert population is not None and np.array_equal(population.mean, learn(siblings(5)).population.mean)
    with pytest.raises(InputError, match="another parameter set"):
        prior_knowledge_of(run, prototype, TABLE1)
    (tmp_path / "siblings.h5").write_bytes(b"x")
    with pytest.raises(InputError, match=r"siblings\.h5: is no whole prior of other joints"):
        run_prototype(tmp_path / "P.toml", tmp_path / "run", Silent(), only="ingest")
    (tmp_path / "P.toml").write_text(text + '[plant]\nsiblings = "siblings.h5"\n')
    with pytest.raises(InputError, match=r"give plant\.parameters too"):
        load_prototype(tmp_path / "P.toml")
