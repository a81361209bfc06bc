"""The cache of compiled kernels: used again, not after something that a kernel calls has changed, nor when damaged."""

import os
import random
import re
import subprocess
import sys
from pathlib import Path

import pytest

from pipeline.errors import InputError
from pipeline.numerics import compiled
from pipeline.numerics.kernel_cache import VARIABLE, WITHOUT_KERNELS, check_private

_HAS_KERNELS = re.compile(r"^from \.+(numerics\.|codegen\.)?(compiled|numba_writer) import", re.MULTILINE)
_COMPILER = (
    "numerics/arrays.py",
    "numerics/compiled.py",
    "numerics/kernel_cache.py",
    "system/isolation.py",
    "system/machine.py",
    "errors.py",
)
_CALLED = "from pipeline.numerics.compiled import compiled\n\n@compiled\ndef inner(x):\n    return {factor} * x\n"
_CALLER = """from pipeline.numerics.compiled import compiled
from pipeline.called import (
    inner,
)

@compiled
def outer(x):
    return inner(x) + 1.0
"""
_RUN = "from pipeline.caller import outer; print(outer(2.0), sum(outer.stats.cache_hits.values()))"


def _copy(package: Path, *names: str) -> None:
    """Copy modules of the program into a package of the same name."""
    for name in names:
        (package / name).parent.mkdir(exist_ok=True, parents=True)
        for folder in (package, (package / name).parent):
            (folder / "__init__.py").touch()
        (package / name).write_text((Path(compiled.__file__).parents[1] / name).read_text())


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A package of the same name with the compiler and two kernels, one calling the other."""
    folder = tmp_path / "pipeline"
    _copy(folder, *_COMPILER)
    (folder / "called.py").write_text(_CALLED.format(factor=3.0))
    (folder / "caller.py").write_text(_CALLER)
    return folder


def _words(package: Path, program: str = _RUN, cwd: Path | None = None) -> list[str]:
    """The words that a program prints, in a process that finds this package and keeps kernels beside it."""
    surroundings = os.environ | {VARIABLE: str(package.parent / "kernels"), "PYTHONPATH": str(package.parent)}
    done = subprocess.run(
        [sys.executable, "-P", "-c", program], cwd=cwd or package.parent, env=surroundings, capture_output=True,
        text=True, check=False, timeout=120,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout.split()


def test_a_kernel_is_compiled_anew_when_one_that_it_calls_has_changed(package: Path) -> None:
    assert _words(package) == ["7.0", "0"]
    assert _words(package) == ["7.0", "1"]
    # Of another length: Python tells sources apart by their size and their second, and both may fall into one second.
    (package / "called.py").write_text(_CALLED.format(factor=10.0))
    assert _words(package) == ["21.0", "0"]


@pytest.mark.parametrize("damages", [1, pytest.param(20, marks=pytest.mark.long)])
def test_damaged_kernels_are_compiled_anew(package: Path, damages: int) -> None:
    """Emptied, cut, zeroed, with a flipped bit or without their digest; and the next process finds them whole."""
    _words(package)
    choice = random.Random(26)
    files = sorted(file for file in (package.parent / "kernels").rglob("*") if file.is_file())
    assert len(files) == 8  # index and machine code of two kernels, and their digests
    whole = {file: file.read_bytes() for file in files}
    for number in range(1, 1 + damages):
        file = choice.choice(files)
        content = bytearray(whole[file])
        place = choice.randrange(len(content))
        match number % 5:
            case 4:
                content.clear()
            case 1:
                del content[place:]
            case 2:
                content[place:] = bytes(len(content) - place)
            case 3:
                content[place] ^= 1 << choice.randrange(8)
        file.write_bytes(content)
        if number % 5 == 0:
            file.unlink()
        assert _words(package)[0] == "7.0", (file, number % 5)
        assert _words(package) == ["7.0", "1"], (file, number % 5)


def test_no_kernel_depends_on_a_room_that_the_state_of_the_sources_leaves_out() -> None:
    """Whoever has kernels is imported; none of these rooms comes with it, nor has kernels itself."""
    root = Path(compiled.__file__).parents[1]
    modules = []
    for file in root.rglob("*.py"):
        if _HAS_KERNELS.search(file.read_text()):
            parts = file.relative_to(root).with_suffix("").parts
            assert parts[0] not in WITHOUT_KERNELS, file
            modules.append(".".join(("pipeline", *parts)))
    assert len(modules) > 20
    program = f"import sys; {'; '.join(f'import {name}' for name in modules)}; print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True, cwd=root.parent)
    loaded = {name.split(".")[1] for name in done.stdout.split() if name.startswith("pipeline.")}
    assert not loaded & set(WITHOUT_KERNELS)


_SYSTEM = """from typing import NamedTuple
import numpy as np
from pipeline.numerics.fixed_step import Methods, begin, finish, integrator, workspace

class {name}(NamedTuple):
    rate: float

def _rates(system, x, node, dx, acceleration):
    dx[0], dx[1] = x[1], -{factor} * system.rate * x[1]
    acceleration[0] = dx[1]

run = integrator({name}, lambda kind: Methods(begin, _rates, finish))
x = np.array([0.0, 1.0])
run({name}(1.0), x, np.empty((2, 3, 1)), workspace(x), 100, 0.01, -np.inf, np.inf)
print(round(float(x[1]), 9), sum(run.stats.cache_hits.values()))
"""


@pytest.mark.long
def test_the_integrator_is_compiled_anew_when_a_system_has_changed(package: Path) -> None:
    """Even its name, which the index of the cache holds; and only then."""
    _copy(package, "numerics/fixed_step.py")
    answers = []
    for factor, name in ((1.0, "Decay"), (1.0, "Decay"), (2.0, "Fading")):
        (package / "decay.py").write_text(_SYSTEM.format(factor=factor, name=name))
        answers.append(_words(package, "import pipeline.decay"))
    (once, fresh), again, (twice, anew) = answers
    assert (float(once), fresh) == (pytest.approx(0.3678794412), "0")
    assert again == [once, "1"]
    assert (float(twice), anew) == (pytest.approx(0.1353352832), "0")


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such modes")
def test_kernels_are_loaded_from_no_folder_that_others_can_write(tmp_path: Path) -> None:
    """They are unpickled and run: whoever may write there runs code as the user."""
    own, opened = tmp_path / "own", tmp_path / "open"
    for folder in (own, opened / "in"):
        folder.mkdir(parents=True, mode=0o700)
    check_private(own)
    opened.chmod(0o777)
    for folder in (opened, opened / "in"):
        with pytest.raises(InputError, match=f"others can write into {opened}"):
            check_private(folder)
    opened.chmod(0o1777)  # as /tmp: what is there stays its owner's, but anybody can put something beside it
    check_private(opened / "in")
    with pytest.raises(InputError, match="others can write"):
        check_private(opened)
