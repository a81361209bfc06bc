"""Settings of the raw logs: which files, which parts of them, and which channel is which signal."""

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal

from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Discriminator,
    Field,
    Strict,
    Tag,
    field_validator,
    model_validator,
)

from ..errors import InputError
from ..system.names import true_name
from ..units.units import DISPLACEMENT, FILL_IN, TIME, parse_quantity


def _not_zero(value: float) -> float:
    if value == 0.0:
        raise ValueError("must not be 0: the channel would be constant")
    return value


# Numbers are written as numbers: true, "0.01", inf and nan are refused.
Number = Annotated[float, Strict(), Field(allow_inf_nan=False)]
Factor = Annotated[Number, AfterValidator(_not_zero)]
Whole = Annotated[int, Strict()]

Role = Literal["train", "validation"]
ROLES: tuple[Role, ...] = ("train", "validation")


class SettingsTable(BaseModel):
    """A table of a settings file: frozen, without unknown keys; each field has its description below it."""

    model_config = ConfigDict(frozen=True, extra="forbid", use_attribute_docstrings=True)
    gone: ClassVar[Mapping[str, str]] = {}
    """Keys that an earlier release had, and what to write instead."""


class LogColumn(SettingsTable):
    """One column of the raw log."""

    channel: str = Field(min_length=1, max_length=1000)
    """Name of the channel in the log."""
    unit: str = Field(min_length=1, max_length=100)
    """Unit of the channel's numbers in pint notation, such as mm, kV, s, deg; mandatory."""
    scale: Factor = 1.0
    """Unit per number of the log, for a log in volts of its data acquisition: value = scale · number + offset."""
    offset: Number = 0.0
    """Summand after that, in the channel's unit."""
    missing: tuple[Number, ...] | None = None
    """Numbers of the log that stand for no value, such as [-9999]. Left out, numbers of 1e20 and more are taken for
    such, and usual codes (-9999, 65535, …) that lie further from the rest than that is wide; [] keeps all."""

    @field_validator("channel")
    @classmethod
    def _filled_in(cls, value: str) -> str:
        if value == FILL_IN:
            raise ValueError("is still to be filled in; `debist inspect LOG` lists the channels of a log")
        return value


class Channel(LogColumn):
    """One channel of the raw log."""

    part: Literal["all", "positive", "negative"] = "all"
    """Part of a signed monitor of both membranes that is this input: its "positive" values, or its "negative" ones
    without their sign; of an input only."""
    on_change: bool = False
    """True if the log has a sample only at each change, which holds until the next one (event-based recording); of
    an input only."""
    average: Number = Field(default=0.0, ge=0.0, le=10.0)
    """Window [s] over which the sensor of q averages before each sample, as some lasers do: half of it is taken off the
    channel's time, by which it lags the motion; of q only. Motion within the window stays smoothed."""
    time: LogColumn | None = None
    """The channel's own time, where a table has several: its column and unit; `[channels] time` by default."""


class Gains(SettingsTable):
    """Factors that make the readings of a log true."""

    q: Factor = 1.0
    """Factor on q."""
    v1: Factor = 1.0
    """Factor on the first input."""
    v2: Factor = 1.0
    """Factor on the second input."""


