"""SINDy behind the model interface: a sparse polynomial equation, printed with units, simulated by our integrator."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import model_validator

from ...device.device import Device
from ...numerics.arrays import FloatArray, IntArray, bridged, sample_interval
from ...numerics.fixed_step import run_status
from ...signals.log import Log
from ..base import FreeRun, checked, gain_curves
from ..model_file import (
    MOST_INPUTS,
    Exponents,
    ModelFile,
    Positive,
    PositiveRow,
    Sizes,
    Span,
    Table,
    Unit,
    Units,
)
from ..model_type import ModelType
from ..polynomial_dynamics import (
    FIRST_INPUT,
    FRICTION,
    QDOT,
    Lag,
    PolynomialDynamics,
    Q,
    free_run,
    monomials,
    scaled_variables,
)

MOST_LAGS = 9


class SindyModel(ModelFile):
    """A sparse polynomial equation of motion, and its file."""

    sizes: ClassVar[Sizes] = {
        "P": (1, 500),
        "X": (FIRST_INPUT + 1, FIRST_INPUT + MOST_INPUTS + MOST_LAGS),
        "L": (0, MOST_LAGS),
    }
    name: Literal["sindy", "sindy-default"] = "sindy"
    """Name of the model: at its best, or pysindy as it comes."""
    exponents: Exponents
    """Powers of the scaled variables, a row for each monomial."""
    coefficients: Annotated[FloatArray, Table("2 P"), Unit("{q}/s, {q}/s²")]
    """Coefficients of the monomials of scaled variables: rows of q̇ and q̈."""
    scales: Annotated[PositiveRow, Unit("SI")]
    """Scale of each variable: displacement, velocities, inputs."""
    lag_s: Annotated[FloatArray, Table("L", 1e-9, 1e9), Unit("s")]
    """Times of the lag states."""
    lag_source: Annotated[IntArray, Table("L", QDOT, FIRST_INPUT + MOST_INPUTS, whole=True)]
    """Column of the exponents whose variable each lag state follows."""
    mass_kg: Annotated[Positive, Unit("{m}")] = 1.0
    """Moving mass or inertia; 1 if it is unknown, and curves are then per unit mass."""
    inputs: Literal["squared", "linear"]
    """Action of the inputs: squared or linear."""
    bounds: Annotated[Span, Unit("{q}")]
    """Smallest and largest displacement, beyond which a run counts as diverged."""
    units: Units = ("m", "V")
    """SI units of displacement and inputs."""

    @model_validator(mode="after")
    def _lags(self) -> Self:
        scales = len(self.scales) - len(self.lag_s)
        if scales <= FIRST_INPUT or not {QDOT, *range(FIRST_INPUT, scales)}.issuperset(self.lag_source.tolist()):
            raise ValueError("lag_source does not fit")
        return self

    @classmethod
    def of(
        cls,
        dynamics: PolynomialDynamics,
        plant: Device,
        name: Literal["sindy", "sindy-default"] = "sindy",
        diagnostics: Mapping[str, Any] | None = None,
    ) -> Self:
        """The model of a right-hand side.

        Parameters
        ----------
        dynamics : PolynomialDynamics
            The right-hand side.
        plant : Device
            Units in which equations are printed, and the mass, which only scales `curves`.
        name : {"sindy", "sindy-default"}
            Name of the model.
        diagnostics : mapping, optional
            Choice of the treatment.
        """
        d = dynamics
        return cls(
            name=name,
            exponents=d.exponents,
            coefficients=d.coefficients,
            scales=d.scales[[*range(d.scales.size), *(lag.source for lag in d.lags)]],
            lag_s=np.array([lag.time for lag in d.lags], dtype=np.float64),
            lag_source=np.array([lag.source for lag in d.lags], dtype=np.int64),
            mass_kg=plant.mass,
            inputs="squared" if d.squared else "linear",
            bounds=np.array([d.low, d.high]),
            diagnostics=dict(diagnostics or {}),
            units=(plant.displacement.symbol, plant.inputs[0].symbol),
        )

    @cached_property
    def dynamics(self) -> PolynomialDynamics:
        """The right-hand side."""
        lags = tuple(map(Lag, self.lag_source.tolist(), self.lag_s.tolist()))
        return PolynomialDynamics(
            self.exponents,
            self.coefficients,
            self.scales[: self.scales.size - len(lags)],
            lags,
            self.inputs == "squared",
            *self.bounds.tolist(),
        )

    @property
    def input_count(self) -> int:
        """Number of voltages that it takes."""
        return self.dynamics.inputs

    @property
    def fine_voltages(self) -> bool:
        """True if the model takes the voltages between the samples: pysindy's own model does not."""
        return self.name == "sindy"

    @checked
    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> FreeRun:
        """Free run; see `pipeline.models.base.DynamicModel.simulate`. Lag states start at what they follow."""
        path, reached = free_run(self.dynamics, v, sample_interval(t), q0, qdot0)
        return FreeRun(t, path[:, 0].copy(), path[:, 1].copy(), path[:, 2].copy(), *run_status(t, reached))

    def predict(
        self, t: FloatArray, v: FloatArray, seen: FloatArray, speed: FloatArray, starts: IntArray, ahead: IntArray
    ) -> Iterator[FloatArray]:
        """Predictions with lag states filtered from the measured signals; see `pipeline.models.base.Predicts`."""
        dt = sample_interval(t)
        measured = np.isfinite(seen) & np.isfinite(speed)
        followed = scaled_variables(
            self.dynamics, v if v.ndim == 2 else v[:, 0], bridged(seen, measured), bridged(speed, measured), dt
        )
        states = followed[:, followed.shape[1] - len(self.dynamics.lags) :]
        for start, count in zip(starts.tolist(), ahead.tolist(), strict=True):
            rows = slice(start, start + count + 1)
            yield free_run(self.dynamics, v[rows], dt, float(seen[start]), float(speed[start]), states[start])[0][:, 0]

    def curves(self, q: FloatArray) -> dict[str, FloatArray]:
        """Characteristic curves on a grid of q [m], shape (n,) (fig. 14).

        Returns
        -------
        dict
            ``F`` restoring force [N] at rest without voltage, ``d`` damping [N s/m] of slow motion and,
            for squared inputs, ``dC1_dq``, ``dC2_dq`` [F/m] = 2 g_k (eq. 33); for linear inputs ``g1``, ``g2`` [N/V].
            Per unit mass where `mass_kg` is 1 because it is unknown.
        """
        d = self.dynamics
        x = scaled_variables(replace(d, lags=()), np.zeros((q.size, d.inputs)), q, np.zeros_like(q), 1.0)
        x = np.column_stack([x, np.zeros((q.size, len(d.lags)))])
        damping = self._slope(x, QDOT) + self._slope(x, FRICTION)
        gains = (self.mass_kg * self._slope(x, FIRST_INPUT + k) for k in range(d.inputs))
        forces = {"F": -self.mass_kg * (monomials(d.exponents, x) @ d.coefficients[1]), "d": -self.mass_kg * damping}
        return forces | gain_curves(gains, squared=d.squared)

    def _slope(self, x: FloatArray, variable: int) -> FloatArray:
        """∂q̈/∂(variable) at rest, where all lags have followed it: its terms of first power, per unit of it."""
        d = self.dynamics
        followers = [d.scales.size + k for k, lag in enumerate(d.lags) if lag.source == variable]
        slope = np.zeros(len(x))
        for column in (variable, *followers):
            linear = d.exponents[:, column] == 1
            reduced = d.exponents[linear].copy()
            reduced[:, column] = 0
            slope += monomials(reduced, x) @ d.coefficients[1, linear] / d.scales[variable]
        return slope

    def equations(self) -> list[str]:
        """The equations as text, one term per part, coefficients in SI with their units."""
        d = self.dynamics
        length = self.units[0]
        lines = [f"q̇ [{length}/s] = {self._sum(0)}", f"q̈ [{length}/s²] = {self._sum(1)}"]
        symbols = self._symbols()
        for k, lag in enumerate(d.lags):
            z = symbols[d.scales.size + k]
            square = "²" if d.squared and lag.source >= FIRST_INPUT else ""
            lines.append(f"d{z}/dt = ({symbols[lag.source]}{square} − {z}) / ({lag.time:.4g} s)")
        if np.any(d.exponents[:, FRICTION]):
            lines.append(f"w = {d.scales[FRICTION]:.4g} {length}/s")
        return lines

    def _symbols(self) -> list[str]:
        d = self.dynamics
        numbered = [f"{letter}{k + 1}" for letter, count in (("v", d.inputs), ("z", len(d.lags))) for k in range(count)]
        return ["q", "q̇", "tanh(q̇/w)", "sin q", "cos q", *numbered]

    def _sum(self, row: int) -> str:
        d = self.dynamics
        sources = np.array([*range(d.scales.size), *(lag.source for lag in d.lags)])
        scales = np.where(sources == FRICTION, 1.0, d.scales[sources])
        orders = np.ones(sources.size, dtype=np.int64)
        orders[FIRST_INPUT : d.scales.size] = 2 if d.squared else 1
        parts = []
        kept = d.coefficients[row] != 0.0
        for powers, scaled in zip(d.exponents[kept], d.coefficients[row, kept], strict=True):
            value = scaled / float(np.prod(scales**powers))
            factors = [s if n == 1 else f"{s}^{n}" for s, n in zip(self._symbols(), powers * orders, strict=True) if n]
            unit = self._unit(np.bincount(sources, powers, d.scales.size).astype(int), row)
            number = f"{value:+.4g}{unit}" if unit or value != 1.0 else ""
            parts.append("·".join([number, *factors]).strip("·"))
        return " ".join(parts) if parts else "0"

    def _unit(self, powers: Any, row: int) -> str:
        """Unit of a coefficient: that of q̇ or q̈ over that of its monomial."""
        named = (
            (self.units[0], 1 - int(powers[Q] + powers[QDOT])),
            ("s", -1 - row + int(powers[QDOT])),
            (self.units[1], -int(powers[FIRST_INPUT:].sum()) * (2 if self.dynamics.squared else 1)),
        )
        parts = [f"{u}^{n}" if n != 1 else u for u, n in named if n and u != "1"]
        return f" {' '.join(parts)}" if parts else ""

    def describe(self) -> dict[str, Any]:
        """Structure, equations and how they were chosen."""
        return {"structure": "sparse polynomial", "equations": self.equations(), **self.diagnostics}


