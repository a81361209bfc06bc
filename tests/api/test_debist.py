"""`import debist`: models from arrays and DataFrames, the same as from a run of the same signals."""

import dataclasses
import json
import pickle
from unittest.mock import Mock

import numpy as np
import pandas as pd
import pytest

import debist
from pipeline.api.in_memory import arrays_of
from pipeline.models.free_runs import free_run
from pipeline.workflow.run import run_prototype
from tests.export.joints import paper, pulses

SECONDS = 12.0
# The planted joint is not of the drawn size, and one test calls its inputs linear.
pytestmark = pytest.mark.filterwarnings("ignore:debist. log 1. (coupling|residual of the fit)")


@pytest.fixture(scope="module")
def log():
    """A planted joint at 1 kHz with noise on q."""
    t, v = pulses(SECONDS)
    run = paper().simulate(t, v, -0.0105, 0.0)
    fine = np.linspace(t[0], t[-1], 10 * (len(t) - 1) + 1)
    rng = np.random.default_rng(3)
    columns = {"t_s": fine, "q_m": np.interp(fine, t, run.q) + 2e-6 * rng.standard_normal(len(fine))}
    columns |= {f"v{k + 1}_V": np.interp(fine, t, v[:, k]) for k in range(2)}
    return pd.DataFrame(columns)


@pytest.fixture(scope="module")
def model(log):
    return debist.identify(log, mass=0.04, model="rbf-paper")


def test_arrays_series_and_a_data_frame_give_the_same_model(log, model):
    columns = log.t_s.to_numpy(), log.q_m, log.v1_V.tolist(), log.v2_V
    other = debist.identify(*columns, mass=0.04, model="rbf-paper")
    np.testing.assert_array_equal(other.core.weights, model.core.weights)
    assert repr(model) == "Model('rbf-paper', 2 inputs, trained on 1 log of 12 s)"
    t, q, *voltages = columns
    np.testing.assert_equal(vars(arrays_of(t, q, np.column_stack(voltages))), vars(arrays_of(*columns)))


@pytest.mark.parametrize("before", [pytest.param("first", marks=pytest.mark.long), "zero"])
def test_a_run_of_the_same_signals_gives_the_same_model(log, before, tmp_path):
    """Also of a log that begins while a voltage is on, where the inputs were zero before it."""
    if before == "zero":
        log = log.iloc[log[log.v1_V > 500.0].index[0] :].reset_index(drop=True)
    model = debist.identify(log, mass=0.04, model="rbf-paper", settings={"plant": {"inputs_before": before}})
    table = log.rename(columns={"t_s": "t", "q_m": "q", "v1_V": "v1", "v2_V": "v2"})
    table.to_csv(tmp_path / "log.csv", index=False, float_format="%.17g")
    names = {"time": "t", "q": "q", "v1": "v1", "v2": "v2"}
    units = {"time": "s", "q": "m", "v1": "V", "v2": "V"}
    lines = [f'{key} = {{ channel = "{name}", unit = "{units[key]}" }}' for key, name in names.items()]
    settings = ['name = "P"', "[logs]", 'train = ["log.csv"]', "[channels]", *lines, "[plant]"]
    settings += [
        'mass = { value = 0.04, unit = "kg" }',
        f'inputs_before = "{before}"',
        "[identify]",
        'models = ["rbf-paper"]',
        "[compare]",
        "models = []",
    ]
    (tmp_path / "P.toml").write_text("\n".join(settings))
    run_prototype(tmp_path / "P.toml", tmp_path / "run", Mock(), with_report=False)
    run = debist.open_run(tmp_path / "run")
    np.testing.assert_array_equal(run.model().core.weights, model.core.weights)
    scores = run.scores().set_index("signal").nrmse
    here = model.score(log).set_index("signal").nrmse
    np.testing.assert_allclose(here.astype(float), scores[here.index].astype(float), rtol=1e-12)
    table = run.log("log")
    moved = table.assign(q_m=1.1 * table.q_m)  # whose derivatives are no longer those of the run
    pd.testing.assert_frame_equal(model.score(moved), model.score(moved[["t_s", "q_m", "v1_V", "v2_V"]]))


def test_what_a_run_would_refuse_is_warned_of(log):
    swapped = log.rename(columns={"v1_V": "v2_V", "v2_V": "v1_V"})
    with pytest.warns(UserWarning, match="v1 is the left membrane") as told:
        model = debist.identify(swapped, mass=0.04, model="rbf-paper")
    assert told[0].filename == __file__
    assert any("left membrane" in text for text in model.notes["warnings"])
    accepted = debist.identify(swapped, mass=0.04, model="rbf-paper", settings={"quality": {"accept": ["sides"]}})
    assert not accepted.notes["contradictions"]


