"""Controllers for the closed loop: C sources with the interface of an exported controller, and Python callables.

C: ``debist_controller_size``, ``_init``, ``_step`` and ``_period``, as `debist export RUN --to controller` writes them.
Python: ``MODULE:NAME`` or ``FILE.py:NAME``, where ``NAME(q)`` is told the first reading [m] and returns a function
``step(q, target) -> (v_left, v_right)`` in m and V. `run_loop` gives both as addresses to the compiled loop.
"""

import ctypes
import importlib
import importlib.util
import os
import resource
import shutil
import signal
import subprocess
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.rig.closed_loop import PERIOD

_COMPILERS = ("cc", "gcc", "clang")
_COMPILE_SECONDS, _COMPILE_MEMORY, _LONGEST_WORDS = 30, 1 << 30, 1 << 16
_STEP = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.POINTER(ctypes.c_double))
Step = Callable[[float, float], tuple[float, float]]


@dataclass
class Controller:
    """A controller in memory.

    Attributes
    ----------
    step, memory : int
        Addresses of its step function and of its state.
    begin : callable
        Told the first reading [m] before the first step.
    failure : list of Exception
        What its Python raised; the voltages are zero from there on.
    keep : tuple
        What must stay alive.
    """

    step: int
    memory: int
    begin: Callable[[float], None]
    failure: list[Exception] = field(default_factory=list)
    keep: tuple[Any, ...] = ()


def load_controller(where: str) -> Controller:
    """A controller from ``FILE.c``, ``MODULE:NAME`` or ``FILE.py:NAME``.

    Raises
    ------
    InputError
        It cannot be compiled, found or loaded, or has another period than the rig.
    """
    if where.endswith(".c"):
        return c_controller(Path(where))
    module, colon, name = where.rpartition(":")
    if not colon:
        raise InputError(f"--controller {where}: give FILE.c, MODULE:NAME or FILE.py:NAME")
    try:
        made = getattr(_module(module), name)
    except (ImportError, AttributeError, OSError, SyntaxError) as error:
        raise InputError(f"--controller {where}: cannot be loaded ({error})") from error
    return python_controller(made)


def python_controller(made: Callable[[float], Step]) -> Controller:
    """A controller from a function that is told the first reading [m] and returns the step function."""
    failure: list[Exception] = []
    steps: list[Step] = []

    def begin(q: float) -> None:
        steps.append(made(q))

    def step(_state: Any, q: float, target: float, v: Any) -> None:
        """Write the voltages [V] for a reading and a target [m] into `v`; zero from the first failure on."""
        left = right = 0.0
        try:
            if not failure:
                left, right = steps[-1](q, target)
        except Exception as error:  # it cannot pass through the compiled loop
            failure.append(error)
        v[0], v[1] = left, right

    called = _STEP(step)
    return Controller(ctypes.cast(called, ctypes.c_void_p).value or 0, 0, begin, failure, (called,))


def c_controller(source: Path) -> Controller:
    """A controller compiled from its C source, whose header lies beside it."""
    with tempfile.TemporaryDirectory() as folder:
        library = Path(folder) / "controller.so"
        compile_shared(source, library)
        try:
            loaded = ctypes.CDLL(str(library))
            size, begin, step, period = (getattr(loaded, f"debist_controller_{n}") for n in _INTERFACE)
        except (OSError, AttributeError) as error:
            raise InputError(f"{source}: lacks a function of the interface ({error})") from None
    size.restype, period.restype = ctypes.c_size_t, ctypes.c_double
    begin.argtypes, begin.restype = [ctypes.c_void_p, ctypes.c_double], None
    if abs(period() - PERIOD) > 1e-9:
        raise InputError(f"{source}: its period is {period():g} s, but the rig calls it every {PERIOD:g} s")
    memory = np.zeros(size() // 8 + 1)
    place = memory.ctypes.data
    address = ctypes.cast(step, ctypes.c_void_p).value or 0
    return Controller(address, place, lambda q: begin(place, q), keep=(loaded, memory))


_INTERFACE = ("size", "init", "step", "period")


def compile_shared(source: Path, library: Path) -> None:
    """Compile a C99 source into a shared library with the system's compiler.

    Raises
    ------
    InputError
        No such file, no compiler, or it refuses the source.
    """
    if not source.is_file():
        raise InputError(f"{source}: no such file")
    names = [name for name in (os.environ.get("CC", ""), *_COMPILERS) if name and shutil.which(name)]
    if not names:
        raise InputError(f"{source}: no C compiler found ({', '.join(_COMPILERS)}); install one, or use a Python one")
    command = [names[0], "-std=c99", "-O2", "-fPIC", "-shared", str(source.absolute()), "-o", str(library), "-lm"]
    with tempfile.TemporaryFile("w+") as said:
        compiler = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=said, stderr=said, process_group=0, preexec_fn=_limit_compiler
        )
        try:
            code = compiler.wait(_COMPILE_SECONDS)
        except subprocess.TimeoutExpired:
            os.killpg(compiler.pid, signal.SIGKILL)  # with what it has started
            compiler.wait()
            raise InputError(f"{source}: {names[0]} has not compiled it in {_COMPILE_SECONDS} s") from None
        said.seek(0)
        told = [line for line in said.read(_LONGEST_WORDS).splitlines() if line.strip()]
    if code:
        lines = [line for line in told if "error" in line] or told or [f"exit code {code}"]
        raise InputError(f"{source}: {names[0]} refuses it: {lines[0]}")


def limit(kind: int, bound: int, spare: int = 0) -> None:
    """Bound what this process may take of a resource, for good; it is killed where it also takes the `spare`."""
    hard = resource.getrlimit(kind)[1]
    last = bound + spare if hard == resource.RLIM_INFINITY else min(bound + spare, hard)
    resource.setrlimit(kind, (min(bound, last), last))


def _limit_compiler() -> None:
    """A source may include what never ends."""
    limit(resource.RLIMIT_AS, _COMPILE_MEMORY)
    limit(resource.RLIMIT_FSIZE, _COMPILE_MEMORY)


def played(t: FloatArray, u: FloatArray) -> Controller:
    """A controller that looks at nothing and gives `u`, shape (N, 2) [V], each row from its time `t` [s] on."""
    rows = np.clip(np.searchsorted(t, np.arange(0.0, t[-1] + PERIOD, PERIOD) + 1e-9, side="right") - 1, 0, t.size - 1)
    commands = iter(u[rows].tolist())

    def step(_q: float, _target: float) -> tuple[float, float]:
        """The next row, and nothing after the last."""
        left, right = next(commands, (0.0, 0.0))
        return left, right

    return python_controller(lambda _q: step)


def _module(name: str) -> Any:
    if not name.endswith(".py"):
        return importlib.import_module(name)
    spec = importlib.util.spec_from_file_location("controller", name)
    if spec is None or spec.loader is None:
        raise ImportError(f"{name} is no Python file")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
