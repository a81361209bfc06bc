"""What a disk may hold after a power failure: all that was synced, and of the rest anything in any order.

The model is that of POSIX, which promises less than any file system keeps: what is written to a file is lost unless the
file was synced since; a name that is given, taken away or moved is as before unless its folder was synced since; what
was not synced may be there nevertheless, each change by itself, later ones without earlier ones.
"""

import os
import random
import shutil
from dataclasses import dataclass, field
from pathlib import Path

from tests.faults.intercepted import Call


@dataclass
class _File:
    """Bytes that are safe, and changes since: (offset, bytes), or (length, None) for a truncation."""

    safe: bytes = b""
    pending: list[tuple[int, bytes | None]] = field(default_factory=list)

    def content(self, changes: list[tuple[int, bytes | None]]) -> bytes:
        held = bytearray(self.safe)
        for offset, data in changes:
            if data is None:
                held = held[:offset].ljust(offset, b"\0")
            else:
                held = held.ljust(offset, b"\0")
                held[offset : offset + len(data)] = data
        return bytes(held)


@dataclass(frozen=True)
class _Change:
    """A name that changed: moved from `source` (None: made) to `target` (None: taken away), leading to `what`."""

    source: str | None
    target: str | None
    what: "_File | None"

    def folders(self) -> set[str]:
        return {path.rpartition("/")[0] for path in (self.source, self.target) if path is not None}


class Disk:
    """A folder, as it is seen and as it is safe.

    Parameters
    ----------
    root : Path
        The folder; what is in it now counts as safe.
    """

    def __init__(self, root: Path) -> None:
        self._root = str(root)
        self._safe: dict[str, _File | None] = {}
        for path in sorted(root.rglob("*")) if root.exists() else ():
            self._safe[str(path)] = _File(path.read_bytes()) if path.is_file() else None
        self._seen = dict(self._safe)
        self._pending: list[_Change] = []

    def take(self, call: Call) -> None:
        """What a call that is about to be done changes."""
        assert call.waiting is not None
        paths = [path for path in call.files if path.startswith(f"{self._root}/")]
        arguments = call.waiting.arguments
        match call.name:
            case "open" | "openat":
                flags = arguments[1 if call.name == "open" else 2]
                if paths and paths[0] not in self._seen and flags & os.O_CREAT:
                    self._change(_Change(None, paths[0], _File()))
                elif paths and flags & os.O_TRUNC and not flags & os.O_EXCL:
                    self._file(paths[0]).pending.append((0, None))
            case "write" | "pwrite64":
                offset = arguments[3] if call.name == "pwrite64" else call.waiting.position()
                self._file(paths[0]).pending.append((offset, call.waiting.written()))
            case "ftruncate":
                self._file(paths[0]).pending.append((arguments[1], None))
            case "fsync" | "fdatasync":
                self._sync(call.files[0])
            case "mkdir" | "mkdirat":
                if paths and paths[0] not in self._seen:
                    self._change(_Change(None, paths[0], None))
            case "unlink" | "unlinkat" | "rmdir":
                if paths and paths[0] in self._seen:
                    self._change(_Change(paths[0], None, self._seen[paths[0]]))
            case "rename" | "renameat" | "renameat2":
                self._change(_Change(paths[0], paths[1], self._seen[paths[0]]))
            case "fchmod" | "chmod":
                pass
            case other:
                raise AssertionError(f"{other} is not modelled")

    def after_a_failure(self, rng: random.Random | None) -> dict[str, bytes | None]:
        """What is there when the power comes back: what is safe, and what `rng` adds of the rest, nothing without."""
        names = dict(self._safe)
        for change in self._pending:
            if rng is not None and rng.random() < 0.5:
                _apply(names, change)
        held: dict[str, bytes | None] = {}
        for path, file in names.items():
            if all(
                str(folder) in names or not str(folder).startswith(f"{self._root}/") for folder in Path(path).parents
            ):
                some = [] if file is None or rng is None else [c for c in file.pending if rng.random() < 0.5]
                held[path] = None if file is None else file.content(some)
        return held

    def lay_out(self, held: dict[str, bytes | None]) -> None:
        """Make the folder so."""
        shutil.rmtree(self._root, ignore_errors=True)
        for path, content in sorted(held.items()):
            place = Path(path)
            place.parent.mkdir(parents=True, exist_ok=True)
            place.mkdir(exist_ok=True) if content is None else place.write_bytes(content)

    def _file(self, path: str) -> _File:
        file = self._seen[path]
        assert file is not None, path
        return file

    def _change(self, change: _Change) -> None:
        self._pending.append(change)
        _apply(self._seen, change)

    def _sync(self, path: str) -> None:
        file = self._seen.get(path)
        if file is not None:
            file.safe, file.pending = file.content(file.pending), []
            return
        kept = []
        for change in self._pending:
            if path in change.folders():
                _apply(self._safe, change)
            else:
                kept.append(change)
        self._pending = kept


def _apply(names: dict[str, "_File | None"], change: _Change) -> None:
    """Make a change, unless what it is made to is not there."""
    if change.source is None:
        names.setdefault(str(change.target), change.what)
    elif change.source in names and names[change.source] is change.what:
        del names[change.source]
        if change.target is not None:
            names[change.target] = change.what
