"""The site builds strictly, without the network, and fetches nothing when it is read."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from tests.docs.pages import GENERATED, ROOT, pages

FETCHED = re.compile(
    r"""<(?:script|img|iframe|link rel="(?:stylesheet|preload|preconnect|icon)")[^>]*?(?:src|href)="(\w+:)?//"""
)


def build(folder: Path) -> "subprocess.CompletedProcess[str]":
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "-q", "-d", str(folder)]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True)


@pytest.mark.long
def test_the_site_builds_strictly_and_fetches_nothing(tmp_path: Path) -> None:
    done = build(tmp_path / "site")
    assert done.returncode == 0, done.stderr
    html = sorted((tmp_path / "site").rglob("*.html"))
    assert len(html) > 15
    for page in html:
        text = page.read_text(encoding="utf-8")
        assert not FETCHED.search(text), f"{page.name} fetches from elsewhere"
        assert "mermaid" not in text, "mermaid would be fetched"
    functions = (tmp_path / "site" / "reference" / "functions.html").read_text(encoding="utf-8")
    assert 'id="pipeline.models.model_type.load_model"' in functions


@pytest.mark.parametrize("page", pages())
def test_files_that_a_page_links_to_exist(page: str) -> None:
    text = re.sub(r"(?s)```.*?```", "", (ROOT / page).read_text(encoding="utf-8"))
    for target in re.findall(r"\]\(([^)\s#]+)[^)]*\)", text):
        if not re.match(r"\w+:", target):
            place = (ROOT / page).parent.joinpath(target).resolve()
            made = place.is_relative_to(ROOT) and place.relative_to(ROOT).as_posix() in GENERATED
            assert made or place.exists(), f"{page} links to {target}, which is not there"


def test_the_pages_that_are_made_have_every_command_setting_and_column(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "docs"))
    import hooks

    assert {f"docs/reference/{name}" for name in hooks.PAGES} == GENERATED
    commands = hooks.commands_page()
    assert all(f"## debist {name}\n" in commands for name in ("run", "rig simulate", "control design"))
    assert "Example: debist run P1.toml -o runs/P1" in commands
    rows = [line for line in hooks.settings_page().splitlines() if line.startswith("| `")]
    assert len(rows) > 50 and not [row for row in rows if row.split("|")[4].strip() == ""]
    columns = hooks.columns_page()
    assert all(f"## {table.kind}\n" in columns for table in hooks.tables())
    assert "| `nrmse` | float64 | 1 |" in columns
