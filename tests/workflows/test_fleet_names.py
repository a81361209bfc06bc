"""The workflow's own Python, without Snakemake: it finds prototypes and runs by the names that debist gives them."""

import re
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from pipeline.stages.run import STAGES
from pipeline.stages.run_place import run_folder

WORKFLOWS = Path(__file__).resolve().parents[2] / "workflows"
TOML = """
[logs]
train = ["Training α (1).csv"]
[channels]
q = { channel = "q", unit = "mm" }
v1 = { channel = "u", unit = "V" }
"""


def _fleet(folder: Path, *, report: bool = True) -> dict[str, Any]:
    """What `fleet.smk` defines for the settings files of a folder."""
    config = {"output": "runs", "prototypes": [str(folder)], "report": report, "check_content": False}
    found: dict[str, Any] = {"config": config, "workflow": SimpleNamespace(is_main_process=True)}
    exec((WORKFLOWS / "fleet.smk").read_text(encoding="utf-8"), found)  # noqa: S102
    return found


@pytest.mark.parametrize("name", ["Prüfling 1", "Größe [2] (neu)", "試作 3", "P1", "Été_α"])
def test_a_prototype_is_found_where_debist_runs_it(name: str, tmp_path: Path) -> None:
    settings = tmp_path / "Prüfling.toml"
    settings.write_text(f'name = "{name}"\n{TOML}', encoding="utf-8")
    found = _fleet(tmp_path)
    (wildcard,) = found["PROTOTYPES"]
    assert wildcard == run_folder(settings).name
    allowed = re.search(r'name="(.*?)"', (WORKFLOWS / "Snakefile").read_text(encoding="utf-8"))
    assert allowed and re.fullmatch(allowed[1], wildcard)
    assert found["raw_logs"](wildcard) == [tmp_path / "Training α (1).csv"]


def test_every_stage_of_a_run_is_watched(tmp_path: Path) -> None:
    assert set(_fleet(tmp_path)["STAGES"]) == set(STAGES)
    assert "report" not in _fleet(tmp_path, report=False)["STAGES"]
