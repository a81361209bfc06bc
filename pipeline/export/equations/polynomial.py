"""SINDy's sparse polynomial equations for export."""

from typing import Any

import numpy as np

from pipeline.baselines.polynomial_dynamics import FIRST_INPUT
from pipeline.codegen.trace import function, trace
from pipeline.export.equations.lagged import lagged_functions, lagged_states, voltages
from pipeline.export.realisation import Realisation
from pipeline.models.sindy import SindyModel
from pipeline.solvers.lagged_free_run import steps_per_sample

Values = list[Any]


def realise(model: SindyModel, interval: float, unit: str = "m") -> Realisation:
    """The model for export, at the sample interval [s] of its run; `unit` is that of q."""
    d = model.dynamics
    inputs, scales = d.scales.size - FIRST_INPUT, [float(scale) for scale in d.scales]

    def rates(x: Values, z: Values, base: Values, u: Values) -> dict[str, Values]:
        scaled = [x[0] / scales[0], x[1] / scales[1], x[2] / scales[2], function("tanh", x[1] / scales[3])]
        scaled += [function("sin", x[0]), function("cos", x[0]), *u]
        found: Values = [0.0, 0.0]
        for powers, coefficients in zip(d.exponents, d.coefficients.T, strict=True):
            factors = [value for value, power in zip(scaled, powers, strict=True) for _ in range(power)]
            for i in range(2):
                term: Any = float(coefficients[i])
                for factor in factors if term else ():
                    term = term * factor
                found[i] = found[i] + term
        return {"dx": [*found, (x[1] - x[2]) / d.lag_time if d.lag_time > 0.0 else 0.0]}

    return Realisation(
        functions=lagged_functions(d.low, d.high)
        | {
            "drive": voltages(inputs, d.squared, d.scales[FIRST_INPUT:]),
            "rates": trace(rates, x=3, z=1, base=1, u=inputs),
        },
        constants={
            "exponents": d.exponents,
            "coefficients": d.coefficients,
            "scales": d.scales,
            "lag": d.lag_time,
            "lagged": int(d.lag_time > 0.0),
            "low": d.low,
            "high": d.high,
            "squared": int(d.squared),
        },
        inputs=inputs,
        states=lagged_states(unit, "velocity that a friction term feels; constant where there is none"),
        memories=(),
        base=1,
        step=interval / steps_per_sample(interval, d.lag_time if d.lag_time > 0.0 else np.inf),
        delay=0.0,
        spline=False,
        structure="; ".join(model.equations()),
    )
