"""Figures 8 and 11 to 15 of the paper: the recipe of § 4.2 and § 5 on a measured log, drawn with matplotlib."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pipeline.device_facts.run_data import LogData, inputs_of
from pipeline.identification.rbf import basis_values
from pipeline.models.base import Model
from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.canvas import label, new_figure
from pipeline.reporting.legend import MODEL_COLOURS

COLOURS = {"measured": "#000000", "analytical": "#8C8C8C", "analytical-calibrated": MODEL_COLOURS[0],
           "rbf-paper": MODEL_COLOURS[1], "sindy": MODEL_COLOURS[2]}  # fmt: skip
SIGNALS = (("q", 1e3, "q [mm]"), ("phi", 180.0 / np.pi, "φ [deg]"), ("qdot", 1e3, "q̇ [mm/s]"),
           ("qddot", 1.0, "q̈ [m/s²]"))  # fmt: skip
ZOOM = (24.0, 30.0)
"""Stretch of figure 13 [s]."""


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


def basis_figure(centres: FloatArray, width: float, weights: FloatArray) -> Any:
    """Figure 8b: the basis functions, and the restoring coefficient c(q) as their weighted sum; weights (M,) [N/m]."""
    q = np.linspace(centres[0], centres[-1], 400)
    bells = basis_values(q, centres, width)
    figure, ((left, right),) = new_figure(1, 2, height=2.6)
    left.plot(1e3 * q, bells, linewidth=0.9)
    label(left, "q [mm]", "φᵢ [1]", f"{len(centres)} basis functions")
    right.plot(1e3 * q, bells * weights, color="#8C8C8C", linewidth=0.7)
    right.plot(1e3 * q, bells @ weights, color=MODEL_COLOURS[1])
    label(right, "q [mm]", "c [N/m]", "Weighted sum c(q), grey: its terms")
    return figure


def signals_figure(log: LogData) -> Any:
    """Figure 11a: voltages, position, velocity and acceleration of a log."""
    table, v = log.kinematics, inputs_of(log.kinematics)
    figure, axes = new_figure(4, 1, height=1.5, share_x=True)
    for side, name in enumerate(("left", "right")[: v.shape[1]]):
        axes[0, 0].plot(table["t"], 1e-3 * v[:, side], color=MODEL_COLOURS[1 + side], linewidth=0.8, label=name)
    axes[0, 0].legend(fontsize="x-small", loc="upper right")
    label(axes[0, 0], "", "v [kV]")
    panels = [signal for signal in SIGNALS if signal[0] != "phi"]
    for row, (name, factor, text) in enumerate(panels, start=1):
        axes[row, 0].plot(table["t"], factor * table[name], color="#000000", linewidth=0.8)
        label(axes[row, 0], "t [s]" if row == 3 else "", text)
    figure.align_ylabels()
    return figure


def basis_study_figure(columns: Mapping[str, FloatArray], chosen: tuple[int, float]) -> Any:
    """Figure 11b: mean squared error of the acceleration over M for several σ_n, the chosen pair marked."""
    figure, ((error, held_out),) = new_figure(1, 2, height=2.6)
    for index, smoothing in enumerate(np.unique(columns["smoothing"])):
        rows = columns["smoothing"] == smoothing
        m, colour = columns["basis_functions"][rows], MODEL_COLOURS[index % len(MODEL_COLOURS)]
        error.semilogy(m, columns["mse"][rows], "o-", color=colour, markersize=3, label=f"σₙ = {smoothing:g}")
        held_out.plot(m, 100.0 * columns["nrmse"][rows], "o-", color=colour, markersize=3)
    here = (columns["basis_functions"] == chosen[0]) & (columns["smoothing"] == chosen[1])
    for axes, values in ((error, columns["mse"]), (held_out, 100.0 * columns["nrmse"])):
        axes.plot(columns["basis_functions"][here], values[here], "o", color="#000000", fillstyle="none", markersize=9)
    error.legend(fontsize="x-small")
    label(error, "basis functions M", "MSE of q̈ [(m/s²)²]", "Training; ring: the recipe")
    label(held_out, "basis functions M", "NRMSE of q [%]", "Free run, held-out logs")
    return figure


def alpha_figure(view: AlphaView) -> Any:
    """Figure 11c: the velocity over time for several α, the chosen one in red; misfit and roughness over α."""
    figure, axes = new_figure(1, 2, height=2.8)
    over_time, over_alpha = axes[0]
    for index, alpha in enumerate(view.alphas):
        chosen = bool(np.isclose(alpha, view.chosen))
        colour = "#D00000" if chosen else str(0.25 + 0.5 * index / len(view.alphas))
        over_time.plot(
            view.t, 1e3 * view.qdot[index], color=colour, linewidth=1.6 if chosen else 0.8,
            zorder=3 if chosen else 2, label=f"α = {alpha:g}",
        )  # fmt: skip
    over_time.legend(fontsize="x-small", title="mm·s", title_fontsize="x-small")
    label(over_time, "t [s]", "q̇ [mm/s]", "Velocity")
    over_alpha.loglog(view.alphas, 1e3 * view.misfit, "o-", color="#000000", markersize=3, label="misfit [mm]")
    over_alpha.loglog(view.alphas, view.roughness, "s--", color="#8C8C8C", markersize=3, label="roughness [m/s²]")
    over_alpha.axvline(view.chosen, color="#D00000", linewidth=1.0)
    over_alpha.legend(fontsize="x-small")
    label(over_alpha, "α [mm·s]", "", "What it costs, red: chosen")
    return figure


def comparison_figure(log: LogData, models: Sequence[str], stretch: tuple[float, float] | None = None) -> Any:
    """Figures 12, 13 and 15: measurement and free runs of q, φ, q̇, q̈, over the whole log or a stretch [s] of it."""
    t = log.kinematics["t"] - log.kinematics["t"][0]
    rows = np.ones(t.size, bool) if stretch is None else (t >= stretch[0]) & (t <= stretch[1])
    measured = {**log.kinematics, **({} if log.phi is None else {"phi": log.phi})}
    shown = [signal for signal in SIGNALS if signal[0] in measured]
    figure, axes = new_figure(len(shown), 1, height=1.6, share_x=True)
    for row, (name, factor, text) in enumerate(shown):
        panel, values = axes[row, 0], factor * measured[name][rows]
        panel.plot(t[rows], values, color=COLOURS["measured"], linewidth=1.6, label="measured")
        for model in models:
            run = log.predictions.get(model, {})
            if name in run:
                panel.plot(t[rows], factor * run[name][rows], color=COLOURS[model], linewidth=0.9, label=model)
        low, high = np.nanmin(values), np.nanmax(values)
        panel.set_ylim(low - 0.35 * (high - low), high + 0.35 * (high - low))
        label(panel, "t [s]" if row == len(shown) - 1 else "", text)
    axes[0, 0].legend(fontsize="x-small", loc="upper right", ncols=4)
    figure.align_ylabels()
    return figure


def curves_figure(models: Mapping[str, Model], q: FloatArray) -> Any:
    """Figure 14: restoring force, damping and both ∂C/∂q of the models; every curve is whole within its axes."""
    figure, axes = new_figure(2, 2, height=2.5)
    panels = (("F", 1e3, "F [mN]"), ("d", 1.0, "d [N·s/m]"), ("dC1_dq", 1e9, "∂C₁/∂q [nF/m]"),
              ("dC2_dq", 1e9, "∂C₂/∂q [nF/m]"))  # fmt: skip
    for model, known in models.items():
        curves = known.curves(q)  # type: ignore[attr-defined]
        colour = "#000000" if model == "analytical" else COLOURS[model]
        for (name, factor, _), panel in zip(panels, axes.flat, strict=True):
            panel.plot(1e3 * q, factor * curves[name], color=colour, linewidth=1.2, label=model)
    for (_, _, text), panel in zip(panels, axes.flat, strict=True):
        label(panel, "q [mm]", text)
    axes[0, 0].legend(fontsize="x-small")
    return figure
