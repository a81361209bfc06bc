"""Inspection: what a raw log holds, and what it excites once it is known which channel is which."""

from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import ValidationError

from pipeline.device_facts.excitation_advice import Shortfall, shortfalls
from pipeline.errors import DebistError, InputError
from pipeline.fitting.excitation import Excitation, examine_excitation
from pipeline.loading.device import device
from pipeline.loading.parameter_sets import parameter_set
from pipeline.loading.si_log import read_si
from pipeline.rig_logs.channel_roles import suggested_unit
from pipeline.rig_logs.inspection import NO_CHANNEL, Inspection, inspect_log
from pipeline.rig_logs.source import CsvOptions
from pipeline.runs.engine import Observer, bring_up_to_date
from pipeline.runs.run_folder import RunFolder
from pipeline.settings import Prototype, load_prototype
from pipeline.si_prefix import scale
from pipeline.stages import ingest
from pipeline.stages.check import examine
from pipeline.stages.run_place import load_settings

if TYPE_CHECKING:
    from pipeline.checks.rows import CheckRow


@dataclass(frozen=True)
class LogExcitation:
    """What a log excites, and what it lacks.

    Attributes
    ----------
    excitation : Excitation
        In SI.
    inputs : tuple of str
        Names of the input channels.
    assumed : bool
        Whether the channels were taken by their names and units, not from settings.
    shortfalls : list of Shortfall
        What was not excited and what to add.
    interval : float
        Interval [s] of the samples that were counted.
    factor, unit : float, str
        In what q is shown: `factor` × SI.
    joint : bool
        Whether the device can be the bistable joint.
    """

    excitation: Excitation
    inputs: tuple[str, ...]
    assumed: bool
    shortfalls: list[Shortfall]
    interval: float
    factor: float
    unit: str
    joint: bool


def inspect(log: Path, settings: Path | None = None) -> tuple[Inspection, LogExcitation | str]:
    """Describe a log, with its excitation or the reason why there is none.

    Without settings the channels are taken by their names and units where these leave no doubt; nothing but this
    description rests on it.

    Raises
    ------
    DebistError
        The log cannot be read; with settings: they do not fit it.
    """
    if settings is not None:
        prototype = load_prototype(settings)
        csv = CsvOptions(**prototype.ingest.csv.model_dump())
        return inspect_log(log, csv=csv), _excitation(log, prototype, assumed=False)
    inspection = inspect_log(log)
    try:
        return inspection, _excitation(log, _supposed(inspection), assumed=True)
    except DebistError as reason:
        return inspection, str(reason)


def _excitation(log: Path, prototype: Prototype, *, assumed: bool) -> LogExcitation:
    from pipeline.signals.uniform_record import Resampling, survey

    plant, ingest = device(prototype), prototype.ingest
    signals = read_si(log, prototype, plant)
    record = Resampling(survey(signals.q, signals.beside, time_reversal="split"), ingest.sample_interval).record()
    excitation = examine_excitation(
        record.q,
        record.v[:, : len(plant.inputs)],
        record.segment.astype(np.int64),
        ingest.sample_interval,
        inputs=plant.action,
        basis_functions=prototype.identify.basis_functions,
        smoothing=prototype.identify.smoothing,
        joint=plant.joint,
    )
    unit, factor = scale(plant.displacement.symbol, float(np.nanmax(np.abs(record.q))))
    names = tuple(channel.channel for channel in prototype.channels.inputs)
    lacking = shortfalls(excitation, names, factor, unit, joint=plant.joint)
    return LogExcitation(excitation, names, assumed, lacking, ingest.sample_interval, factor, unit, plant.joint)


def _supposed(inspection: Inspection) -> Prototype:
    """Settings from the suggestions, if each role has one candidate and a unit.

    Raises
    ------
    InputError
        Something is in doubt.
    """
    if not inspection.channels:
        raise InputError(NO_CHANNEL)
    units = {channel.name: suggested_unit(channel.name, channel.unit) for channel in inspection.channels}
    channels: dict[str, Any] = {}
    log = inspection.path
    settings = f"fill in what `debist init {log} > P.toml` writes, then `debist inspect {log} --settings P.toml`"
    for role in inspection.suggestions:
        if role.role == "v2" and not role.candidates:
            continue
        if role.only is None or not units[role.only]:
            what = "its unit is not stated" if role.only else "no single channel stands out"
            raise InputError(f"which channel is {role.role} is not clear ({what}); {settings}")
        channels[role.role] = {"channel": role.only, "unit": units[role.only]}
    document = {"name": "log", "logs": {"train": ["log"]}, "channels": channels}
    try:
        return Prototype.model_validate(document)
    except ValidationError as error:
        raise InputError(f"the channels are not clear; {settings}") from error


def check(place: Path, observer: Observer) -> "tuple[Prototype, list[CheckRow]]":
    """Look at the logs of a settings file, or again at those that a run folder holds.

    Raises
    ------
    DebistError
        Bad settings, a log that cannot be read or that ingest refuses.
    """
    if place.is_dir():
        run = RunFolder.open(place)
        prototype = run.prototype
        return prototype, examine(run, prototype)
    prototype = load_settings(place)
    parameter_set(prototype, place)  # its name, before the logs are read
    with TemporaryDirectory(prefix="debist-check-") as folder:
        run = RunFolder.create(Path(folder) / "run", prototype.model_dump(mode="json"), place)
        bring_up_to_date(run, ingest.tasks(prototype, place), observer)
        return prototype, examine(run, prototype)
