"""Models of q, q̇ and a lagged velocity for export: the paper's of § 4.2, and SINDy's sparse polynomial equations."""

from typing import Any

import numpy as np

from ..codegen.graph import Graph, function, trace
from ..models.paper.lagged_free_run import lagged_rates
from ..models.paper.model import RbfPaperModel
from ..models.polynomial_dynamics import FIRST_INPUT, QDOT, polynomial_rates, steps_between_samples
from ..models.sindy.model import SindyModel
from ..numerics.fixed_step import escape_bounds, steps_per_sample
from .subject import Realisation, Variable

Values = list[Any]


def realise_paper(model: RbfPaperModel, interval: float, unit: str = "m") -> Realisation:
    """The paper's model at the sample interval [s] of its run; `unit` is that of q."""
    low, high = escape_bounds(float(model.centres[0]), float(model.centres[-1]))

    def rates(x: Values, z: Values, base: Values, u: Values) -> dict[str, Values]:
        """The law of a run."""
        return {"dx": lagged_rates(model.law, x, u)}

    squared = model.inputs == "squared"
    bend = 0.5 / model.width**2
    constants = {"basis": model.basis, "centres": model.centres, "weights": model.law.weights, "bend": bend}
    return Realisation(
        functions=_functions(rates, lambda qdot0, u: [*qdot0], np.ones(model.input_count), squared, low, high, 3),
        constants=constants | {"lag": model.lag_s, "low": low, "high": high, "squared": int(squared)},
        inputs=model.input_count,
        states=(*_states(unit), Variable("lagged_velocity", f"{unit}/s", "velocity that the friction feels", 0.1)),
        hysteresis_states=(),
        base=1,
        step=interval / steps_per_sample(interval, model.lag_s),
        delay=0.0,
        between="linear",
        structure=str(model.describe()["structure"]),
    )


def realise_polynomial(model: SindyModel, interval: float, unit: str = "m") -> Realisation:
    """A polynomial model at the sample interval [s] of its run; `unit` is that of q."""
    d = model.dynamics

    def rates(x: Values, z: Values, base: Values, u: Values) -> dict[str, Values]:
        """The law of a run."""
        return {"dx": polynomial_rates(d, x, u)}

    def start(qdot0: Values, u: Values) -> Values:
        """Lag states begin at what they follow."""
        return [
            qdot0[0] / float(d.scales[QDOT]) if lag.source == QDOT else u[lag.source - FIRST_INPUT] for lag in d.lags
        ]

    table: dict[str, Any] = {"exponents": d.exponents, "coefficients": d.coefficients, "scales": d.scales}
    table |= {"lag": np.array([lag.time for lag in d.lags]), "lag_source": np.array([lag.source for lag in d.lags])}
    bounds = {"low": d.low, "high": d.high, "squared": int(d.squared)}
    return Realisation(
        functions=_functions(rates, start, d.scales[FIRST_INPUT:], d.squared, d.low, d.high, 2 + len(d.lags)),
        constants=table | bounds,
        inputs=d.inputs,
        states=(
            *_states(unit),
            *(Variable(f"lag_{k + 1}", "1", "scaled velocity or input, lagged") for k in range(len(d.lags))),
        ),
        hysteresis_states=(),
        base=1,
        step=interval / steps_between_samples(d, interval),
        delay=0.0,
        between="linear",
        structure="; ".join(model.equations()),
    )


def _functions(
    rates: Any, start: Any, scales: Any, squared: bool, low: float, high: float, states: int
) -> dict[str, Graph]:
    """How such a model moves: inputs are the voltages, or their squares, over `scales` (K,)."""
    over = [float(1.0 / scale) for scale in scales]

    def within(x: Values) -> dict[str, Values]:
        """Q within its bounds, and the velocity finite."""
        inside = function("and", function("le", low, x[0]), function("le", x[0], high))
        return {"ok": [function("and", inside, function("finite", x[1]))]}

    def drive(v: Values) -> dict[str, Values]:
        """Inputs of the equations."""
        return {"u": [(x * x if squared else x) * y for x, y in zip(v, over, strict=True)]}

    def begun(q0: Values, qdot0: Values, u: Values) -> dict[str, Values]:
        """The states at the start."""
        return {"x": [*q0, *qdot0, *start(qdot0, u)], "z": []}

    return {
        "drive": trace(drive, v=len(over)),
        "start": trace(begun, q0=1, qdot0=1, u=len(over)),
        "begin": trace(lambda x, z, h: {"base": [0.0]}, x=states, z=1, h=1),
        "rates": trace(rates, x=states, z=1, base=1, u=len(over)),
        "finish": trace(lambda base, x, z: {"x": x, "z": z}, base=1, x=states, z=1),
        "read": trace(lambda x, dx: {"y": [x[0], x[1], dx[1]]}, x=states, dx=states),
        "within": trace(within, x=states),
    }


def _states(unit: str) -> tuple[Variable, Variable]:
    return Variable("displacement", unit, "displacement", 0.01), Variable("velocity", f"{unit}/s", "its velocity", 0.1)
