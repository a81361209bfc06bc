"""Mistakes of a first week on a rig: what is done, what is said, and where.

The page of the docs is made from it while the site is built (docs/hooks.py).
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from pipeline.device.device import device
from pipeline.diagnostics.check import check_logs
from pipeline.diagnostics.copies import shared_recordings
from pipeline.diagnostics.sentences import sentences
from pipeline.errors import DebistError
from pipeline.numerics.arrays import FloatArray
from pipeline.settings.prototype import parse_prototype
from pipeline.signals.columns import Signal
from pipeline.signals.log import RawLog
from pipeline.workflow.stage_check import log_signals
from pipeline.workflow.steps.ingest import examined, record_columns
from tests.double_well import DoubleWell
from tests.prototypes import motion

RATE = 1000.0
HEAD = """# Mistakes of the first week

Each row is a test: the mistake is made in a small simulated log, and debist says what stands beside it.
"""


@dataclass(frozen=True)
class Log:
    """A log in SI units: times [s], displacement [m] and inputs [V]."""

    t: FloatArray
    q: FloatArray
    v: FloatArray


@dataclass(frozen=True)
class Mistake:
    """One mistake: what is done, a part of what is said, where, and how it is made."""

    done: str
    said: str
    where: str
    tell: Callable[[], Sequence[str]]


@cache
def log(seed: int, left_well: float = 8e-3) -> Log:
    """20 s of a double well at 1 kHz under pulses, with noise on sensor and probes."""
    device = DoubleWell() if left_well == 8e-3 else DoubleWell(left_well=left_well)
    t, q, v = motion(20.0, RATE, seed, device=device, noise=3e-6)
    return Log(t, q, v + np.random.default_rng(seed).normal(0.0, 4.0, v.shape))


def told(logs: Sequence[Log], plant: dict | None = None, **tables: dict) -> list[str]:
    """What ingest and the checks say of logs; the first is the training log, the error's text if they are refused."""
    inputs = logs[0].v.shape[1]
    channels = {"q": {"channel": "q", "unit": "m"}} | {
        f"v{k}": {"channel": f"v{k}", "unit": "V"} for k in range(1, inputs + 1)
    }
    document = {"name": "P", "logs": {"train": ["a"]}, "channels": channels, "plant": plant or {}} | tables
    said: list[str] = []
    try:
        prototype = parse_prototype(document, "P.toml")
        seen = []
        for number, one in enumerate(logs, start=1):
            inputs = tuple(Signal(one.t, np.ascontiguousarray(column)) for column in one.v.T)
            signals = RawLog(Signal(one.t, one.q), inputs)
            (fine, _), noticed = examined(signals, prototype, f"log {number}")
            said += noticed["warnings"]
            notes = {**noticed, "raw_step": fine.report.raw_step}
            seen.append(log_signals(f"log {number}", record_columns(fine.record(), tuple(signals.beside)), notes))
        found_of_all = [
            *check_logs(seen, device(prototype), prototype.ingest.sample_interval),
            *(finding for _, _, finding in shared_recordings(seen)),
        ]
    except DebistError as error:
        return [*said, str(error)]
    return said + [": ".join(sentences(one)) for one in found_of_all if one.severity in ("fair", "poor")]


def _signal(
    change: Callable[[Log], Log], other: Callable[[Log], Log] | None = None, **settings: dict
) -> Callable[[], list[str]]:
    """A mistake in the training log, or in a second log of the same device."""

    def tell() -> list[str]:
        first = change(log(1))
        return told([first] if other is None else [first, other(log(3))], **settings)

    return tell


def _q(change: Callable[[FloatArray], FloatArray]) -> Callable[[Log], Log]:
    return lambda one: Log(one.t, change(one.q.copy()), one.v)


def _v(change: Callable[[FloatArray], FloatArray]) -> Callable[[Log], Log]:
    return lambda one: Log(one.t, one.q, change(one.v.copy()))


def _t(change: Callable[[FloatArray], FloatArray]) -> Callable[[Log], Log]:
    return lambda one: Log(change(one.t.copy()), one.q, one.v)


def bursts(value: float | None, length: int = 5, count: int = 40) -> Callable[[Log], Log]:
    """Bursts at a value, or of the last one held, at places that a seed draws."""

    def change(q: FloatArray) -> FloatArray:
        for place in np.random.default_rng(7).integers(50, q.size - 50, count):
            q[place : place + length] = q[place - 1] if value is None else value
        return q

    return _q(change)


