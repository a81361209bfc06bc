"""Run folder of a settings file, and mistakes that can be named before any work."""

import math
import stat
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..device.device import device
from ..errors import InputError, SeveralMistakesError
from ..settings.file import read_document
from ..settings.logs import ROLES, Channels
from ..settings.prototype import Prototype, load_prototype, parse_prototype
from ..store import layout
from ..store.atomic import reading
from ..store.hashing import file_sha256
from ..store.manifest import MANIFEST, Manifest, changes, load_manifest
from ..store.run_folder import RunFolder, holds_run
from ..units.units import DISPLACEMENT, INPUT, MASS, TIME, VELOCITY, to_si
from .engine import Task, missing_source, unreadable_source

_ALLOWED = {"time": TIME, "q": DISPLACEMENT, "qdot": tuple(VELOCITY.values())}


def load_settings(prototype_file: Path) -> Prototype:
    """The settings of a prototype; all mistakes in keys, units and names of logs are reported at once.

    Raises
    ------
    InputError
        A key or a unit is wrong; if so, missing logs are named beside it.
    """
    document = read_document(prototype_file)
    mistakes = list(_wrong_units(document))
    try:
        prototype = parse_prototype(document, str(prototype_file))
    except InputError as error:
        alone = (str(error).removeprefix(f"{prototype_file}: "),)
        mistakes[:0] = error.lines[1:] if isinstance(error, SeveralMistakesError) else alone
    else:
        if not mistakes:
            device(prototype)  # whether the units suit each other
            return prototype
    raise SeveralMistakesError.of(str(prototype_file), [*mistakes, *_missing_logs(document, prototype_file)])


def _table(document: Any, key: str) -> dict[str, Any]:
    table = document.get(key) if isinstance(document, dict) else None
    return table if isinstance(table, dict) else {}


def _wrong_units(document: dict[str, Any]) -> Iterator[str]:
    """Every unit of a channel, and of the mass, that does not exist or measures something else."""
    channels = _table(document, "channels")
    stated = [
        (f"channels.{key}", _table(channels, key), _ALLOWED.get(key, INPUT))
        for key in channels
        if key in Channels.model_fields
    ]
    stated += [(f"{key}.time", _table(table, "time"), _ALLOWED["time"]) for key, table, _ in stated]
    for key, table, allowed in [
        *stated,
        ("plant.mass", _table(_table(document, "plant"), "mass"), tuple(MASS.values())),
    ]:
        if isinstance(unit := table.get("unit"), str):
            try:
                to_si(unit, allowed, f"{key}.unit")
            except InputError as error:
                yield str(error)


def _missing_logs(document: dict[str, Any], prototype_file: Path) -> Iterator[str]:
    """Every log that is named and not there."""
    for role, logs in _table(document, "logs").items():
        for log in logs if isinstance(logs, list) else []:
            file = log.get("file") if isinstance(log, dict) else log
            if isinstance(file, str) and not layout.source(file, prototype_file).exists():
                yield f"logs.{role}: {file!r}: no such log; correct its name"


def require_sources(tasks: Sequence[Task]) -> None:
    """Make sure that every raw file of these tasks is there, all of them at once.

    Raises
    ------
    InputError
        Some are not, or are no files; each is named.
    """
    mistakes = []
    sources = {path: task for task in tasks for path in (task.sources or {}).values()}
    for path, task in sources.items():
        try:
            if not stat.S_ISREG(path.stat().st_mode):
                mistakes.append(f"{path}: cannot be read: is no regular file; correct its name in {task.named_in}")
        except FileNotFoundError:
            mistakes.append(missing_source(path, task))
        except OSError as error:
            mistakes.append(unreadable_source(path, error))
    if len(mistakes) == 1:
        raise InputError(mistakes[0])
    if mistakes:
        raise SeveralMistakesError("logs", mistakes)


