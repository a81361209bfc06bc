"""The hybrid joint for export: the condensed joint between its instruments."""

from typing import Any

import numpy as np

from pipeline.codegen.trace import choose, clip, function, inline, square, trace
from pipeline.export.realisation import Realisation, Variable
from pipeline.generated.condensed_joint import AT_REST, BRANCHES, FIRST_MEMORY, MEMORIES, RATES, SHAPE, STATES, STOPS
from pipeline.joint.condensed_kernels import INDEX, VALUES, prepare
from pipeline.joint.correction_table import CURVED, CURVES
from pipeline.models.hybrid import HybridModel
from pipeline.numerics.arrays import FloatArray

Values = list[Any]
_REACH = 30.0  # widths of a Gaussian beyond which corrections are zero


def _corrections(q: Any, basis: FloatArray, weights: FloatArray) -> Values:
    """The corrections at q; see `pipeline.joint.condensed_kernels.corrections_at`."""
    if weights.shape[1] == 0:
        return [0.0] * VALUES
    first, distance, width = (float(value) for value in basis)
    s, near = distance / width, function("lt", function("abs", q - first), _REACH * width)
    r = clip((q - first) / width, -_REACH, _REACH)
    bell, ratio, shrink = function("exp", -0.5 * r * r), function("exp", r * s - 0.5 * s * s), float(np.exp(-s * s))
    found: Values = [0.0] * VALUES
    for i, column in enumerate(weights.T):
        slope = (i * s - r) / width * bell
        for row in range(CURVES):
            found[row] = found[row] + float(column[row]) * bell
        for row, weight in enumerate(column[CURVED]):
            found[CURVES + row] = found[CURVES + row] + float(weight) * slope
        bell, ratio = bell * ratio, ratio * shrink
    return [choose(near, value, 0.0) for value in found]


def realise(model: HybridModel, interval: float, unit: str = "m") -> Realisation:
    """The model for export, at the sample interval [s] of its run."""
    seen, condensed = model.joint.instruments(model.theta), model.joint
    k, weights = condensed.constants(model.theta), condensed.weights(model.theta)
    p = [float(value) for value in prepare(k[None])[0]]
    constant = {name: float(k[place]) for name, place in INDEX.items()}
    held_above, wall = 2.0 * condensed.largest_voltage, float(condensed.q_stop)
    gain, offset, arm = float(seen.gain), float(seen.offset), constant["friction_arm"]

    def drive(v: Values) -> dict[str, Values]:
        offsets = [float(value) for value in seen.probe]
        return {"u": [square(clip(x - y, -held_above, held_above)) for x, y in zip(v, offsets, strict=True)]}

    def start(q0: Values, qdot0: Values, u: Values) -> dict[str, Values]:
        x: Values = [0.0] * STATES
        x[0] = (q0[0] - offset) / gain
        x[1], x[2] = qdot0[0] / gain, 1.25 * x[0] / constant["l"]
        x[FIRST_MEMORY:] = [at_rest * x[0] for at_rest in AT_REST]
        return {"x": x, "z": [0.0] * STOPS}

    def forces(x: Values, u: Values) -> dict[str, Values]:
        return inline(SHAPE, x=x, u=u, c=_corrections(x[0], condensed.basis, weights), p=p)

    def shape(x: Values, u: Values) -> dict[str, Values]:
        found = forces(x, u)
        slope, interior = 4.0 * constant["bending"], 0.8 * constant["bending"]
        by = found["by_shape"]
        scaled = [found["forces"][1] / slope, found["forces"][2] / interior]
        return {"f": [*scaled, by[2] / slope, by[3] / slope, by[4] / interior, by[5] / interior]}

    def stick(x: Values, u: Values) -> dict[str, Values]:
        capacity = sum(constant[f"stop_force_{i}"] for i in range(STOPS))
        share = clip(forces(x, u)["forces"][0] / capacity, -1.0, 1.0) if capacity > 0.0 else 0.0
        return {"z": [share] * STOPS}

    def rates(x: Values, z: Values, base: Values, u: Values) -> dict[str, Values]:
        c = _corrections(x[0], condensed.basis, weights)
        return {"dx": inline(RATES, x=x, u=u, c=c, z=z, start=base, p=p)["rates"]}

    def finish(base: Values, x: Values, z: Values) -> dict[str, Values]:
        beyond = function("lt", wall, function("abs", x[0]))
        q = choose(beyond, choose(function("lt", 0.0, x[0]), wall, -wall), x[0])
        play = q - base[0] + arm * (x[2] - base[1])
        stops = [clip(z[i] + play / constant[f"stop_travel_{i}"], -1.0, 1.0) for i in range(STOPS)]
        return {"x": [q, choose(beyond, 0.0, x[1]), *x[2:]], "z": stops}

    return Realisation(
        functions={
            "drive": trace(drive, v=2),
            "start": trace(start, q0=1, qdot0=1, u=2),
            "shape": trace(shape, x=STATES, u=2),
            "stick": trace(stick, x=STATES, u=2),
            "begin": trace(lambda x, z, h: {"base": [x[0], x[2]]}, x=STATES, z=STOPS, h=1),
            "rates": trace(rates, x=STATES, z=STOPS, base=2, u=2),
            "finish": trace(finish, base=2, x=STATES, z=STOPS),
            "read": trace(lambda x, dx: {"y": [gain * x[0] + offset, gain * x[1], gain * dx[1]]}, x=STATES, dx=STATES),
            # The wall confines every run, so only a number that is none lies outside.
            "within": trace(lambda x: {"ok": [function("finite", x[0])]}, x=STATES),
        },
        constants={
            "k": k,
            "basis": condensed.basis,
            "weights": weights,
            "probe": seen.probe,
            "held_above": held_above,
            "gain": gain,
            "offset": offset,
            "wall": wall,
        },
        inputs=2,
        states=_states(),
        memories=tuple(Variable(f"stop_{i}", "1", f"stop operator {i}, share of its force") for i in range(STOPS)),
        base=2,
        step=interval / condensed.substeps(model.theta, interval),
        delay=float(seen.delay),
        spline=True,
        structure=str(model.describe()["structure"]),
        held=(2, 4),
    )


def _states() -> tuple[Variable, ...]:
    strains = [
        Variable(f"strain_{side}_{i}", "1", f"strain of Maxwell element {i} of the {side} membrane", 0.1)
        for i in range(BRANCHES)
        for side in ("left", "right")
    ]
    return (
        Variable("tip", "m", "displacement of the tip, without the laser's gain and offset", 0.01),
        Variable("tip_speed", "m/s", "its velocity", 0.1),
        Variable("slope", "1", "slope of the beam at the tip", 0.1),
        Variable("slope_rate", "1/s", "its rate", 10.0),
        Variable("interior", "1", "interior shape mode of the beam", 0.1),
        *strains,
        *(Variable(name, unit, "memory of an element on the tip", 0.01) for name, unit in MEMORIES),
    )
