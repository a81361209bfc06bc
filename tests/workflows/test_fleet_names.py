"""The workflow's own Python, without Snakemake: it finds prototypes and runs by the names that debist gives them."""

import os
import re
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from pipeline.workflow.place import run_folder

WORKFLOWS = Path(__file__).resolve().parents[2] / "workflows"
TOML = """
[logs]
train = ["Training α (1).csv"]
[channels]
q = { channel = "q", unit = "mm" }
v1 = { channel = "u", unit = "V" }
"""


@pytest.fixture(autouse=True)
def debist_on_the_path(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}")


def _fleet(folder: Path, *, report: bool = True) -> dict[str, Any]:
    """What `fleet.smk` defines for the settings files of a folder."""
    config = {"output": str(folder / "runs"), "prototypes": [str(folder)], "report": report, "check_content": False}
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
    assert found["raw_logs"](wildcard) == [str(tmp_path / "Training α (1).csv")]


def test_parts_a_mark_of_utf_8_and_a_broken_file_are_met_as_by_batch(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    parts = TOML.replace(
        '"Training α (1).csv"', '{ file = "long.csv", start = "1 s" }, { file = "long.csv", stop = "1 s" }'
    )
    (tmp_path / "P.toml").write_text(f'name = "P"\n{parts}', encoding="utf-8-sig")
    (tmp_path / "broken.toml").write_text("name =")
    found = _fleet(tmp_path)
    assert list(found["PROTOTYPES"]) == ["P"] and found["raw_logs"]("P") == [str(tmp_path / "long.csv")]
    assert "left out" in capsys.readouterr().err
    (tmp_path / "other.toml").write_text(f'name = "p"\n{TOML}', encoding="utf-8")
    with pytest.raises(SystemExit):
        _fleet(tmp_path)
