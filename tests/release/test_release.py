"""What a release rests on: equal builds, one version everywhere, completion that answers."""

import ast
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from pathlib import Path

import pytest
import yaml

from pipeline import __version__

ROOT = Path(__file__).resolve().parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
_PACKAGES = {"sklearn": "scikit-learn", "matio": "mat-io"}
"""What brings a module that is named otherwise."""


def test_the_version_is_the_same_everywhere() -> None:
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    assert citation["version"] == PROJECT["version"] == __version__
    assert citation["license"] == PROJECT["license"].split(" AND ")[0], "the others are of what is vendored"
    headings = re.findall(r"^## (.+)$", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert headings[:2] == ["Unreleased", f"{__version__} ({citation['date-released']})"]
    named = {"docs/how-to/install.md": r"debist-([\d.]+)-py3", "docs/how-to/cluster.md": r"/debist:([\d.]+)"}
    named |= {f"workflows/{name}": r"/debist:([\d.]+)" for name in ("config.yaml", "config.schema.yaml")}
    for name, pattern in named.items():
        assert set(re.findall(pattern, (ROOT / name).read_text(encoding="utf-8"))) == {__version__}, name


def test_what_the_package_imports_is_declared_explained_and_locked() -> None:
    imported = set()
    for path in [*(ROOT / "pipeline").rglob("*.py"), ROOT / "cli.py", ROOT / "debist.py"]:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            own = isinstance(node, ast.ImportFrom) and node.level > 0
            if isinstance(node, ast.ImportFrom | ast.Import) and not own:
                names = [node.module or ""] if isinstance(node, ast.ImportFrom) else [one.name for one in node.names]
                imported |= {name.partition(".")[0] for name in names}
    ours = {"pipeline", "cli", "debist"}
    packages = {_PACKAGES.get(name, name) for name in imported - set(sys.stdlib_module_names) - ours}
    declared = {re.split("[<>=]", entry)[0] for entry in PROJECT["dependencies"]}
    extras = {re.split("[<>=]", entry)[0] for entries in PROJECT["optional-dependencies"].values() for entry in entries}
    packages = {name.replace("_", "-").lower() for name in packages}
    assert packages - {name.lower() for name in declared | extras} == {"casadi"}, "developers alone need it"
    table = (ROOT / "docs/reference/dependencies.md").read_text(encoding="utf-8")
    explained = {name for row in re.findall(r"^\| ([^|]+) \|", table, re.MULTILINE) for name in re.split("[ ,]+", row)}
    assert declared <= explained
    for lock in ROOT.glob("requirements*.lock"):
        text = lock.read_text(encoding="utf-8")
        for name in declared:
            entry = re.search(rf"^{name.lower()}==.*\n(?: .*\n)+", text, re.MULTILINE)
            assert entry and "debist (pyproject.toml)" in entry[0], f"{name} in {lock.name}"


@pytest.mark.long
def test_two_builds_are_equal_and_own_one_name(tmp_path: Path) -> None:
    built = []
    for name in ("one", "two"):
        source = tmp_path / name
        shutil.copytree(
            ROOT,
            source,
            ignore=shutil.ignore_patterns(".git", ".venv", "build", "dist", "runs", ".*_cache", "__pycache__"),
        )
        for number, path in enumerate(sorted(source.rglob("*"))):
            os.utime(path, (1.0e9 + number, 1.0e9 + number + (name == "two")))
        environment = os.environ | {"SOURCE_DATE_EPOCH": "1700000000"}
        command = [
            sys.executable,
            "-m",
            "build",
            "--no-isolation",
            "-q",
            "-o",
            str(tmp_path / f"dist-{name}"),
            str(source),
        ]
        subprocess.run(command, env=environment, check=True, capture_output=True)
        built.append({path.name: path.read_bytes() for path in (tmp_path / f"dist-{name}").iterdir()})
    assert built[0] == built[1] and len(built[0]) == 2
    (wheel,) = (tmp_path / "dist-one").glob("*.whl")
    names = {entry.split("/")[0] for entry in zipfile.ZipFile(wheel).namelist()}
    assert names == {"debist", f"debist-{__version__}.dist-info"}
    (archive,) = (tmp_path / "dist-one").glob("*.tar.gz")
    with tarfile.open(archive) as packed:
        inside = {entry.split("/", 1)[1] for entry in packed.getnames() if "/" in entry}
    for name in ("LICENSE", "README.md", "mkdocs.yml", "docs/index.md", "tests/conftest.py", "requirements-dev.lock"):
        assert name in inside
