"""Friction whose level sets in with the speed: Coulomb's, without its step at rest."""

import casadi as ca

from pipeline.equations.tip_elements import Constant, TipElement

SLIDING = TipElement(
    (Constant("sliding_force", 0.1e-3, 1.2, "N"), Constant("sliding_speed", 6e-3, 0.5, "m/s")),
    lambda q, p, w, k: k["sliding_force"] * p / ca.sqrt(p * p + k["sliding_speed"] * k["sliding_speed"]),
    level="sliding_force",
)
