"""Inspection: contents of a raw log, its excitation once its channels are named, and experiments to add."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from pydantic import ValidationError

from ..device.device import Device, device
from ..device.parameters import JointParameters, parameter_set
from ..errors import DebistError, InputError
from ..fitting.excitation import Excitation, examine_excitation
from ..fitting.information import FEW
from ..numerics.arrays import runs_of
from ..rig_logs.channel_roles import suggested_unit
from ..rig_logs.inspection import NO_CHANNEL, Inspection, inspect_log
from ..rig_logs.source import CsvOptions
from ..scoring.wells import NoWells, Wells
from ..settings.prototype import Prototype, load_prototype
from ..signals.findings import Finding
from ..signals.survey import survey
from ..signals.uniform_record import Resampling
from ..store.run_folder import RunFolder
from ..system.names import shell_word
from ..units.quantity import scale
from . import stage_ingest as ingest
from .engine import Observer, bring_up_to_date
from .place import load_settings
from .si_log import read_si
from .stage_check import examine

LEAST_SWITCHES = 5
"""Snaps in either direction: each lasts 0.1 s, and nothing else shows the curves between the wells."""
LEAST_LARGEST = 0.8
"""Share of the other input's largest value: the force goes with the square, so 0.8 is two thirds of it."""


@dataclass(frozen=True)
class Shortfall:
    """Missing excitation, and advice what to add."""

    finding: str
    add: str


def shortfalls(
    excitation: Excitation, names: Sequence[str], factor: float, unit: str, plant: Device
) -> list[Shortfall]:
    """Everything that falls short. A device other than the joint needs no two wells.

    Parameters
    ----------
    excitation : Excitation
        Excitation of a log, in SI.
    names : sequence of str
        Names of the inputs.
    factor : float
        Printed number over the value in SI.
    unit : str
        Unit in which q is printed.
    plant : Device
        Its inputs, and whether it is the joint.
    """
    return [
        *(_wells(excitation, names) if plant.joint else ()),
        *_centres(excitation, factor, unit),
        *_driven(excitation, names, factor, unit),
        *_largest(excitation, names, plant=plant),
    ]


def _wells(excitation: Excitation, names: Sequence[str]) -> Iterator[Shortfall]:
    every = " and ".join(names)
    if isinstance(excitation.wells, NoWells):
        add = f"full pulses of {every}, 1 to 2 s long, with rests of 1 s, that send it into the other well"
        yield Shortfall(f"no two wells: {excitation.wells.reason}", f"{add}; nothing, if the device is not bistable")
        return
    for count, where in zip(excitation.switches, ("left to right", "right to left"), strict=True):
        if count < LEAST_SWITCHES:
            add = f"pulses of {every} in turn until it has snapped at least {LEAST_SWITCHES} times each way"
            yield Shortfall(f"it snaps from {where} {count} times only", add)


def _centres(excitation: Excitation, factor: float, unit: str) -> Iterator[Shortfall]:
    poor = excitation.visits.visits < FEW
    for rows in runs_of(poor):
        fewest = int(excitation.visits.visits[rows].min())
        if rows.start == 0 or rows.stop == len(poor):
            add = "full pulses in quick succession, so that it overshoots; or fewer basis functions"
        elif isinstance(excitation.wells, Wells):
            add = "pulses near the switching voltage and chirps, which linger between the wells"
        else:
            add = "chirps, random steps and pulses of all sizes, which lead it there"
        yield Shortfall(f"{_places(excitation, rows, factor, unit)}: {fewest} samples, below {FEW}", add)


def _driven(excitation: Excitation, names: Sequence[str], factor: float, unit: str) -> Iterator[Shortfall]:
    for k, name in enumerate(names):
        for rows in runs_of((excitation.visits.driven[k] < FEW) & (excitation.visits.visits >= FEW)):
            place = _places(excitation, rows, factor, unit)
            yield Shortfall(
                f"{name} hardly acts at {place}: its gain there is a guess",
                f"pulses of {name}, also weak ones, while q is or swings there",
            )


