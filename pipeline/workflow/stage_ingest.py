"""Ingest and differentiate: raw logs to uniform records in SI units, and these to kinematics."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import get_args

from ..device.device import device
from ..device.parameters import JointParameters, parameter_set, parameter_values
from ..diagnostics.sentences import accepted_settings
from ..numerics.arrays import FloatArray
from ..settings.logs import Role
from ..settings.prototype import LogGate, Prototype
from ..signals.log import Corrections
from ..signals.uniform_record import Resampling
from ..store import layout, schemas
from ..store.run_folder import RunFolder, Written
from ..system.names import log_title, true_name
from ..system.worker_pool import OnProgress
from .engine import Task
from .run_contents import corrections
from .si_log import part_of_log, read_si
from .steps.ingest import corrected_log, examined, record_columns

ALGORITHM = "21"
DIFFERENTIATE_ALGORITHM = "7"


def tasks(prototype: Prototype, prototype_file: Path) -> list[Task]:
    """One task per log."""
    parameters = parameter_set(prototype, prototype_file) if device(prototype).angle else None
    return [
        _task(prototype, parameters, role, log, raw, corrections(prototype)[role, log])
        for (role, log, _), raw in zip(layout.logs(prototype), layout.raw_logs(prototype, prototype_file), strict=True)
    ]


def _task(
    prototype: Prototype,
    parameters: JointParameters | None,
    role: Role,
    log: str,
    raw: tuple[str, Path, tuple[float, float]],
    by: Corrections,
) -> Task:
    """The task of one log.

    Parameters
    ----------
    prototype : Prototype
        Settings.
    parameters : JointParameters or None
        Geometry of the joint, where its angle is logged.
    role, log : str
        Role of the log and its name in the run.
    raw : (str, Path, (float, float))
        The log as the settings name it, its file, and the span [s] that is read.
    by : Corrections
        Corrections of its instruments.
    """
    label, path, span = raw
    ends = {key: end for key, end in zip(("start_s", "stop_s"), span, strict=True) if math.isfinite(end)}
    return Task(
        stage="ingest",
        title=log_title(role, true_name(label)),
        algorithm=ALGORITHM,
        settings={
            "channels": prototype.channels.model_dump(mode="json"),
            "ingest": prototype.ingest.model_dump(mode="json"),
            "joint": prototype.may_be_a_joint,  # what its signals plausibly span
            **({"kinematics": parameter_values(parameters)} if parameters else {}),
            **({"part": ends} if ends else {}),
            **({"corrections": asdict(by)} if by.act else {}),
            **accepted_settings(prototype.quality, get_args(LogGate)),
        },
        inputs=(),
        sources={path.name: path},
        outputs=(layout.record(role, log), layout.signals(role, log)),
        work=partial(
            _ingest,
            prototype=prototype,
            parameters=parameters,
            path=path,
            span=span,
            by=by,
            outputs=(layout.record(role, log), layout.signals(role, log)),
        ),
        reports=True,
    )


def _ingest(
    run: RunFolder,
    on_progress: OnProgress,
    *,
    prototype: Prototype,
    parameters: JointParameters | None,
    path: Path,
    span: tuple[float, float],
    by: Corrections,
    outputs: tuple[str, str],
) -> Mapping[str, Written]:
    """Write the records of the part of a log that the settings name, corrected; see `_task`."""
    raw = part_of_log(read_si(path, prototype, parameters, partial(on_progress, "reading")), span, path)
    signals = corrected_log(raw, by) if by.act else raw
    on_progress("examining", 0.0)
    resamplings, notes = examined(signals, prototype, str(path))
    kinds = (schemas.RECORD, schemas.SIGNALS)
    return {
        name: run.write_pieces(
            name,
            schemas.schema_of(kind, device(prototype)),
            _pieces(resampling, tuple(signals.beside), on_progress),
            asdict(resampling.report) | notes,
        )
        for name, kind, resampling in zip(outputs, kinds, resamplings, strict=True)
    }


def _pieces(
    resampling: Resampling, names: Sequence[str], on_progress: OnProgress
) -> Iterator[Mapping[str, FloatArray]]:
    done = 0
    for piece in resampling.pieces():
        yield record_columns(piece, names)
        done += piece.t.size
        on_progress(f"resampling to {1e3 * resampling.report.interval:g} ms", done / resampling.report.rows)


def differentiate_tasks(prototype: Prototype) -> list[Task]:
    """One task per log."""
    return [
        Task(
            stage="differentiate",
            title=log_title(role, true_name(path)),
            algorithm=DIFFERENTIATE_ALGORITHM,
            settings={"differentiate": prototype.differentiate.model_dump(mode="json")},
            inputs=(layout.record(role, log), layout.signals(role, log)),
            outputs=(layout.kinematics(role, log),),
            work=partial(_differentiate, prototype=prototype, role=role, log=log),
        )
        for role, log, path in layout.logs(prototype)
    ]


def _differentiate(run: RunFolder, prototype: Prototype, role: Role, log: str) -> Mapping[str, Written]:
    from .steps.differentiate import kinematics

    columns, notes = kinematics(
        run.read_table(layout.signals(role, log)), run.read_table(layout.record(role, log)), prototype
    )
    name = layout.kinematics(role, log)
    return {name: run.write_table(name, schemas.schema_of(schemas.KINEMATICS, device(prototype)), columns, notes)}
