"""Velocity and acceleration of a log, segment by segment."""

from typing import Any

import numpy as np

from ...device.device import device
from ...numerics.arrays import FloatArray, sample_interval
from ...settings.prototype import Differentiate, Prototype
from ...signals.differentiate import PAPER_EPSILON, differentiate
from ...store.tables import Table
from ...units.units import ALPHA_UNIT

_WAY = 10
_AGREES = 0.1


def kinematics(signals: Table, fine: Table, prototype: Prototype) -> tuple[Table, dict[str, Any]]:
    """The signals with velocity and acceleration, NaN where masked, and notes on how they were differentiated.

    Parameters
    ----------
    signals : Table
        At the sample interval.
    fine : Table
        The record that is differentiated, whose grid holds the times of the signals.
    prototype : Prototype
        Its settings of the stage.
    """
    qdot, qddot, notes = derivatives(fine, signals["t"], prototype)
    if "velocity" in signals and (warning := contradiction(signals)):
        notes["warnings"] = [warning]
    masked = signals["segment"] < 0
    return signals | {"qdot": np.where(masked, np.nan, qdot), "qddot": np.where(masked, np.nan, qddot)}, notes


def contradiction(signals: Table) -> str | None:
    """A warning if q does not move as its measured velocity, else None.

    Ways over `_WAY` samples are compared, so that neither the steps of an encoder nor the noise of a velocity matter.
    """
    steps = 0.5 * sample_interval(signals["t"]) * (signals["velocity"][1:] + signals["velocity"][:-1])
    by_velocity = np.convolve(steps, np.ones(_WAY), "valid")
    by_q = signals["q"][_WAY:] - signals["q"][:-_WAY]
    both = np.isfinite(by_velocity) & np.isfinite(by_q)
    power = float(by_velocity[both] @ by_velocity[both])
    if power == 0.0:
        return "qdot is always zero; take the channel out of [channels], or name another"
    factor = float(by_q[both] @ by_velocity[both]) / power
    if abs(factor - 1.0) <= _AGREES:
        return None
    return f"q moves {factor:.3g} times as far as qdot; check unit, scale and sign of both in [channels]"


def derivatives(fine: Table, t: FloatArray, prototype: Prototype) -> tuple[FloatArray, FloatArray, dict[str, Any]]:
    """Velocity and acceleration at the times `t`, from a record whose grid holds them.

    Where the velocity was measured it is smoothed, with parameters of its own chosen by its noise, and differentiated
    once; else q is differentiated twice.

    Parameters
    ----------
    fine : Table
        A uniform record with its segments, and perhaps the measured ``velocity``.
    t : FloatArray, shape (N,)
        Times [s] on the record's grid.
    prototype : Prototype
        Its settings of the stage.

    Returns
    -------
    qdot, qddot : FloatArray, shape (N,)
        NaN where the record is masked.
    notes : dict
        For each segment its parameters and noise, in the unit that alpha and epsilon are set for, and convergence.
    """
    unit = ALPHA_UNIT[device(prototype).displacement.symbol][1]
    settings = prototype.differentiate
    measured = "velocity" in fine
    grid = fine["t"]
    interval = sample_interval(grid)
    method = differentiator(settings, measured=measured, unit=unit)
    rates = np.full((2, len(grid)), np.nan)
    segments = []
    for number in np.unique(fine["segment"][fine["segment"] >= 0]):
        rows = fine["segment"] == number
        result = differentiate(fine["velocity" if measured else "q"][rows], interval, **method)
        rates[:, rows] = (result.q_smooth, result.qdot) if measured else (result.qdot, result.qddot)
        segments.append(
            {
                "segment": int(number),
                "alpha": result.alpha / unit,
                "epsilon": result.epsilon / unit**2,
                "noise_std": result.noise_std / unit,
                "iterations": result.iterations,
                "converged": result.converged,
            }
        )
    index = np.rint((t - grid[0]) / interval).astype(np.int64)
    return (
        rates[0, index],
        rates[1, index],
        {
            "method": settings.method,
            "of": "velocity" if measured else "q",
            **({"order": method["order"]} if settings.method == "tvregdiff" else {}),
            "interval_s": interval,
            "unit_si": unit,
            "stretches": segments,
        },
    )


def differentiator(settings: Differentiate, *, measured: bool, unit: float) -> dict[str, Any]:
    """Arguments of the differentiator. A `measured` velocity has its own: one order less, 2 or 3, and an alpha that its
    noise chooses, as one that was set is of q.
    """
    chosen = measured or settings.alpha == "auto"
    return {
        "method": settings.method,
        "order": max(2, min(3, settings.order - 1)) if measured else settings.order,
        "alpha": None if chosen else float(settings.alpha) * unit,
        "epsilon": None if chosen else (settings.epsilon or PAPER_EPSILON) * unit**2,
    }
