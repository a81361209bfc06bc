"""`compiled`: numba's `njit` with a cache that knows what a kernel calls.

numba's own cache asks whether the file of a kernel has changed, not those of the kernels and graphs that went into its
machine code, and then runs the old code. Here the stamp of a kernel covers its module and all modules of this package
that it imports, directly or not. Cost: reading those files once per process, some milliseconds in all.
"""

# mypy: disable-error-code="no-untyped-call,misc"

import hashlib
import inspect
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, TypeVar, overload

import numba
from numba.core.caching import FunctionCache, IndexDataCacheFile

Kernel = TypeVar("Kernel", bound=Callable[..., Any])
_PACKAGE = Path(__file__).resolve().parent
_IMPORT = re.compile(rf"^from {_PACKAGE.name}\.?([\w.]*) import (\([^)]*\)|.*)", re.MULTILINE)


@overload
def compiled(function: Kernel, /) -> Kernel: ...
@overload
def compiled(**options: Any) -> Callable[[Kernel], Kernel]: ...
def compiled(
    function: Callable[..., Any] | None = None, /, *, with_module_of: type | None = None, **options: Any
) -> Any:
    """Compile for the machine when first called, division by zero as in IEEE 754, and keep the code on disk.

    Parameters
    ----------
    function : callable
        In numba's subset of Python.
    with_module_of : type, optional
        A class of whose instances the kernel takes, whose module says what it calls on them.
    options
        Further options of ``numba.njit``, as ``@compiled(forceinline=True)``.
    """

    def kernel_of(function: Callable[..., Any]) -> Any:
        """The kernel with its cache."""
        kernel = numba.njit(error_model="numpy", **options)(function)
        kernel._cache = _Cache(function, with_module_of)
        return kernel

    return kernel_of if function is None else kernel_of(function)


def sources(module: Path) -> frozenset[Path]:
    """The files of this package that `module` imports at its top, directly or not, and itself."""
    found, waiting = set[Path](), [module]
    while waiting:
        file = waiting.pop()
        if file not in found:
            found.add(file)
            waiting += _imports(file)
    return frozenset(found)


@cache
def _imports(file: Path) -> tuple[Path, ...]:
    found = []
    for name, imported in _IMPORT.findall(file.read_text(encoding="utf-8")):
        place = _PACKAGE.joinpath(*name.split(".")) if name else _PACKAGE
        inside = [place / f"{word}.py" for word in re.findall(r"\w+", imported)]
        found += [path for path in (place.with_suffix(".py"), *inside) if path.is_file()]
    return tuple(found)


@cache
def _digest(file: Path) -> bytes:
    return hashlib.sha256(file.read_bytes()).digest()


@cache
def _stamp(modules: frozenset[Path]) -> bytes:
    files = frozenset[Path]().union(*(sources(module) for module in modules))
    return hashlib.sha256(b"".join(sorted(_digest(file) for file in files))).digest()


class _Cache(FunctionCache):
    """numba's cache of one function, valid as long as `sources` of its modules are what they were."""

    def __init__(self, function: Callable[..., Any], of: type | None) -> None:
        super().__init__(function)
        modules = frozenset(Path(inspect.getfile(each)).resolve() for each in (function, of) if each is not None)
        self._cache_file = IndexDataCacheFile(
            cache_path=self._cache_path,
            filename_base=self._impl.filename_base,
            source_stamp=_stamp(modules),
        )
