"""Facts from a model's characteristic curves: wells, barriers, switching voltages, asymmetry.

With the restoring force F(q), positive where it pulls towards smaller q, and the inputs' forces g_k(q) u_k,
the device rests where F(q) = Σ g_k(q) u_k (eq. 37 at rest); u = v² for an electrostatic input, u = v for a linear one.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..device.device import Device
from ..errors import InputError
from ..models.base import DynamicModel, HasCurveDraws, HasCurves
from ..numerics.arrays import BoolArray, FloatArray
from ..numerics.continuation import outermost_pair
from ..scoring.wells import NoWells, Wells
from ..store.columns import STABLE
from .run_data import RunData

COVERAGE = 0.9  # share of the draws inside a band or an interval
POINTS = 1201  # of the grid over the operating range
DRAWS = 64  # of the model's curves
COARSER = 20  # points of that grid per point at which the draws are evaluated; divides POINTS - 1
STEEP = 5.0  # times the change of the force two grid points away, beyond which it jumps
SMALL = 1e-3  # share of the range of the force that is no jump


@dataclass(frozen=True)
class Curves:
    """Characteristic curves on one grid.

    Attributes
    ----------
    q : FloatArray, shape (n,)
        Displacement [m or rad], ascending.
    force, damping : FloatArray, shape (n,)
        F [N] and d [N s/m]; per unit mass where the mass is unknown.
    gains : FloatArray, shape (K, n)
        g_k [N/V²] or [N/V]: ½ dC_k/dq for an electrostatic input.
    """

    q: FloatArray
    force: FloatArray
    damping: FloatArray | None
    gains: FloatArray

    @property
    def energy(self) -> FloatArray:
        """U [J] = ∫F dq, zero at its lowest point, shape (n,)."""
        total = np.concatenate(([0.0], np.cumsum(np.diff(self.q) * (self.force[1:] + self.force[:-1]) / 2.0)))
        return np.asarray(total - total.min())


@dataclass(frozen=True)
class CurveEquilibrium:
    """A state of rest: its place, and dF/dq there, positive if it is stable."""

    q: float
    stiffness: float

    @property
    def stable(self) -> bool:
        """True if the device stays there."""
        return self.stiffness > 0.0


def curves_from(named: Mapping[str, FloatArray], q: FloatArray) -> Curves:
    """Curves from a model's own names: ``F``, ``d``, and ``dC1_dq`` … [F/m] or ``g1`` … [N/V]."""
    shares = {"dC1_dq": 0.5, "dC2_dq": 0.5, "g1": 1.0, "g2": 1.0}
    gains = np.array([named[key] * share for key, share in shares.items() if key in named]).reshape(-1, q.size)
    return Curves(q, np.asarray(named["F"]), named.get("d"), gains)


def model_curves(data: RunData) -> tuple[dict[str, Curves], dict[str, list[Curves]]]:
    """Curves of every model that has them, over the range of the training data, and draws of their posterior."""
    grid = _operating_range([log.motion.q for log in data.role("train")])
    named = {name: own for name, model in data.models.items() if (own := _own_curves(model, grid)) is not None}
    draws = {
        name: [curves_from(drawn, grid) for drawn in _drawn_curves(model, own, grid)]
        for name, own in named.items()
        if isinstance(model := data.models[name], HasCurveDraws)
    }
    return {name: curves_from(own, grid) for name, own in named.items()}, draws


def _operating_range(motions: Sequence[FloatArray]) -> FloatArray:
    q = np.concatenate(motions)
    return np.linspace(float(np.nanmin(q)), float(np.nanmax(q)), POINTS)


def _own_curves(model: DynamicModel, grid: FloatArray) -> Mapping[str, FloatArray] | None:
    """Curves of a model by its own names; None of one without a restoring force."""
    if not isinstance(model, HasCurves):
        return None
    try:
        named: Mapping[str, FloatArray] = model.curves(grid)
    except InputError:
        return None  # a parameter set whose beam snaps while its tip is held has no curve over q
    return named if "F" in named else None