def lose_rows(one: Log, length: int = 64) -> Log:
    """Three buffers are missing while q moves, and time goes on."""
    speed = np.abs(np.diff(one.q))
    fast = np.flatnonzero(speed > np.quantile(speed, 0.97))
    keep = np.ones(one.q.size, dtype=bool)
    for place in fast[:: fast.size // 3][:3]:
        keep[place : place + length] = False
    return Log(one.t[: keep.sum()], one.q[keep], one.v[keep])


def rows(one: Log, part: slice, shift: float = 0.0, digits: float | None = None) -> Log:
    """Rows of a log, later by a time [s], q rounded to a step [m]."""
    q = one.q[part] if digits is None else np.round(one.q[part] / digits) * digits
    return Log(one.t[part] + shift, q, one.v[part])


def _drifting() -> Log:
    """A minute in which the sensor moves by 6 mm."""
    t, q, v = motion(60.0, 500.0, 4, noise=3e-6)
    return Log(t, q + 1e-4 * t, v)


def _copies(part: slice, shift: float = 0.0, digits: float | None = None) -> Callable[[], list[str]]:
    return lambda: told([log(1), rows(log(1), part, shift, digits)])


def _settings(**tables: dict) -> Callable[[], list[str]]:
    return lambda: told([log(1)], **tables)


def _gap(one: Log) -> Log:
    keep = np.abs(one.t - 9.0) > 0.2
    return Log(one.t[keep], one.q[keep], one.v[keep])


def _poke(places: Sequence[int], value: float) -> Callable[[FloatArray], FloatArray]:
    def change(column: FloatArray) -> FloatArray:
        column[list(places)] = value
        return column

    return change


INGEST, CHECK, SETTINGS = "ingest", "check", "settings"


def _spike(v: FloatArray) -> FloatArray:
    v[4_000, 0] += 900.0
    return v


def held(q: FloatArray) -> FloatArray:
    """Every value for five samples."""
    return np.repeat(q[::5], 5)


_SHARED = "counts twice in fits and scores"
MISTAKES = (
    Mistake("the same log again, 100 s later", _SHARED, CHECK, _copies(slice(None), 100.0)),
    Mistake(
        "halves that overlap",
        _SHARED,
        CHECK,
        lambda: told([rows(log(1), slice(0, 13_000)), rows(log(1), slice(7_003, None))]),
    ),
    Mistake("an early part of the training log", _SHARED, CHECK, _copies(slice(2_000, 9_000), -2.0)),
    Mistake(
        "the training log again with q counted to the other side",
        _SHARED,
        CHECK,
        lambda: told([log(1), _q(lambda q: -q)(log(1))]),
    ),
    Mistake("v2 forgotten", "name the second input as v2", CHECK, _signal(lambda one: Log(one.t, one.q, one.v[:, :1]))),
    Mistake("v1 forgotten", "name the second input as v2", CHECK, _signal(lambda one: Log(one.t, one.q, one.v[:, 1:]))),
    Mistake(
        "a laser that drops out to 0.0 mm", "samples at 0 m, which no motion reaches", INGEST, _signal(bursts(0.0))
    ),
    Mistake("a laser that drops out to −9.9 m", "the sensor had lost its target", INGEST, _signal(bursts(-9.9))),
    Mistake("a laser that drops out to its upper end", "which no motion reaches", INGEST, _signal(bursts(0.026))),
    Mistake(
        "a sensor that holds its last value", "in which the last value was held", INGEST, _signal(bursts(None, 12))
    ),
    Mistake("buffers that were lost", "rows are missing though time goes on", INGEST, _signal(lose_rows)),
    Mistake("a probe at its rail", "a saturated probe?", INGEST, _signal(_v(lambda v: np.minimum(v, 2500.0)))),
    Mistake("a sensor that warms up", "let the sensor warm up", CHECK, lambda: told([_drifting()])),
    Mistake("mm read as m", "too large: check its unit", INGEST, _signal(_q(lambda q: 1e3 * q))),
    Mistake("µm read as mm, the other way", "too small: check its unit", INGEST, _signal(_q(lambda q: 1e-6 * q))),
    Mistake("kV read as V", "check the unit", CHECK, _signal(_v(lambda v: 1e-3 * v))),
    Mistake("ms read as s", "ms is not s", INGEST, _signal(_t(lambda t: 1e3 * t))),
    Mistake(
        'inputs = "linear" on squared pulses',
        'set inputs = "squared"',
        CHECK,
        _signal(_v(lambda v: v), plant={"inputs": "linear"}),
    ),
    Mistake("grams as gr", "write 'g' for grams", SETTINGS, lambda: _unit("gr")),
    Mistake("degrees as grad", "write 'deg' for degrees", SETTINGS, lambda: _unit("grad", ("rad",))),
    Mistake("pixels as a length", "a pixel has no length", SETTINGS, lambda: _unit("px", ("m",))),
    Mistake("a probe with an offset", "to its `offset` in [channels]", CHECK, _signal(_v(lambda v: v + 94.2))),
    Mistake("a probe with a negative offset", "to its `offset` in [channels]", CHECK, _signal(_v(lambda v: v - 94.2))),
    Mistake("v1 and v2 swapped", "v1 is the left membrane", CHECK, _signal(_v(lambda v: v[:, ::-1]))),
    Mistake("q counted to the other side", "give q scale = -1", CHECK, _signal(_q(lambda q: -q))),
    Mistake(
        "60 ms between two recorders",
        "start both recorders by one trigger",
        CHECK,
        _signal(lambda one: Log(one.t[60:], one.q[:-60], one.v[60:])),
    ),
    Mistake(
        "the drive of v2 was off",
        "leave it out for a device with one input",
        CHECK,
        _signal(_v(lambda v: v * [1.0, 0.0])),
    ),
    Mistake("a sensor whose zero is outside the wells", "zero the sensor", CHECK, _signal(_q(lambda q: q + 0.03))),
    Mistake("v1 logged twice", "drive them apart, or leave v2 out", CHECK, _signal(_v(lambda v: v[:, [0, 0]]))),
    Mistake(
        "v2 not connected",
        "leave it out of [channels]",
        CHECK,
        _signal(_v(lambda v: np.column_stack([v[:, 0], np.random.default_rng(1).normal(0.0, 3.0, len(v))]))),
    ),
    Mistake("a bus that is slower than the recorder", "q has new values at 200 Hz only", CHECK, _signal(_q(held))),
    Mistake("the laser without its target throughout", "q does not move", CHECK, _signal(_q(lambda q: 0.0 * q + 7e-3))),
    Mistake(
        "a laser at the end of its range",
        "at the ends of its range masked",
        INGEST,
        _signal(_q(lambda q: np.minimum(q, np.quantile(q, 0.97)))),
    ),
    Mistake("a coarse converter", "velocities come in steps", CHECK, _signal(_q(lambda q: np.round(q / 8e-4) * 8e-4))),
    Mistake(
        "samples that are not finite",
        "samples not finite, the first at",
        INGEST,
        _signal(_q(_poke([500, 7_000], np.nan))),
    ),
    Mistake("a spike of a probe", "v1: 1 single-sample spike", INGEST, _signal(_v(_spike))),
    Mistake("a spike of one sample", "single-sample spike masked", INGEST, _signal(_q(_poke([500], 0.021)))),
    Mistake("a gap in time", "gap in time, from", INGEST, _signal(_gap)),
    Mistake("time that steps back", "time steps back", INGEST, _signal(_t(lambda t: np.where(t > 10.0, t - 3.0, t)))),
    Mistake(
        "stamps that repeat", "repeat the one before", INGEST, _signal(_t(lambda t: np.floor(t * RATE / 4) * 4 / RATE))
    ),
    Mistake(
        "50 Hz hum on q",
        "hum of 50 Hz",
        INGEST,
        _signal(lambda one: Log(one.t, one.q + 4e-3 * np.sin(314.159 * one.t), one.v)),
    ),
    Mistake(
        "a sample interval as long as a swing",
        "set sample_interval",
        INGEST,
        _settings(ingest={"sample_interval": 0.5}),
    ),
    Mistake("a log of 20 ms", "record longer", INGEST, _signal(lambda one: rows(one, slice(0, 20)))),
    Mistake(
        "a mass in g given as kg",
        "of q and of plant.mass (",
        CHECK,
        _settings(plant={"mass": {"value": 41.0, "unit": "kg"}}),
    ),
    Mistake("a mass without its unit", "plant.mass", SETTINGS, _settings(plant={"mass": 0.041})),
    Mistake(
        "a gate of an earlier release", "refuses no data any more", SETTINGS, _settings(quality={"accept": ["device"]})
    ),
    Mistake("a misspelt key", "did you mean", SETTINGS, _settings(ingest={"sample_intervall": 0.01})),
    Mistake(
        "hybrid for a device with one input",
        "hybrid",
        SETTINGS,
        _signal(lambda one: Log(one.t, one.q, one.v[:, :1]), identify={"models": ["hybrid"]}),
    ),
)
"""In the order of the page."""


def _unit(text: str, allowed: tuple[str, ...] = ("kg",)) -> list[str]:
    from pipeline.units.units import to_si

    try:
        return [str(to_si(text, allowed, "unit"))]
    except DebistError as error:
        return [str(error)]


def sentence(mistake: Mistake) -> str:
    """What is said to a mistake; empty where its part is missing."""
    return next((text for text in mistake.tell() if mistake.said in text), "")


def page() -> str:
    """The page, every mistake made just now."""
    table = ["| mistake | what is said | where |", "|---|---|---|"]
    table += [f"| {each.done} | {sentence(each).replace('|', '¦')} | {each.where} |" for each in MISTAKES]
    return HEAD + "\n".join(table) + "\n"
