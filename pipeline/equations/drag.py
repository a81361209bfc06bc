"""Drag of the air on the frame."""

import casadi as ca

from pipeline.equations.tip_elements import TipElement

DRAG = TipElement((("drag", 0.02, 1.2),), lambda q, p, k: k["drag"] * ca.fabs(p) * p)
