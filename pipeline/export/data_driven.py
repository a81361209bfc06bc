"""Models from data alone for export: the data-driven joint, the paper's of § 4.2, and SINDy's polynomial equations."""

from typing import Any

import numpy as np

from ..codegen.graph import Graph, apply, choose, function, trace
from ..generated.terms import BENT, DAHL_RATE, LAG, PAST_ZONE
from ..models.paper.model import RbfPaperModel, lagged_rates
from ..models.polynomial_dynamics import FIRST_INPUT, QDOT, polynomial_rates, steps_between_samples
from ..models.rbf.dynamics import free_rates, no_sensitivities, resting_elements, slide
from ..models.rbf.model import RbfModel
from ..models.rbf.observed_run import WALL
from ..models.rbf.problem import steps_per_sample as rbf_steps
from ..models.sindy.model import SindyModel
from ..numerics.fixed_step import escape_bounds, steps_per_sample
from .subject import Realisation, Variable, lagged_nodes

Values = list[Any]
Outputs = dict[str, Values]


def realise_rbf(model: RbfModel, interval: float, unit: str = "m") -> Realisation:
    """The model for export, at the sample interval [s] of its run."""
    joint = _Joint(model)
    hold = model.parameters.structure.hold
    log_delay = model.theta[model.parameters.slices["input_delay"]]
    return Realisation(
        functions=joint.functions(),
        constants={
            "joint": joint.c._asdict(),
            "middle": joint.middle,
            "half": joint.half,
            "volts": joint.volts,
            "squared": int(joint.squared),
            "offset": joint.offset,
            "lagged": int(joint.lagged),
            "lag": joint.lag,
        },
        inputs=joint.inputs,
        states=joint.states(),
        hysteresis_states=(),
        base=1,
        step=interval / rbf_steps(model.parameters, interval, model.theta),
        delay=float(np.exp(log_delay[0])) if len(log_delay) else 0.0,
        between="linear" if hold == "record" else hold,
        structure=str(model.describe()["structure"]),
    )


