"""What of a machine must not decide a result and what of its disk must not be run, settled before NumPy loads."""

import os
import stat
from collections.abc import Callable
from functools import wraps
from pathlib import Path
from typing import ParamSpec, TypeVar

from pipeline.errors import InputError

P = ParamSpec("P")
T = TypeVar("T")
ONE_THREAD = tuple(f"{library}_NUM_THREADS" for library in ("OMP", "OPENBLAS", "MKL"))
KERNELS = "NUMBA_CACHE_DIR"
_PROCESSOR, _ENOUGH = Path("/proc/cpuinfo"), 1 << 14


def settle_machine() -> None:
    """Fix how sums are taken, whatever the environment says, and refuse kernels that others could have put there.

    One thread: the matrices here are small, threads cost ten times the work they share, and their number decides the
    order of sums. One set of BLAS kernels for every x86-64 processor since 2013: those for newer ones add up in another
    order.

    Raises
    ------
    InputError
        Others can write into the folder of the compiled kernels.
    """
    for name in ONE_THREAD:
        os.environ[name] = "1"
    settle_library()


def settle_library() -> None:
    """The same for a program that imports debist, without its threads, which are its own: see `one_thread`.

    Raises
    ------
    InputError
        Others can write into the folder of the compiled kernels.
    """
    if _has_avx2():
        os.environ["OPENBLAS_CORETYPE"] = "Haswell"
    if KERNELS in os.environ:
        check_kernel_folder(Path(os.environ[KERNELS]))


def one_thread(work: Callable[P, T]) -> Callable[P, T]:
    """The same function, during which linear algebra takes one thread; afterwards it has as many as before."""

    @wraps(work)
    def limited(*arguments: P.args, **named: P.kwargs) -> T:
        """`work` with one thread."""
        import scipy.linalg  # noqa: F401  # only libraries that are loaded can be limited
        from threadpoolctl import threadpool_limits  # type: ignore[import-untyped]

        with threadpool_limits(1, user_api="blas"):
            return work(*arguments, **named)

    return limited


def check_kernel_folder(folder: Path) -> None:
    """Refuse a folder of compiled kernels, which are unpickled and run, if others can write into it.

    Raises
    ------
    InputError
        It, or a folder on the way to it, belongs to somebody else or is open to everybody.
    """
    whole = folder.absolute()
    for place in (whole, *whole.parents):
        try:
            found = place.stat()
        except OSError:
            continue  # not there yet: whoever may make it is checked above it
        others = stat.S_IWOTH | (stat.S_IWGRP if found.st_gid not in (0, os.getegid()) else 0)
        open_to_all = bool(found.st_mode & others) and (place == whole or not found.st_mode & stat.S_ISVTX)
        if open_to_all or found.st_uid not in (0, os.geteuid()):
            raise InputError(
                f"{KERNELS}={folder}: others can write into {place}, and kernels that lie there are run; name a folder "
                "of your own"
            )


def _has_avx2() -> bool:
    try:
        with _PROCESSOR.open("rb") as stream:
            return b" avx2 " in stream.read(_ENOUGH)
    except OSError:
        return False
