"""Figures 8 and 11 to 15 of the paper: the recipe of § 4.2 and § 5 on a measured log."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from pipeline.device_facts.run_data import LogData
from pipeline.identification.rbf import basis_values
from pipeline.models.base import Model
from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.figure import Figure, Line, Panel, Points
from pipeline.reporting.study_figure import study_figure

ZOOM = (24.0, 30.0)
"""Stretch of figure 13 [s]."""
_OTHERS = ("v1", "analytical", "raw", "measured")
"""Whose colours the α have that were not chosen."""


@dataclass(frozen=True)
class AlphaView:
    """Figure 11c on one stretch of a record.

    Attributes
    ----------
    t : FloatArray, shape (N,)
        Times [s].
    alphas : FloatArray, shape (K,)
        Regularisation parameters [mm·s], the chosen one among them.
    chosen : float
        The recipe's α [mm·s].
    qdot : FloatArray, shape (K, N)
        Velocity [m/s] with each.
    misfit, roughness : FloatArray, shape (K,)
        RMS of record less regularised signal [m]; mean change of the acceleration from sample to sample [m/s²].
    """

    t: FloatArray
    alphas: FloatArray
    chosen: float
    qdot: FloatArray
    misfit: FloatArray
    roughness: FloatArray


def basis_figure(centres: FloatArray, width: float, weights: FloatArray) -> Figure:
    """Figure 8b: the basis functions, and the restoring coefficient c(q) as their weighted sum; weights (M,) [N/m]."""
    q = np.linspace(centres[0], centres[-1], 400)
    bells = basis_values(q, centres, width)
    functions = tuple(Line(f"{len(centres)} basis functions", "v1", q, bell) for bell in bells.T)
    terms = tuple(Line("its terms", "raw", q, term) for term in (bells * weights).T)
    total = Line("weighted sum", "rbf-paper", q, bells @ weights, "solid")
    panels = (Panel("φᵢ", "1", functions), Panel("c", "N/m", (*terms, total)))
    return Figure("basis", "Basis functions", "", "q", "m", panels, columns=2)


def signals_figure(log: LogData) -> Figure:
    """Figure 11a: voltages, position, velocity and acceleration of a log."""
    table, t = log.kinematics, log.kinematics["t"]
    sides = (("left", "v1"), ("right", "v2"))
    panels = [Panel("v", "V", tuple(Line(side, name, t, table[name]) for side, name in sides if name in table))]
    for name, key, unit in (("q", "q", "m"), ("q̇", "qdot", "m/s"), ("q̈", "qddot", "m/s²")):
        panels.append(Panel(name, unit, (Line("measured", "measured", t, table[key]),)))
    return Figure("signals", "Excitation and measured motion", "", "time", "s", tuple(panels))


def basis_study_figure(
    columns: Mapping[str, FloatArray], units: Mapping[str, str], chosen: tuple[int, float]
) -> Figure:
    """Figure 11b: errors and condition over M for several σ_n, the chosen pair marked."""
    figure = study_figure("basis", columns, units)
    here = (columns["basis_functions"] == chosen[0]) & (columns["smoothing"] == chosen[1])
    x, values = columns["basis_functions"][here], ("mse", "condition", "nrmse")
    factors = {"nrmse": 100.0}
    panels = tuple(
        replace(
            panel, points=(Points("the recipe", "measured", x, factors.get(key, 1.0) * columns[key][here], "ring"),)
        )
        for key, panel in zip(values, figure.panels, strict=True)
    )
    return replace(figure, panels=panels)


def alpha_figure(view: AlphaView) -> Figure:
    """Figure 11c: the velocity over time for several α, the chosen one strong; misfit and roughness over α."""
    chosen = np.isclose(view.alphas, view.chosen)
    order = np.argsort(chosen, kind="stable")  # the chosen one over the others
    velocities = tuple(
        Line(f"α = {view.alphas[i]:g} mm·s", "v2" if chosen[i] else _OTHERS[k % 4], view.t, view.qdot[i], "solid",
             wide=bool(chosen[i]))
        for k, i in enumerate(order)
    )  # fmt: skip
    panels = [Panel("q̇", "m/s", velocities, x=("t", "s"))]
    for name, unit, values in (("misfit", "m", view.misfit), ("roughness", "m/s²", view.roughness)):
        ring = Points("the recipe", "v2", view.alphas[chosen], values[chosen], "ring")
        line = Line("all α", "measured", view.alphas, values)
        panels.append(Panel(name, unit, (line,), points=(ring,), log=True, x=("α", "mm·s"), x_log=True))
    return Figure("alpha", "Regularisation parameter", "", "t", "s", tuple(panels), columns=2)


def curves_figure(models: Mapping[str, Model], q: FloatArray) -> Figure:
    """Figure 14: restoring force, damping and both ∂C/∂q of the models; every curve is whole within its axes."""
    curves = {name: model.curves(q) for name, model in models.items()}  # type: ignore[attr-defined]
    shown = (("F", "F", "N"), ("d", "d", "N s/m"), ("dC1_dq", "∂C₁/∂q", "F/m"), ("dC2_dq", "∂C₂/∂q", "F/m"))
    panels = tuple(
        Panel(title, unit, tuple(Line(model, model, q, known[key]) for model, known in curves.items()))
        for key, title, unit in shown
    )
    return Figure("curves", "Characteristic curves", "", "q", "m", panels, columns=2)
