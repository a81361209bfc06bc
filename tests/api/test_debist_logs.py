"""`debist.read_log`, `check`, `differentiate`, `compare` and `Model.predict`: the same numbers as in a run."""

from pathlib import Path

import numpy as np
import pandas as pd
import pyarrow as pa
import pytest

import debist
from tests.prototypes import motion, settings, write_csv


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("logs")
    for name, seed in (("log", 1), ("other", 2)):
        write_csv(folder / f"{name}.csv", *motion(15.0, 500.0, seed, noise=3e-6))
    (folder / "P.toml").write_text(settings(), encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def model(folder: Path) -> debist.Model:
    return debist.identify(debist.read_log(folder / "log.csv", folder / "P.toml"), model="rbf-paper")


@pytest.fixture(scope="module")
def log(folder: Path) -> pd.DataFrame:
    return debist.read_log(folder / "other.csv", folder / "P.toml")


def test_a_log_is_read_in_si_units(folder: Path) -> None:
    raw = np.loadtxt(folder / "other.csv", delimiter=",", skiprows=1)
    table = debist.read_log(folder / "other.csv", folder / "P.toml")
    assert list(table) == ["t_s", "q_m", "v1_V", "v2_V"]
    np.testing.assert_allclose(table.to_numpy(), raw * [1.0, 1e-3, 1e3, 1e3], rtol=1e-12)


def test_the_check_is_a_table_with_numbers(folder: Path) -> None:
    rows = debist.check(folder / "P.toml").set_index("what")
    assert rows.loc["sampling rate", "values"] == {"rate_Hz": pytest.approx(500.0)}
    assert rows.loc["direction of v1", "values"]["push_m_per_s2"] > 0.0


def test_derivatives_of_a_sine_are_a_cosine() -> None:
    t = np.arange(2000) / 1000.0
    noise = np.random.default_rng(1).normal(0.0, 1e-5, t.size)
    table = debist.differentiate(t, np.sin(2.0 * np.pi * t) + noise)
    inside = slice(50, -50)
    assert np.max(np.abs(table.qdot - 2.0 * np.pi * np.cos(2.0 * np.pi * t))[inside]) < 0.05
    assert table.attrs["noise_std"] == pytest.approx(1e-5, rel=0.2)
    with pytest.raises(debist.DebistError, match="t is not uniform"):
        debist.differentiate(t**2, t)


def test_models_are_compared_on_one_log(model: debist.Model, log: pd.DataFrame) -> None:
    both = debist.compare([model, model], log)
    assert list(both.columns[:2]) == ["model", "signal"] and len(both) == 6
    for rows in (both[:3], both[3:]):
        pd.testing.assert_frame_equal(rows.drop(columns="model").reset_index(drop=True), model.score(log))
    for wrong in ([], model, ["rbf-paper"]):
        with pytest.raises(debist.DebistError, match="give a list of the models"):
            debist.compare(wrong, log)


def test_times_and_tables_of_other_libraries_are_read(model: debist.Model, log: pd.DataFrame) -> None:
    stamps = np.datetime64("2026-11-27T10:15") + (1e9 * log.t_s.to_numpy()).round().astype("m8[ns]")
    for other in (pa.table(log), log.assign(t_s=stamps)):
        np.testing.assert_allclose(model.predict(other).q_m, model.predict(log).q_m, atol=1e-8)


@pytest.mark.parametrize(
    ("call", "match"),
    [
        (lambda m, t: debist.identify(None, t.q_m, t.v1_V), "t is missing"),
        (lambda m, t: debist.identify(t[:0]), "t is empty"),
        (lambda m, t: debist.identify(t.rename(columns={"v2_V": "v2_kV"})), "v2_kV; call it v2_V"),
        (lambda m, t: m.simulate(t.t_s, t[["v1_V", "v2_V"]].to_numpy().T, 0.01), r"np\.column_stack"),
        (lambda m, t: m.simulate(1e3 * t.t_s, t[["v1_V", "v2_V"]], 0.01), "give t in s"),
        (lambda m, t: m.curves([5.0]), "1000 times too large"),
        (lambda m, t: m.score([t, t]), "2 logs were given"),
        (lambda m, t: m.simulate(t.t_s, t[["v1_V", "v2_V"]].replace(0.0, np.nan), 0.01), "interpolate it there"),
    ],
)
def test_wrong_arguments_are_named(model: debist.Model, log: pd.DataFrame, call, match) -> None:
    with pytest.raises(debist.DebistError, match=match):
        call(model, log)


def test_a_prediction_ahead_is_a_restart_from_the_measurement(model: debist.Model, log: pd.DataFrame) -> None:
    errors = []
    for ahead in (1, 20):
        table = model.predict(log, ahead=ahead)
        assert table.q_m[:ahead].isna().all() and table.q_m[ahead:].notna().any()
        errors.append(float(np.sqrt(np.nanmean((table.q_m - table.q_measured_m) ** 2))))
    assert errors[0] < errors[1] < np.ptp(log.q_m)
    assert errors[0] < 1e-4
    with pytest.raises(debist.DebistError, match="ahead is 0"):
        model.predict(log, ahead=0)
