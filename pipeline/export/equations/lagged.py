"""The model of the paper's § 4.2 for export: RBF curves and a lagged velocity."""

from typing import Any

import numpy as np

from pipeline.codegen.graph import Graph
from pipeline.codegen.trace import Value, function, trace
from pipeline.export.realisation import Realisation, Variable
from pipeline.models.rbf_paper import RbfPaperModel
from pipeline.solvers.lagged_free_run import escape_bounds, steps_per_sample

Values = list[Any]


def voltages(inputs: int, squared: bool, scales: Any = 1.0) -> Graph:
    """``drive`` of inputs that are the voltages, squared where the force goes with their square, over their scale."""
    over = np.broadcast_to(1.0 / np.asarray(scales, dtype=np.float64), (inputs,))
    return trace(lambda v: {"u": [(x * x if squared else x) * y for x, y in zip(v, over, strict=True)]}, v=inputs)


def lagged_functions(low: float, high: float) -> dict[str, Graph]:
    """What models of q, q̇ and a lagged velocity have in common."""

    def within(x: Values) -> dict[str, Values]:
        inside = function("and", function("le", low, x[0]), function("le", x[0], high))
        return {"ok": [function("and", inside, function("and", *(function("finite", value) for value in x[1:3])))]}

    return {
        "start": trace(lambda q0, qdot0, u: {"x": [*q0, *qdot0, *qdot0], "z": []}, q0=1, qdot0=1, u=1),
        "begin": trace(lambda x, z, h: {"base": [0.0]}, x=3, z=1, h=1),
        "finish": trace(lambda base, x, z: {"x": x, "z": z}, base=1, x=3, z=1),
        "read": trace(lambda x, dx: {"y": [x[0], x[1], dx[1]]}, x=3, dx=3),
        "within": trace(within, x=3),
    }


def lagged_states(unit: str, meaning: str) -> tuple[Variable, ...]:
    """The three states."""
    return (
        Variable("displacement", unit, "displacement", 0.01),
        Variable("velocity", f"{unit}/s", "its velocity", 0.1),
        Variable("lagged_velocity", f"{unit}/s", meaning, 0.1),
    )


def realise(model: RbfPaperModel, interval: float, unit: str = "m") -> Realisation:
    """The model for export, at the sample interval [s] of its run; `unit` is that of q."""
    inputs = len(model.weights) - 2
    weights, bend = model.weights / model.mass, 0.5 / model.width**2

    def rates(x: Values, z: Values, base: Values, u: Values) -> dict[str, Values]:
        distances = [x[0] - float(centre) for centre in model.centres]
        bells: list[Value] = [function("exp", -bend * distance * distance) for distance in distances]
        c, d, *gains = (sum(float(w) * bell for w, bell in zip(row, bells, strict=True)) for row in weights)
        pushed = sum(gain * value for gain, value in zip(gains, u, strict=True))
        return {"dx": [x[1], pushed - c * x[0] - d * x[2], (x[1] - x[2]) / model.lag]}

    bounds = escape_bounds(float(model.centres[0]), float(model.centres[-1]))
    return Realisation(
        functions=lagged_functions(*bounds)
        | {
            "drive": voltages(inputs, model.inputs == "squared"),
            "rates": trace(rates, x=3, z=1, base=1, u=inputs),
        },
        constants={
            "centres": model.centres,
            "weights": weights.T,
            "bend": bend,
            "lag": model.lag,
            "low": bounds[0],
            "high": bounds[1],
            "squared": int(model.inputs == "squared"),
            "inputs": inputs,
        },
        inputs=inputs,
        states=lagged_states(unit, "velocity that the friction feels"),
        memories=(),
        base=1,
        step=interval / steps_per_sample(interval, model.lag),
        delay=0.0,
        spline=False,
        structure=str(model.describe()["structure"]),
    )