def refuse_training_as_validation(prototype: Prototype, prototype_file: Path) -> None:
    """Make sure that no validation log holds the bytes of a training log, whatever it is called, at common times.

    Raises
    ------
    InputError
        One does: as a link, a copy or by another path, as a whole or in parts that overlap. Or a log cannot be read.

    Notes
    -----
    Cost: only logs of equal size are hashed.
    """
    try:
        raw = layout.raw_logs(prototype, prototype_file)
        trained = len(prototype.logs.train)
        sizes = [(*log, log[1].stat().st_size) for log in raw[:trained]]
        for log, path, span in raw[trained:]:
            size = path.stat().st_size
            for other, place, its_span, its_size in sizes:
                overlap = size == its_size and max(span[0], its_span[0]) < min(span[1], its_span[1])
                if overlap and (path.samefile(place) or file_sha256(path) == file_sha256(place)):
                    whole = math.isinf(span[0]) and math.isinf(span[1]) and span == its_span
                    raise InputError(
                        f"{prototype_file}: logs.validation: {log!r} has {'the content' if whole else 'samples'} of "
                        f"the training log {other!r}; validate on a {'log' if whole else 'part'} of its own, or leave "
                        "logs.validation empty"
                    )
    except OSError as error:
        raise InputError(unreadable_source(Path(error.filename or prototype_file), error)) from error


@dataclass(frozen=True)
class Place:
    """A settings file with what stands in it, and the run folder that belongs to it."""

    prototype_file: Path
    prototype: Prototype
    root: Path


def place_of(given: Path, output: Path | None = None) -> Place:
    """The settings file and the run folder that belong together, found from either.

    Raises
    ------
    DebistError
        A folder without a run, bad settings, or a run whose settings file is gone.
    """
    if not given.is_dir():
        prototype = load_settings(given)
        return Place(given, prototype, output or Path("runs") / prototype.folder)
    if not (given / MANIFEST).exists():
        raise InputError(f"{given}: is a folder; name a settings file (*.toml), or the folder of a run")
    prototype_file = Path(load_manifest(given).prototype_file)
    if not prototype_file.is_file():
        raise InputError(f"{given}: its settings file {prototype_file} is gone; name the settings file instead")
    return Place(prototype_file, load_settings(prototype_file), output or given)


def run_folder(given: Path) -> Path:
    """The run folder that is meant: itself, or the one of a settings file."""
    return place_of(given).root if given.suffix.lower() == ".toml" and given.is_file() else given


def before_any_work(place: Place, reading_tasks: Sequence[Task], *, replace: bool) -> None:
    """Refuse what would make the work worthless; `reading_tasks` are those that read raw files.

    Raises
    ------
    InputError
        The folder holds another prototype's run, a raw file is missing, or a validation log is a training log.
    """
    root = place.root
    with reading(root):
        continued = holds_run(root) and (root / MANIFEST).is_file() and not replace
    if continued:
        _refuse_foreign(load_manifest(root), place.prototype, place.prototype_file, root)
    require_sources(reading_tasks)
    refuse_training_as_validation(place.prototype, place.prototype_file)


def _refuse_foreign(stored: Manifest, prototype: Prototype, prototype_file: Path, root: Path) -> None:
    """A run folder belongs to a prototype: to its name, and to at least one of its logs."""
    if not stored.artifacts:
        return
    advice = "choose another folder with -o, or say --replace to overwrite it"
    if stored.prototype["name"] != prototype.name:
        raise InputError(
            f"{root}: holds the run of the prototype {stored.prototype['name']!r}, not of {prototype.name!r}; {advice}"
        )
    made_of = {digest for record in stored.artifacts.values() for digest in record.recipe.inputs.values()}
    before = Path(stored.prototype_file)
    paths = {layout.source(log, before).resolve() for role in ROLES for log in stored.prototype["logs"][role]}
    own = [path for _, path, _ in layout.raw_logs(prototype, prototype_file)]
    if not any(path.resolve() in paths for path in own) and not any(_digest(path) in made_of for path in own):
        raise InputError(f"{root}: holds a run of {prototype.name!r} from other logs, none of them of today; {advice}")


def _digest(log: Path) -> str | None:
    with reading(log):
        return file_sha256(log) if log.is_file() else None


def edited(run: RunFolder) -> list[str]:
    """Differences between the present settings file and the run's settings; empty if the file is gone.

    Raises
    ------
    InputError
        The file has mistakes.
    """
    path = Path(run.manifest.prototype_file)
    if not path.is_file():
        return []
    return changes(load_prototype(path).model_dump(mode="json"), run.prototype.model_dump(mode="json"))
