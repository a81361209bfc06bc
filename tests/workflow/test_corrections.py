"""Corrections of a log in the settings act on its readings, and what cannot be meant is refused."""

from pathlib import Path

import numpy as np
import pytest

from pipeline.errors import InputError
from pipeline.settings.prototype import Prototype, parse_prototype
from pipeline.signals.columns import Signal
from pipeline.signals.log import Corrections, RawLog
from pipeline.store.run_folder import RunFolder
from pipeline.workflow.engine import Unheard
from pipeline.workflow.run import run_prototype
from pipeline.workflow.run_contents import corrections
from pipeline.workflow.steps.ingest import corrected_log


def _prototype(log: object, **plant: object) -> Prototype:
    channels = {"time": {"channel": "t", "unit": "s"}, "q": {"channel": "q", "unit": "mm"}}
    channels |= {"v1": {"channel": "v1", "unit": "kV"}}
    return parse_prototype({"name": "P", "logs": {"train": [log]}, "channels": channels, "plant": plant}, "P.toml")


def test_signals_that_share_a_time_base_share_the_corrected_one() -> None:
    t = np.arange(5.0)
    same = Signal(t, t)
    log = RawLog(same, (same, same), same)
    made = corrected_log(log, Corrections((2.0, 3.0), 0.5, 10.0, 0.25, 1.5))
    np.testing.assert_allclose(made.q, (1.5 * t, 10.0 * t + 0.5))
    np.testing.assert_allclose([values for _, values in made.inputs], [2.0 * t, 3.0 * t])
    assert made.inputs[0][0] is made.inputs[1][0]
    np.testing.assert_allclose(made.inputs[0][0], 1.5 * t + 0.25)
    assert made.velocity is not None and made.velocity[0] is made.q[0] and made.velocity[1] is t


def test_a_log_with_its_errors_corrected_is_the_true_one(tmp_path: Path) -> None:
    t = 0.001 * np.arange(4001)
    q, v = np.sin(7.0 * t), 1.0 + np.sin(11.0 * t)
    late = 1.0 + np.sin(11.0 * (t - 0.004))
    wrong = np.column_stack([1.01 * t, (q + 0.3) / 0.98, late / 1.05])
    for name, table in (("true", np.column_stack([t, q, v])), ("wrong", wrong)):
        np.savetxt(tmp_path / f"{name}.csv", table, delimiter=",", header="t,q,v1", comments="")
    entry = (
        '{ file = "wrong.csv", gain = { v1 = 1.05, q = 0.98 }, zero = "-0.3 mm", delay = "-4 ms", clock = 0.990099 }'
    )
    settings = tmp_path / "P.toml"
    settings.write_text(
        f'name = "P"\n[logs]\ntrain = ["true.csv"]\nvalidation = [{entry}]\n[channels]\n'
        'time = { channel = "t", unit = "s" }\nq = { channel = "q", unit = "mm" }\n'
        'v1 = { channel = "v1", unit = "kV" }\n'
    )
    run_prototype(settings, tmp_path / "run", Unheard(), only="ingest")
    run = RunFolder.open(tmp_path / "run")
    true, mended = (run.read_table(f"{log}/signals.parquet") for log in ("train/true", "validation/wrong"))
    n = min(len(true["t"]), len(mended["t"])) - 2
    np.testing.assert_allclose(mended["q"][2:n], true["q"][2:n], atol=2e-6)
    np.testing.assert_allclose(mended["v1"][2:n], true["v1"][2:n], atol=2.0)
    assert run.record("validation/wrong/record.parquet").recipe.settings["corrections"]["clock"] == 0.990099


@pytest.mark.parametrize(
    ("log", "text"),
    [
        ({"file": "a.csv", "gain": {"v2": 1.1}}, "gain.v2 is stated, but"),
        ({"file": "a.csv", "zero": "0.1 rad"}, "zero"),
        ({"file": "a.csv", "zero": 0.1}, "needs its unit in quotes"),
        ({"file": "a.csv", "gain": {"v1": 0.0}}, "gain.v1: must not be 0"),
        ({"file": "a.csv", "clock": 0.0}, "clock"),
        ({"file": "a.csv", "delay": "5 mm"}, "delay"),
    ],
)
def test_what_cannot_be_meant_is_refused(log: dict[str, object], text: str) -> None:
    with pytest.raises(InputError, match=text):
        corrections(_prototype(log))
