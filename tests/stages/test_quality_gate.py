"""Data that would make a model up are refused with exit code 3; what is accepted knowingly is told everywhere."""

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.checks.gates import judge
from pipeline.errors import DataRefusedError
from pipeline.runs.manifest import load_manifest
from pipeline.settings import Quality
from pipeline.signals.quality_gates import Finding
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


def test_what_is_left_out_where_a_voltage_ends_is_told(tmp_path):
    result = _run(_write(tmp_path, TOML, until=19.0), "--no-report")
    told = " ".join(result.output.split())
    assert "v2: 499 samples not finite, the first at 19.002 s" in told
    assert "v2 ends 0.998 s before q: what q shows there is left out" in told


def test_where_the_equations_stand_in_it_is_told_and_not_refused():
    findings = [Finding("one-well", "only one well", "snap it"), Finding("idle", "no excitation", "drive it")]
    (told,) = judge("logs", findings[:1], Quality(), ("one-well",))
    assert told == "only one well; there the joint's equations decide"
    with pytest.raises(DataRefusedError, match=r'no excitation: drive it\. .*accept = \["idle"\]'):
        judge("logs", findings, Quality(), ("one-well",))


def test_data_alone_must_pass_what_the_equations_stood_in_for(tmp_path, monkeypatch):
    def no_hybrid(*_, **__):
        raise DataRefusedError("no simulation follows the training logs")

    monkeypatch.setattr("pipeline.models.hybrid.identify.identify_hybrid", no_hybrid)
    toml = TOML.replace('["rbf-paper"]', '["auto"]') + '[plant]\nparameters = "nominal"\n'
    result = _run(_write(tmp_path, toml, gain=0.3))
    assert result.exit_code == 3
    assert '"one-well"' in " ".join(result.output.split())


def test_what_the_priors_of_the_network_decide_does_not_refuse_it(tmp_path, monkeypatch):
    """Its regressor's rank is a matter of `rbf-paper`: a device that is no joint got no further."""

    def refuse(text):
        def refused(*_, **__):
            raise DataRefusedError(text)

        return refused

    found = [Finding("rank", "columns cannot be told apart", "vary the inputs"), Finding("visits", "few", "go there")]
    monkeypatch.setattr("pipeline.stages.identify._findings", lambda *_: found)
    monkeypatch.setattr("pipeline.models.hybrid.identify.identify_hybrid", refuse("no joint"))
    monkeypatch.setattr("pipeline.models.rbf.identify.identify_rbf", refuse("the network was asked"))
    result = _run(_write(tmp_path, TOML.replace('["rbf-paper"]', '["auto"]')))
    assert "the network was asked" in " ".join(result.output.split())


def test_what_no_model_needs_is_told_and_is_no_fault_of_the_data(tmp_path, monkeypatch):
    found = [Finding("rank", "columns cannot be told apart", "vary the inputs")]
    monkeypatch.setattr("pipeline.stages.identify._findings", lambda *_: found)
    toml = TOML.replace('["rbf-paper"]', '["rbf"]').replace(
        "[identify]", '[identify]\nstructure = { friction = "viscous" }'
    )
    result = _run(_write(tmp_path, toml), "--no-report")
    assert result.exit_code == 0, result.output
    assert "columns cannot be told apart; there the priors of rbf decide" in result.stderr
    assert load_manifest(tmp_path / "run").artifacts["model.h5"].notes["accepted"] == []


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


def test_an_accepted_finding_of_a_log_is_recorded_and_shown(tmp_path):
    result = _run(_write(tmp_path, TOML + '[quality]\naccept = ["hum", "visits", "rank"]\n', hum=4.0))
    assert result.exit_code == 0, result.output
    accepted = load_manifest(tmp_path / "run").artifacts["train/log/record.parquet"].notes["accepted"]
    (told,) = [text for text in accepted if "(accepted: hum)" in text]
    assert "% of the range of q is hum of 50 Hz (at most 5 %)" in told and told in result.stderr
    checks = json.loads((tmp_path / "run" / "datasheet.json").read_text())["verdict"]["checks"]
    assert [c["grade"] for c in checks if told in c["statement"]] == ["poor"]
    assert "(accepted: hum)" in (tmp_path / "run" / "report.html").read_text()


def test_an_unknown_gate_is_a_mistake_in_the_settings(tmp_path):
    result = _run(_write(tmp_path, TOML + '[quality]\naccept = ["everything"]\n'))
    assert (result.exit_code, "quality.accept" in result.stderr) == (2, True)
