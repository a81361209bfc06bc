"""Files that a command writes into a folder of the user's: beside what lies there, never onto it.

A command writes into a new folder first, and then moves each file to its place. It replaces an existing file if a list
in the folder shows that this command wrote it and nobody changed it since, or if the user says so. A raw log that a
settings file names is never replaced.
"""

import json
import shutil
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from ..errors import InputError
from ..system.plain_files import read_plain, read_toml
from . import layout
from .atomic import TEMPORARY_MARK, refuse_link, replace, write_text, writing
from .hashing import file_sha256

WRITTEN = ".debist-written.json"
EXTRA_FOLDERS = (layout.STUDIES, layout.EXPORTS)
_LARGEST_LIST = 1 << 26
_MOST_SETTINGS = 1000


@contextmanager
def new_outputs(
    folder: Path,
    command: str,
    *,
    force: bool | None = False,
    names: Iterable[str] = (),
    made_from: Mapping[str, str] | None = None,
) -> Iterator[Path]:
    """A folder to write into, whose files go to `folder` when the block ends well.

    Parameters
    ----------
    folder : Path
        Their folder; made if missing.
    command : str
        Who writes.
    force : bool or None
        True if files of others may be replaced, raw logs excepted; None where the command has no such option.
    names : iterable of str
        Files that are going to be written, to refuse them before the work.
    made_from : mapping of str to str, optional
        Artifacts of a run and the hashes of their content that the files are made from, which the list keeps.

    Raises
    ------
    InputError
        A file is there that this command did not write, or the disk does not let it.
    """
    check_places(folder, names, command, force=force)
    with writing(folder):
        folder.mkdir(parents=True, exist_ok=True)
        staged = Path(tempfile.mkdtemp(prefix=".", suffix=TEMPORARY_MARK, dir=folder))
        try:
            yield staged
            written = [path.relative_to(staged) for path in staged.rglob("*") if path.is_file()]
            written.sort(key=lambda name: (name.suffix == ".toml", name))  # where the settings are, there are the logs
            check_places(folder, map(str, written), command, force=force)
            _place(
                staged, folder, written, {"command": command} | ({"made_from": dict(made_from)} if made_from else {})
            )
        finally:
            shutil.rmtree(staged, ignore_errors=True)


def note_written(folder: Path, names: Iterable[str], command: str) -> None:
    """Add files that a command has written by itself to the list of a folder."""
    files = {name: {"command": command, "sha256": file_sha256(folder / name)} for name in names}
    write_text(folder / WRITTEN, _list({**written_files(folder), **files}))


def rebased(path: Path, staged: Path, folder: Path) -> Path:
    """Final path of a file that was written into the folder of `new_outputs`."""
    return folder / path.relative_to(staged)


def _place(staged: Path, folder: Path, written: list[Path], about: dict[str, Any]) -> None:
    """Move the files to their places; `about` is the entry of each in the list.

    The list is written first and names what they replace: after any interruption each file is in the list.
    """
    listed = written_files(folder)
    coming = {name.as_posix(): about | {"sha256": file_sha256(staged / name)} for name in written}
    replacing = {
        name: entry | {"replaces": file_sha256(folder / name)}
        for name, entry in coming.items()
        if listed.get(name, {}).get("command") == about["command"] and (folder / name).is_file()
    }
    write_text(folder / WRITTEN, _list(listed | coming | replacing))
    for name in written:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        replace(staged / name, folder / name)
    write_text(folder / WRITTEN, _list(listed | coming))


def _list(files: dict[str, Any]) -> str:
    return json.dumps({"files": files}, indent=1, sort_keys=True) + "\n"


def check_places(folder: Path, names: Iterable[str], command: str, *, force: bool | None) -> None:
    """Refuse to write where files of others lie, before any work is done for it.

    Parameters
    ----------
    folder : Path
        Folder of the files.
    names : iterable of str
        Their paths in it.
    command : str
        Who writes.
    force : bool or None
        As of `new_outputs`.

    Raises
    ------
    InputError
        As `new_outputs`.
    """
    listed = written_files(folder)
    for name in names:
        path = folder / name
        refuse_link(path)
        if not path.exists() or _is_known(path, listed.get(Path(name).as_posix()), command):
            continue
        if not path.is_file():
            raise InputError(f"{path}: is no file; name another place")
        if (settings := _named_by(path)) is not None:
            raise InputError(f"{path}: is a raw log of {settings} and is never overwritten; name another place")
        if not force:
            raise InputError(
                f"{path}: is there already and was not written by `debist {command}`, or was changed since; "
                f"name another place, or {'remove it' if force is None else 'give --force to replace it'}"
            )


def _is_known(path: Path, entry: Any, command: str) -> bool:
    if entry is None or entry.get("command") != command:
        return False
    try:
        return file_sha256(path) in (entry.get("sha256"), entry.get("replaces"))
    except OSError:
        return False


def written_files(folder: Path) -> dict[str, Any]:
    """Files written into a folder, each with its command and hash; empty where the list is missing or damaged."""
    try:
        files = dict(json.loads(read_plain(folder / WRITTEN, _LARGEST_LIST))["files"])
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return {}
    return {name: entry for name, entry in files.items() if isinstance(entry, dict) and layout.inside(name)}


def _named_by(path: Path) -> Path | None:
    """A settings file beside the file, above it, or in the current folder that names it as a log."""
    folder = path.parent.absolute()
    for place in (folder, folder.parent, Path()):
        for settings in sorted(place.glob("*.toml"))[:_MOST_SETTINGS]:
            try:
                logs = [log for role in read_toml(settings)["logs"].values() for log in role]
                files = [settings.parent / (log if isinstance(log, str) else log["file"]) for log in logs]
                if any(file.samefile(path) for file in files if file.exists()):
                    return settings
            except (OSError, ValueError, KeyError, TypeError, AttributeError):
                continue
    return None


def beside(path: Path, ending: str) -> Path:
    """What is called as `path` with an ending, beside it; ``.`` and ``..`` are folders with a name, too."""
    named = path if path.name.strip(".") else path.resolve()
    return named.with_name(f"{named.name}{ending}")
