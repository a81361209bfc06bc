"""Settings of numerical libraries that keep results independent of the surroundings; made before NumPy loads."""

import importlib.util
import os
from collections.abc import Callable
from contextlib import chdir, suppress
from functools import wraps
from pathlib import Path
from types import ModuleType
from typing import ParamSpec, TypeVar

P = ParamSpec("P")
T = TypeVar("T")
ONE_THREAD = tuple(f"{library}_NUM_THREADS" for library in ("OMP", "OPENBLAS", "MKL"))


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