def _largest(excitation: Excitation, names: Sequence[str], plant: Device) -> Iterator[Shortfall]:
    top = float(excitation.largest.max())
    for k, name in enumerate(names):
        if excitation.largest[k] == 0.0:
            yield Shortfall(f"{name} never acts", f"pulses of {name}")
        elif plant.joint and excitation.largest[k] < LEAST_LARGEST * top:
            yield Shortfall(
                f"{name} reaches {100 * excitation.largest[k] / top:.0f} % of the other input only",
                f"pulses of {name} up to the same limit",
            )


def _places(excitation: Excitation, rows: slice, factor: float, unit: str) -> str:
    places = factor * excitation.centres[rows]
    return f"q = {places[0]:.1f} {unit}" if len(places) == 1 else f"q = {places[0]:.1f} … {places[-1]:.1f} {unit}"


@dataclass(frozen=True)
class LogExcitation:
    """Excitation of a log, and its shortfalls.

    Attributes
    ----------
    excitation : Excitation
        In SI.
    inputs : tuple of str
        Names of the input channels.
    assumed : bool
        True if the channels were taken by their names and units, not from settings.
    shortfalls : list of Shortfall
        Missing excitation, each with advice.
    interval : float
        Interval [s] of the samples that were counted.
    factor, unit : float, str
        Scale and unit in which q is shown: `factor` × SI.
    plant : Device
        Its inputs, and whether it is the joint.
    """

    excitation: Excitation
    inputs: tuple[str, ...]
    assumed: bool
    shortfalls: list[Shortfall]
    interval: float
    factor: float
    unit: str
    plant: Device

    @property
    def rests(self) -> tuple[float, float] | None:
        """Left and right rest position in the unit that is shown; None where there are no two wells."""
        wells = self.excitation.wells
        return (self.factor * wells.left, self.factor * wells.right) if isinstance(wells, Wells) else None


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
        inspection = inspect_log(log, csv=CsvOptions(**prototype.ingest.csv.model_dump()))
        return inspection, _excitation(log, prototype, parameter_set(prototype, settings))
    inspection = inspect_log(log)
    try:
        return inspection, replace(_excitation(log, _supposed(inspection), None), assumed=True)
    except DebistError as reason:
        return inspection, str(reason)


def _excitation(log: Path, prototype: Prototype, parameters: JointParameters | None) -> LogExcitation:
    """The excitation of a log whose channels the settings name."""
    plant = device(prototype)
    ingest = prototype.ingest
    signals = read_si(log, prototype, parameters)
    record = Resampling(survey(signals.q, signals.beside, time_reversal="split"), ingest.sample_interval).record()
    excitation = examine_excitation(
        record.q,
        record.v[:, : len(plant.inputs)],
        record.segment.astype(np.int64),
        ingest.sample_interval,
        plant,
        basis_functions=prototype.identify.basis_functions,
        smoothing=prototype.identify.smoothing,
    )
    unit, factor = scale(plant.displacement.symbol, float(np.nanmax(np.abs(record.q))))
    names = tuple(channel.channel for channel in prototype.channels.inputs)
    return LogExcitation(
        excitation=excitation,
        inputs=names,
        assumed=False,
        shortfalls=shortfalls(excitation, names, factor, unit, plant=plant),
        interval=ingest.sample_interval,
        factor=factor,
        unit=unit,
        plant=plant,
    )


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
    name = shell_word(inspection.path)
    settings = f"fill in what `debist init {name} -o P.toml` writes, then `debist inspect {name} --settings P.toml`"
    for role in inspection.suggestions:
        if role.role == "v2" and not role.candidates:
            continue
        if role.only is None or not units[role.only]:
            what = "its unit is not stated" if role.only else "no single channel stands out"
            raise InputError(f"which channel is {role.role} is not clear ({what}); {settings}")
        channels[role.role] = {"channel": role.only, "unit": units[role.only]}
    try:
        return Prototype.model_validate({"name": "log", "logs": {"train": ["log"]}, "channels": channels})
    except ValidationError as error:
        raise InputError(f"the channels are not clear; {settings}") from error


def check(place: Path, observer: Observer) -> tuple[Prototype, list[Finding]]:
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
