"""Prototypes of a batch, by name: settings files, folders, and tables whose rows become settings files."""

import copy
import csv
import hashlib
import re
import tomllib
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import reduce
from pathlib import Path
from typing import Any, NamedTuple

from ..errors import DebistError, InputError
from ..settings.file import read_document, toml_text
from ..settings.prototype import load_prototype, parse_prototype
from ..store import layout
from ..store.atomic import write_text
from ..system.names import slug
from ..system.plain_files import read_plain
from .prior_knowledge import read_siblings

_ENDINGS = (".csv", ".tsv", ".xlsx")
"""Of files that list prototypes in rows."""
_LARGEST = 1 << 26
_MOST_ROWS = 100_000
_SHORT = {"train": "logs.train", "validation": "logs.validation"}
"""Headings that stand for keys of the settings."""
_BASE = "base.toml"
_PATHS = (
    ("logs", "train"),
    ("logs", "validation"),
    ("plant", "parameters"),
    ("plant", "curves"),
    ("plant", "siblings"),
    ("compare", "curves"),
)
"""Keys with paths that are relative to the settings file."""
FLEET_TABLE = "fleet.parquet"
FLEET_CSV = "fleet.csv"
FLEET_FACTS = "fleet-facts.parquet"
FLEET_REPORT = "fleet.html"
FLEET_FILES = (FLEET_TABLE, FLEET_CSV, FLEET_FACTS, FLEET_REPORT)
SETTINGS = "settings"
"""Folder for settings files that a batch writes."""
FAILED = "failed"
"""Folder for what prototypes printed that failed."""


def table_settings(table: Path, base: Path | None, folder: Path) -> list[Path]:
    """Write a settings file for each row into `folder`, and return the files in the order of the rows.

    Parameters
    ----------
    table : Path
        CSV or XLSX with a heading: ``name``, ``logs.train``, ``logs.validation`` and other keys of the settings, such
        as ``differentiate.alpha``. Several logs of a cell are separated by semicolons; an empty cell leaves the base's
        value. Paths are relative to the table.
    base : Path or None
        Settings that all rows share; None: the TOML file beside the table with its name, or ``base.toml`` there.
    folder : Path
        Folder of the settings files.

    Raises
    ------
    InputError
        The table or its base cannot be read, a heading is missing or doubled, or two rows have one name. A row with
        another mistake fails when it is run, alone.
    """
    shared = _base_of(table, base)
    document = anchored(read_document(shared), shared.resolve().parent)
    rows = enumerate(_workbook_rows(table) if table.suffix.lower() == ".xlsx" else _csv_rows(table), start=1)
    keys = _keys(table, next(rows, (0, []))[1])
    written: dict[str, tuple[int, Path]] = {}
    for number, cells in rows:
        if number > _MOST_ROWS:
            raise InputError(f"{table}: has more than {_MOST_ROWS} rows; divide it")
        values = {key: cell for key, cell in zip(keys, cells, strict=False) if key and cell != ""}
        if not values:
            continue
        name = str(values.pop("name", "")).strip()
        if not name:
            raise InputError(f"{table}: row {number}: has no name; the name decides the run folder")
        stem = slug(name)
        if (before := written.get(stem.casefold())) is not None:
            raise InputError(f"{table}: row {number}: is named {name!r} as row {before[0]}; change one")
        try:
            settings = _settings(document, name, values, table.resolve().parent)
        except InputError as error:
            raise InputError(f"{table}: row {number}: {error}") from None
        written[stem.casefold()] = number, write_settings(folder, stem, settings)
    if not written:
        raise InputError(f"{table}: has no rows below its heading")
    return [path for _, path in written.values()]


def _base_of(table: Path, given: Path | None) -> Path:
    usual = table.with_suffix(".toml")
    base = given or next((path for path in (usual, table.with_name(_BASE)) if path.is_file()), None)
    if base is None:
        raise InputError(
            f"{table}: no base settings; write what all rows share into {usual.name} beside it, or name it with --base"
        )
    return base


def _keys(table: Path, heading: list[Any]) -> list[str]:
    keys = [_SHORT.get(text, text) for text in (str(cell).strip() for cell in heading)]
    named = [key for key in keys if key]
    if "name" not in named:
        raise InputError(f"{table}: row 1: has no heading 'name'; it names the prototype of each row")
    if doubled := next((key for key in named if named.count(key) > 1), None):
        raise InputError(f"{table}: row 1: has the heading {doubled!r} twice; leave one out")
    return keys


