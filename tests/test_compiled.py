"""The cache of compiled kernels: used again, and not after something that a kernel calls has changed."""

import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

from pipeline import compiled

_COMPILER = ("compiled.py", "kernel_parts.py", "prepared_kernels.py")
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
_COPIES = """import os, sys
import numpy
from numba.core.registry import cpu_target
cpu_target.target_context.refresh()
for program in sys.argv[1:]:
    copy = os.fork()
    if copy == 0:
        exec(program)
        print(end="\f", flush=True)
        os._exit(0)
    assert os.waitpid(copy, 0)[1] == 0
"""


def _in_processes(programs: Sequence[str], folder: Path) -> list[list[str]]:
    """The words that each program prints, one after the other; each is in a copy of a process with numba alone."""
    run = [sys.executable, "-c", _COPIES, *programs]
    done = subprocess.run(run, cwd=folder, capture_output=True, text=True, check=True, timeout=120)
    return [words.split() for words in done.stdout.split("\f")[:-1]]


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A package of the same name with the compiler and two kernels, one calling the other."""
    folder = tmp_path / "pipeline"
    folder.mkdir()
    (folder / "__init__.py").write_text("")
    for name in _COMPILER:
        (folder / name).write_text(Path(compiled.__file__).with_name(name).read_text())
    (folder / "called.py").write_text(_CALLED.format(factor=3.0))
    (folder / "caller.py").write_text(_CALLER)
    return folder


def test_of_two_processes_one_compiles_a_kernel_and_the_other_waits(package: Path) -> None:
    """And it is compiled anew when one that it calls has changed."""
    both = [
        subprocess.Popen([sys.executable, "-c", _RUN], cwd=package.parent, stdout=subprocess.PIPE, text=True)
        for _ in range(2)
    ]
    assert sorted(child.communicate(timeout=60)[0].split() for child in both) == [["7.0", "0"], ["7.0", "1"]]
    # Of another length: Python tells sources apart by their size and their second, and both may fall into one second.
    (package / "called.py").write_text(_CALLED.format(factor=10.0))
    done = subprocess.run([sys.executable, "-c", _RUN], cwd=package.parent, capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["21.0", "0"]


def test_sources_are_the_modules_imported_directly_or_not(package: Path) -> None:
    code = (
        "from pathlib import Path; from pipeline.compiled import sources; "
        "print(*sorted(file.name for file in sources(Path('pipeline/caller.py').resolve())))"
    )
    assert _in_processes([code], package.parent) == [["called.py", "caller.py", *_COMPILER]]


_SYSTEM = """from typing import NamedTuple
import numpy as np
from pipeline.solvers.fixed_step import Methods, integrator, no_begin, no_finish, workspace

class {name}(NamedTuple):
    rate: float

def _rates(system, x, node, dx, acceleration):
    dx[0], dx[1] = x[1], -{factor} * system.rate * x[1]
    acceleration[0] = dx[1]

run = integrator({name}, lambda kind: Methods(no_begin, _rates, no_finish))
x = np.array([0.0, 1.0])
run({name}(1.0), x, np.empty((2, 3, 1)), workspace(x), 100, 0.01, -np.inf, np.inf)
print(round(float(x[1]), 9), sum(run.stats.cache_hits.values()))
"""


def test_the_integrator_is_compiled_anew_when_a_system_has_changed(tmp_path: Path) -> None:
    """Even its name, which the index of the cache holds; and only then."""
    root = Path(compiled.__file__).parent
    names = [*_COMPILER, "solvers/fixed_step.py", "numerics/arrays.py", "numerics/inner_loops.py"]
    for name in (*names, "__init__.py", "solvers/__init__.py", "numerics/__init__.py"):
        target = tmp_path / "pipeline" / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text((root / name).read_text() if name != "__init__.py" else "")
    systems = [_SYSTEM.format(factor=factor, name=name) for factor, name in ((1.0, "Decay"), (2.0, "Fading"))]
    first, second = (f"open('pipeline/decay.py', 'w').write({system!r}); import pipeline.decay" for system in systems)
    (once, fresh), again, (twice, anew) = _in_processes([first, first, second], tmp_path)
    assert (float(once), fresh) == (pytest.approx(0.3678794412), "0")
    assert again == [once, "1"]
    assert (float(twice), anew) == (pytest.approx(0.1353352832), "0")


def test_a_kernel_that_does_not_compile_is_refused_each_time(package: Path) -> None:
    (package / "caller.py").write_text(_CALLER.replace("+ 1.0", "+ 'a'"))
    run = (
        "from pipeline.caller import outer\n"
        "for _ in range(2):\n"
        "    try: outer(2.0)\n"
        "    except Exception as error: print(type(error).__name__)\n"
    )
    assert _in_processes([run], package.parent) == [["TypingError", "TypingError"]]


_ARRAYS = """import sys
import numpy as np
from pipeline.compiled import compiled

@compiled
def half(x):
    return 0.5 * x

@compiled(nogil=True)
def largest(x):
    return half(x).max()

x = np.array([2.0, 4.0])
for word in sys.argv[1:]:
    print(np.sum(globals()[word](x)))
print(*(sum(kernel.stats.cache_hits.values()) for kernel in (half, largest)))
"""


def test_a_kernel_serves_python_and_other_kernels_in_any_order(package: Path) -> None:
    (package / "arrays.py").write_text(_ARRAYS)
    orders = (["largest"], ["largest", "half"], ["largest", "half"], ["half"])
    found = _in_processes([f"sys.argv[1:] = {words}; import pipeline.arrays" for words in orders], package.parent)
    assert found == [["2.0", "0", "0"], ["2.0", "3.0", "0", "1"], ["2.0", "3.0", "1", "1"], ["3.0", "1", "0"]]
