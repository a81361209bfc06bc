"""The hybrid joint for export: the condensed joint between its instruments, behind its electrodes."""

from typing import Any

from ..codegen.graph import apply, choose, clip, function, inline, trace
from ..errors import InputError
from ..generated.condensed_joint import (
    AT_REST,
    BENDS,
    BRANCHES,
    ELEMENT_STATES,
    FIRST_ELEMENT,
    RATES,
    REST_FORCES,
    SHAPE,
    SLIPS,
    STATES,
    STOP_MOVE,
    STOPS,
)
from ..generated.terms import FIRST_BELL, LAG, NEXT_BELL
from ..models.hybrid.kernels import CURVED, CURVES, INDEX, VALUES, WIDTHS, prepare
from ..models.hybrid.log_reading import ANGLE_IS_READ
from ..models.hybrid.model import HybridModel
from ..numerics.arrays import FloatArray
from .subject import Realisation, Variable, lagged_nodes

Values = list[Any]
Outputs = dict[str, Values]

_MEMBRANES = tuple(
    Variable(f"{side}_voltage", "V", f"voltage of the {side} membrane", 1e3) for side in ("left", "right")
)
ALL_STATES = STATES + len(_MEMBRANES)
LEAST_CHARGING = 0.5e-3
"""Charging time [s] below which an integrator with steps of its own takes this one: they need not be shorter then."""


def _corrections(q: Any, basis: FloatArray, weights: FloatArray) -> Values:
    """The corrections at q; see `pipeline.models.hybrid.kernels.corrections_at`."""
    if weights.shape[1] == 0:
        return [0.0] * VALUES
    first = float(basis[0])
    reach = WIDTHS * float(basis[2])
    near = function("lt", function("abs", q - first), reach)
    bell = apply(FIRST_BELL, clip(q, first - reach, first + reach), *basis)
    summed: Values = [0.0] * VALUES
    for column in weights.T:
        slope, *following = apply(NEXT_BELL, *bell, *basis)
        for row in range(CURVES):
            summed[row] = summed[row] + float(column[row]) * bell[1]
        for row, weight in enumerate(column[CURVED]):
            summed[CURVES + row] = summed[CURVES + row] + float(weight) * slope
        bell = following
    return [choose(near, value, 0.0) for value in summed]


def realise(model: HybridModel, interval: float, unit: str = "m") -> Realisation:
    """The model for export, at the sample interval [s] of its run.

    Raises
    ------
    InputError
        The angle of the joint was measured, which the exported equations do not read.
    """
    condensed = model.joint
    if condensed.angle:
        raise InputError(ANGLE_IS_READ.format(name="hybrid", what="exports", way_out="measure q, or take --model rbf"))
    joint = _Joint(model)
    return Realisation(
        functions={
            "drive": trace(joint.drive, v=2),
            "start": trace(joint.start, q0=1, qdot0=1, u=2),
            "shape": trace(joint.shape, x=ALL_STATES, u=2),
            "stick": trace(joint.stick, x=ALL_STATES, u=2),
            "begin": trace(lambda x, z, h: {"base": [x[i] for i in SHAPE]}, x=ALL_STATES, z=STOPS, h=1),
            "lag": trace(joint.lag, before=2, within=2, after=2, h=1, x=ALL_STATES),
            "rates": trace(joint.rates, x=ALL_STATES, z=STOPS, base=3, u=2),
            "finish": trace(joint.finish, base=3, x=ALL_STATES, z=STOPS),
            "flow": trace(joint.flow, x=ALL_STATES, z=STOPS, base=3, u=2),
            "read": trace(joint.read, x=ALL_STATES, dx=ALL_STATES),
            # The wall confines every run, so only a number that is not finite lies outside.
            "within": trace(lambda x: {"ok": [function("finite", x[0])]}, x=ALL_STATES),
        },
        constants={
            "k": joint.k,
            "basis": condensed.basis,
            "weights": joint.weights,
            "probe": joint.seen.probe,
            "charging_time": joint.charging,
            "held_above": joint.held_above,
            "offset": joint.offset,
            "wall": joint.wall,
        },
        inputs=2,
        states=(*states(), *_MEMBRANES),
        hysteresis_states=stop_operators(),
        base=3,
        step=interval / condensed.substeps(model.theta, interval),
        delay=float(joint.seen.delay),
        between="cubic",
        structure=str(model.describe()["structure"]),
        held=(2, 4),
    )