def identify_sindy(
    trajectories: Sequence[Log],
    plant: Device,
    *,
    most: int | None = None,
    name: Literal["sindy", "sindy-default"] = "sindy",
) -> SindyModel:
    """SINDy at its best, or as pysindy ships it; see `pipeline.models.sindy.fit`.

    Parameters
    ----------
    trajectories : sequence of Log
        Gap-free segments of the training logs, voltages as finely as they are known.
    plant : Device
        Action of the inputs, units, those of the log among them, and the mass, which scales the characteristic curves
        only.
    most : int, optional
        Candidates that the search for `sindy` tries.
    name : {"sindy", "sindy-default"}
        The model.

    Raises
    ------
    InputError
        No data, differing inputs, or a constant displacement.
    """
    from .fit import fit_default_sindy, fit_sindy

    best = name == "sindy"
    dynamics, notes = fit_sindy(trajectories, plant, most=most) if best else fit_default_sindy(trajectories, plant)
    return SindyModel.of(dynamics, plant, name, notes)


SINDY = ModelType(
    lambda data: identify_sindy(data.fitted_segments, data.device, most=data.compare.candidates),
    SindyModel,
    "export.data_driven:realise_polynomial",
)
SINDY_DEFAULT = ModelType(
    lambda data: identify_sindy(data.segments, data.device, name="sindy-default"),
    SindyModel,
    "export.data_driven:realise_polynomial",
)
