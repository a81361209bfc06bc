"""A batch by a table: a row for each prototype, its name, logs and the settings that differ from a base."""

import csv
import zipfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from ..errors import InputError
from ..settings.file import read_document
from ..system.names import slug
from ..system.plain_files import read_plain
from .variants import anchored, toml_value, with_values, write_settings

_ENDINGS = (".csv", ".tsv", ".xlsx")
_LARGEST = 1 << 26
_MOST_ROWS = 100_000
_SHORT = {"train": "logs.train", "validation": "logs.validation"}
"""Headings that stand for keys of the settings."""
_BASE = "base.toml"


def is_table(place: Path) -> bool:
    """Whether a file lists prototypes in rows."""
    return place.suffix.lower() in _ENDINGS and place.is_file()


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
        Where the settings files go.

    Raises
    ------
    InputError
        The table or its base cannot be read, a heading is missing or doubled, or two rows have one name. A row with
        another mistake fails when it is run, alone.
    """
    shared = _base_of(table, base)
    document = anchored(read_document(shared), shared.resolve().parent)
    rows = _rows(table)
    keys = _keys(table, next(rows, (0, []))[1])
    written: dict[str, tuple[int, Path]] = {}
    for number, cells in rows:
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
    if given is not None:
        return given
    beside = [table.with_suffix(".toml"), table.with_name(_BASE)]
    for path in beside:
        if path.is_file():
            return path
    raise InputError(
        f"{table}: no base settings; write what all rows share into {beside[0].name} beside it, or name it with --base"
    )


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
    changed = {key: _at(row, key) for key in typed}
    return {"name": name} | with_values({**base, "name": name}, changed)


def _at(document: Any, key: str) -> Any:
    for part in key.split("."):
        document = document[part]
    return document


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


def _rows(table: Path) -> Iterator[tuple[int, list[Any]]]:
    """Number, counted from 1, and cells of each row."""
    rows = _workbook_rows(table) if table.suffix.lower() == ".xlsx" else _csv_rows(table)
    for number, row in enumerate(rows, start=1):
        if number > _MOST_ROWS:
            raise InputError(f"{table}: has more than {_MOST_ROWS} rows; divide it")
        yield number, row


def _csv_rows(table: Path) -> Iterator[list[Any]]:
    try:
        content = read_plain(table, _LARGEST)
    except OSError as error:
        raise InputError(f"{table}: cannot be read: {error.strerror or error}") from error
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(f"{table}: not UTF-8; save it as 'CSV UTF-8'") from None
    lines = text.splitlines(keepends=True)
    heading = lines[0] if lines else ""
    separator = max((",", ";", "\t"), key=heading.count)
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
