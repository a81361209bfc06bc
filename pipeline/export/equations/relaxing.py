"""The data-driven joint for export: `pipeline.identification.relaxing_joint` in its own dimensionless numbers.

The right side stands here once more without sensitivities: there it is fused with them, because apart it costs the
identification a fifth of its time. A test holds the two together.
"""

from typing import Any

import numpy as np

from pipeline.codegen.graph import Graph
from pipeline.codegen.trace import choose, clip, function, trace
from pipeline.export.realisation import Realisation, Variable
from pipeline.identification.joint_problem import steps_per_sample
from pipeline.identification.relaxing_joint import DAMPING, ESCAPE, FORCE, INPUT, WALL, Coefficients
from pipeline.models.rbf import RbfModel
from pipeline.numerics.arrays import FloatArray

Values = list[Any]


def _basis(x: Any, c: Coefficients) -> Values:
    """See `pipeline.identification.relaxing_joint.basis_at`."""
    values = [1.0, x, x * x, x * x * x]
    if c.arm[1] != 0.0:
        q, past = float(c.arm[0]) + float(c.arm[1]) * x, (x - clip(x, -1.0, 1.0)) / WALL
        values = [1.0, function("sin", q), function("cos", q), x * x * x + past * past * past]
    inside = clip(x, float(c.low), float(c.high))
    distances = [inside - float(centre) for centre in c.centres]
    return values + [function("exp", -float(c.bend) * distance * distance) for distance in distances]


def _moved(x: Values, slip: Values, f: Values, c: Coefficients) -> Values:
    """Rates of the displacement, its velocity and the relaxing elements under the inputs f of the motion."""
    basis, inputs, elements, p = _basis(x[0], c), len(f), len(c.rates), x[1]
    values = [sum(float(w) * bell for w, bell in zip(row, basis, strict=True)) for row in c.curves]
    arm, bend = x[0] - float(c.inertia[1]), float(c.inertia[0])
    total = values[FORCE] - values[DAMPING] * p - bend * arm * p * p
    total = total + sum(values[INPUT + n] * f[n] for n in range(inputs))
    total = total - sum(values[INPUT + inputs + n] * x[2 + n] for n in range(elements))
    total = total - sum(float(force) * s for force, s in zip(c.slip_force, slip, strict=True))
    changes = [
        values[INPUT + inputs + n] * p
        - float(c.rates[n]) * x[2 + n]
        + sum(float(b) * value for b, value in zip(c.coupling[n], f, strict=True))
        for n in range(elements)
    ]
    return [p, total / (1.0 + bend * arm * arm), *changes]


def _lagged_after(h: Any, lagged: Any, before: Any, after: Any, lag: float) -> Any:
    """Lagged input after h [s] in which the input goes on a line, exactly (`pipeline.numerics.lag`)."""
    ratio = h / lag
    known = function("lt", 0.0, ratio)
    share = choose(known, -function("expm1", -ratio) / choose(known, ratio, 1.0), 1.0)
    kept = function("exp", -ratio)
    return kept * lagged + (share - kept) * before + (1.0 - share) * after


def realise(model: RbfModel, interval: float, unit: str = "m") -> Realisation:
    """The model for export, at the sample interval [s] of its run."""
    p, s = model.parameters, model.parameters.scales
    c: Coefficients = p.coefficients(model.theta)
    inputs, elements, slips = len(p.signs), len(c.rates), len(c.slip_force)
    offset, log_lag = model.theta[p.slices["input_offset"]], model.theta[p.slices["input_lag"]]
    offsets = offset if len(offset) else np.zeros(inputs)
    lag = float(np.exp(log_lag[0])) if len(log_lag) else 0.0
    lagged, rested = p.structure.input_lag, not p.structure.rest_at_zero
    log_delay = model.theta[p.slices["input_delay"]]
    scales = (float(s.middle), float(s.half), float(s.volts))
    return Realisation(
        functions=_functions(c, p.law == "squared", offsets, scales, lag, lagged, rested),
        constants={
            "joint": c._asdict(),
            "middle": scales[0],
            "half": scales[1],
            "volts": scales[2],
            "squared": int(p.law == "squared"),
            "offset": offsets,
            "lagged": int(lagged),
            "lag": lag,
        },
        inputs=inputs,
        states=(
            Variable("x", "1", "displacement from the middle of the operating range over half of it"),
            Variable("p", "1/s", "its rate", 10.0),
            *(Variable(f"w_{i}", "1/s", f"relaxing element {i}") for i in range(elements)),
            *(Variable(f"s_{i}", "1", f"Dahl friction state {i}") for i in range(slips)),
            *(
                Variable(f"input_{i}", "1", f"lagged input {i + 1} over the largest trained one")
                for i in range(inputs if lagged else 0)
            ),
        ),
        memories=(),
        base=slips + 1,
        step=interval / steps_per_sample(p, interval, model.theta),
        delay=float(np.exp(log_delay[0])) if len(log_delay) else 0.0,
        spline=p.structure.hold == "cubic",
        structure=str(model.describe()["structure"]),
    )


