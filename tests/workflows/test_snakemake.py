"""The Snakemake workflow: clean lint, nothing to do after a run, and content that decides where time stamps lie.

Needs an environment with the extra `workflow` (`make workflow`); skipped elsewhere.
"""

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

from pipeline.store.manifest import load_manifest
from tests.prototypes import motion_prototype

SNAKEFILE = Path(__file__).resolve().parents[2] / "workflows/Snakefile"
STAGES = {"check", "ingest", "differentiate", "identify", "instruments", "validate", "compare", "scores"}

pytestmark = pytest.mark.skipif(
    shutil.which("snakemake") is None or shutil.which("debist") is None,
    reason="snakemake and debist are not on the PATH; `make workflow` installs both",
)


def _snakemake(folder: Path, *options: str) -> str:
    done = subprocess.run(
        ["snakemake", "-s", str(SNAKEFILE), "--cores", "2", "--configfile", "config.json", *options],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, "OMP_NUM_THREADS": "1"},
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout + done.stderr


def _planned(folder: Path) -> set[str]:
    """The rules that a dry run would run."""
    said = _snakemake(folder, "--dry-run")
    lines = map(str.strip, said.splitlines())
    return {line.split()[-1].rstrip(":") for line in lines if line.startswith(("rule ", "localrule "))}


@pytest.fixture(scope="module")
def fleet(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A working directory whose one prototype has been run through."""
    folder = tmp_path_factory.mktemp("workflow")
    (folder / "prototypes").mkdir()
    motion_prototype(folder / "prototypes", "a", 1)
    (folder / "config.json").write_text(json.dumps({"report": False}))
    _snakemake(folder)
    return folder


def _hashes(folder: Path) -> dict[str, str]:
    return {name: record.content_hash for name, record in load_manifest(folder / "runs/a").artifacts.items()}


def test_lint_finds_nothing(tmp_path: Path) -> None:
    (tmp_path / "prototypes").mkdir()
    motion_prototype(tmp_path / "prototypes", "a", 1)
    (tmp_path / "config.json").write_text("{}")
    assert "good condition" in _snakemake(tmp_path, "--lint")


def test_after_a_full_run_there_is_nothing_to_do(fleet: Path) -> None:
    assert {path.stem for path in (fleet / "runs/a/stages").iterdir()} == STAGES
    assert (fleet / "runs/fleet.parquet").is_file()
    stated = json.loads((fleet / "runs/a/stages/ingest.json").read_text())["content"]
    assert stated == {name: _hashes(fleet)[name] for name in stated} and len(stated) == 2
    assert _planned(fleet) == set()


def test_garbage_is_noticed_and_rebuilt_to_the_same_content(fleet: Path) -> None:
    before = _hashes(fleet)
    artifact = fleet / "runs/a/train/a/kinematics.parquet"
    stamps = artifact.stat()
    artifact.write_bytes(b"\x07" * stamps.st_size)
    os.utime(artifact, ns=(stamps.st_atime_ns, stamps.st_mtime_ns))
    assert _planned(fleet) >= {"differentiate", "identify"}
    _snakemake(fleet)
    assert _hashes(fleet) == before
    assert _planned(fleet) == set()


def test_changes_under_an_old_time_stamp_are_noticed(fleet: Path) -> None:
    before = _hashes(fleet)
    log, settings = fleet / "prototypes/a.csv", fleet / "prototypes/a.toml"
    stamps = log.stat()
    lines = log.read_text().splitlines(keepends=True)
    time, displacement, inputs = lines[-1].split(",", 2)
    log.write_text("".join([*lines[:-1], f"{time},{float(displacement) + 1e-3},{inputs}"]))  # the last one alone
    os.utime(log, ns=(stamps.st_atime_ns, stamps.st_mtime_ns))
    assert "ingest" in _planned(fleet)
    _snakemake(fleet)
    assert _hashes(fleet)["train/a/signals.parquet"] != before["train/a/signals.parquet"]
    assert _planned(fleet) == set()

    stamps = settings.stat()
    settings.write_text(settings.read_text() + "\n[ingest]\nsample_interval = 0.02\n")
    os.utime(settings, ns=(stamps.st_atime_ns, stamps.st_mtime_ns))
    assert "ingest" in _planned(fleet)


def test_a_wrong_configuration_is_refused(tmp_path: Path) -> None:
    (tmp_path / "config.json").write_text('{"prototype": []}')
    with pytest.raises(AssertionError, match="Additional properties are not allowed"):
        _snakemake(tmp_path, "--dry-run")