class _Joint:
    """Motion of the joint in scaled variables; its state is x, p, elements, friction states, lagged inputs.

    Attributes
    ----------
    c : Coefficients
        Of the state equation.
    middle, half, volts : float
        Middle and half of the range of q [m or rad], and the largest trained input.
    squared : bool
        True if inputs pull by their squares.
    offset : FloatArray, shape (K,)
        Offset of each scaled input.
    lagged, lag : bool, float
        True if the inputs lag, and by how much [s].
    effect_lags : bool
        True if the effect of the inputs lags, not the inputs themselves.
    bend, zone : float or None
        Bend of the inputs' effect, and their dead zone.
    rested : bool
        True if it is at rest under the first inputs before the run, not without any.
    inputs, slips : int
        Number of inputs, and of slip elements of the friction.
    first : int
        Place of the friction states; lagged inputs are behind them.
    """

    def __init__(self, model: RbfModel) -> None:
        p = model.parameters
        theta = model.theta
        offset = theta[p.slices["input_offset"]]
        log_lag = theta[p.slices["input_lag"]]
        self.c = p.coefficients(theta)
        self.middle = float(p.scales.middle)
        self.half = float(p.scales.half)
        self.volts = float(p.scales.volts)
        self.squared = p.law == "squared"
        self.offset = offset if len(offset) else np.zeros(len(p.signs))
        self.lagged = p.structure.input_lag
        self.lag = float(np.exp(log_lag[0])) if len(log_lag) else 0.0
        self.effect_lags = p.structure.effect_lags
        self.bend = float(theta[p.slices["input_bend"]][0]) if p.structure.bent_input else None
        self.zone = float(np.exp(theta[p.slices["input_zone"]][0])) if p.structure.dead_zone else None
        self.rested = not p.structure.rest_at_zero
        self.inputs = len(self.offset)
        self.slips = len(self.c.slip_force)
        self.first = 2 + len(self.c.rates)

    def functions(self) -> dict[str, Graph]:
        """Graphs by name, see `Realisation`."""
        k = self.inputs
        size = len(self.states())
        state = {"x": size, "z": 1, "base": 1, "u": k}
        lag = {"lag": trace(self.behind, before=k, within=k, after=k, h=1, x=size)} if self.lagged else {}
        return lag | {
            "drive": trace(self.drive, v=k),
            "start": trace(self.start, q0=1, qdot0=1, u=k),
            "begin": trace(self.begin, x=size, z=1, h=1),
            "rates": trace(self.rates, **state),
            "finish": trace(self.finish, base=1, x=size, z=1),
            "flow": trace(self.flow, **state),
            "read": trace(self.read, x=size, dx=size),
            "within": trace(self.within, x=size),
        }

    def states(self) -> tuple[Variable, ...]:
        """Names, units and meanings."""
        return (
            Variable("x", "1", "displacement from the middle of the operating range over half of it"),
            Variable("p", "1/s", "its rate", 10.0),
            *(Variable(f"w_{i}", "1/s", f"Maxwell state {i}") for i in range(len(self.c.rates))),
            *(Variable(f"s_{i}", "1", f"Dahl friction state {i}") for i in range(self.slips)),
            *(
                Variable(f"input_{i}", "1", f"lagged input {i + 1} over the largest trained one")
                for i in range(self.inputs if self.lagged else 0)
            ),
        )

    def drive(self, v: Values) -> Outputs:
        """Inputs over the largest one, or their effect where that lags."""
        u = [value / self.volts for value in v]
        return {"u": self._effect(u) if self.effect_lags else u}

    def start(self, q0: Values, qdot0: Values, u: Values) -> Outputs:
        """Elements at rest, friction relaxed."""
        before = u if self.rested else [0.0] * self.inputs
        at = (q0[0] - self.middle) / self.half
        elements = resting_elements(self.c, at, self._acting(before))
        x = [at, qdot0[0] / self.half, *elements, *([0.0] * self.slips)]
        return {"x": x + (before if self.lagged else []), "z": []}

    def begin(self, x: Values, z: Values, h: Values) -> Outputs:
        """Displacement at the start of the step."""
        return {"base": [x[0]]}

    def rates(self, x: Values, z: Values, base: Values, u: Values) -> Outputs:
        """Friction has followed the step so far, and `behind` has moved the lagged inputs."""
        return {"dx": self._moved(x, self._slid(x, x[0] - base[0]), self._acting(u)) + [0.0] * (len(x) - self.first)}

    def finish(self, base: Values, x: Values, z: Values) -> Outputs:
        """Friction states moved with the step; the wall ends a motion."""
        beyond = function("lt", WALL, function("abs", x[0]))
        at = choose(beyond, choose(function("lt", 0.0, x[0]), WALL, -WALL), x[0])
        moved = [at, choose(beyond, 0.0, x[1]), *x[2 : self.first]]
        return {"x": [*moved, *self._slid(x, x[0] - base[0]), *x[self.first + self.slips :]], "z": z}

    def flow(self, x: Values, z: Values, base: Values, u: Values) -> Outputs:
        """Rates of all states, friction as Dahl's differential equation."""
        last = self.first + self.slips
        slip = x[self.first : last]
        acting = self._acting(x[last:] if self.lagged else u)
        sliding = [apply(DAHL_RATE, x[1], s, float(d))[0] for s, d in zip(slip, self.c.slip_length, strict=True)]
        lagging = [apply(LAG, value, late, self.lag)[0] for value, late in zip(u, x[last:], strict=False)]
        return {"dx": self._moved(x, slip, acting) + sliding + lagging}

    def behind(self, before: Values, within: Values, after: Values, h: Values, x: Values) -> Outputs:
        """Inputs at the nodes of a step behind their lag, which may be far shorter than the step."""
        last = self.first + self.slips
        middles, ends = lagged_nodes(x[last:], before, within, after, h[0], self.lag)
        return {"before": x[last:], "within": middles, "after": ends, "x": [*x[:last], *ends]}

    def read(self, x: Values, dx: Values) -> Outputs:
        """Outputs in the units of the log."""
        return {"y": [self.middle + self.half * x[0], self.half * x[1], self.half * dx[1]]}

    def within(self, x: Values) -> Outputs:
        """True if the state is finite: the wall confines every run."""
        return {"ok": [function("finite", x[1])]}

    def _acting(self, u: Values) -> Values:
        """Inputs of the equation of motion from what `drive` gives, behind its lag."""
        return u if self.effect_lags else self._effect(u)

    def _effect(self, u: Values) -> Values:
        """Effect of scaled inputs: freed of their offset, bent, squared."""
        freed = [value - float(zero) for value, zero in zip(u, self.offset, strict=True)]
        bent = [value if self.bend is None else apply(BENT, value, self.bend)[0] for value in freed]
        drives = [value if self.zone is None else apply(PAST_ZONE, value, self.zone)[0] for value in bent]
        return [value * value if self.squared else value for value in drives]

    def _slid(self, x: Values, way: Any) -> Values:
        """Friction states after a monotonous travel."""
        slip, moved = np.empty((2, self.slips, 1), dtype=object)
        slip[:, 0] = x[self.first : self.first + self.slips]
        slide(slip, way, np.empty(0), np.empty(0), self.c, no_sensitivities(), moved)
        return list(moved[:, 0])

    def _moved(self, x: Values, slip: Values, f: Values) -> Values:
        """Rates of the displacement, its velocity and the relaxing elements under the inputs f of the motion."""
        return free_rates(self.c, x[: self.first], slip, f)


def realise_paper(model: RbfPaperModel, interval: float, unit: str = "m") -> Realisation:
    """The paper's model at the sample interval [s] of its run; `unit` is that of q."""
    low, high = escape_bounds(float(model.centres[0]), float(model.centres[-1]))

    def rates(x: Values, z: Values, base: Values, u: Values) -> dict[str, Values]:
        """State equation of a run."""
        return {"dx": lagged_rates(model, x, u)}

    squared = model.inputs == "squared"
    return Realisation(
        functions=_functions(rates, lambda qdot0, u: [*qdot0], np.ones(model.input_count), squared, low, high, 3),
        constants={
            "basis": model.basis,
            "centres": model.centres,
            "weights": np.ascontiguousarray(model.weights.T) / model.mass_kg,
            "bend": 0.5 / model.width**2,
            "lag": model.lag_s,
            "low": low,
            "high": high,
            "squared": int(squared),
        },
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
        """State equation of a run."""
        return {"dx": polynomial_rates(d, x, u)}

    def start(qdot0: Values, u: Values) -> Values:
        """Lag states begin at what they follow."""
        return [
            qdot0[0] / float(d.scales[QDOT]) if lag.source == QDOT else u[lag.source - FIRST_INPUT] for lag in d.lags
        ]

    return Realisation(
        functions=_functions(rates, start, d.scales[FIRST_INPUT:], d.squared, d.low, d.high, 2 + len(d.lags)),
        constants={
            "exponents": d.exponents,
            "coefficients": d.coefficients,
            "scales": d.scales,
            "lag": np.array([lag.time for lag in d.lags]),
            "lag_source": np.array([lag.source for lag in d.lags]),
            "low": d.low,
            "high": d.high,
            "squared": int(d.squared),
        },
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
    """Functions of such a model: inputs are the voltages, or their squares, over `scales` (K,)."""
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