def test_masked_samples_are_gaps_as_in_a_log_and_complex_ones_are_refused(log):
    """The inputs across a gap of q are known, so nothing starts anew behind it; a log of a run may hold such rows."""
    gap = np.abs(np.arange(len(log)) - 1000) < 20
    masked = np.ma.masked_array(log.q_m, mask=gap)
    of_arrays = debist.identify(log.t_s, masked, log.v1_V, log.v2_V, mass=0.04, model="rbf-paper")
    of_table = debist.identify(log.assign(q_m=log.q_m.where(~gap)), mass=0.04, model="rbf-paper")
    assert of_arrays.notes["warnings"] == of_table.notes["warnings"]
    assert "log 1: q: 39 samples not finite" in of_table.notes["warnings"][0]
    assert not any("start anew" in text for text in of_table.notes["warnings"])
    with pytest.raises(debist.DebistError, match="q holds no finite sample at all"):
        debist.identify(log.assign(q_m=np.nan), mass=0.04, model="rbf-paper")
    with pytest.raises(debist.DebistError, match=r"ingest\.sample_rate, but t has the time of each sample"):
        debist.identify(log, mass=0.04, model="rbf-paper", settings={"ingest": {"sample_rate": 100.0}})
    with pytest.raises(debist.DebistError, match="t is not finite at sample 5"):
        debist.identify(log.assign(t_s=log.t_s.where(log.index != 5)), mass=0.04, model="rbf-paper")
    with pytest.raises(debist.DebistError, match="v1 does not consist of numbers"):
        debist.identify(log.t_s, log.q_m, log.v1_V.to_numpy() + 0j, log.v2_V)


def test_scores_of_a_run_that_diverged_are_not_numbers(model, log, monkeypatch):
    def lost(log, core):
        """A free run that diverged at once."""
        gone = {name: np.full(len(log.t), np.nan) for name in ("q", "qdot", "qddot")}
        return dataclasses.replace(free_run(log, core), status="diverged", diverged_at_s=0.0, **gone)

    monkeypatch.setattr("pipeline.api.model.free_run", lost)
    scores = model.score(log)
    assert scores.nrmse.dtype == scores.fit_percent.dtype == np.float64
    assert scores.nrmse.isna().all()


def test_voltages_come_as_columns_or_as_a_table(model, log):
    columns = model.simulate(log.t_s, log[["v1_V", "v2_V"]], -0.0105)
    table = model.simulate(log, q0=-0.0105)
    assert table.equals(columns)
    with pytest.raises(debist.DebistError, match="has no tubes"):
        model.simulate(log, q0=-0.0105, tube=True)


@pytest.mark.parametrize("target", [".", "", "folder"])
def test_a_model_is_saved_to_a_file_and_to_no_folder(model, tmp_path, monkeypatch, target):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder").mkdir()
    with pytest.raises(debist.DebistError, match=r"(\.|folder): cannot be written: it is a folder; name a file"):
        model.save(target)
    assert [place.name for place in tmp_path.iterdir()] == ["folder"]


def test_a_saved_model_is_the_same_one_wherever_it_is_loaded(model, log, tmp_path):
    again = debist.Model.load(model.save(tmp_path / "model.h5"))
    assert (again.name, again.inputs) == (model.name, model.inputs)
    assert again.simulate(log, q0=-0.0105).equals(model.simulate(log, q0=-0.0105))
    assert again.score(log).equals(model.score(log))
    written = [each.export("json", tmp_path / name) for each, name in ((model, "first"), (again, "second"))]
    first, second = (json.loads(paths[0].read_text(encoding="utf-8")) for paths in written)
    assert first == second
    with pytest.raises(debist.DebistError, match="no export 'crate' of a model alone; there are c, fmu, json, matlab"):
        model.export("crate", tmp_path)


