"""Files that settings name beside the logs: curves from a test stand (fig. 14), and the prior from other joints.

Stage `ingest` writes both into the run, in SI units.
"""

import csv
import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from ..device.device import JOINT, Device, device
from ..device.parameters import JointParameters
from ..errors import CorruptArtifactError, InputError
from ..fitting.population import NormalPopulation
from ..numerics.arrays import FloatArray
from ..settings.prototype import Prototype
from ..store import layout
from ..store.columns import Column
from ..store.run_folder import RunFolder, Written
from ..store.schemas import Schema
from ..store.trees import read_tree
from ..system.plain_files import read_plain
from ..units.units import to_si
from .engine import Task
from .steps.identify import PriorKnowledge

ALGORITHM = "1"
MOST_ROWS = 100_000
MEANINGS = {
    "F": "restoring force, positive where it pulls to the left",
    "d": "damping",
    "dC1_dq": "slope of the left membrane's capacitance",
    "dC2_dq": "slope of the right membrane's capacitance",
}

_HEADING = re.compile(r"\s*(?P<name>\w+)\s*\[(?P<unit>[^\]]+)\]\s*")


def named_files(prototype: Prototype) -> list[tuple[str, str, str]]:
    """The files that the settings name: key, artifact, and path; curves to compare with and to keep, and a prior."""
    named = (
        ("compare.curves", layout.CURVES, prototype.compare.curves),
        ("plant.curves", layout.KNOWN_CURVES, prototype.plant.curves),
        ("plant.siblings", layout.SIBLINGS, prototype.plant.siblings),
    )
    return [(key, artifact, name) for key, artifact, name in named if name is not None]


def column_units(plant: Device) -> dict[str, tuple[str, ...]]:
    """Allowed units of each column, in SI."""
    units = replace(JOINT, displacement=plant.displacement, known_mass=1.0).curve_units
    slope = (units["dC"],)
    return {"q": (plant.displacement.symbol,), "F": (units["F"],), "d": (units["d"],), "dC1_dq": slope, "dC2_dq": slope}


def read_measured_curves(path: Path, plant: Device) -> dict[str, FloatArray]:
    """Read a CSV file whose first line names columns with their units: ``q [mm], F [mN], dC1_dq [nF/m]``.

    Parameters
    ----------
    path : Path
        UTF-8, also as spreadsheets mark it (BOM), separated by commas, decimal points; lines that begin with # are left
        out. ``q`` and at least one of ``F``, ``d``, ``dC1_dq``, ``dC2_dq``; an empty cell is a place where that curve
        was not measured.
    plant : Device
        States whether q is a length or an angle.

    Returns
    -------
    dict of str to FloatArray, shape (n,)
        In SI units, q ascending; NaN where a cell is empty.

    Raises
    ------
    InputError
        The file cannot be read, a column or unit is unknown, or a cell is no number.
    """
    try:
        lines = read_plain(path).decode("utf-8-sig").splitlines()
        heading, *rows = list(csv.reader(line for line in lines if line.strip() and line[0] != "#")) or [[]]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise InputError(
            f"{path}: cannot be read as text: {error}; correct its name in the settings, or save it as 'CSV UTF-8'"
        ) from error
    units = column_units(plant)
    names = []
    factors = []
    for cell in heading:
        match = _HEADING.fullmatch(cell)
        if match is None or match["name"] not in units:
            raise InputError(f"{path}: column {cell!r}; write each of {', '.join(units)} as 'q [mm]', with its unit")
        names.append(match["name"])
        factors.append(to_si(match["unit"], units[match["name"]], f"{path}: column {match['name']}").factor)
    if "q" not in names or len(names) < 2 or len(set(names)) < len(names):
        raise InputError(f"{path}: it needs q and at least one of {', '.join(MEANINGS)}, each once")
    if not 2 <= len(rows) <= MOST_ROWS:
        raise InputError(f"{path}: it holds {len(rows)} rows; 2 to {MOST_ROWS} are read")
    values = np.array([_row(path, number, row, len(names)) for number, row in enumerate(rows, 2)]) * factors
    if not np.all(np.isfinite(values[:, names.index("q")])):
        raise InputError(f"{path}: q is empty in a row; give every row its displacement")
    order = np.argsort(values[:, names.index("q")], kind="stable")
    return {name: values[order, names.index(name)] for name in units if name in names}


