"""Gaps in the excitation of a log, in words, with what to add; the thresholds with their reasons."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from pipeline.fitting.coverage import FEW
from pipeline.fitting.excitation import Excitation
from pipeline.numerics.arrays import runs_of
from pipeline.scoring.wells import NoWells, Wells

LEAST_SWITCHES = 5
"""Snaps in either direction: each lasts 0.1 s, and nothing else shows the curves between the wells."""
LEAST_INTERMEDIATE = 0.1
"""Share of an input's acting time: with full pulses alone q and v² go together, and c and g cannot be separated."""
LEAST_TOGETHER = 0.01
"""Share of the time: whether two inputs add up is otherwise an assumption."""
LEAST_LARGEST = 0.8
"""Share of the other input's largest value: the force goes with the square, so 0.8 is two thirds of it."""


@dataclass(frozen=True)
class Shortfall:
    """What was not excited, and what to add."""

    finding: str
    add: str


def shortfalls(
    excitation: Excitation, names: Sequence[str], factor: float, unit: str, *, joint: bool = True
) -> list[Shortfall]:
    """Everything that falls short; `names` are those of the inputs; q is printed in `unit`, which is `factor` × SI.

    A device other than the `joint` needs no two wells; two places of rest are no wells yet.
    """
    return [
        *(_wells(excitation, names) if joint else ()),
        *_centres(excitation, factor, unit),
        *_driven(excitation, names, factor, unit),
        *_levels(excitation, names, joint=joint),
        *_frequencies(excitation, names),
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
    poor = np.isin(np.arange(len(excitation.centres)), excitation.visits.poorly_visited)
    for rows in runs_of(poor):
        fewest = int(excitation.visits.visits[rows].min())
        finding = f"{_places(excitation, rows, factor, unit)}: {fewest} samples, below {FEW}"
        if rows.start == 0 or rows.stop == len(poor):
            add = "full pulses in quick succession, so that it overshoots; or fewer basis functions"
        else:
            add = "chirps, random steps and pulses of all sizes, which lead it there"
            if isinstance(excitation.wells, Wells):
                add = "pulses near the switching voltage and chirps, which linger between the wells"
        yield Shortfall(finding, add)


def _driven(excitation: Excitation, names: Sequence[str], factor: float, unit: str) -> Iterator[Shortfall]:
    for k, name in enumerate(names):
        visited = excitation.visits.visits >= FEW
        poor = (excitation.visits.driven[k] < FEW) & visited
        for rows in runs_of(poor):
            finding = f"{name} hardly acts at {_places(excitation, rows, factor, unit)}: its gain there is a guess"
            yield Shortfall(finding, f"pulses of {name}, also weak ones, while q is or swings there")


def _levels(excitation: Excitation, names: Sequence[str], *, joint: bool) -> Iterator[Shortfall]:
    top = float(excitation.largest.max())
    for k, name in enumerate(names):
        if excitation.largest[k] == 0.0:
            yield Shortfall(f"{name} never acts", f"pulses of {name}")
            continue
        if joint and excitation.largest[k] < LEAST_LARGEST * top:
            finding = f"{name} reaches {100 * excitation.largest[k] / top:.0f} % of the other input only"
            yield Shortfall(finding, f"pulses of {name} up to the same limit")
        if excitation.intermediate[k] < LEAST_INTERMEDIATE:
            share = 100 * excitation.intermediate[k]
            finding = f"{name} is either off or full: {share:.0f} % of its acting time lies between 15 and 85 %"
            yield Shortfall(finding, f"random steps or multisines of {name}")
    if len(names) > 1 and excitation.together < LEAST_TOGETHER:
        yield Shortfall(f"{' and '.join(names)} never act together", "pulses with both sides on, at unequal voltages")


def _frequencies(excitation: Excitation, names: Sequence[str]) -> Iterator[Shortfall]:
    if excitation.ringing is None:
        return
    for name, band in zip(names, excitation.bandwidth, strict=True):
        if band < excitation.ringing:
            finding = (
                f"95 % of the power of {name} lies below {band:.2g} Hz, but q rings at {excitation.ringing:.2g} Hz"
            )
            yield Shortfall(
                finding, f"chirps of {name} from {excitation.ringing / 3:.1g} to {3 * excitation.ringing:.2g} Hz"
            )


def _places(excitation: Excitation, rows: slice, factor: float, unit: str) -> str:
    places = factor * excitation.centres[rows]
    first, last = places[0], places[-1]
    return f"q = {first:.1f} {unit}" if len(places) == 1 else f"q = {first:.1f} … {last:.1f} {unit}"
