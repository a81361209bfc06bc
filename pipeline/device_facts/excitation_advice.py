"""What a log did not excite, in words, and what to add; the thresholds with their reasons."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from pipeline.fitting.coverage import FEW
from pipeline.fitting.excitation import Excitation
from pipeline.numerics.arrays import runs_of
from pipeline.scoring.wells import NoWells, Wells

LEAST_SWITCHES = 5
"""Of either direction: a snap lasts 0.1 s, and the curves between the wells are seen in nothing else."""
LEAST_INTERMEDIATE = 0.1
"""Share of an input's acting time: with full pulses alone q and v² go together, and c is not told from g."""
LEAST_TOGETHER = 0.01
"""Share of the time: whether two inputs add up is otherwise an assumption."""
LEAST_LARGEST = 0.8
"""Of the other input's largest value: the force goes with the square, so 0.8 is two thirds of it."""


@dataclass(frozen=True)
class Shortfall:
    """What was not excited, and what to add."""

    finding: str
    add: str


def shortfalls(
    found: Excitation, names: Sequence[str], factor: float, unit: str, *, joint: bool = True
) -> list[Shortfall]:
    """Everything that falls short; `names` are those of the inputs, q is told in `factor` × SI, called `unit`.

    Another device than the `joint` needs no two wells, and two places where it rests are none yet.
    """
    return [
        *(_wells(found, names) if joint else ()),
        *_centres(found, factor, unit),
        *_driven(found, names, factor, unit),
        *_levels(found, names, joint=joint),
        *_frequencies(found, names),
    ]


def _wells(found: Excitation, names: Sequence[str]) -> Iterator[Shortfall]:
    every = " and ".join(names)
    if isinstance(found.wells, NoWells):
        add = f"full pulses of {every}, 1 to 2 s long, with rests of 1 s, that send it into the other well"
        yield Shortfall(f"no two wells: {found.wells.reason}", f"{add}; nothing, if the device is not bistable")
        return
    for count, where in zip(found.switches, ("left to right", "right to left"), strict=True):
        if count < LEAST_SWITCHES:
            add = f"pulses of {every} in turn until it has snapped at least {LEAST_SWITCHES} times each way"
            yield Shortfall(f"it snaps from {where} {count} times only", add)


def _centres(found: Excitation, factor: float, unit: str) -> Iterator[Shortfall]:
    poor = np.isin(np.arange(len(found.centres)), found.visits.poorly_visited)
    for rows in runs_of(poor):
        fewest = int(found.visits.visits[rows].min())
        finding = f"{_places(found, rows, factor, unit)}: {fewest} samples, below {FEW}"
        if rows.start == 0 or rows.stop == len(poor):
            add = "full pulses in quick succession, so that it overshoots; or fewer basis functions"
        else:
            add = "chirps, random steps and pulses of all sizes, which lead it there"
            if isinstance(found.wells, Wells):
                add = "pulses near the switching voltage and chirps, which linger between the wells"
        yield Shortfall(finding, add)


def _driven(found: Excitation, names: Sequence[str], factor: float, unit: str) -> Iterator[Shortfall]:
    for k, name in enumerate(names):
        seen = found.visits.visits >= FEW
        poor = (found.visits.driven[k] < FEW) & seen
        for rows in runs_of(poor):
            finding = f"{name} hardly acts at {_places(found, rows, factor, unit)}: its gain there is a guess"
            yield Shortfall(finding, f"pulses of {name}, also weak ones, while q is or swings there")


def _levels(found: Excitation, names: Sequence[str], *, joint: bool) -> Iterator[Shortfall]:
    top = float(found.largest.max())
    for k, name in enumerate(names):
        if found.largest[k] == 0.0:
            yield Shortfall(f"{name} never acts", f"pulses of {name}")
            continue
        if joint and found.largest[k] < LEAST_LARGEST * top:
            finding = f"{name} reaches {100 * found.largest[k] / top:.0f} % of the other input only"
            yield Shortfall(finding, f"pulses of {name} up to the same limit")
        if found.intermediate[k] < LEAST_INTERMEDIATE:
            share = 100 * found.intermediate[k]
            finding = f"{name} is either off or full: {share:.0f} % of its acting time lies between 15 and 85 %"
            yield Shortfall(finding, f"random steps or multisines of {name}")
    if len(names) > 1 and found.together < LEAST_TOGETHER:
        yield Shortfall(f"{' and '.join(names)} never act together", "pulses with both sides on, at unequal voltages")


def _frequencies(found: Excitation, names: Sequence[str]) -> Iterator[Shortfall]:
    if found.ringing is None:
        return
    for name, band in zip(names, found.bandwidth, strict=True):
        if band < found.ringing:
            finding = f"95 % of the power of {name} lies below {band:.2g} Hz, but q rings at {found.ringing:.2g} Hz"
            yield Shortfall(finding, f"chirps of {name} from {found.ringing / 3:.1g} to {3 * found.ringing:.2g} Hz")


def _places(found: Excitation, rows: slice, factor: float, unit: str) -> str:
    places = factor * found.centres[rows]
    first, last = places[0], places[-1]
    return f"q = {first:.1f} {unit}" if len(places) == 1 else f"q = {first:.1f} … {last:.1f} {unit}"
