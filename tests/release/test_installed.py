"""The wheel as users install it: one name, which works beside a user's own `pipeline`, `cli` and `debist` files."""

import os
import subprocess
import sys
import sysconfig
import zipfile
from pathlib import Path

import pytest

from tests.faults.small_run import write_prototype

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def python(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An environment with the wheel, and with this one's packages behind it but not the checkout."""
    folder = tmp_path_factory.mktemp("installed")
    build = [sys.executable, "-m", "build", "--no-isolation", "-q", "-w", "-o", str(folder / "dist"), str(ROOT)]
    subprocess.run(build, check=True, capture_output=True)
    (wheel,) = (folder / "dist").glob("*.whl")
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(folder / "venv")], check=True)
    made = folder / "venv" / ("Scripts" if os.name == "nt" else "bin") / "python"
    words = [str(made), "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"]
    site = Path(subprocess.run(words, check=True, capture_output=True, text=True).stdout.strip())
    with zipfile.ZipFile(wheel) as archive:
        assert {name.partition("/")[0] for name in archive.namelist()} == {"debist", f"{wheel.name[:12]}.dist-info"}
        archive.extractall(site)
    behind = [path for path in sys.path if path.endswith("site-packages")] or [sysconfig.get_path("purelib")]
    (site / "behind.pth").write_text("".join(f"{path}\n" for path in behind))
    return made


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A lab's folder, with modules that have the names of this repository's."""
    for name in ("pipeline.py", "cli.py"):
        (tmp_path / name).write_text("raise SystemExit('a module of the user was imported')\n")
    (tmp_path / "pipeline").mkdir()
    (tmp_path / "pipeline" / "__init__.py").write_text("raise SystemExit('a package of the user was imported')\n")
    return tmp_path


def _prints(python: Path, folder: Path, *arguments: str) -> str:
    surroundings = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
    done = subprocess.run([str(python), *arguments], capture_output=True, text=True, cwd=folder, env=surroundings)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_scripts_and_the_module_run_beside_files_of_the_same_names(python: Path, folder: Path) -> None:
    (folder / "notebook.py").write_text("import debist\nprint(debist.identify.__module__, debist.__version__)\n")
    module, version = _prints(python, folder, "notebook.py").split()
    assert module == "debist.api.model"
    assert _prints(python, folder, "-m", "debist", "--version") == f"debist {version}\n"


def test_an_unknown_public_name_is_refused(python: Path, folder: Path) -> None:
    program = "import debist\ntry: debist.pipeline\nexcept AttributeError as error: print(error)"
    assert "has no attribute 'pipeline'" in _prints(python, folder, "-c", program)


def test_a_batch_with_worker_processes_runs_beside_them(python: Path, folder: Path) -> None:
    prototype = write_prototype(folder)
    _prints(python, folder, "-m", "debist", "run", str(prototype), "-o", "run", "--jobs", "2", "-q", "--no-report")
    _prints(python, folder, "-m", "debist", "batch", str(prototype), "-o", "runs", "-q", "--no-report")
    program = "import debist; print(len(debist.open_run('run').scores()))"
    assert int(_prints(python, folder, "-c", program)) > 0