def stable_rests(model: DynamicModel, motions: Sequence[FloatArray]) -> int | None:
    """Number of places at which a device rests by a model's curves over the measured range of q; None without curves.

    Parameters
    ----------
    model : DynamicModel
        Any model.
    motions : sequence of FloatArray, shape (N,)
        Displacement [m or rad] in the training logs, NaN where masked.
    """
    grid = _operating_range(motions)
    named = _own_curves(model, grid)
    return None if named is None else sum(e.stable for e in equilibria(grid, np.asarray(named["F"])))


def believed_wells(wells: Wells | NoWells, model: str, rests: int | None, plant: Device) -> Wells | NoWells:
    """The wells seen in the data of the joint, and of another device if its model has two stable states.

    Parameters
    ----------
    wells : Wells or NoWells
        Seen in the data.
    model : str
        Name of the model.
    rests : int or None
        Its `stable_rests`.
    plant : Device
        Its inputs, and whether it is the joint.
    """
    if plant.joint or rests is None or rests == 2 or isinstance(wells, NoWells):
        return wells
    states = {0: "no two wells", 1: "a single rest"}
    return NoWells(f"{model} has {states.get(rests, f'{rests} stable states')}", rests == 1)


def _drawn_curves(
    model: HasCurveDraws, named: Mapping[str, FloatArray], grid: FloatArray
) -> list[dict[str, FloatArray]]:
    """The curves of draws from the posterior on the grid.

    A hybrid model's curve costs 0.03 ms a point. A draw differs from the model's own curves by little and smoothly, so
    the difference is evaluated at every `COARSER`-th point and interpolated. On P1 that moves no limit of the datasheet
    by more than 1e-4 of its interval.
    """
    from scipy.interpolate import CubicSpline

    coarse = grid[::COARSER]
    drawn = model.curve_ensemble(coarse, DRAWS)
    full = {key: named[key] + CubicSpline(coarse, drawn[key] - named[key][::COARSER], axis=1)(grid) for key in drawn}
    return [dict(zip(full, rows, strict=True)) for rows in zip(*full.values(), strict=True)]


def jumps(force: FloatArray) -> BoolArray:
    """Mask of the grid intervals in which the force jumps, shape (n − 1,): the beam's shape snaps there."""
    change = np.abs(np.diff(force))
    beside = np.maximum(np.roll(change, 2), np.roll(change, -2))
    beside[:2], beside[-2:] = change[2:4], change[-4:-2]
    return np.asarray((change > STEEP * beside) & (change > SMALL * np.ptp(force)))


def equilibria(q: FloatArray, force: FloatArray) -> list[CurveEquilibrium]:
    """Zeros of the force on the grid, by straight lines between its points; where it jumps it has none."""
    sign = np.sign(force)
    rows = np.flatnonzero((sign[:-1] * sign[1:] < 0.0) & ~jumps(force))
    slopes: FloatArray = np.diff(force) / np.diff(q)
    exact = [(float(q[i]), float(slopes[min(int(i), slopes.size - 1)])) for i in np.flatnonzero(sign == 0.0)]
    crossed = [(float(q[i] - force[i] / slopes[i]), float(slopes[i])) for i in rows]
    return [CurveEquilibrium(place, slope) for place, slope in sorted(exact + crossed)]


def outer_wells(curves: Curves, plant: Device) -> tuple[CurveEquilibrium, CurveEquilibrium, CurveEquilibrium] | None:
    """Left well, saddle, right well: the outermost stable states and the highest unstable one between.

    None where there are no two, or where the force jumps between them; on another device than the joint also where
    there are more than two.
    """
    places = equilibria(curves.q, curves.force)
    stable = [e.stable for e in places]
    pair = outermost_pair(stable, np.interp([e.q for e in places], curves.q, curves.energy).tolist())
    if pair is None or not (plant.joint or sum(stable) == 2):
        return None
    left, saddle, right = (places[i] for i in pair)
    between = (curves.q[:-1] > left.q) & (curves.q[1:] < right.q)
    return None if np.any(jumps(curves.force)[between]) else (left, saddle, right)


