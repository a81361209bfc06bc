"""Data that would make a model up are refused with exit code 3; what is accepted knowingly is told everywhere."""

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.diagnostics.sentences import judge
from pipeline.errors import DataRefusedError
from pipeline.settings.prototype import Quality
from pipeline.signals.findings import refusal
from pipeline.store.manifest import load_manifest
from tests.prototypes import motion, settings, write_csv

RUNNER = CliRunner()
TOML = settings()
pytestmark = pytest.mark.usefixtures("read_once")


def _write(
    folder: Path, toml: str, *, gain: float = 1.0, second: float = 1.0, top: float = np.inf, hum: float = 0.0,
    until: float = np.inf,
) -> Path:  # fmt: skip
    """A log of 20 s of a double well; voltages scaled, the displacement [mm] cut at a rail, with hum [mm] on it, v2
    none after a time [s].
    """
    t, q, v = motion(20.0, 500.0, 1, gain=(gain, gain * second), noise=3e-6)
    q = np.minimum(q + 1e-3 * hum * np.sin(2.0 * np.pi * 50.0 * t), 1e-3 * top)
    v += np.random.default_rng(2).normal(0.0, 0.1, v.shape)
    v[t > until, 1] = np.nan
    write_csv(folder / "log.csv", t, q, v)
    (folder / "P.toml").write_text(toml, encoding="utf-8")
    return folder / "P.toml"


def _run(prototype: Path, *options: str):
    return RUNNER.invoke(
        app, ["run", str(prototype), "-o", str(prototype.parent / "run"), "-q", "--jobs", "1", *options]
    )


@pytest.mark.parametrize(
    ("damage", "toml", "words"),
    [
        ({"top": 5.0}, TOML, ["log.csv: ", "of the samples of q stay at its extremes (at most 5 %)", '"rails"']),
        ({"until": 12.0}, TOML, ["log.csv: v2 is missing for 40 % of the log (at most 10 %)", '"missing"']),
        ({"second": 0.0}, TOML, ["input v2 never changes", "leave it out of [channels] (v2)", '"undriven"']),
        ({"gain": 0.3}, TOML + '[plant]\nparameters = "nominal"\n', ["only one well", "snap the joint", '"one-well"']),
    ],
)
def test_refused_with_number_and_next_step(tmp_path, damage, toml, words):
    result = _run(_write(tmp_path, toml, **damage))
    assert result.exit_code == 3, result.output
    (line,) = [line for line in result.stderr.splitlines() if line.startswith("debist: ")]
    for word in words:
        assert word in line


def test_where_the_equations_stand_in_it_is_told_and_not_refused():
    findings = [refusal("one-well", "one_well"), refusal("idle", "idle")]
    (told,) = judge("logs", findings[:1], Quality(), ("one-well",))
    assert told.endswith("; there the joint's equations decide")
    with pytest.raises(DataRefusedError, match=r'no excitation: drive .*accept = \["idle"\]'):
        judge("logs", findings, Quality(), ("one-well",))


def test_what_is_accepted_is_recorded_and_shown(tmp_path):
    prototype = _write(tmp_path, TOML + '[quality]\naccept = ["visits", "undriven"]\n', second=0.0)
    result = _run(prototype)
    assert result.exit_code == 0, result.output
    told = "input v2 never changes by more than its noise: nothing is known of its gain (accepted: undriven)"
    assert told in result.stderr
    manifest = load_manifest(tmp_path / "run")
    assert manifest.prototype["quality"] == {"accept": ["visits", "undriven"]}
    assert told in manifest.artifacts["model.h5"].notes["accepted"]
    assert manifest.artifacts["model.h5"].recipe.settings["quality"] == {"accept": ["undriven", "visits"]}
    checks = json.loads((tmp_path / "run" / "datasheet.json").read_text())["verdict"]["checks"]
    assert [c["grade"] for c in checks if told in c["statement"]] == ["poor"], checks
    assert "nothing is known of its gain (accepted: undriven)" in (tmp_path / "run" / "report.html").read_text()