def _functions(
    c: Coefficients,
    squared: bool,
    offset: FloatArray,
    scales: tuple[float, float, float],
    lag: float,
    lagged: bool,
    rested: bool,
) -> dict[str, Graph]:
    """How the joint moves between what is measured: middle and half of the range of q, largest voltage.

    `rested`: it was at rest under the first inputs, not without any.
    """
    middle, half, volts = scales
    inputs, elements, slips = len(offset), len(c.rates), len(c.slip_force)
    first, last = 2 + elements, 2 + elements + slips
    size, lengths = last + (inputs if lagged else 0), [float(length) for length in c.slip_length]

    def acting(u: Values) -> Values:
        """Inputs of the equation of motion from those behind their lag: freed of their offset, squared."""
        freed = [value - float(zero) for value, zero in zip(u, offset, strict=True)]
        return [value * value if squared else value for value in freed]

    def slid(slip: Any, travel: Any, length: float) -> Any:
        """Dahl state after a monotonous travel, exactly: it tends to ±1 exponentially in the distance."""
        side = choose(function("le", 0.0, travel), 1.0, -1.0)
        return side + (slip - side) * function("exp", -function("abs", travel) / length)

    def start(q0: Values, qdot0: Values, u: Values) -> dict[str, Values]:
        before = u if rested else [0.0] * inputs
        f = acting(before)
        strains = [
            sum(float(b / rate) * value for b, value in zip(row, f, strict=True))
            for row, rate in zip(c.coupling, c.rates, strict=True)
        ]
        x = [(q0[0] - middle) / half, qdot0[0] / half, *strains, *([0.0] * slips)]
        return {"x": x + (before if lagged else []), "z": []}

    def begin(x: Values, z: Values, h: Values) -> dict[str, Values]:
        """Friction states at the middle of the step, and where the step starts."""
        return {"base": [slid(x[first + n], 0.5 * h[0] * x[1], lengths[n]) for n in range(slips)] + [x[0]]}

    def rates(x: Values, z: Values, base: Values, u: Values) -> dict[str, Values]:
        """Friction holds its middle value, and `lag` has moved the lagged inputs."""
        return {"dx": _moved(x, base[:slips], acting(u), c) + [0.0] * (size - first)}

    def finish(base: Values, x: Values, z: Values) -> dict[str, Values]:
        moved = [slid(x[first + n], x[0] - base[slips], lengths[n]) for n in range(slips)]
        return {"x": [*x[:first], *moved, *x[last:]], "z": z}

    def flow(x: Values, z: Values, base: Values, u: Values) -> dict[str, Values]:
        """Rates of all states, friction as Dahl's differential equation."""
        slip, acts = x[first:last], x[last:] if lagged else u
        sliding = [(x[1] - function("abs", x[1]) * s) / length for s, length in zip(slip, lengths, strict=True)]
        lagging = [(value - late) / lag for value, late in zip(u, acts, strict=True)] if lagged else []
        return {"dx": _moved(x, slip, acting(acts), c) + sliding + lagging}

    def behind(before: Values, within: Values, after: Values, h: Values, x: Values) -> dict[str, Values]:
        """Inputs at the nodes of a step behind their lag, which may be far shorter than the step."""
        middles = [_lagged_after(0.5 * h[0], x[last + i], before[i], within[i], lag) for i in range(inputs)]
        ends = [_lagged_after(0.5 * h[0], middles[i], within[i], after[i], lag) for i in range(inputs)]
        return {"before": x[last:], "within": middles, "after": ends, "x": [*x[:last], *ends]}

    def inside(x: Values) -> dict[str, Values]:
        return {"ok": [function("and", function("lt", function("abs", x[0]), ESCAPE), function("finite", x[1]))]}

    state = {"x": size, "z": 1, "base": slips + 1, "u": inputs}
    functions = {
        "drive": trace(lambda v: {"u": [value / volts for value in v]}, v=inputs),
        "start": trace(start, q0=1, qdot0=1, u=inputs),
        "begin": trace(begin, x=size, z=1, h=1),
        "rates": trace(rates, **state),
        "finish": trace(finish, base=slips + 1, x=size, z=1),
        "flow": trace(flow, **state),
        "read": trace(lambda x, dx: {"y": [middle + half * x[0], half * x[1], half * dx[1]]}, x=size, dx=size),
        "within": trace(inside, x=size),
    }
    if lagged:
        functions["lag"] = trace(behind, before=inputs, within=inputs, after=inputs, h=1, x=size)
    return functions
