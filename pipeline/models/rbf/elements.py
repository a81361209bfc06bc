"""Accelerations by the equation of a data-driven joint, and the part of each of its elements: what acts."""

import numpy as np

from ...codegen.graph import trace
from ...numerics.arrays import FloatArray
from ...numerics.metrics import rms
from .coefficients import DAMPING, FORCE, INPUT, Coefficients
from .dynamics import free_rates
from .parameter_layout import ParameterLayout


def acting_forces(p: ParameterLayout, theta: FloatArray, states: FloatArray, inputs: FloatArray) -> dict[str, float]:
    """RMS of the acceleration [1/s²] that each element of the equation adds to states, 0 of one that is absent.

    It is the difference between the accelerations with the element and without. Cost: a trace of the equation for each
    element, and N evaluations of it.

    Parameters
    ----------
    p : ParameterLayout
        Structure.
    theta : FloatArray, shape (P,)
        Its parameters.
    states : FloatArray, shape (N, 2 + L + D)
        x, p, hidden elements and friction.
    inputs : FloatArray, shape (N, K)
        Acting inputs there.
    """
    c = p.coefficients(theta)
    whole = _accelerations(c, states, inputs)
    return {
        name: 0.0 if without is None else rms(whole - _accelerations(without, states, inputs))
        for name, without in _left_out(p, c).items()
    }


def _left_out(p: ParameterLayout, c: Coefficients) -> dict[str, Coefficients | None]:
    """The equation without each of the elements; None of one that it does not have."""
    s = p.structure
    first = INPUT + len(p.signs)
    shapes = first + s.shape_elements
    own = first + len(s.rates)
    return {
        "restoring force": _without_curves(c, FORCE)._replace(at_ends=np.zeros(2)),
        "damping": _without_curves(c, DAMPING),
        "inputs": _without_curves(c, slice(INPUT, first)),
        "hidden shapes": _without_curves(c, slice(first, shapes), slice(own, None)) if s.shape_elements else None,
        "relaxation": _without_curves(c, slice(shapes, own)) if own > shapes else None,
        "dry friction": c._replace(slip_force=np.zeros(s.slips)) if s.slips else None,
        "drag": c._replace(drag=0.0) if s.drag else None,
        "end stops": c._replace(stops=np.empty(0)) if s.stops else None,
    }


def _without_curves(c: Coefficients, *rows: int | slice) -> Coefficients:
    curves = c.curves.copy()
    for row in rows:
        curves[row] = 0.0
    return c._replace(curves=curves)


def _accelerations(c: Coefficients, states: FloatArray, inputs: FloatArray) -> FloatArray:
    """ṗ [1/s²] at the states, shape (N,)."""
    elements = 2 + len(c.rates)
    rates = trace(
        lambda x, slip, u: {"dx": free_rates(c, x, slip, u)}, x=elements, slip=len(c.slip_force), u=inputs.shape[1]
    )
    acceleration: FloatArray = rates.evaluate(x=states[:, :elements], slip=states[:, elements:], u=inputs)["dx"][:, 1]
    return acceleration
