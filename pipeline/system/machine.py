"""Numerical libraries on this machine: settings before they load that keep results independent of the surroundings.

Where the address space is limited (`ulimit -v`), OpenBLAS needs room for its buffer while it is loaded, or at its first
product. Without that room it tries for ever, or ends the process without an error.
"""

import importlib.util
import mmap
import os
from collections.abc import Callable
from contextlib import chdir, suppress
from functools import wraps
from pathlib import Path
from types import ModuleType
from typing import Any, ParamSpec, TypeVar

resource: Any
try:
    import resource
except ImportError:  # Windows has no limits of this kind
    resource = None

P = ParamSpec("P")
T = TypeVar("T")
ONE_THREAD = tuple(f"{library}_NUM_THREADS" for library in ("OMP", "OPENBLAS", "MKL"))
BUFFERS = 2**28
"""Address space [bytes] that OpenBLAS and what is imported with it need; tried at limits from 120 to 700 MB."""


def settle_machine() -> None:
    """Let linear algebra take one thread, and figures be drawn as matplotlib comes, whatever the environment variables.

    The matrices here are small: threads cost ten times the work that they share, and their number decides the order
    of sums. A user's ``matplotlibrc`` would change the report, or stop it. Without its compiler numba would take hours.
    """
    for name in ONE_THREAD:
        os.environ[name] = "1"
    for name in ("MPLBACKEND", "NUMBA_DISABLE_JIT"):
        os.environ.pop(name, None)
    if matplotlib := importlib.util.find_spec("matplotlib"):
        os.environ["MATPLOTLIBRC"] = str(Path(matplotlib.origin or "").parent / "mpl-data")


def is_limited() -> bool:
    """True under a limit of address space."""
    return resource is not None and resource.getrlimit(resource.RLIMIT_AS)[0] != resource.RLIM_INFINITY


def claim_room(size: int) -> None:
    """Claim so much address space [bytes] for a moment, if it is limited.

    Raises
    ------
    OSError
        There is less.
    """
    if is_limited():
        mmap.mmap(-1, size).close()


def load_linear_algebra() -> None:
    """Have OpenBLAS take its memory now, if the address space is limited.

    Raises
    ------
    OSError
        There is too little.
    """
    if is_limited():
        claim_room(BUFFERS)
        import numpy as np
        from scipy.linalg.blas import dgemm

        dgemm(1.0, np.eye(3), np.eye(3) @ np.eye(3))


def cores() -> int:
    """The number of processor cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):  # a job of a cluster may have fewer than the machine
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def one_thread(work: Callable[P, T]) -> Callable[P, T]:
    """The same function, during which linear algebra takes one thread; the number before is restored."""

    @wraps(work)
    def limited(*arguments: P.args, **named: P.kwargs) -> T:
        """`work` with one thread."""
        import scipy.linalg  # noqa: F401  # only libraries that are loaded can be limited
        from threadpoolctl import threadpool_limits  # type: ignore[import-untyped]

        with threadpool_limits(1, user_api="blas"):
            return work(*arguments, **named)

    return limited


def import_configured(name: str) -> ModuleType:
    """Import a library that reads a configuration file of the current folder, without that file.

    numba looks for ``.numba_config.yaml`` and matplotlib for ``matplotlibrc``. A folder of somebody's logs may hold
    either; the folder of this package holds none.
    """
    with suppress(FileNotFoundError), chdir(Path(__file__).parent):
        return importlib.import_module(name)
    return importlib.import_module(name)  # the current folder was deleted, and its files with it
