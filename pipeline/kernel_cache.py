"""Where compiled kernels lie on disk: a folder for each state of their sources, whose files are checked before use.

numba keeps machine code and the index to it in files that it unpickles and runs without a check. So a folder that
others can write to is refused, and a digest beside each file shows whether the file is whole. A file without its digest
is deleted, and numba compiles that kernel anew.
"""

import hashlib
import os
import re
import stat
import sys
from collections.abc import Iterable
from functools import cache
from importlib.metadata import version
from pathlib import Path

from platformdirs import user_cache_path

from pipeline.errors import InputError

VARIABLE = "NUMBA_CACHE_DIR"
_PACKAGE = Path(__file__).resolve().parent
_IMPORT = re.compile(rf"^from {_PACKAGE.name}\.?([\w.]*) import (\([^)]*\)|.*)", re.MULTILINE)
_DIGEST = ".sha256"


@cache
def folder_for(modules: frozenset[Path]) -> Path:
    """The folder for kernels of these modules, in a state that depends on all that they import and on versions.

    numba itself checks only the file that defines a kernel. Cost: each file of the package is read once a process.
    Files that are not whole are deleted.

    Raises
    ------
    InputError
        Others can write into the folder.
    OSError
        The folder cannot be made.
    """
    files = sorted(frozenset[Path]().union(*(sources(module) for module in modules)))
    versions = (sys.implementation.cache_tag, *(version(name) for name in ("numba", "llvmlite", "numpy")))
    state = hashlib.sha256("".join((*versions, *(_digest(file) for file in files))).encode()).hexdigest()[:16]
    folder = _root() / state
    folder.mkdir(parents=True, exist_ok=True)
    check_private(folder)
    for file in _kernels(folder):
        if not _is_whole(file):
            file.unlink(missing_ok=True)
    return folder


def has_kernels(folder: Path) -> bool:
    """Whether any machine code lies in a folder."""
    return bool(_kernels(folder))


def certify(folders: Iterable[Path]) -> None:
    """Write the digest of each file that is newer than its digest; called after a compilation."""
    for folder in folders:
        for file in _kernels(folder):
            digest = file.with_name(file.name + _DIGEST)
            if not digest.exists() or digest.stat().st_mtime_ns < file.stat().st_mtime_ns:
                beside = digest.with_name(f"{digest.name}.{os.getpid()}")
                beside.write_text(hashlib.sha256(file.read_bytes()).hexdigest())
                beside.replace(digest)


def check_private(folder: Path) -> None:
    """Refuse a folder of compiled kernels, which are unpickled and run, if others can write into it.

    Windows keeps the folders of a user to that user, and has no such modes.

    Raises
    ------
    InputError
        It, or a folder on the way to it, belongs to somebody else or is open to everybody.
    """
    if not hasattr(os, "geteuid"):
        return
    whole = folder.absolute()
    for place in (whole, *whole.parents):
        status = place.stat()
        others = stat.S_IWOTH | (stat.S_IWGRP if status.st_gid not in (0, os.getegid()) else 0)
        open_to_all = bool(status.st_mode & others) and (place == whole or not status.st_mode & stat.S_ISVTX)
        if open_to_all or status.st_uid not in (0, os.geteuid()):
            raise InputError(
                f"{folder}: others can write into {place}, and compiled kernels that lie there are run; permit writing "
                f"to yourself alone, or name a folder of your own by {VARIABLE}"
            )


def sources(module: Path) -> frozenset[Path]:
    """The files of this package that `module` imports at its top, directly or not, and itself."""
    reached, waiting = set[Path](), [module]
    while waiting:
        file = waiting.pop()
        if file not in reached:
            reached.add(file)
            waiting += _imports(file)
    return frozenset(reached)


def _root() -> Path:
    named = os.environ.get(VARIABLE)
    return Path(named).absolute() if named else user_cache_path("debist", appauthor=False)


@cache
def _imports(file: Path) -> tuple[Path, ...]:
    imported = []
    for name, words in _IMPORT.findall(file.read_text(encoding="utf-8")):
        place = _PACKAGE.joinpath(*name.split(".")) if name else _PACKAGE
        inside = [place / f"{word}.py" for word in re.findall(r"\w+", words)]
        imported += [path for path in (place.with_suffix(".py"), *inside) if path.is_file()]
    return tuple(imported)


@cache
def _digest(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()


def _kernels(folder: Path) -> list[Path]:
    return [file for file in folder.rglob("*.nb?") if file.suffix in (".nbi", ".nbc")]


def _is_whole(file: Path) -> bool:
    try:
        digest = file.with_name(file.name + _DIGEST).read_text(encoding="ascii", errors="replace")
        return digest == hashlib.sha256(file.read_bytes()).hexdigest()
    except OSError:
        return False
