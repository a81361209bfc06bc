"""Figures 8 and 11 to 15 of the paper, its recipe (§ 4.2, § 5) on a measured log; and the figures of the studies."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ..device.device import JOINT
from ..diagnostics.run_data import LogData
from ..numerics.arrays import FloatArray
from ..signals.differentiate import AlphaStudy
from ..store.columns import StudyName
from .figure import Figure, Line, Panel, Points

ZOOM = (24.0, 30.0)
"""Segment of figure 13 [s]."""
_OTHERS = ("v1", "analytical", "raw", "measured")
"""Colours of the α that were not chosen."""


def basis_figure(q: FloatArray, bells: FloatArray, weights: FloatArray) -> Figure:
    """Figure 8b: the basis functions at q (n, M), and c(q) as their weighted sum; weights (M,) [N/m]."""
    functions = tuple(Line(f"{len(weights)} basis functions", "v1", q, bell) for bell in bells.T)
    terms = tuple(Line("its terms", "raw", q, term) for term in (bells * weights).T)
    total = Line("weighted sum", "rbf-paper", q, bells @ weights, "solid")
    panels = (Panel("φᵢ", "1", functions), Panel("c", "N/m", (*terms, total)))
    return Figure("basis", "Basis functions", caption="", x_name="q", x_unit="m", panels=panels, columns=2)


def lag_figure(search: Mapping[str, FloatArray]) -> Figure:
    """Rank and condition number at each accepted step of the search for T_z (§ 4.2)."""
    lag = search["lag_s"]
    panels = tuple(
        Panel(
            title,
            "1",
            (Line("accepted steps", "measured", lag, search[key], "solid"),),
            points=(Points("taken", "rbf-paper", lag[-1:], search[key][-1:], "ring"),),
            log=key == "condition",
            whole=key == "rank",
        )
        for title, key in (("rank", "rank"), ("condition number", "condition"))
    )
    return Figure(
        "lag-search", "Search for T_z", caption="", x_name="T_z", x_unit="s", panels=panels, columns=2, x_log=True
    )


def signals_figure(log: LogData) -> Figure:
    """Figure 11a: voltages, position, velocity and acceleration of a log."""
    motion = log.motion
    sides = zip(("left", "right"), ("v1", "v2"), motion.v.T, strict=True)
    panels = (
        Panel("v", "V", tuple(Line(side, name, motion.t, v) for side, name, v in sides)),
        *(
            Panel(name, unit, (Line("measured", "measured", motion.t, values),))
            for name, unit, values in (("q", "m", motion.q), ("q̇", "m/s", motion.qdot), ("q̈", "m/s²", motion.qddot))
        ),
    )
    return Figure("signals", "Excitation and measured motion", caption="", x_name="time", x_unit="s", panels=panels)


def basis_study_figure(
    columns: Mapping[str, FloatArray], units: Mapping[str, str], chosen: tuple[int, float]
) -> Figure:
    """Figure 11b: errors and condition over M for several σ_n, the chosen pair marked."""
    figure = study_figure("basis", columns, units)
    here = (columns["basis_functions"] == chosen[0]) & (columns["smoothing"] == chosen[1])
    x = columns["basis_functions"][here]
    factors = {"nrmse": PERCENT}
    panels = tuple(
        replace(
            panel, points=(Points("the recipe", "measured", x, factors.get(key, 1.0) * columns[key][here], "ring"),)
        )
        for key, panel in zip(("mse", "condition", "nrmse"), figure.panels, strict=True)
    )
    return replace(figure, panels=panels)


def alpha_figure(t: FloatArray, study: AlphaStudy, recipe: float) -> Figure:
    """Figure 11c: velocity at t [s] for several α [mm·s], that of the recipe strong; misfit and roughness over α."""
    chosen = np.isclose(study.alphas, recipe)
    order = np.argsort(chosen, kind="stable")  # the chosen one over the others
    velocities = tuple(
        Line(
            f"α = {study.alphas[i]:g} mm·s",
            "v2" if chosen[i] else _OTHERS[k % len(_OTHERS)],
            t,
            study.qdot[i],
            "solid",
            wide=bool(chosen[i]),
        )
        for k, i in enumerate(order)
    )
    panels = [Panel("q̇", "m/s", velocities, x=("t", "s"))]
    for name, unit, values in (("misfit", "m", study.misfit), ("roughness", "m/s²", study.roughness)):
        ring = Points("the recipe", "v2", study.alphas[chosen], values[chosen], "ring")
        line = Line("all α", "measured", study.alphas, values)
        panels.append(Panel(name, unit, (line,), points=(ring,), log=True, x=("α", "mm·s"), x_log=True))
    return Figure(
        "alpha", "Regularisation parameter", caption="", x_name="t", x_unit="s", panels=tuple(panels), columns=2
    )


def curves_figure(curves: Mapping[str, Mapping[str, FloatArray]], q: FloatArray) -> Figure:
    """Figure 14: restoring force, damping and both ∂C/∂q by model; every curve is whole within its axes."""
    units = replace(JOINT, known_mass=1.0).curve_units
    shown = (("F", "F", "F"), ("d", "d", "d"), ("dC1_dq", "∂C₁/∂q", "dC"), ("dC2_dq", "∂C₂/∂q", "dC"))
    panels = tuple(
        Panel(title, units[unit], tuple(Line(model, model, q, own[key]) for model, own in curves.items()))
        for key, title, unit in shown
    )
    return Figure("curves", "Characteristic curves", caption="", x_name="q", x_unit="m", panels=panels, columns=2)


PERCENT = 100.0

Columns = Mapping[str, FloatArray]


def study_figure(name: StudyName, columns: Columns, units: Mapping[str, str]) -> Figure:
    """The figure of one study.

    Parameters
    ----------
    name : {"alpha", "basis", "data", "online"}
        Name of the study.
    columns : mapping of str to FloatArray, each of shape (n,)
        As the study's table holds them.
    units : mapping of str to str
        SI units of the columns.
    """
    return {"alpha": _alpha, "basis": _basis, "data": _data, "online": _online}[name](columns, units)


def _alpha(columns: Columns, units: Mapping[str, str]) -> Figure:
    panels = tuple(
        Panel(
            title,
            units[key],
            (Line("longest segment of the first training log", "v1", columns["alpha"], columns[key]),),
            log=True,
        )
        for key, title in (("misfit", "misfit"), ("roughness", "roughness of q̈"))
    )
    caption = "Small α leaves noise in the acceleration (roughness), large α smooths the motion away (misfit)."
    return Figure(
        "study-alpha",
        "Regularisation parameter",
        caption=caption,
        x_name="α",
        x_unit=units["alpha"],
        panels=panels,
        x_log=True,
    )


def _basis(columns: Columns, units: Mapping[str, str]) -> Figure:
    rows_of = {value: columns["smoothing"] == value for value in np.unique(columns["smoothing"])}
    roles = ("v1", "v2", "measured", "reference")
    values = {**columns, "nrmse": PERCENT * columns["nrmse"]}

    def lines(key: str) -> tuple[Line, ...]:
        """A quantity over M, a line for each σₙ."""
        return tuple(
            Line(
                f"σₙ = {value:g}",
                roles[i % len(roles)],
                columns["basis_functions"][rows],
                values[key][rows],
                dash="dashed" if i > 1 else "role",
            )
            for i, (value, rows) in enumerate(rows_of.items())
        )

    panels = (
        Panel("MSE of q̈", units["mse"], lines("mse"), log=True),
        Panel("condition number", "1", lines("condition"), log=True),
        Panel("NRMSE of q", "%", lines("nrmse")),
    )
    caption = (
        "Training error of the acceleration, conditioning, and free-run error on the logs held out (100 %: diverged, "
        "or missed everything)."
    )
    return Figure(
        "study-basis",
        "Basis functions and smoothing",
        caption=caption,
        x_name="basis functions M",
        x_unit="1",
        panels=panels,
        whole=True,
    )


def _data(columns: Columns, _: Mapping[str, str]) -> Figure:
    rows = columns["noise"] == 0.0
    order = np.argsort(columns["samples"][rows])
    x = columns["samples"][rows][order]
    median, low, high = (PERCENT * columns[key][rows][order] for key in ("nrmse", "nrmse_low", "nrmse_high"))
    spread = (Points("smallest", "reference", x, low, "ring"), Points("largest", "reference", x, high, "cross"))
    panel = Panel("NRMSE of q", "%", (Line("median", "v1", x, median),), points=spread)
    caption = "Free-run error on the logs held out against the amount of training data; repeats at random places."
    return Figure(
        "study-data",
        "Amount of training data",
        caption=caption,
        x_name="training samples",
        x_unit="1",
        panels=(panel,),
        x_log=True,
        whole=True,
    )


def _online(columns: Columns, _: Mapping[str, str]) -> Figure:
    roles = ("measured", "v1", "v2")
    panels = []
    for drift in np.unique(columns["drift"]):
        rows_of = {
            value: (columns["forgetting"] == value) & (columns["drift"] == drift)
            for value in sorted(np.unique(columns["forgetting"]), reverse=True)
        }
        lines = tuple(
            Line(
                "nothing forgotten" if value >= 1.0 else f"λ = {value:g}",
                roles[i % 3],
                columns["t"][rows],
                PERCENT * columns["curve_error"][rows],
                dash="dashed" if i == 1 else "role",
            )
            for i, (value, rows) in enumerate(rows_of.items())
        )
        name = "constant F" if drift == 0.0 else f"F + {PERCENT * drift:g} %"
        panels.append(Panel(name, "%", lines, log=True))
    caption = (
        "Recursive least squares: error of the restoring force against that of the whole log, over its range. Below, a "
        "growth of the restoring force is planted in the log, and the estimate has to follow it."
    )
    return Figure(
        "study-online",
        "Online identification",
        caption=caption,
        x_name="length of the stream",
        x_unit="s",
        panels=tuple(panels),
    )