def _settings(base: Mapping[str, Any], name: str, values: Mapping[str, Any], folder: Path) -> dict[str, Any]:
    """The base with the values of a row, whose paths are relative to `folder`."""
    typed = {key: _logs(cell) if key.startswith("logs.") else _value(cell) for key, cell in values.items()}
    row = anchored(with_values({}, typed), folder)
    whole = {key: reduce(lambda table, part: table[part], key.split("."), row) for key in typed}
    return {"name": name} | with_values({**base, "name": name}, whole)


def _value(cell: Any) -> Any:
    if isinstance(cell, str):
        return toml_value(cell.strip())
    return int(cell) if isinstance(cell, float) and cell.is_integer() else cell


def _logs(cell: Any) -> list[Any]:
    """The logs of a cell: paths between semicolons or line breaks, or as TOML has them."""
    text = str(cell).strip()
    if text[:1] in ("[", "{"):
        value = toml_value(text)
        return value if isinstance(value, list) else [value]
    return [part.strip() for part in text.replace("\n", ";").split(";") if part.strip()]


def _csv_rows(table: Path) -> Iterator[list[Any]]:
    try:
        text = read_plain(table, _LARGEST).decode("utf-8-sig")
    except OSError as error:
        raise InputError(f"{table}: cannot be read: {error.strerror or error}") from error
    except UnicodeDecodeError:
        raise InputError(f"{table}: not UTF-8; save it as 'CSV UTF-8'") from None
    lines = text.splitlines(keepends=True)
    separator = max((",", ";", "\t"), key=(lines[0] if lines else "").count)
    try:
        yield from csv.reader(lines, delimiter=separator, strict=True)
    except csv.Error as error:
        raise InputError(f"{table}: is no table: {error}") from None


def _workbook_rows(table: Path) -> Iterator[list[Any]]:
    from python_calamine import CalamineError, load_workbook

    try:
        with zipfile.ZipFile(table) as archive:
            if sum(entry.file_size for entry in archive.infolist()) > _LARGEST:
                raise InputError(f"{table}: holds more than {_LARGEST >> 20} MiB; save the rows as CSV")
        yield from load_workbook(table).get_sheet_by_index(0).to_python(skip_empty_area=False)
    except (OSError, zipfile.BadZipFile, CalamineError) as error:
        raise InputError(f"{table}: cannot be read as a workbook: {error}") from None


def with_siblings(prototypes: Sequence[Path], siblings: Path, folder: Path) -> list[Path]:
    """The prototypes with `siblings` in their settings, which are written into `folder`.

    One whose settings cannot be read stays as it is, and fails alone.

    Raises
    ------
    InputError
        There is no such file, or it is no prior of `debist fleet learn`.
    """
    read_siblings(siblings)
    changed = []
    for path in prototypes:
        try:
            own = anchored(read_document(path), path.resolve().parent)
            document = with_values(own, {"plant.siblings": str(siblings.resolve())})
            changed.append(write_settings(folder, parse_prototype(document, str(path)).folder, document))
        except InputError:
            changed.append(path)
    return changed


def write_settings(folder: Path, stem: str, document: Mapping[str, Any]) -> Path:
    """Write settings as ``STEM.toml`` into a folder, and return the file."""
    path = folder / f"{stem}.toml"
    text = toml_text(document)
    with suppress(OSError):
        if read_plain(path) == text.encode():  # its time stamp means a change to workflow engines
            return path
    write_text(path, text, within=folder.parent)
    return path


def toml_value(text: str) -> Any:
    """A value as TOML has it, or the text itself."""
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except (tomllib.TOMLDecodeError, KeyError):
        return text


