"""Ingest, beside the logs: the prior from siblings, checked and filed."""

from collections.abc import Mapping
from functools import partial
from pathlib import Path

from pipeline.loading.siblings import read_siblings
from pipeline.runs import layout
from pipeline.runs.engine import Task
from pipeline.runs.run_folder import RunFolder, Written
from pipeline.settings import Prototype

ALGORITHM = "1"


def tasks(prototype: Prototype, prototype_file: Path) -> list[Task]:
    """A task for the file that the settings name, if they name one."""
    if prototype.plant.siblings is None:
        return []
    path = layout.source(prototype.plant.siblings, prototype_file)
    return [
        Task(
            stage="ingest",
            title="siblings",
            algorithm=ALGORITHM,
            settings={},
            inputs=(),
            sources={path.name: path},
            named_in="plant.siblings",
            outputs=(layout.SIBLINGS,),
            work=partial(_work, path=path),
        )
    ]


def _work(run: RunFolder, *, path: Path) -> Mapping[str, Written]:
    from pipeline.models.hybrid.siblings import column

    return {layout.SIBLINGS: run.write_tree(layout.SIBLINGS, read_siblings(path), {"source": path.name}, column)}