def switching_input(curves: Curves, k: int, start: float, saddle: float, plant: Device) -> float | None:
    """Lowest steady input [V] of electrode k that carries the device from the rest at `start` over the `saddle`.

    On the way the input's force must exceed the restoring one everywhere: u > max F/g_k over the path. None where the
    input's gain has the other sign, or is zero, somewhere on the way.

    Parameters
    ----------
    curves : Curves
        Curves of a model.
    k : int
        Number of the input, from zero.
    start : float
        Rest position [m or rad].
    saddle : float
        Unstable equilibrium [m or rad].
    plant : Device
        Action of its inputs.
    """
    path = (curves.q > min(start, saddle)) & (curves.q < max(start, saddle))
    force = curves.force[path]
    gain = curves.gains[k][path]
    toward = np.sign(saddle - start)
    resisting = force * toward > 0.0
    useless = gain[resisting] * toward <= 0.0 if plant.squared else gain[resisting] == 0.0
    if not resisting.any() or np.any(useless):
        return None
    u = force[resisting] / gain[resisting]
    if plant.squared:
        return float(np.sqrt(u.max()))
    if not (np.all(u > 0.0) or np.all(u < 0.0)):
        return None
    return float(u.max() if u[0] > 0.0 else u.min())


def device_facts(curves: Curves, plant: Device) -> dict[str, float | None]:
    """The numbers of a datasheet that follow from the curves alone, in SI; None where one does not exist.

    Of a device with one stable equilibrium only, ``rest`` and ``stiffness``. Where the force jumps between two wells,
    what is on the way between them does not follow from the curves. More than two stable states are two wells on the
    joint alone; on another device they are ``stable_1``, ``stable_2`` …, from the least q on.
    """
    stable = [e for e in equilibria(curves.q, curves.force) if e.stable]
    if len(stable) < 2:
        return {"rest": stable[0].q, "stiffness": stable[0].stiffness} if stable else {}
    if len(stable) > 2 and not plant.joint:
        return {f"{STABLE}{number}": e.q for number, e in enumerate(stable, start=1)}
    left, *_, right = stable
    facts: dict[str, float | None] = {
        "well_left": left.q,
        "well_right": right.q,
        "stiffness_left": left.stiffness,
        "stiffness_right": right.stiffness,
        "asymmetry_wells": (left.q + right.q) / (right.q - left.q),
    }
    outer = outer_wells(curves, plant=plant)
    if outer is None:
        return facts
    saddle = outer[1]
    energy = np.interp([left.q, saddle.q, right.q], curves.q, curves.energy)
    facts |= {
        "saddle": saddle.q,
        "barrier_left": float(energy[1] - energy[0]),
        "barrier_right": float(energy[1] - energy[2]),
    }
    for k in range(len(curves.gains)):
        facts[f"switch_v{k + 1}_to_right"] = switching_input(curves, k, left.q, saddle.q, plant)
        facts[f"switch_v{k + 1}_to_left"] = switching_input(curves, k, right.q, saddle.q, plant)
    mean = (facts["barrier_left"] + facts["barrier_right"]) / 2.0  # type: ignore[operator]
    facts["asymmetry_barriers"] = float(energy[2] - energy[0]) / mean if mean > 0.0 else None
    return facts


def intervals(
    values: Mapping[str, float | None], draws: list[dict[str, float | None]]
) -> dict[str, tuple[float, float]]:
    """The central 90 % of each fact over the model's curve draws, where at least nine in ten have it.

    A fact such as a rest does not follow linearly from the curves, so nearly all draws may lie on one side of the
    model's own value. The interval is then extended to that value.
    """
    limits = {}
    for key in sorted({key for draw in draws for key in draw}):
        drawn = [value for draw in draws if (value := draw.get(key)) is not None]
        if len(drawn) >= COVERAGE * len(draws):
            middle = np.quantile(drawn, [(1.0 - COVERAGE) / 2.0, (1.0 + COVERAGE) / 2.0]).tolist()
            ends = [end for end in (*middle, values.get(key)) if end is not None]
            limits[key] = (min(ends), max(ends))
    return limits


def shares(values: Mapping[str, float | None], draws: Sequence[Mapping[str, float | None]]) -> dict[str, float]:
    """Share of the model's curve draws that have each fact which its own curves have; empty without draws."""
    return {
        key: sum(draw.get(key) is not None for draw in draws) / len(draws)
        for key, value in values.items()
        if value is not None and draws
    }
