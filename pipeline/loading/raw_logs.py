"""Raw logs before any work: is every one there, and is no training log a validation log under another name?"""

import stat
from collections.abc import Sequence
from pathlib import Path

from pipeline.errors import InputError, SeveralMistakesError
from pipeline.runs import layout
from pipeline.runs.engine import Task
from pipeline.runs.hashing import file_sha256
from pipeline.settings import Prototype


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