@pytest.mark.parametrize(
    ("scale", "start", "match"),
    [(1e-3, -0.0105, "if it is in kV"), (2.0, -0.0105, r"v1 is up to .* extrapolates"), (1.0, 0.05, "q0 is 50.0 mm")],
)
def test_what_the_training_logs_do_not_reach_is_warned_of(model, log, scale, start, match):
    """At the line that called, whatever the method."""
    strange = log.assign(v1_V=scale * log.v1_V, v2_V=min(scale, 1.0) * log.v2_V)
    with pytest.warns(UserWarning, match=match) as warned:
        model.simulate(strange, q0=start)
    assert warned[0].filename == __file__
    if scale != 1.0:
        for call in (model.score, model.predict, lambda t: debist.compare([model], t)):
            with pytest.warns(UserWarning, match=match) as warned:
                call(strange)
            assert warned[0].filename == __file__
    model.simulate(0.01 * np.arange(50), np.zeros((50, 2)), -0.0105)  # no warning


def test_a_model_goes_to_another_process(model, log, tmp_path):
    for each in (model, debist.Model.load(model.save(tmp_path / "model.h5"))):
        again = pickle.loads(pickle.dumps(each))  # noqa: S301  # what was just made
        assert again.simulate(log, q0=-0.0105).equals(model.simulate(log, q0=-0.0105))
        assert again.export("json", tmp_path / str(id(each)))


def test_a_file_that_is_no_saved_model_is_refused(model, tmp_path):
    from pipeline.store.trees import read_tree, write_tree

    tree = read_tree(model.save(tmp_path / "model.h5"))
    for name, changed, message in (
        ("none", {"x": 1.0}, "is no saved model"),
        ("other", {"check": tree["check"]}, "holds no model 'rbf-paper'"),
        ("short", tree | {"check": tree["check"] | {"t": tree["check"]["t"][:5]}}, "cannot be read"),
        ("settings", tree | {"check": tree["check"] | {"settings_json": "{"}}, "settings cannot be read"),
    ):
        write_tree(tmp_path / f"{name}.h5", changed)
        with pytest.raises(debist.DebistError, match=message):
            debist.Model.load(tmp_path / f"{name}.h5")


def test_an_angle_is_in_radians_and_curves_without_a_mass_have_no_unit(log):
    table = log.rename(columns={"q_m": "q_rad"}).assign(q_rad=50.0 * log.q_m)
    found = debist.identify(table, model="rbf-paper")  # the column says that it is one
    assert "qdot_rad_per_s" in found.simulate(0.01 * np.arange(9), np.zeros((9, 2)), 0.5)
    assert list(found.curves([0.0]))[:3] == ["q_rad", "F_rad_per_s2", "d_1_per_s"]
    with pytest.raises(debist.DebistError, match="q of the log is in m, that of the model rbf-paper in rad"):
        found.score(log)
    with pytest.raises(debist.DebistError, match="q_m is a length"):
        debist.identify(log, angle=True)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda c: c | {"v1": c["v1"][:50]}, "v1 has 50 samples, but t has"),
        (lambda c: c | {"q": np.where(c["t"] > 5.0, np.inf, c["q"])}, r"q is not finite at sample 50\d\d"),
        (lambda c: c | {"q": c["q"][:, None]}, r"q has the shape \(\d+, 1\)"),
        (lambda c: c | {"v1": None, "v2": None}, "v1 is missing"),
        (lambda c: c | {"model": "hibrid"}, "hybrid"),
        (lambda c: c | {"t": c["t"][::-1].copy()}, "time|t "),
        (lambda c: c | {"v1": c["v1"] / 1e3, "v2": c["v2"] / 1e3}, "give SI units, or if they are, accept it"),
        (
            lambda c: c | {"settings": {"identify": {"models": ["rbf"]}}},
            "identify.models; the arguments of the function",
        ),
        (
            lambda c: c | {"settings": {"plant": {"mass": {"value": 0.08, "unit": "kg"}}}},
            "settings has plant.mass; the",
        ),
        (
            lambda c: c | {"parameters": "nominal", "settings": {"plant": {"parameters": "table1"}}},
            "settings has plant.parameters; the",
        ),
        (
            lambda c: c | {"inputs": "linear", "settings": {"plant": {"inputs": "squared"}}},
            "settings has plant.inputs; the",
        ),
        (lambda c: c | {"settings": {"compare": {"models": ["sindy"]}}}, "compare.models, but the argument `model`"),
    ],
)
def test_mistakes_are_one_line(log, change, told):
    columns = {"t": log.t_s.to_numpy(), "q": log.q_m.to_numpy(), "v1": log.v1_V.to_numpy(), "v2": log.v2_V.to_numpy()}
    with pytest.raises(debist.DebistError, match=told) as refused:
        debist.identify(**change(columns | {"mass": 0.04, "model": "rbf-paper"}))
    assert "\n" not in str(refused.value)