class LogPart(SettingsTable):
    """A recording with corrections of its readings, or a part of one: the samples from `start` to before `stop`, by the
    time that the log itself has.
    """

    file: str = Field(min_length=1)
    """The log."""
    start: str | None = None
    """Start of the part, as "12 s"; left out, that of the log."""
    stop: str | None = None
    """End of the part, as "49.5 s"; left out, that of the log."""
    gain: Gains = Gains()
    """Factors on readings of this log, as { v1 = 1.053 }: what its instruments read too low."""
    zero: str = "0"
    """Summand to q after its gain, as "0.3 mm"."""
    delay: str = "0"
    """Time by which the inputs are delayed, as "5 ms"; negative where they were recorded late."""
    clock: Number = Field(default=1.0, gt=0.0)
    """Factor on the time of this log, as 0.99 where its clock runs fast."""

    @field_validator("start", "stop", "zero", "delay", mode="before")
    @classmethod
    def _has_a_unit(cls, value: Any) -> Any:
        if isinstance(value, int | float):
            raise ValueError(f'needs its unit in quotes, as "{value:g} s" of a time or "{value:g} mm" of a zero')
        return value

    @model_validator(mode="after")
    def _lasts(self) -> "LogPart":
        try:
            start, stop = self.span
            parse_quantity(self.zero, DISPLACEMENT, "zero")
            parse_quantity(self.delay, TIME, "delay")
        except InputError as error:
            raise ValueError(str(error)) from None
        if not start < stop:
            raise ValueError(f"stop = {self.stop!r} is not after start = {self.start!r}; correct one of them")
        return self

    @property
    def span(self) -> tuple[float, float]:
        """Start and end of the part [s]."""
        return (
            -math.inf if self.start is None else parse_quantity(self.start, TIME, "start"),
            math.inf if self.stop is None else parse_quantity(self.stop, TIME, "stop"),
        )

    @property
    def label(self) -> str:
        """Name for readers, in place of a file's name: ``long from 12 s to 49.5 s.mf4``."""
        ends = [f"from {self.start}"] * (self.start is not None) + [f"to {self.stop}"] * (self.stop is not None)
        return " ".join([true_name(self.file), *ends]) + (Path(self.file).suffix or ".log")


Log = Annotated[
    Annotated[str, Tag("str")] | Annotated[LogPart, Tag("LogPart")],
    Discriminator(lambda log: "LogPart" if isinstance(log, dict | LogPart) else "str"),
]
"""A raw log, or a part of it, or one with corrections."""


def log_label(log: Log) -> str:
    """Name of a log: its path, or `LogPart.label`."""
    return log if isinstance(log, str) else log.label


class Logs(SettingsTable):
    """Raw logs, as paths relative to the settings file, parts of them: { file, start, stop }, or logs whose readings
    are corrected: { file, gain, zero, delay, clock }.
    """

    train: tuple[Log, ...] = Field(min_length=1)
    """Logs on which the models are identified; a part of one is { file = "long.mf4", start = "12 s", stop = "49.5 s" },
    by the log's own time."""
    validation: tuple[Log, ...] = ()
    """Logs that no identification uses; parts of a recording too, where none of it is for training."""


class Channels(SettingsTable):
    """Channels of the signals in the logs."""

    time: LogColumn | None = None
    """Time; left out where the format carries its own time base."""
    q: Channel
    """Displacement of the joint: a length or an angle, or the voltage that stands for it in a circuit."""
    qdot: Channel | None = None
    """Velocity of q where it was measured too (a tachometer, a gyroscope, a laser vibrometer), in the unit of q per
    time as in mm/s or deg/s: derivatives and the fit of `rbf` then rest on it as well."""
    v1: Channel
    """First input: voltage of the left membrane."""
    v2: Channel | None = None
    """Second input: voltage of the right membrane; left out for a device with one input."""

    @model_validator(mode="after")
    def _each_its_own(self) -> "Channels":
        named: dict[tuple[str, str], str] = {}
        for key in ("time", "q", "qdot", "v1", "v2"):
            if (column := getattr(self, key)) is None:
                continue
            part = getattr(column, "part", "all")
            other = named.setdefault((column.channel, part), key)
            if other not in (key, "v1"):
                raise ValueError(f"{key} and {other} are the same channel {column.channel!r}")
            if key in ("q", "qdot") and (part != "all" or column.on_change):
                why = "is no signed input" if part != "all" else "cannot be recorded on change only"
                raise ValueError(f"{key} {why}: between two samples it moves")
            if key != "q" and isinstance(column, Channel) and column.average:
                raise ValueError(f"{key} has no average: that is for q, whose sensor is the one that lags")
        if self.v2 == self.v1:
            raise ValueError(
                f"v1 and v2 are the same channel {self.v1.channel!r}; leave v2 out for a single input, or give both "
                "their `part` of a signed monitor"
            )
        return self

    @property
    def inputs(self) -> tuple[Channel, ...]:
        """The input channels in order."""
        return (self.v1,) if self.v2 is None else (self.v1, self.v2)
