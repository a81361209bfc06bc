"""Ingest, beside the logs: characteristic curves from a test stand in SI units, and the prior from siblings."""

from collections.abc import Mapping
from functools import partial
from pathlib import Path

from ..device.device import Device, device
from ..settings.prototype import Prototype
from ..store import layout
from ..store.columns import Column
from ..store.run_folder import RunFolder, Written
from ..store.schemas import Schema
from .engine import Task
from .prior_knowledge import MEANINGS, column_units, named_curves, read_measured_curves, read_siblings

ALGORITHM = "1"


def tasks(prototype: Prototype, prototype_file: Path) -> list[Task]:
    """A task for each file that the settings name."""
    curves = [
        _curves_task(prototype, layout.source(name, prototype_file), artifact)
        for name, artifact in named_curves(prototype)
    ]
    siblings = prototype.plant.siblings
    return curves if siblings is None else [*curves, _siblings_task(layout.source(siblings, prototype_file))]


def _curves_task(prototype: Prototype, path: Path, artifact: str) -> Task:
    return Task(
        stage="ingest",
        title="measured curves" if artifact == layout.CURVES else "known curves",
        algorithm=ALGORITHM,
        settings={"displacement": device(prototype).displacement.symbol},
        inputs=(),
        sources={path.name: path},
        named_in="compare.curves" if artifact == layout.CURVES else "plant.curves",
        outputs=(artifact,),
        work=partial(_write_curves, path=path, plant=device(prototype), artifact=artifact),
    )


def _write_curves(run: RunFolder, *, path: Path, plant: Device, artifact: str) -> Mapping[str, Written]:
    columns = read_measured_curves(path, plant)
    units = column_units(plant)
    schema = Schema(
        "curves",
        tuple(Column(name, "", units[name][0], MEANINGS.get(name, "displacement of the joint")) for name in columns),
    )
    return {artifact: run.write_table(artifact, schema, columns, {"source": path.name})}


def _siblings_task(path: Path) -> Task:
    return Task(
        stage="ingest",
        title="siblings",
        algorithm=ALGORITHM,
        settings={},
        inputs=(),
        sources={path.name: path},
        named_in="plant.siblings",
        outputs=(layout.SIBLINGS,),
        work=partial(_write_siblings, path=path),
    )


def _write_siblings(run: RunFolder, *, path: Path) -> Mapping[str, Written]:
    from ..models.hybrid.siblings import column

    return {layout.SIBLINGS: run.write_tree(layout.SIBLINGS, read_siblings(path), {"source": path.name}, column)}
