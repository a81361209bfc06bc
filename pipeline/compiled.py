"""`compiled`: numba's `njit` with a cache that knows what a kernel calls.

numba's own cache asks whether the file of a kernel has changed, not those of the kernels and graphs that went into its
machine code, and then runs the old code. Here the stamp of a kernel covers its module and all modules of this package
that it imports, directly or not. Cost: reading those files once per process, some milliseconds in all.
"""

# mypy: disable-error-code="no-untyped-call,misc,attr-defined"

import fcntl
import hashlib
import inspect
import os
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, TypeVar, overload

from numba.core import types
from numba.core.caching import FunctionCache, IndexDataCacheFile
from numba.core.registry import CPUDispatcher

from pipeline import prepared_kernels
from pipeline.kernel_parts import Part, entry

Kernel = TypeVar("Kernel", bound=Callable[..., Any])
_PACKAGE = Path(__file__).resolve().parent
_IMPORT = re.compile(rf"^from {_PACKAGE.name}\.?([\w.]*) import (\([^)]*\)|.*)", re.MULTILINE)


@overload
def compiled(function: Kernel, /) -> Kernel: ...
@overload
def compiled(**options: Any) -> Callable[[Kernel], Kernel]: ...
def compiled(
    function: Callable[..., Any] | None = None, /, *, with_module_of: type | None = None, allocates: bool = True,
    **options: Any,
) -> Any:  # fmt: skip
    """Compile for the machine when first called, division by zero as in IEEE 754, and keep the code on disk.

    Parameters
    ----------
    function : callable
        In numba's subset of Python.
    with_module_of : type, optional
        A class of whose instances the kernel takes, whose module says what it calls on them.
    allocates : bool
        Whether the kernel makes arrays. One that does not need not count who holds the arrays that it is given; with
        many small arrays that takes most of its time.
    options
        Further options of ``numba.njit``, as ``@compiled(forceinline=True)``.
    """

    def kernel_of(function: Callable[..., Any]) -> Any:
        """The kernel with its cache."""
        kernel = _Kernel(function, {"nopython": True, "error_model": "numpy", "_nrt": allocates, **options})
        kernel._cache = _Cache(function, with_module_of)
        return kernel

    return kernel_of if function is None else kernel_of(function)


def is_cached(kernel: Any) -> bool:
    """Whether some machine code of a kernel is in the cache."""
    return bool(kernel._cache._cache_file._load_index())


def is_prepared(kernel: Any) -> bool:
    """Whether some version of a kernel comes with the package, made from the sources that are there."""
    return prepared_kernels.holds(kernel, kernel._cache.stamp)


def cache_folder(kernel: Any) -> Path:
    """The folder in which the machine code of a kernel is kept; it is made."""
    kernel._cache._impl.locator.ensure_cache_path()
    return Path(kernel._cache._cache_path)


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
def _stamp(files: frozenset[Path]) -> bytes:
    return hashlib.sha256(b"".join(sorted(_digest(file) for file in files))).digest()


class _Index(IndexDataCacheFile):
    """The index of a kernel's machine code; one that names a class which is gone is of another version, and empty."""

    def _load_index(self) -> Any:
        try:
            return super()._load_index()
        except Exception:  # whatever it holds is compiled anew
            return {}


class _Kernel(CPUDispatcher):
    """What Python calls; what other kernels call is its part."""

    def __init__(self, function: Callable[..., Any], options: dict[str, Any]) -> None:
        super().__init__(function, targetoptions=options)
        self.part = Part(function, options)
        self._compiler.compile = self._entry

    def _entry(self, arguments: tuple[Any, ...], _: Any) -> Any:
        stamp = self._cache.stamp
        made = prepared_kernels.load(self, arguments, stamp)
        if made is None:
            made = entry(self.part, arguments, bool(self.targetoptions.get("nogil")))
            prepared_kernels.record(self, arguments, stamp, made)
        return made

    @property
    def _numba_type_(self) -> Any:
        return types.Dispatcher(self.part)


class _Cache(FunctionCache):
    """numba's cache of one function, valid as long as `sources` of its modules are what they were."""

    def __init__(self, function: Callable[..., Any], of: type | None) -> None:
        super().__init__(function)
        modules = [Path(inspect.getfile(each)).resolve() for each in (function, of) if each is not None]
        self.files = frozenset[Path]().union(*(sources(module) for module in modules))
        self.stamp = _stamp(self.files)
        self._cache_file = _Index(
            cache_path=self._cache_path, filename_base=self._impl.filename_base, source_stamp=self.stamp
        )
        self._lock = -1

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """The machine code for a signature; None if this process is to compile it, and no other one does."""
        found = super().load_overload(sig, target_context)
        if found is None and self._locked():  # another process may have compiled it meanwhile
            found = super().load_overload(sig, target_context)
            if found is not None:
                self._release()
        return found

    def save_overload(self, sig: Any, data: Any) -> None:
        super().save_overload(sig, data)
        self._release()

    def _locked(self) -> bool:
        """Lock the kernel; whether this call did. Without a file system that locks, two processes may compile."""
        if self._lock >= 0:
            return False
        try:
            self._impl.locator.ensure_cache_path()
            path = Path(self._cache_path) / f"{self._impl.filename_base}.lock"
            self._lock = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o666)
            fcntl.flock(self._lock, fcntl.LOCK_EX)
        except OSError:
            self._release()
        return self._lock >= 0

    def _release(self) -> None:
        if self._lock >= 0:
            os.close(self._lock)
            self._lock = -1