def _row(path: Path, number: int, row: list[str], width: int) -> list[float]:
    if len(row) != width:
        raise InputError(f"{path}: row {number} has {len(row)} cells, the heading {width}")
    try:
        values = [float(cell) if cell.strip() else float("nan") for cell in row]
    except ValueError:
        raise InputError(f"{path}: row {number} holds something that is no number: {','.join(row)[:60]!r}") from None
    if any(np.isinf(value) for value in values):
        raise InputError(f"{path}: row {number} holds an infinite number")
    return values


def read_siblings(path: Path) -> dict[str, Any]:
    """The tree of a file of `debist fleet learn`, checked.

    Raises
    ------
    InputError
        There is no such file, or it is no prior of `debist fleet learn`.
    """
    from ..models.hybrid.siblings import from_tree

    try:
        tree = read_tree(path)
        from_tree(tree)
    except CorruptArtifactError as error:
        raise InputError(f"{path}: is no whole prior of other joints; `debist fleet learn` writes one") from error
    return tree


def taught(tree: dict[str, Any], parameters: JointParameters | None) -> NormalPopulation:
    """Prior from other joints, from the tree of its file.

    Raises
    ------
    InputError
        They were learnt about another parameter set than that of the settings.
    """
    from ..models.hybrid.siblings import from_tree

    about, population, _ = from_tree(tree)
    if parameters is None or about != parameters:
        raise InputError("plant.siblings: was learnt about another parameter set than plant.parameters; use that one")
    return population


def known_inputs(prototype: Prototype) -> tuple[str, ...]:
    """The artifacts of what a fit takes beside the logs: curves that it keeps, and the prior of other joints."""
    return tuple(artifact for key, artifact, _ in named_files(prototype) if key.startswith("plant."))


def prior_knowledge_of(run: RunFolder, prototype: Prototype, parameters: JointParameters | None) -> PriorKnowledge:
    """Prior knowledge beside the logs.

    Raises
    ------
    InputError
        The other joints have another parameter set.
    """
    named = known_inputs(prototype)
    return PriorKnowledge(
        run.read_table(layout.KNOWN_CURVES) if layout.KNOWN_CURVES in named else None,
        taught(run.read_tree(layout.SIBLINGS), parameters) if layout.SIBLINGS in named else None,
    )


def prior_knowledge_in(settings_file: Path, prototype: Prototype, parameters: JointParameters | None) -> PriorKnowledge:
    """Prior knowledge beside signals in memory: the files that the settings name, relative to a settings file.

    Raises
    ------
    InputError
        A file is missing or cannot be read, or the other joints have another parameter set.
    """
    curves = prototype.plant.curves
    siblings = prototype.plant.siblings
    return PriorKnowledge(
        None if curves is None else read_measured_curves(layout.source(curves, settings_file), device(prototype)),
        None if siblings is None else taught(read_siblings(layout.source(siblings, settings_file)), parameters),
    )


def tasks(prototype: Prototype, prototype_file: Path) -> list[Task]:
    """A task for each file that the settings name."""
    plant = device(prototype)
    of_curves = ({"displacement": plant.displacement.symbol}, partial(_write_curves, plant=plant))
    kinds: dict[str, tuple[str, dict[str, Any], Callable[..., Mapping[str, Written]]]] = {
        layout.CURVES: ("measured curves", *of_curves),
        layout.KNOWN_CURVES: ("known curves", *of_curves),
        layout.SIBLINGS: ("siblings", {}, _write_siblings),
    }
    made = []
    for key, artifact, name in named_files(prototype):
        path = layout.source(name, prototype_file)
        title, settings, write = kinds[artifact]
        made.append(
            Task(
                stage="ingest",
                title=title,
                algorithm=ALGORITHM,
                settings=settings,
                inputs=(),
                outputs=(artifact,),
                work=partial(write, path=path, artifact=artifact),
                sources={path.name: path},
                named_in=key,
            )
        )
    return made


def _write_curves(run: RunFolder, *, path: Path, plant: Device, artifact: str) -> Mapping[str, Written]:
    columns = read_measured_curves(path, plant)
    units = column_units(plant)
    schema = Schema(
        "curves",
        tuple(Column(name, "", units[name][0], MEANINGS.get(name, "displacement of the joint")) for name in columns),
    )
    return {artifact: run.write_table(artifact, schema, columns, {"source": path.name})}


def _write_siblings(run: RunFolder, *, path: Path, artifact: str) -> Mapping[str, Written]:
    from ..models.hybrid.siblings import column

    return {artifact: run.write_tree(artifact, read_siblings(path), {"source": path.name}, column)}
