"""Exact derivatives of the condensed joint's rates by state, inputs, constants and corrections.

State here: x (13,) and the stop operators z (3,) behind it, 16 numbers in all, names in `STATE_NAMES`; more with
further elements that have a memory.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from pipeline.codegen.numba_writer import kernel
from pipeline.compiled import compiled
from pipeline.generated.condensed_joint import CORRECTIONS, ELEMENT_STATES, STATES, STOPS
from pipeline.generated.condensed_joint_jacobian import BY_CONSTANTS, JACOBIAN, PREPARE
from pipeline.joint.condensed_kernels import corrections_at
from pipeline.numerics.arrays import FloatArray

STATE_NAMES = (
    "q", "qdot", "tau", "taudot", "beta",
    *(f"strain_{side}_{i}" for i in range(3) for side in ("left", "right")),
    *(name for name, _ in ELEMENT_STATES),
    *(f"stop_{i}" for i in range(STOPS)),
)  # fmt: skip
"""q [m], q̇ [m/s], τ [1], τ̇ [1/s], β [1], strains [1], creep displacements [m], stop operators [1]."""
_ALL = STATES + STOPS
_jacobian, _by_constants = kernel(JACOBIAN), kernel(BY_CONSTANTS)


class Linearisation(NamedTuple):
    """f (16,) rates; a = ∂f/∂(x, z) (16, 16); b = ∂f/∂u (16, 2) by the squared voltages [V²]."""

    f: FloatArray
    a: FloatArray
    b: FloatArray


@dataclass(frozen=True)
class PreparedJoint:
    """What depends on a joint's constants alone, and its corrections.

    `prepared` once for each joint takes 1 ms; then a linearisation takes 20 µs from Python.
    """

    p: FloatArray
    basis: FloatArray
    weights: FloatArray


def prepared(k: FloatArray, basis: FloatArray, weights: FloatArray) -> PreparedJoint:
    """A joint of constants k (len(CONSTANTS),), basis (3,) and weights (9, M) of the corrections."""
    return PreparedJoint(PREPARE.evaluate(k=k)["p"], basis, np.ascontiguousarray(weights))


def linearise(joint: PreparedJoint, x: FloatArray, z: FloatArray, u: FloatArray) -> Linearisation:
    """Rates and their exact Jacobians at a state.

    Parameters
    ----------
    joint : PreparedJoint
        See `prepared`.
    x : FloatArray, shape (13,)
        State; `pipeline.joint.condensed_statics.rest_state` gives one.
    z : FloatArray, shape (3,)
        Stop operators in [−1, 1] at x. Those that are at ±1 and pushed on stick there: their rows of `a` are zero.
    u : FloatArray, shape (2,)
        Squared voltages [V²].
    """
    f, a, b, by_c = np.zeros(_ALL), np.zeros(_ALL * _ALL), np.zeros(_ALL * 2), np.zeros(_ALL * len(CORRECTIONS))
    c, c_q = _corrections(joint, float(x[0]))
    linearise_into(x, z, u, joint.p, c, c_q, f, a, b, by_c)
    return Linearisation(f, a.reshape(_ALL, _ALL), b.reshape(_ALL, 2))


@compiled
def linearise_into(
    x: FloatArray, z: FloatArray, u: FloatArray, p: FloatArray, c: FloatArray, c_q: FloatArray,
    f: FloatArray, a: FloatArray, b: FloatArray, by_c: FloatArray,
) -> None:  # fmt: skip
    """`linearise` for compiled code: fills f (16,), a (256,) and b (32,) row by row, and by_c = ∂f/∂c (16 · 13,).

    Zeros of the structure are left as they are: pass arrays of zeros. c (13,) are the corrections at q, c_q (13,) their
    slopes along q (`correction_slopes`).
    """
    _jacobian((x, u, c, z, c_q, p, f, a, b, by_c))


def by_constants(joint: PreparedJoint, x: FloatArray, z: FloatArray, u: FloatArray) -> FloatArray:
    """∂f/∂k, shape (16, len(CONSTANTS)), in the order of `pipeline.generated.condensed_joint.CONSTANTS`."""
    count = BY_CONSTANTS.outputs["by_k"]
    found = np.zeros(count)
    _by_constants_into(x, z, u, joint.p, _corrections(joint, float(x[0]))[0], found)
    return found.reshape(_ALL, count // _ALL)


@compiled
def _by_constants_into(
    x: FloatArray, z: FloatArray, u: FloatArray, p: FloatArray, c: FloatArray, found: FloatArray
) -> None:
    _by_constants((x, u, c, z, p, found))


def by_weights(joint: PreparedJoint, x: FloatArray, z: FloatArray, u: FloatArray) -> FloatArray:
    """∂f/∂weights, shape (16, 9, M)."""
    f, a, b, by_c = np.zeros(_ALL), np.zeros(_ALL * _ALL), np.zeros(_ALL * 2), np.zeros(_ALL * len(CORRECTIONS))
    c, c_q = _corrections(joint, float(x[0]))
    linearise_into(x, z, u, joint.p, c, c_q, f, a, b, by_c)
    bells, slopes, _ = _bells(joint.basis, joint.weights.shape[1], float(x[0]))
    curves = by_c.reshape(_ALL, -1)
    found = curves[:, :9, None] * bells
    found[:, 4:8] += curves[:, 9:, None] * slopes
    return np.asarray(found)


def _corrections(joint: PreparedJoint, q: float) -> tuple[FloatArray, FloatArray]:
    """The 13 corrections at q and their slopes along q."""
    count = joint.weights.shape[1]
    if count == 0:
        return np.zeros(len(CORRECTIONS)), np.zeros(len(CORRECTIONS))
    _, slopes, bends = _bells(joint.basis, count, q)
    values = np.empty(len(CORRECTIONS))
    corrections_at(q, joint.basis, joint.weights, values)
    return values, np.concatenate([joint.weights @ slopes, joint.weights[4:8] @ bends])


def _bells(basis: FloatArray, count: int, q: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Gaussians at q, their slopes and curvatures, each (M,)."""
    r = (q - basis[0] - basis[1] * np.arange(count)) / basis[2]
    bells = np.exp(-0.5 * r * r)
    return bells, -r / basis[2] * bells, (r * r - 1.0) / basis[2] ** 2 * bells
