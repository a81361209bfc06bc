"""Ingest: raw logs to uniform records in SI units."""

from collections.abc import Mapping
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pipeline.artifacts import schemas
from pipeline.artifacts.run_folder import RunFolder, Written
from pipeline.errors import DataRefusedError, InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.settings import Channel, Ingest, Prototype, Role
from pipeline.stages import layout
from pipeline.stages.device import Device, device
from pipeline.stages.engine import Task
from pipeline.units import DISPLACEMENT, INPUT, TIME, SiUnit, to_si

if TYPE_CHECKING:
    from pipeline.numerics.sampling.uniform_record import UniformRecord
    from pipeline.rig_logs import Channel as LogChannel

ALGORITHM = "1"


def tasks(prototype: Prototype, prototype_file: Path) -> list[Task]:
    """One task per log."""
    return [
        _task(prototype, role, log, layout.source(path, prototype_file)) for role, log, path in layout.logs(prototype)
    ]


def _task(prototype: Prototype, role: Role, log: str, path: Path) -> Task:
    return Task(
        stage="ingest",
        title=f"{role}/{log}",
        algorithm=ALGORITHM,
        settings={
            "channels": prototype.channels.model_dump(mode="json"),
            "ingest": prototype.ingest.model_dump(mode="json"),
        },
        inputs=(),
        sources={path.name: path},
        outputs=(layout.record(role, log), layout.signals(role, log)),
        work=partial(_ingest, prototype=prototype, role=role, log=log, path=path),
    )


def _ingest(run: RunFolder, prototype: Prototype, role: Role, log: str, path: Path) -> Mapping[str, Written]:
    from pipeline.numerics.sampling.timebase import nominal_step
    from pipeline.numerics.sampling.uniform_record import uniform_record

    plant = device(prototype)
    time, q, v, v_time = read_si(path, prototype, plant)
    settings = prototype.ingest
    warnings = _warnings(time, q, v, plant)
    written = {}
    for name, schema, interval in (
        (layout.record(role, log), schemas.RECORD, record_interval(settings, nominal_step(time))),
        (layout.signals(role, log), schemas.SIGNALS, settings.sample_interval),
    ):
        try:
            uniform = uniform_record(
                time, q, v, interval, v_time=v_time, gaps=settings.gaps, time_reversal=settings.time_reversal
            )
        except DataRefusedError as error:
            raise DataRefusedError(f"{path}: {error}") from error
        written[name] = run.write_table(
            name, plant.schema(schema), _columns(uniform), asdict(uniform.report) | {"warnings": warnings}
        )
    return written


def _warnings(time: FloatArray, q: FloatArray, v: FloatArray, plant: Device) -> list[str]:
    """What is suspicious about the signals; nothing is corrected."""
    from pipeline.numerics.sampling.signal_quality import examine_signal, scale_suspicion
    from pipeline.numerics.sampling.timebase import nominal_step
    from pipeline.rig_logs.inspection import remarks_on

    found = [f"q: {remark}" for remark in remarks_on(examine_signal(time, q, nominal_step(time)))]
    columns = [("q", q, plant.displacement)] + [
        (f"v{k}", column, unit) for k, (column, unit) in enumerate(zip(v.T, plant.inputs, strict=True), start=1)
    ]
    for name, values, unit in columns:
        span = float(np.nanmax(values) - np.nanmin(values)) if np.isfinite(values).any() else 0.0
        factor = scale_suspicion(span, unit.symbol)
        if factor is not None:
            size = f"{factor:g}× too large" if factor > 1.0 else f"{1.0 / factor:g}× too small"
            found.append(f"{name} spans {span:.3g} {unit.symbol} and looks {size}: check its unit in [channels]")
    return found


def record_interval(settings: Ingest, raw_step: float) -> float:
    """Interval [s] of the fine record: a whole fraction of the sample interval, never finer than the log."""
    finest = max(settings.record_interval, raw_step * (1.0 - 1e-3))
    return settings.sample_interval / max(1, int(settings.sample_interval / finest + 1e-9))


def _columns(uniform: "UniformRecord") -> dict[str, FloatArray]:
    inputs = {f"v{i}": np.ascontiguousarray(column) for i, column in enumerate(uniform.v.T, start=1)}
    return {"t": uniform.t, "q": uniform.q, **inputs, "segment": uniform.segment}


def read_si(
    path: Path, prototype: Prototype, plant: Device
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray | None]:
    """Time [s], displacement, inputs (N, k) in SI, and the inputs' own time base where they have one.

    Raises
    ------
    InputError
        The log cannot be read, lacks a channel or a time base, or contradicts a unit of the settings.
    """
    from pipeline.rig_logs import CsvOptions, read_recording

    channels, csv = prototype.channels, prototype.ingest.csv
    wanted = [channel for channel in (channels.time, channels.q, *channels.inputs) if channel is not None]
    recording = read_recording(
        path, channels=[channel.channel for channel in wanted], csv=CsvOptions(**csv.model_dump())
    )

    def si(channel: Channel, unit: SiUnit) -> FloatArray:
        found = recording.channel(channel.channel)
        _check_unit(path, found, channel.unit, unit)
        return found.samples if unit.factor == 1.0 else found.samples * unit.factor

    q = si(channels.q, plant.displacement)
    inputs = [si(channel, unit) for channel, unit in zip(channels.inputs, plant.inputs, strict=True)]
    if channels.time is not None and plant.time is not None:
        return si(channels.time, plant.time), q, np.column_stack(inputs), None
    time = recording.channel(channels.q.channel).time
    bases = [recording.channel(channel.channel).time for channel in channels.inputs]
    if time is None or any(base is None for base in bases):
        raise InputError(
            f"{path}: the format carries no time base; name the time channel as [channels] time "
            f"(the log has {', '.join(recording.listed)})"
        )
    first = np.asarray(bases[0])
    rows = [
        column if _same(np.asarray(base), first) else np.interp(first, np.asarray(base), column)
        for base, column in zip(bases, inputs, strict=True)
    ]
    return time, q, np.column_stack(rows), None if _same(first, time) else first


def _same(one: FloatArray, other: FloatArray) -> bool:
    return one is other or np.array_equal(one, other)


def _check_unit(path: Path, channel: "LogChannel", unit: str, resolved: SiUnit) -> None:
    """Refuse a log whose own unit contradicts the settings; a unit the log words in its own way is let pass."""
    stated = channel.unit.strip("[]() ")
    if not stated:
        return
    try:
        own = to_si(stated, (*DISPLACEMENT, *INPUT, *TIME), "")
    except InputError:
        return
    if own.symbol != resolved.symbol or not np.isclose(own.factor, resolved.factor, rtol=1e-9):
        raise InputError(
            f"{path}: channel {channel.name!r} is in {channel.unit} by the log, but in {unit} by the settings; "
            "correct the unit in [channels]"
        )
