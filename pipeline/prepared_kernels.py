"""Kernels that come with the package: types and LLVM's code of them, so that a first run only makes machine code.

What is kept is what numba makes of a kernel before anything depends on the processor, with a stamp: the sources that go
into the kernel and the versions of Python, numba and LLVM. A kernel whose stamp is another is compiled from its source.
``make kernels`` writes the file anew.
"""

# mypy: disable-error-code="no-untyped-call,misc"

import hashlib
import io
import pickle
import sys
import zipfile
import zlib
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import llvmlite
import numba
from llvmlite.binding import get_process_triple
from numba.core import serialize
from numba.core.compiler import compile_result

from pipeline.kernel_parts import EntryLibrary

_HERE = Path(__file__).resolve().parent
PREPARED = _HERE / "generated" / "kernels.zip"
SOURCES = "sources.txt"
"""Its entry with the digests of all files that kernels are made from, one a line."""
_recorded: dict[str, bytes] | None = None
_files: set[Path] = set()


def load(kernel: Any, types: tuple[Any, ...], stamp: bytes) -> Any:
    """Machine code of a kernel that was prepared, and the function by which Python calls it; None if it was not."""
    name = _name(kernel, stamp, types)
    content = None if _recorded is not None else _read(name)
    if content is None:
        return None
    # As trustworthy as the modules beside it, which are run as well.
    inlined, fndesc, environment, signature, actions, environments = pickle.loads(content)  # noqa: S301
    for action in actions:
        action()
    library = EntryLibrary(kernel.targetctx.codegen(), fndesc.qualname)
    library.finish(inlined)
    function = kernel.targetctx.get_executable(library, fndesc, environment)
    for each in environments:
        library.codegen.set_env(each.env_name, each)
    return compile_result(
        target_context=kernel.targetctx,
        typing_context=kernel.targetctx.typing_context,
        library=library,
        environment=environment,
        entry_point=function,
        fndesc=fndesc,
        type_annotation="",
        signature=signature,
        objectmode=False,
        lifted=(),
        metadata={},
        reload_init=actions,
    )


def record(kernel: Any, types: tuple[Any, ...], stamp: bytes, made: Any) -> None:
    """Keep what has been compiled, if this process writes the file."""
    if _recorded is not None and not made.library.has_dynamic_globals:
        _, fndesc, environment, signature, _, _, _, actions, environments = made._reduce()
        content = (made.library.inlined, fndesc, environment, signature, actions, environments)
        _files.update(kernel._cache.files)
        _recorded[_name(kernel, stamp, types)] = serialize.dumps(content)


def write(path: Path, use: Callable[[], None]) -> None:
    """Write the kernels that `use` calls and that the cache does not hold, and what they are made from."""
    global _recorded
    _recorded = {}
    use()
    lines = sorted(f"{file.relative_to(_HERE)} {hashlib.sha256(file.read_bytes()).hexdigest()}\n" for file in _files)
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in sorted({**_recorded, SOURCES: "".join(lines).encode()}.items()):
            archive.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED, 9)


def outdated() -> list[str]:
    """Files that have changed since kernels were made from them."""
    found = (line.split() for line in (_read(SOURCES) or b"").decode().splitlines())
    return [name for name, digest in found if hashlib.sha256((_HERE / name).read_bytes()).hexdigest() != digest]


def holds(kernel: Any, stamp: bytes) -> bool:
    """Whether some version of a kernel was prepared from these sources."""
    archive = _archive()
    return archive is not None and any(name.startswith(_name(kernel, stamp)) for name in archive.NameToInfo)


def _name(kernel: Any, stamp: bytes, types: tuple[Any, ...] | None = None) -> str:
    versions = f"{sys.version_info[:2]} {numba.__version__} {llvmlite.__version__} {get_process_triple()}"
    made_from = hashlib.sha256(versions.encode() + stamp).hexdigest()[:16]
    called_with = "" if types is None else hashlib.sha256(str(types).encode()).hexdigest()[:16]
    return f"{kernel.py_func.__module__}.{kernel.py_func.__qualname__}-{made_from}-{called_with}"


def _read(name: str) -> bytes | None:
    archive = _archive()
    try:
        return None if archive is None else archive.read(name)
    except (KeyError, zipfile.BadZipFile, zlib.error):
        return None


@cache
def _archive() -> zipfile.ZipFile | None:
    """The file, read as a whole: copies of this process would move one another's place in an open one."""
    try:
        return zipfile.ZipFile(io.BytesIO(PREPARED.read_bytes()))
    except (OSError, zipfile.BadZipFile):
        return None
