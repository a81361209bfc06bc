"""Drag of the air on the frame."""

import casadi as ca

from pipeline.equations.tip_elements import Constant, TipElement

DRAG = TipElement((Constant("drag", 0.02, 1.2, "N·s²/m²"),), lambda q, p, w, k: k["drag"] * ca.fabs(p) * p)
