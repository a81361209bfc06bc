"""What a free run leaves open, on a planted double well."""

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from pipeline.device_facts.characteristics import believed_wells, stable_rests
from pipeline.loading.free_runs import drawn_runs
from pipeline.scoring.wells import Wells, wells_of
from pipeline.signals.log import Log
from pipeline.stages import scores
from pipeline.stages.validate import trust_notes

N, INTERVAL = 600, 0.01


class Undecided:
    """A model whose ensemble splits after the second pulse: `share` of the draws go right."""

    def __init__(self, share):
        self.share = share

    fine_voltages = False

    def simulate_draws(self, t, v, q0, qdot0, *, count):
        ensemble = np.full((count, len(t)), -0.01)
        ensemble[:, 200:400] = 0.01
        ensemble[: round(self.share * count), 400:] = 0.01
        return ensemble, np.zeros((count, 1))


def planted():
    """Left, right after the first pulse, left after the second; rests of a second between."""
    q, v = np.full(N, -0.01), np.zeros(N)
    q[200:400] = 0.01
    v[150:200] = v[350:400] = 3000.0
    q += 1e-5 * np.sin(np.arange(N))
    qdot = np.gradient(q, INTERVAL)
    return Log(INTERVAL * np.arange(N), q, qdot, np.gradient(qdot, INTERVAL), v[:, None])


@pytest.mark.parametrize(("share", "ambiguous"), [(0.0, False), (0.4, True), (1.0, False)])
def test_an_outcome_hinges_where_the_ensemble_splits(share, ambiguous):
    log = planted()
    noted = trust_notes(log, wells_of([log], joint=True), [log], drawn_runs(log, Undecided(share)), joint=True)[
        "outcomes"
    ]
    assert noted["at_s"] == pytest.approx([3.49, 5.99])
    assert noted["right"][0] > 0.95
    assert noted["right"][1] == pytest.approx(share, abs=0.05)
    assert noted["ambiguous"] == [False, ambiguous]


def test_a_model_without_an_ensemble_or_a_device_without_wells_has_no_outcomes():
    log = planted()
    assert (
        trust_notes(log, wells_of([log], joint=True), [log], drawn_runs(log, object()), joint=True)["outcomes"] is None
    )
    flat = replace(log, q=1e-5 * np.sin(np.arange(N)))
    assert (
        trust_notes(flat, wells_of([flat], joint=True), [flat], drawn_runs(log, Undecided(0.5)), joint=True)["outcomes"]
        is None
    )


def test_only_states_far_from_all_training_samples_count_as_outside():
    log = planted()
    beyond = replace(log, q=np.where(np.arange(N) < 150, 0.05, log.q))
    assert (
        trust_notes(log, wells_of([log], joint=True), [log], drawn_runs(log, object()), joint=True)["outside_training"]
        == 0.0
    )
    assert trust_notes(beyond, wells_of([log], joint=True), [log], drawn_runs(beyond, object()), joint=True)[
        "outside_training"
    ] == pytest.approx(0.25)


class Curved(Undecided):
    """The same with a restoring force of one stable equilibrium, or of two."""

    name = "curved"

    def __init__(self, wells):
        super().__init__(0.5)
        self.wells = wells

    def curves(self, q):
        return {"F": q if self.wells == 1 else q * (q**2 - 0.01**2)}


def test_wells_of_another_device_than_the_joint_are_those_that_its_model_has_too():
    seen = wells_of([planted()], joint=True)
    assert isinstance(seen, Wells)
    for count, joint, two in ((1, False, False), (2, False, True), (1, True, True)):
        rests = stable_rests(Curved(count), [planted().q * 1.1])
        assert rests == count
        wells = believed_wells(seen, "curved", rests, joint=joint)
        assert isinstance(wells, Wells) == two
        assert (
            trust_notes(planted(), wells, [planted()], drawn_runs(planted(), Curved(count)), joint=joint)["outcomes"]
            is not None
        ) == two
    assert stable_rests(object(), [planted().q]) is None
    assert believed_wells(seen, "curved", None, joint=False) is seen


@pytest.mark.parametrize(("rests", "joint", "two"), [(1, False, False), (2, False, True), (1, True, True)])
def test_scores_judge_no_wells_that_the_first_model_with_curves_does_not_have(rests, joint, two):
    notes = {"narx": {"stable_rests": None}, "rbf": {"stable_rests": rests}, "rbf-paper": {"stable_rests": 2}}
    run = SimpleNamespace(record=lambda name: SimpleNamespace(notes=notes[Path(name).stem]))
    found = scores._wells(run, [planted()], SimpleNamespace(joint=joint), ("train", "log"), list(notes))
    assert isinstance(found, Wells) == two