class _Joint:
    """Motion of the joint between its instruments; `base` is (q, τ, β) where a step started."""

    def __init__(self, model: HybridModel) -> None:
        self.basis = model.joint.basis
        self.seen = model.joint.instruments(model.theta)
        self.k = model.joint.constants(model.theta)
        self.weights = model.joint.weights(model.theta)
        self.p = [float(value) for value in prepare(self.k[None])[0]]
        self.constant = {name: float(self.k[place]) for name, place in INDEX.items()}
        self.held_above = 2.0 * model.joint.largest_voltage
        self.wall = float(model.joint.q_stop)
        self.offset = float(self.seen.offset)
        self.charging = float(self.seen.charging)

    def drive(self, v: Values) -> Outputs:
        """Voltages without the probes' offsets; absurd ones are held."""
        freed = [x - float(zero) for x, zero in zip(v, self.seen.probe, strict=True)]
        return {"u": [clip(x, -self.held_above, self.held_above) for x in freed]}

    def start(self, q0: Values, qdot0: Values, u: Values) -> Outputs:
        """The state at a reading, with the shape from which the search for that at rest starts."""
        x: Values = [0.0] * STATES
        x[0] = q0[0] - self.offset
        x[1], x[2] = qdot0[0], self.constant["slope_ratio"] * x[0] / self.constant["l"]
        x[FIRST_ELEMENT:] = [at_rest * x[0] for at_rest in AT_REST]
        return {"x": [*x, *u], "z": [0.0] * STOPS}

    def lag(self, before: Values, within: Values, after: Values, h: Values, x: Values) -> Outputs:
        """Voltages of the membranes at the nodes of a step, which `rates` takes; x moves to its end."""
        middles, ends = lagged_nodes(x[STATES:], before, within, after, h[0], self.charging)
        return {"before": x[STATES:], "within": middles, "after": ends, "x": [*x[:STATES], *ends]}

    def shape(self, x: Values, u: Values) -> Outputs:
        """Forces on slope and interior mode at rest, as rates of their overdamped relaxation, and their derivatives."""
        summed = self._forces(x, u)
        slope, interior = (BENDS[i][i] * self.constant["bending"] for i in (1, 2))
        by = summed["by_shape"]
        scaled = [summed["forces"][1] / slope, summed["forces"][2] / interior]
        return {"f": [*scaled, by[2] / slope, by[3] / slope, by[4] / interior, by[5] / interior]}

    def stick(self, x: Values, u: Values) -> Outputs:
        """Stop operators that balance the remaining force at rest, as far as they can."""
        capacity = sum(self.constant[f"stop_force_{i}"] for i in range(SLIPS))
        share = clip(self._forces(x, u)["forces"][0] / capacity, -1.0, 1.0) if capacity > 0.0 else 0.0
        return {"z": [share] * SLIPS + [0.0] * (STOPS - SLIPS)}

    def rates(self, x: Values, z: Values, base: Values, u: Values) -> Outputs:
        """State equation, with the corrections at q, under voltages of the membranes that `lag` has moved."""
        c = _corrections(x[0], self.basis, self.weights)
        squares = [v * v for v in u]
        return {"dx": [*inline(RATES, x=x[:STATES], u=squares, c=c, z=z, start=base, p=self.p)["rates"], 0.0, 0.0]}

    def flow(self, x: Values, z: Values, base: Values, u: Values) -> Outputs:
        """Rates of all states: the membranes charge."""
        lag = max(self.charging, LEAST_CHARGING)
        charging = [apply(LAG, v, held, lag)[0] for v, held in zip(u, x[STATES:], strict=True)]
        return {"dx": [*self.rates(x, z, base, x[STATES:])["dx"][:STATES], *charging]}

    def finish(self, base: Values, x: Values, z: Values) -> Outputs:
        """The wall holds the tip, and the stop operators move with the step."""
        beyond = function("lt", self.wall, function("abs", x[0]))
        q = choose(beyond, choose(function("lt", 0.0, x[0]), self.wall, -self.wall), x[0])
        held = [q, choose(beyond, 0.0, x[1]), *x[2:]]
        return {"x": held, "z": inline(STOP_MOVE, x=held[:STATES], z=z, start=base, p=self.p)["moved"]}

    def read(self, x: Values, dx: Values) -> Outputs:
        """Outputs as the laser shows them."""
        return {"y": [x[0] + self.offset, x[1], dx[1]]}

    def _forces(self, x: Values, u: Values) -> Outputs:
        return inline(
            REST_FORCES,
            x=x[:STATES],
            u=[v * v for v in u],
            c=_corrections(x[0], self.basis, self.weights),
            p=self.p,
        )


def stop_operators() -> tuple[Variable, ...]:
    """States of the hysteresis of friction."""
    return tuple(Variable(f"stop_{i}", "1", f"stop operator {i}, share of its force") for i in range(STOPS))


def states() -> tuple[Variable, ...]:
    """The state of the condensed joint."""
    strains = [
        Variable(f"strain_{side}_{i}", "1", f"strain of Maxwell element {i} of the {side} membrane", 0.1)
        for i in range(BRANCHES)
        for side in ("left", "right")
    ]
    return (
        Variable("tip", "m", "displacement of the tip, without the laser's offset", 0.01),
        Variable("tip_speed", "m/s", "its velocity", 0.1),
        Variable("slope", "1", "slope of the beam at the tip", 0.1),
        Variable("slope_rate", "1/s", "its rate", 10.0),
        Variable("interior", "1", "interior shape mode of the beam", 0.1),
        Variable("interior_rate", "1/s", "its rate", 10.0),
        *strains,
        *(Variable(name, unit, "memory of an element", 0.01) for name, unit in ELEMENT_STATES),
    )
