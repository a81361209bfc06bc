"""A prototype days later: what changes slowly in a joint and its bench."""

from collections.abc import Mapping
from dataclasses import replace

from pipeline.errors import InputError
from pipeline.rig.bench import Bench
from pipeline.rig.parameters import RigParameters
from pipeline.units import parse_quantity

DRIFTS = {"capacitance": "1", "stiffness": "1", "charging": "s", "laser": "m"}
"""What may change, with the unit of the change in a day: C0 of both membranes, the beam's bending stiffness, the time
constant with which the membranes charge, and the laser's reading at q = 0. Changes are proportional to the age."""

USUAL = "capacitance=-0.1%,stiffness=-0.05%,charging=20us,laser=2um"
"""What changes in a day unless it is stated."""


def parse_drift(text: str) -> dict[str, float]:
    """Changes in a day by their names, as fractions or in SI units, from ``NAME=CHANGE,…``; ``none`` is no change.

    Raises
    ------
    InputError
        A name or a unit is none of `DRIFTS`.
    """
    drift = {}
    for entry in text.split(",") if text != "none" else ():
        name, _, change = (part.strip() for part in entry.partition("="))
        if name not in DRIFTS:
            raise InputError(f"--drift {entry}: unknown; write NAME=CHANGE with {', '.join(DRIFTS)}, or none")
        drift[name] = parse_quantity(change, (DRIFTS[name],), "--drift")
    return drift


def aged(joint: RigParameters, bench: Bench, age: float, drift: Mapping[str, float]) -> tuple[RigParameters, Bench]:
    """Joint and bench at an age [days] with changes a day as `parse_drift` gives them.

    Raises
    ------
    InputError
        Nothing of a capacitance, a stiffness or a charging time is left at that age.
    """
    change = {name: age * drift.get(name, 0.0) for name in DRIFTS}
    charging = bench.charging + change["charging"]
    if min(change["capacitance"], change["stiffness"]) <= -0.5 or charging < 0.0:
        raise InputError(
            f"--age {age:g}: more than half of a capacitance or a stiffness is gone, or a time is negative"
        )
    stiffer = 1.0 + change["stiffness"]
    joint = joint._replace(
        capacitance=joint.capacitance * (1.0 + change["capacitance"]),
        bending=joint.bending * stiffer,
        hinge_stiffness=joint.hinge_stiffness * stiffer,
    )
    laser = replace(bench.laser, zero=bench.laser.zero + change["laser"])
    return joint, replace(bench, charging=charging, laser=laser)
