"""The condensed joint's frame: the angle at which it stands, and the inertia of frame and beam."""

from dataclasses import dataclass

import casadi as ca

from pipeline.equations.beam import Expression
from pipeline.equations.condensed_beam import bends, raised
from pipeline.equations.condensed_symbols import Symbols


@dataclass(frozen=True)
class FrameAngle:
    """The frame's angle φ by sin φ = τ / √(1 + rotation τ²), arctan τ (eq. 1) for a rotation of 1.

    For 0 it is arcsin τ, the slope along the arc. Held are its sine and cosine, ∂φ/∂τ and ∂²φ/∂τ² over ∂φ/∂τ.
    """

    sin: Expression
    cos: Expression
    turn: Expression
    bend: Expression


def frame_angle(s: Symbols) -> FrameAngle:
    """The angle at the slope τ of the state."""
    tau, rotation = s.x[2], s.constant("rotation")
    root, rest = ca.sqrt(1.0 + rotation * tau * tau), ca.sqrt(1.0 + (rotation - 1.0) * tau * tau)
    over = 1.0 / (root * rest)
    of_root, of_rest = rest * over, root * over  # 1/√…
    bend = -tau * (2.0 * rotation * of_root * of_root + (rotation - 1.0) * of_rest * of_rest)
    return FrameAngle(tau * of_root, rest * of_root, of_root * over, bend)


@dataclass(frozen=True)
class Inertia:
    """Mass matrix (3, 3) of (q, τ, β) [kg, kg·m, kg·m²], and what velocities push with beyond it, (3,) [N, N·m, J]."""

    mass: Expression
    centrifugal: Expression


def frame_inertia(s: Symbols) -> Inertia:
    """Inertia of T = ½ mass (ẋ² + ẏ²) + ½ gyration φ̇² + cross q̇ τ̇ + ½ inertia τ̇² + ½ interior_inertia β̇².

    x = q + offset sin φ and y = −½ (q, τ, β) R (q, τ, β)ᵀ + offset (cos φ − 1) are where the frame's centre of mass is:
    the beam shortens where it bends, and the frame tilts. `cross` and `inertia` are the beam's, `gyration` the frame's.
    """
    k, phi, speeds = s.constant, frame_angle(s), s.speeds
    # ∂x and ∂y along (q, τ, β), and what ẍ and ÿ are without accelerations
    out, down, turning = phi.cos * phi.turn, phi.sin * phi.turn, phi.turn * s.x[3] * s.x[3]
    across = ca.vertcat(1.0, k("offset") * out, 0.0)
    up = raised(s) - ca.vertcat(0.0, k("offset") * down, 0.0)
    across_more = k("offset") * turning * (phi.cos * phi.bend - down)
    up_more = -ca.mtimes(speeds.T, ca.mtimes(bends(s), speeds)) - k("offset") * turning * (phi.sin * phi.bend + out)
    tilting = k("gyration") * phi.turn
    own = ca.vertcat(ca.horzcat(0.0, k("cross")), ca.horzcat(k("cross"), k("inertia") + tilting * phi.turn))
    mass = ca.diagcat(own, k("interior_inertia"))
    mass += k("mass") * (ca.mtimes(across, across.T) + ca.mtimes(up, up.T))
    push = k("mass") * (across * across_more + up * up_more)
    push[1] += tilting * phi.bend * turning
    return Inertia(mass, -push)
