"""Settings and raw logs before any work: is every key, unit and log right, and is no training log a validation log?"""

import stat
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from pipeline.errors import InputError, SeveralMistakesError
from pipeline.plain_files import read_toml
from pipeline.runs import layout
from pipeline.runs.engine import Task
from pipeline.runs.hashing import file_sha256
from pipeline.settings import Prototype, load_prototype
from pipeline.units import DISPLACEMENT, INPUT, MASS, TIME, VELOCITY, to_si

_ALLOWED = {"time": TIME, "q": DISPLACEMENT, "qdot": tuple(VELOCITY.values())}


def load_settings(prototype_file: Path) -> Prototype:
    """The settings of a prototype; what is wrong in keys, units and names of logs is told at once.

    Raises
    ------
    InputError
        A key or a unit is wrong; if so, missing logs are named beside it.
    """
    try:
        prototype, mistakes = load_prototype(prototype_file), list[str]()
    except SeveralMistakesError as error:
        prototype, mistakes = None, list(error.lines[1:])
    except InputError as error:
        prototype, mistakes = None, [str(error).removeprefix(f"{prototype_file}: ")]
    try:
        document = read_toml(prototype_file)
    except (OSError, ValueError):  # no settings at all, which is what the first reading said
        document = {}
    mistakes += _wrong_units(document)
    if prototype is not None and not mistakes:
        return prototype
    raise SeveralMistakesError.of(str(prototype_file), [*mistakes, *_missing_logs(document, prototype_file)])


def _table(document: Any, key: str) -> dict[str, Any]:
    found = document.get(key) if isinstance(document, dict) else None
    return found if isinstance(found, dict) else {}


def _wrong_units(document: dict[str, Any]) -> Iterator[str]:
    """Every unit of a channel, and of the mass, that is none or measures something else."""
    channels = _table(document, "channels")
    stated = [(f"channels.{key}", _table(channels, key), _ALLOWED.get(key, INPUT)) for key in channels]
    for key, table, allowed in [*stated, ("plant.mass", _table(_table(document, "plant"), "mass"), MASS)]:
        if isinstance(unit := table.get("unit"), str):
            try:
                to_si(unit, allowed, f"{key}.unit")
            except InputError as error:
                yield str(error)


def _missing_logs(document: dict[str, Any], prototype_file: Path) -> Iterator[str]:
    """Every log that is named and not there."""
    for role, logs in _table(document, "logs").items():
        for log in logs if isinstance(logs, list) else []:
            if isinstance(log, str) and not layout.source(log, prototype_file).exists():
                yield f"logs.{role}: {log!r}: no such log; correct its name"


def require_sources(tasks: Sequence[Task]) -> None:
    """Make sure that every raw file of these tasks is there, all of them at once.

    Raises
    ------
    InputError
        Some are not, or are no files; each is named.
    """
    found = []
    for path in dict.fromkeys(path for task in tasks for path in (task.sources or {}).values()):
        try:
            regular = stat.S_ISREG(path.stat().st_mode)
        except FileNotFoundError:
            found.append(f"{path}: no such log or table; correct its name, for a log in [logs]")
        except OSError as error:
            found.append(f"{path}: cannot be read: {error.strerror}; see to disk and permission")
        else:
            if not regular:
                found.append(f"{path}: cannot be read: is no regular file; correct its name, for a log in [logs]")
    if len(found) == 1:
        raise InputError(found[0])
    if found:
        raise SeveralMistakesError("logs", found)


def refuse_training_as_validation(prototype: Prototype, prototype_file: Path) -> None:
    """Make sure that no validation log holds the bytes of a training log, whatever it is called.

    Raises
    ------
    InputError
        One does: as a link, a copy or by another path.

    Notes
    -----
    Cost: only logs of equal size are hashed.
    """
    train, validation = (
        [(log, layout.source(log, prototype_file)) for role, _, log in layout.logs(prototype) if role == wanted]
        for wanted in ("train", "validation")
    )
    sizes = [(log, path, path.stat().st_size) for log, path in train]
    for log, path in validation:
        size = path.stat().st_size
        for other, place, its_size in sizes:
            if size == its_size and (path.samefile(place) or file_sha256(path) == file_sha256(place)):
                raise InputError(
                    f"{prototype_file}: logs.validation: {log!r} has the content of the training log {other!r}; "
                    "validate on a log of its own, or leave logs.validation empty"
                )
