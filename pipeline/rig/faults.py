"""Faults of a test bench, put into a log on request, each at places drawn from a generator."""

from dataclasses import dataclass

import numpy as np

from pipeline.errors import InputError
from pipeline.rig.log import RawLog

KINDS = ("saturation", "dropouts", "nan", "gaps", "repeats")  # in the order in which they are put in
_COUNT = 3
_GAP, _DROPOUT = (5e-3, 60e-3), (2e-3, 30e-3)  # s, shortest and longest
_RAIL = 25.0e-3  # m, end of the laser's range
_SATURATED_SHARE = 0.97  # of the largest |q|: where the range ends on request


@dataclass(frozen=True)
class Fault:
    """One fault that was put in: its kind, and where it begins and ends [s]."""

    kind: str
    start: float
    end: float


def parse_faults(text: str) -> tuple[str, ...]:
    """The kinds named in a comma-separated `text`.

    Raises
    ------
    InputError
        A kind that does not exist.
    """
    kinds = listed(text)
    for kind in kinds:
        if kind not in KINDS:
            raise InputError(f"--faults {kind}: no such fault; choose among {', '.join(KINDS)}")
    return kinds


def listed(text: str) -> tuple[str, ...]:
    """The entries of a comma-separated `text`."""
    return tuple(entry.strip() for entry in text.split(",") if entry.strip())


def inject_faults(log: RawLog, kinds: tuple[str, ...], rng: np.random.Generator) -> tuple[RawLog, list[Fault]]:
    """Put faults of the `kinds` into `log`; say which and where.

    ``gaps``        samples are missing, time runs on (3 of 5 to 60 ms)
    ``dropouts``    the laser loses its target and reads the end of its range (3 of 2 to 30 ms)
    ``saturation``  the laser's range ends at 97 % of the largest displacement, not at 25 mm
    ``nan``         single readings are not numbers (3)
    ``repeats``     single samples are written twice with the same stamp (3)
    """
    faults: list[Fault] = []
    q, rail = log.q.copy(), _RAIL
    for kind in KINDS:
        if kind not in kinds or kind in ("gaps", "repeats"):
            continue
        if kind == "saturation":
            rail = _SATURATED_SHARE * float(np.abs(q).max())
            beyond = np.flatnonzero(np.abs(q) > rail)
            faults.append(Fault(kind, float(log.t[beyond[0]]), float(log.t[beyond[-1]])))
            q = np.clip(q, -rail, rail)
            continue
        for first, last in _places(log, (0.0, 0.0) if kind == "nan" else _DROPOUT, rng):
            q[first:last] = np.nan if kind == "nan" else rail
            faults.append(Fault(kind, float(log.t[first]), float(log.t[last - 1])))
    damaged, intact = log.with_q(q), log.t
    for first, last in _places(log, _GAP, rng) if "gaps" in kinds else []:
        faults.append(Fault("gaps", float(intact[first - 1]), float(intact[last])))
        damaged = damaged.rows_where((damaged.t < intact[first]) | (damaged.t >= intact[last]))
    for _ in range(_COUNT if "repeats" in kinds else 0):
        at = int(rng.integers(1, damaged.t.size))
        faults.append(Fault("repeats", float(damaged.t[at]), float(damaged.t[at])))
        damaged = damaged.repeated(at)
    return damaged, sorted(faults, key=lambda fault: fault.start)


def _places(log: RawLog, lengths: tuple[float, float], rng: np.random.Generator) -> list[tuple[int, int]]:
    """Ranges of samples [first, last), one in each third of the log, at least one sample long."""
    dt, third = float(log.t[1] - log.t[0]), log.t.size // _COUNT
    places = []
    for i in range(_COUNT):
        count = max(1, round(float(rng.uniform(*lengths)) / dt))
        first = i * third + int(rng.integers(1, max(2, third - count - 1)))
        places.append((first, first + count))
    return places
