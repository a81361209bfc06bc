"""Differentiate: velocity and acceleration of every log, segment by segment."""

from collections.abc import Mapping
from functools import partial

from ..device.device import device
from ..settings.logs import Role
from ..settings.prototype import Prototype
from ..store import layout, schemas
from ..store.run_folder import RunFolder, Written
from ..system.names import log_title, true_name
from .engine import Task
from .steps.differentiate import kinematics

ALGORITHM = "7"


def tasks(prototype: Prototype) -> list[Task]:
    """One task per log."""
    return [_task(prototype, role, log, log_title(role, true_name(path))) for role, log, path in layout.logs(prototype)]


def _task(prototype: Prototype, role: Role, log: str, title: str) -> Task:
    return Task(
        stage="differentiate",
        title=title,
        algorithm=ALGORITHM,
        settings={"differentiate": prototype.differentiate.model_dump(mode="json")},
        inputs=(layout.record(role, log), layout.signals(role, log)),
        outputs=(layout.kinematics(role, log),),
        work=partial(_differentiate, prototype=prototype, role=role, log=log),
    )


def _differentiate(run: RunFolder, prototype: Prototype, role: Role, log: str) -> Mapping[str, Written]:
    signals = run.read_table(layout.signals(role, log))
    fine = run.read_table(layout.record(role, log))
    columns, notes = kinematics(signals, fine, prototype)
    name = layout.kinematics(role, log)
    return {name: run.write_table(name, schemas.schema_of(schemas.KINEMATICS, device(prototype)), columns, notes)}
