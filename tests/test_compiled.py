"""The cache of compiled kernels: used again, and not after something that a kernel calls has changed."""

import subprocess
import sys
from pathlib import Path

import pytest

from pipeline import compiled

_CALLED = "from pipeline.compiled import compiled\n\n@compiled\ndef inner(x):\n    return {factor} * x\n"
_CALLER = """from pipeline.compiled import compiled
from pipeline.called import (
    inner,
)

@compiled
def outer(x):
    return inner(x) + 1.0
"""
_RUN = "from pipeline.caller import outer; print(outer(2.0), sum(outer.stats.cache_hits.values()))"


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A package of the same name with `compiled.py` and two kernels, one calling the other."""
    folder = tmp_path / "pipeline"
    folder.mkdir()
    (folder / "__init__.py").write_text("")
    (folder / "compiled.py").write_text(Path(compiled.__file__).read_text())
    (folder / "called.py").write_text(_CALLED.format(factor=3.0))
    (folder / "caller.py").write_text(_CALLER)
    return folder


def _run(package: Path) -> list[str]:
    done = subprocess.run([sys.executable, "-c", _RUN], cwd=package.parent, capture_output=True, text=True, check=True)
    return done.stdout.split()


def test_a_kernel_is_compiled_anew_when_one_that_it_calls_has_changed(package: Path) -> None:
    assert _run(package) == ["7.0", "0"]
    assert _run(package) == ["7.0", "1"]
    (package / "called.py").write_text(_CALLED.format(factor=5.0))
    assert _run(package) == ["11.0", "0"]


def test_sources_are_the_modules_imported_directly_or_not(package: Path) -> None:
    code = (
        "from pathlib import Path; from pipeline.compiled import sources; "
        "print(*sorted(file.name for file in sources(Path('pipeline/caller.py').resolve())))"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=package.parent, capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["called.py", "caller.py", "compiled.py"]
