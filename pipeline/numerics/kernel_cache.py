"""Cache of numba's compiled kernels: a folder for each state of the package's sources, checked before it is used.

numba compares only the file that defines a kernel, and runs the files of its cache without a check. So a folder that
others can write to is refused, and a digest beside each file shows whether the file is whole. A file without its digest
is deleted, and numba compiles that kernel anew.
"""

import hashlib
import os
import stat
import sys
from contextlib import suppress
from functools import cache
from importlib.metadata import version
from pathlib import Path

from platformdirs import user_cache_path

from ..errors import InputError

VARIABLE = "NUMBA_CACHE_DIR"
WITHOUT_KERNELS = ("api", "commands", "diagnostics", "export", "reporting", "rig_logs", "workflow")
"""Rooms that no kernel imports: a change in them leaves the kernels as they are."""
_PACKAGE = Path(__file__).resolve().parents[1]
_DIGEST = ".sha256"


@cache
def kernel_folder() -> Path | None:
    """The folder for the sources and libraries as they are, without damaged files; None where none can be made.

    Cost: each source file and each kernel is read once a process, about 20 ms.

    Raises
    ------
    InputError
        Others can write into the folder.
    """
    state = hashlib.sha256(sys.implementation.cache_tag.encode())
    for name in ("numba", "llvmlite", "numpy"):
        state.update(version(name).encode())
    for file in sorted(_PACKAGE.rglob("*.py")):
        if file.relative_to(_PACKAGE).parts[0] not in WITHOUT_KERNELS:
            state.update(hashlib.sha256(file.read_bytes()).digest())
    named = os.environ.get(VARIABLE)
    root = Path(named).absolute() if named else user_cache_path("debist", appauthor=False)
    folder = root / state.hexdigest()[:16]
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        check_private(folder)
        for file in _kernels(folder):
            if not _is_whole(file):
                file.unlink(missing_ok=True)
    except OSError:
        return None
    return folder


def has_kernels() -> bool:
    """True if any machine code is in the folder."""
    folder = kernel_folder()
    return folder is not None and bool(_kernels(folder))


def certify() -> None:
    """Write the digest of each file that is newer than its digest, where that succeeds; called after a compilation."""
    folder = kernel_folder()
    for file in _kernels(folder) if folder else ():
        digest = file.with_name(file.name + _DIGEST)
        if not digest.exists() or digest.stat().st_mtime_ns < file.stat().st_mtime_ns:
            beside = digest.with_name(f"{digest.name}.{os.getpid()}")
            with suppress(OSError):  # as on Windows, where another process reads the old one; or the disk is full
                beside.write_text(hashlib.sha256(file.read_bytes()).hexdigest(), encoding="ascii")
                beside.replace(digest)
            with suppress(OSError):
                beside.unlink(missing_ok=True)


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


def _kernels(folder: Path) -> list[Path]:
    return [file for file in folder.rglob("*.nb?") if file.suffix in (".nbi", ".nbc")]


def _is_whole(file: Path) -> bool:
    try:
        digest = file.with_name(file.name + _DIGEST).read_text(encoding="ascii", errors="replace")
        return digest == hashlib.sha256(file.read_bytes()).hexdigest()
    except OSError:
        return False
