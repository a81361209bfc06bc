"""`compiled`: numba's `njit` with the cache of `kernel_cache`, and the parts of numba that kernels need."""

import os
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, TypeVar, overload

from ..system.isolation import at_end
from ..system.machine import import_configured
from .arrays import FloatArray, IntArray
from .kernel_cache import certify, kernel_folder

# Level 3 compiles 7 % longer; of all kernels only the rig's search for rests is faster by it, 8 %.
os.environ.setdefault("NUMBA_OPT", "2")
numba: Any = import_configured("numba")
# numba reads the file again at each compilation, by a name that is relative to the current folder.
numba.config._config_fname = str(Path(__file__).with_name("numba.yaml"))
extending: Any = import_configured("numba.extending")
types = numba.types
TypingError = numba.TypingError
intrinsic = extending.intrinsic
implement = extending.overload
inlinable = extending.register_jitable
type_callable = extending.type_callable
lower_builtin = extending.lower_builtin

Kernel = TypeVar("Kernel", bound=Callable[..., Any])
_kernels: list[Any] = []


@overload
def compiled(function: Kernel, /) -> Kernel: ...
@overload
def compiled(**options: Any) -> Callable[[Kernel], Kernel]: ...
def compiled(function: Any = None, /, **options: Any) -> Any:
    """Compile for the machine when first called, division by zero as in IEEE 754, and keep the code on disk.

    Parameters
    ----------
    function : callable
        In numba's subset of Python.
    options
        Further options of ``numba.njit``, as ``@compiled(forceinline=True)``.
    """
    return partial(_kernel, options=options) if function is None else _kernel(function, options)


def inner(function: Kernel, **options: Any) -> Kernel:
    """Compile a function that kernels alone call: a wrapper for Python would take up to half of the compilation."""
    return compiled(no_cpython_wrapper=True, **options)(function)


def part(function: Kernel) -> Kernel:
    """An `inner` function that the optimiser puts into what calls it."""
    return inner(function, forceinline=True)


def shared(function: Kernel) -> Kernel:
    """Compile an equation that kernels call, and that plain Python calls with traced values."""
    return inlinable(error_model="numpy", _nrt=False)(function)  # type: ignore[no-any-return]


def _kernel(function: Callable[..., Any], options: dict[str, Any]) -> Any:
    folder = kernel_folder()  # none: each process compiles for itself
    usual = numba.config.CACHE_DIR
    try:
        numba.config.CACHE_DIR = str(folder or "")
        kernel = numba.njit(function, cache=folder is not None, no_cfunc_wrapper=True, error_model="numpy", **options)
    finally:
        numba.config.CACHE_DIR = usual
    _kernels.append(kernel)
    return kernel


def keep_kernels() -> None:
    """Certify what this process has compiled; a process that does not end as usual calls it before its end."""
    if any(kernel.stats.cache_misses for kernel in _kernels):
        certify()


at_end(keep_kernels)


@inner
def copy_into(target: FloatArray, source: FloatArray) -> None:
    """target[:] = source, shapes (n,): an assignment of slices compiles seconds longer, for what it could raise."""
    for i in range(len(target)):
        target[i] = source[i]


@inner
def factorise(matrix: FloatArray, pivots: IntArray) -> bool:
    """LU with partial pivoting, in place; False if a pivot vanishes or is not finite.

    Parameters
    ----------
    matrix : FloatArray, shape (n, n)
        Overwritten by the factors.
    pivots : IntArray, shape (n,)
        Row taken at each step (output).

    Notes
    -----
    Cost: n³/3 multiply-adds; 40 ns for n = 4.
    """
    n = matrix.shape[0]
    for k in range(n):
        best = k
        for i in range(k + 1, n):
            if abs(matrix[i, k]) > abs(matrix[best, k]):
                best = i
        pivots[k] = best
        if not abs(matrix[best, k]) > 0.0 or abs(matrix[best, k]) > 1e300:
            return False
        if best != k:
            for j in range(n):
                matrix[k, j], matrix[best, j] = matrix[best, j], matrix[k, j]
        for i in range(k + 1, n):
            matrix[i, k] /= matrix[k, k]
            for j in range(k + 1, n):
                matrix[i, j] -= matrix[i, k] * matrix[k, j]
    return True


@part
def solve_factorised(factors: FloatArray, pivots: IntArray, right: FloatArray) -> None:
    """Solve with the factors of `factorise` for right-hand sides, which become the solutions.

    Parameters
    ----------
    factors, pivots : shapes (n, n) and (n,)
        From `factorise`.
    right : FloatArray, shape (n · count,)
        Right-hand sides, row by row; the solutions (output).
    """
    n = factors.shape[0]
    count = len(right) // n
    for k in range(n):
        other = pivots[k]
        if other != k:
            for c in range(count):
                right[k * count + c], right[other * count + c] = right[other * count + c], right[k * count + c]
    for k in range(n):
        for i in range(k + 1, n):
            factor = factors[i, k]
            for c in range(count):
                right[i * count + c] -= factor * right[k * count + c]
    for k in range(n - 1, -1, -1):
        for j in range(k + 1, n):
            factor = factors[k, j]
            for c in range(count):
                right[k * count + c] -= factor * right[j * count + c]
        pivot = factors[k, k]
        for c in range(count):
            right[k * count + c] /= pivot


FAST = {"contract", "arcp", "nsz"}
"""Liberties of the compiler: fused operations, reciprocals, and the sign of zero; NaN stays NaN."""
