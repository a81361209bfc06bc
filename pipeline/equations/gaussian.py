"""The Gaussian of eq. 38; eq. 35 prints it without the minus sign that a bell needs."""

import casadi as ca

from pipeline.equations.basis_functions import BasisFunction

GAUSSIAN = BasisFunction(lambda square: ca.exp(-0.5 * square), 8.6)  # exp(−37) is below rounding
