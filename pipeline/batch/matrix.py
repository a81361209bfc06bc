"""Settings files that a batch writes: every combination of some values of one prototype, or siblings for all."""

import copy
import itertools
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pipeline.errors import InputError
from pipeline.loading.prior_knowledge import read_siblings
from pipeline.loading.report_data import load_scores
from pipeline.names import slug
from pipeline.runs.atomic import write_text
from pipeline.settings import parse_prototype
from pipeline.settings_file import read_document, toml_text

FOLDER = "settings"
"""Where these files lie, in the folder of the runs."""

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


def write_matrix(prototype_file: Path, sets: Sequence[str], output: Path) -> list[Variant]:
    """Write a settings file for each combination into ``settings/`` of `output`; all are checked before one is written.

    Parameters
    ----------
    prototype_file : Path
        The settings that are varied.
    sets : sequence of str
        ``SECTION.KEY=VALUE,VALUE,…``; the values as in TOML, texts without quotes.
    output : Path
        The folder of the runs.

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
    digits, documents = len(str(len(combinations))), []
    for number, values in enumerate(combinations, start=1):
        named = _anchored(_with(document, values), prototype_file.resolve().parent)
        named["name"] = f"{document['name']}-{number:0{digits}d}"
        parse_prototype(named, "--set " + " ".join(f"{key}={value}" for key, value in values.items()))
        documents.append(named)
    return [
        Variant(named["name"], _write(output, slug(named["name"]), named), values)
        for values, named in zip(combinations, documents, strict=True)
    ]


def with_siblings(named: Sequence[tuple[str, Path]], siblings: Path, output: Path) -> list[tuple[str, Path]]:
    """The prototypes with `siblings` in their settings, which are written into ``settings/`` of `output`.

    One whose settings cannot be read stays as it is, and fails alone.

    Raises
    ------
    InputError
        There is no such file, or it is not a file of siblings.
    """
    read_siblings(siblings)
    changed = []
    for name, path in named:
        try:
            document = _anchored(read_document(path), path.resolve().parent)
            document = _with(document, {"plant.siblings": str(siblings.resolve())})
            parse_prototype(document, str(path))
            changed.append((name, _write(output, name, document)))
        except InputError:
            changed.append((name, path))
    return changed


def _write(output: Path, name: str, document: Mapping[str, Any]) -> Path:
    path = output / FOLDER / f"{name}.toml"
    write_text(path, toml_text(document), within=output)
    return path


def matrix_rows(runs: Mapping[str, Path], variants: Sequence[Variant]) -> list[dict[str, Any]]:
    """For each variant whose run is there, what was set and the scores of q; `runs` are run folders by name."""
    return [
        {
            "name": variant.name,
            "settings": variant.values,
            "scores": [row for row in load_scores(runs[variant.name]) if row["signal"] == "q"],
        }
        for variant in variants
        if variant.name in runs
    ]


def _varied(text: str) -> tuple[str, list[Any]]:
    key, equals, values = text.partition("=")
    if not equals or not values or not key.strip():
        raise InputError(f"--set {text}: write SECTION.KEY=VALUE,VALUE, such as identify.basis_functions=6,8,10")
    return key.strip(), [_value(part.strip()) for part in values.split(",")]


def _value(text: str) -> Any:
    """A value as TOML has it, or the text itself."""
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except (tomllib.TOMLDecodeError, KeyError):
        return text


def _with(document: dict[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
    changed = copy.deepcopy(document)
    for key, value in values.items():
        *sections, last = key.split(".")
        table = changed
        for section in sections:
            table = table.setdefault(section, {})
            if not isinstance(table, dict):
                raise InputError(f"--set {key}: {section!r} is no section of the settings")
        table[last] = value
    return changed


def _anchored(document: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Settings whose paths are absolute."""
    for section, key in _PATHS:
        table = document.get(section, {})
        value = table.get(key)
        if isinstance(value, list):
            table[key] = [
                str(folder / log) if isinstance(log, str) else {**log, "file": str(folder / log["file"])}
                for log in value
            ]
        elif isinstance(value, str) and Path(value).suffix:
            table[key] = str(folder / value)
    return document
