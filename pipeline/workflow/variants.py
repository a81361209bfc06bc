"""Settings files that a batch writes: every combination of some values of one prototype, siblings for all, or rows."""

import copy
import itertools
import tomllib
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..errors import InputError
from ..settings.file import read_document, toml_text
from ..settings.prototype import parse_prototype
from ..store.atomic import write_text
from ..system.names import slug
from ..system.plain_files import LARGEST_SETTINGS, read_plain
from .prior_knowledge import read_siblings
from .report_data import load_scores

LARGEST = 1000
"""Combinations that a matrix may have."""

_PATHS = (
    ("logs", "train"),
    ("logs", "validation"),
    ("plant", "parameters"),
    ("plant", "curves"),
    ("plant", "siblings"),
    ("compare", "curves"),
)
"""Keys with paths that are relative to the settings file."""


@dataclass(frozen=True)
class Variant:
    """One combination: its name, its settings file, and what was set."""

    name: str
    path: Path
    values: dict[str, Any]


def write_matrix(prototype_file: Path, sets: Sequence[str], folder: Path) -> list[Variant]:
    """Write a settings file for each combination into `folder`; all are checked before one is written.

    Parameters
    ----------
    prototype_file : Path
        The settings that are varied.
    sets : sequence of str
        ``SECTION.KEY=VALUE,VALUE,…``; the values as in TOML, texts without quotes.
    folder : Path
        Where they go.

    Raises
    ------
    InputError
        A text is not a set, a key or a value is unknown, or there are too many combinations.
    """
    document = read_document(prototype_file)
    parse_prototype(document, str(prototype_file))
    varied = dict(map(_varied, sets))
    combinations = [dict(zip(varied, values, strict=True)) for values in itertools.product(*varied.values())]
    if not varied or len(combinations) > LARGEST:
        raise InputError(f"--set: {len(combinations)} combinations; a matrix has at least one --set and {LARGEST} runs")
    digits = len(str(len(combinations)))
    documents = []
    for number, values in enumerate(combinations, start=1):
        named = anchored(with_values(document, values), prototype_file.resolve().parent)
        named["name"] = f"{document['name']}-{number:0{digits}d}"
        parse_prototype(named, "--set " + " ".join(f"{key}={value}" for key, value in values.items()))
        documents.append(named)
    return [
        Variant(named["name"], write_settings(folder, slug(named["name"]), named), values)
        for values, named in zip(combinations, documents, strict=True)
    ]


def with_siblings(prototypes: Sequence[Path], siblings: Path, folder: Path) -> list[Path]:
    """The prototypes with `siblings` in their settings, which are written into `folder`.

    One whose settings cannot be read stays as it is, and fails alone.

    Raises
    ------
    InputError
        There is no such file, or it is not a file of siblings.
    """
    read_siblings(siblings)
    changed = []
    for path in prototypes:
        try:
            document = anchored(read_document(path), path.resolve().parent)
            document = with_values(document, {"plant.siblings": str(siblings.resolve())})
            name = parse_prototype(document, str(path)).folder
            changed.append(write_settings(folder, name, document))
        except InputError:
            changed.append(path)
    return changed


def write_settings(folder: Path, stem: str, document: Mapping[str, Any]) -> Path:
    """Write settings as ``STEM.toml`` into a folder, and return the file."""
    path = folder / f"{stem}.toml"
    text = toml_text(document)
    with suppress(OSError):
        if read_plain(path, LARGEST_SETTINGS) == text.encode():  # its time stamp means a change to workflow engines
            return path
    write_text(path, text, within=folder.parent)
    return path


def matrix_rows(runs: Mapping[str, Path], variants: Sequence[Variant]) -> list[dict[str, Any]]:
    """For each variant whose run is there, what was set and the scores of q; `runs` are run folders by name."""
    return [
        {
            "name": variant.name,
            "settings": variant.values,
            "scores": [row for row in load_scores(runs[slug(variant.name)]) if row["signal"] == "q"],
        }
        for variant in variants
        if slug(variant.name) in runs
    ]


def _varied(text: str) -> tuple[str, list[Any]]:
    key, equals, values = text.partition("=")
    if not equals or not values or not key.strip():
        raise InputError(f"--set {text}: write SECTION.KEY=VALUE,VALUE, such as identify.basis_functions=6,8,10")
    return key.strip(), [toml_value(part.strip()) for part in values.split(",")]


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
