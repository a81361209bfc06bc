"""`debist series`: planted drifts of one device, in order of their days, and what is refused."""

import json
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.models.hybrid.parameters import NAMES
from pipeline.store import layout
from pipeline.store.manifest import Recipe
from pipeline.store.run_folder import RunFolder
from tests.export.conftest import planted_run  # noqa: F401 - a fixture
from tests.export.joints import hybrid, paper


def uncertain():
    """The model of all runs, of which five numbers are not certain."""
    joint, names = (
        hybrid(),
        ("left.log C0", "right.log C0", "log charging time", "laser offset", "log creep stiffness 0"),
    )
    spread = np.diag([0.01 * (name in names) for name in NAMES] + [0.0] * (len(joint.theta) - len(NAMES)))
    return replace(joint, spread=spread, band_spread=spread, curve_spread=spread)


DAYS = (0, 10, 5, 30, 20, 25)


def planted(run: Path, folder: Path, name: str, barrier: float, source: str = "hybrid") -> Path:
    """A copy of a run whose datasheet has this barrier [J] ± 1 µJ, rests, and an asymmetry."""
    shutil.copytree(run, folder / name)
    copy = RunFolder.open(folder / name)
    values = {"well_left": (-0.01, 1e-6, "m"), "well_right": (0.011, 1e-6, "m"), "barrier_left": (barrier, 1e-6, "J")}
    seen = {"measured": None, "measured_spread": None, "events": 0}
    facts = [
        {"key": key, "title": key, "unit": unit, "value": value, "low": value - half, "high": value + half} | seen
        for key, (value, half, unit) in {**values, "asymmetry_wells": (300.0 * barrier, 0.01, "%")}.items()
    ]
    facts.append(
        {"key": "damping_left", "title": "damping", "unit": "1", "value": 0.1, "low": None, "high": None} | seen
    )
    verdict = {"data": "good", "model": "good", "checks": []}
    sheet = {
        "name": name,
        "facts_from": source,
        "judged_model": source,
        "facts": facts,
        "verdict": verdict,
        "scores": [],
    }
    tree = {"headline": "hybrid", "hybrid": uncertain().to_tree(), "rbf-paper": paper().to_tree()}
    notes = {"identified": ["hybrid", "rbf-paper"], "hybrid": {}, "rbf-paper": {}}
    written = {
        layout.DATASHEET: copy.write_text(layout.DATASHEET, json.dumps(sheet), {}),
        layout.MODELS: copy.write_tree(layout.MODELS, tree, notes),
    }
    copy.commit(Recipe("test", "1", {}, {}), written)
    return copy.root


@pytest.fixture
def drifting(planted_run, tmp_path):  # noqa: F811
    """Runs of six days, not in order; the barrier falls by 2 µJ a day and scatters by less than its interval."""
    noise = 0.3e-6 * np.random.default_rng(1).standard_normal(len(DAYS))
    return [
        str(planted(planted_run, tmp_path, f"day{day}", 3e-4 - 2e-6 * day + noise[i])) for i, day in enumerate(DAYS)
    ]


def invoke(*arguments):
    return CliRunner().invoke(app, ["series", *arguments])


AT = ("--at", ",".join(map(str, DAYS)))


def test_a_planted_drift_is_claimed_and_nothing_else(drifting):
    made = json.loads(invoke(*drifting, *AT, "--json").stdout)
    facts = {fact["key"]: fact for fact in made["facts"]}
    assert made["names"] == [f"day{day}" for day in sorted(DAYS)] and made["unit"] == "day"
    assert {key for key, fact in facts.items() if fact["trend"]["kind"] != "none"} == {"barrier_left"}
    slope, half = (facts["barrier_left"]["trend"][key] for key in ("slope", "slope_error"))
    assert abs(slope + 2e-6) < half < 2e-7
    assert {"gain_v1", "gain_v2", "laser_offset", "charging_time", "creep_stiffness_0"} < facts.keys()
    assert not {"asymmetry_wells", "damping_left"} & facts.keys()
    shown = " ".join(invoke(*drifting, *AT).stdout.split())
    assert "changed: barrier_left" in shown and "µJ a day" in shown


def test_a_series_that_is_none_is_refused(drifting, planted_run, tmp_path):  # noqa: F811
    other = str(planted(planted_run, tmp_path, "other", 3e-4, "rbf-paper"))
    for arguments, message in (
        (drifting[:1], "at least two runs"),
        ([*drifting, "--at", "1,2,3"], "6 runs need 6 different times"),
        ([*drifting, "--at", "1,2,3,4,5,5"], "6 different times"),
        ([*drifting, "--at", "spring"], "give dates as 2026-03-01"),
        ([str(planted_run), drifting[0]], "has no datasheet"),
        ([*drifting, other], "facts come from different models"),
        ([*drifting, drifting[2]], f"{drifting[2]}: has the facts of another run"),
    ):
        result = invoke(*arguments)
        assert result.exit_code == 2 and message in " ".join(result.stderr.split()), result.output