def with_values(document: dict[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
    """A copy of settings with some values, by dotted keys."""
    changed = copy.deepcopy(document)
    for key, value in values.items():
        *sections, last = key.split(".")
        table = changed
        for section in sections:
            table = table.setdefault(section, {})
            if not isinstance(table, dict):
                raise InputError(f"{key}: {section!r} is no section of the settings")
        table[last] = value
    return changed


def anchored(document: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Settings whose paths are absolute."""
    for section, key in _PATHS:
        table = document.get(section, {})
        value = table.get(key) if isinstance(table, dict) else None
        if isinstance(value, list):
            table[key] = [_anchored_log(log, folder) for log in value]
        elif isinstance(value, str) and Path(value).suffix:
            table[key] = str(folder / value)
    return document


def _anchored_log(log: Any, folder: Path) -> Any:
    if isinstance(log, str):
        return str(folder / log)
    named = isinstance(log, dict) and isinstance(log.get("file"), str)
    return {**log, "file": str(folder / log["file"])} if named else log


class Shard(NamedTuple):
    """One of `of` parts of a fleet, counted from 1."""

    number: int = 1
    of: int = 1

    @classmethod
    def parse(cls, text: str) -> "Shard":
        """The shard that a text such as ``3/100`` names.

        Raises
        ------
        InputError
            It names none.
        """
        match = re.fullmatch(r"(\d{1,6})/(\d{1,6})", text)
        number, count = map(int, match.groups()) if match else (0, 0)
        if not 1 <= number <= count:
            raise InputError(f"--shard {text}: write number/count such as 3/100; the numbers count from 1")
        return cls(number, count)

    def holds(self, name: str) -> bool:
        """True if the shard holds the prototype `name`, which depends on no other name."""
        return int.from_bytes(hashlib.sha256(name.encode()).digest()[:8], "big") % self.of == self.number - 1

    @property
    def lock(self) -> str:
        """Name of the lock that its batch holds."""
        return f".batch-{self.number}-of-{self.of}.lock"


def prototype_files(places: Sequence[Path], output: Path, base: Path | None = None) -> list[Path]:
    """The settings files that are meant: files, all ``*.toml`` of folders, rows of a table.

    Parameters
    ----------
    places : sequence of Path
        Files and folders that the user names.
    output : Path
        The folder of the runs: settings files of a table's rows are written into ``settings/`` there.
    base : Path, optional
        Settings that the rows of a table share; found beside the table if left out.

    Raises
    ------
    InputError
        A place that does not exist, a folder without settings files, or a table with mistakes.
    """
    files: list[Path] = []
    of_rows: dict[Path, Path] = {}
    for place in places:
        if place.suffix.lower() in _ENDINGS and place.is_file():
            for path in table_settings(place, base, output / SETTINGS):
                if path in of_rows:
                    raise InputError(f"{place}: a prototype of {of_rows[path]} has the name of {path.stem}, too")
                of_rows[path] = place
                files.append(path)
        elif place.is_dir():
            inside = sorted(place.glob("*.toml")) + sorted(place.glob("*/*.toml"))
            if not inside:
                raise InputError(f"{place}: holds no settings file (*.toml)")
            files += inside
        elif place.exists():
            files.append(place)
        else:
            raise InputError(f"{place}: no such file or folder")
    if base is not None and not of_rows:
        raise InputError("--base: is what the rows of a table share; name a table, such as fleet.csv")
    return list(dict.fromkeys(path.resolve() for path in files))


@dataclass(frozen=True)
class Member:
    """A prototype of a batch.

    Attributes
    ----------
    name : str
        Name of its run folder.
    settings : Path
        Its settings file.
    logs : tuple of Path
        Its raw logs; none where the settings have a mistake.
    error : str
        That mistake; empty without one.
    """

    name: str
    settings: Path
    logs: tuple[Path, ...] = ()
    error: str = ""


def members(prototypes: Sequence[Path]) -> list[Member]:
    """The prototypes with the names of their run folders, and their logs.

    Raises
    ------
    InputError
        Two prototypes of one name, capitals aside, or one that is named as a file of the fleet.
    """
    named: dict[str, Member] = {}
    for path in prototypes:
        member = _member(path)
        if (folded := member.name.casefold()) in (*FLEET_FILES, SETTINGS, FAILED):
            raise InputError(
                f"{path}: {member.name!r} is the name of a file of the fleet; name the prototype otherwise"
            )
        if (other := named.get(folded)) is not None:
            alike = "" if member.name == other.name else f" ({other.name!r}, which some disks take for the same)"
            raise InputError(
                f"{path}: a second prototype is named {member.name!r}{alike} after {other.settings}; names decide the "
                "run folders, change one"
            )
        named[folded] = member
    return list(named.values())


def _member(path: Path) -> Member:
    try:
        prototype = load_prototype(path)
    except DebistError as error:
        return Member(slug(path.stem), path, error=str(error))  # its own run fails with the reason
    return Member(prototype.folder, path, tuple(dict.fromkeys(log for _, log, _ in layout.raw_logs(prototype, path))))
