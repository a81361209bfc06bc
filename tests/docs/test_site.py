"""The site builds strictly, without the network, and fetches nothing when it is read."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from tests.docs.pages import ROOT, pages

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
    assert 'id="pipeline.models.kind.load_model"' in functions


def test_a_fetched_font_or_script_would_be_noticed() -> None:
    assert FETCHED.search('<script async src="https://cdn.example/x.js">')
    assert FETCHED.search('<link rel="stylesheet" href="//fonts.example/css">')
    assert not FETCHED.search('<script src="assets/bundle.js"></script><a href="https://doi.org/10">')


@pytest.mark.parametrize("page", pages())
def test_files_that_a_page_links_to_exist(page: str) -> None:
    text = re.sub(r"(?s)```.*?```", "", (ROOT / page).read_text(encoding="utf-8"))
    for target in re.findall(r"\]\(([^)\s#]+)[^)]*\)", text):
        if not re.match(r"\w+:", target):
            assert (ROOT / page).parent.joinpath(target).exists(), f"{page} links to {target}, which is not there"
