"""The figures of the studies: figs. 11b and 11c, and the error against amount of data and noise."""

from collections.abc import Mapping
from typing import Literal

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.figure import Figure, Line, Panel, Points

PERCENT = 100.0

Columns = Mapping[str, FloatArray]


def study_figure(
    name: Literal["alpha", "basis", "data", "online", "folds"], columns: Columns, units: Mapping[str, str]
) -> Figure:
    """The figure of one study.

    Parameters
    ----------
    name : {"alpha", "basis", "data", "online", "folds"}
        Which study.
    columns : mapping of str to FloatArray, each of shape (n,)
        As the study's table holds them.
    units : mapping of str to str
        SI units of the columns.
    """
    return {"alpha": _alpha, "basis": _basis, "data": _data, "online": _online, "folds": _folds}[name](columns, units)


def _alpha(columns: Columns, units: Mapping[str, str]) -> Figure:
    panels = tuple(
        Panel(
            title,
            units[key],
            (Line("longest stretch of the first training log", "v1", columns["alpha"], columns[key]),),
            log=True,
        )
        for key, title in (("misfit", "misfit"), ("roughness", "roughness of q̈"))
    )
    caption = "Small α leaves noise in the acceleration (roughness), large α smooths the motion away (misfit)."
    return Figure("study-alpha", "Regularisation parameter", caption, "α", units["alpha"], panels, x_log=True)


def _basis(columns: Columns, units: Mapping[str, str]) -> Figure:
    groups = np.unique(columns["smoothing"])
    roles = ("v1", "v2", "measured", "reference")
    known = {**columns, "nrmse": PERCENT * columns["nrmse"]}

    def lines(key: str) -> tuple[Line, ...]:
        """A quantity over M, a line for each σₙ."""
        return tuple(
            Line(
                f"σₙ = {value:g}",
                roles[i % 4],
                columns["basis_functions"][rows],
                known[key][rows],
                dash="dashed" if i > 1 else "role",
            )
            for i, value in enumerate(groups)
            for rows in [columns["smoothing"] == value]
        )

    panels = (
        Panel("MSE of q̈", units["mse"], lines("mse"), log=True),
        Panel("condition number", "1", lines("condition"), log=True),
        Panel("NRMSE of q", "%", lines("nrmse")),
    )
    caption = "Training error of the acceleration, conditioning, and free-run error on the logs held out"
    caption += " (100 %: diverged, or missed everything)."
    return Figure("study-basis", "Basis functions and smoothing", caption, "basis functions M", "1", panels)


def _data(columns: Columns, _: Mapping[str, str]) -> Figure:
    rows = columns["noise"] == 0.0
    order = np.argsort(columns["samples"][rows])
    x = columns["samples"][rows][order]
    median, low, high = (PERCENT * columns[key][rows][order] for key in ("nrmse", "nrmse_low", "nrmse_high"))
    spread = (Points("smallest", "reference", x, low, "ring"), Points("largest", "reference", x, high, "cross"))
    panel = Panel("NRMSE of q", "%", (Line("median", "v1", x, median),), points=spread)
    caption = "Free-run error on the logs held out against the amount of training data; repeats at random places."
    return Figure("study-data", "Amount of training data", caption, "training samples", "1", (panel,), x_log=True)


def _online(columns: Columns, _: Mapping[str, str]) -> Figure:
    roles, panels = ("measured", "v1", "v2"), []
    for drift in np.unique(columns["drift"]):
        lines = tuple(
            Line(
                "nothing forgotten" if value >= 1.0 else f"λ = {value:g}",
                roles[i % 3], columns["t"][rows], PERCENT * columns["curve_error"][rows],
                dash="dashed" if i == 1 else "role",
            )
            for i, value in enumerate(sorted(np.unique(columns["forgetting"]), reverse=True))
            for rows in [(columns["forgetting"] == value) & (columns["drift"] == drift)]
        )  # fmt: skip
        name = "constant F" if drift == 0.0 else f"F + {PERCENT * drift:g} %"
        panels.append(Panel(name, "%", lines, log=True))
    caption = "Recursive least squares: error of the restoring force against that of the whole log, over its range. "
    caption += "Below, a growth of the restoring force is planted in the log, and the estimate has to follow it."
    return Figure("study-online", "Online identification", caption, "length of the stream", "s", tuple(panels))


def _folds(columns: Columns, _: Mapping[str, str]) -> Figure:
    """One mark per model and fold; marks stand beside one another in the order of the models."""
    models = list(dict.fromkeys(str(name) for name in columns["model"]))
    step = 0.6 / max(1, len(models))
    errors = {key: PERCENT * columns[key] for key in ("nrmse", "nrmse_qdot", "nrmse_qddot")}
    markers: tuple[Literal["dot", "ring", "cross"], ...] = ("dot", "ring", "cross")

    def points(key: str) -> tuple[Points, ...]:
        """The errors fold by fold."""
        return tuple(
            Points(model, model, columns["fold"][rows] + 1 + (i - (len(models) - 1) / 2) * step, errors[key][rows],
                   markers[i % 3])
            for i, model in enumerate(models)
            for rows in [columns["model"] == model]
        )  # fmt: skip

    def means(key: str) -> tuple[Line, ...]:
        """Their means."""
        ends = np.array([0.5, float(np.max(columns["fold"])) + 1.5])
        return tuple(
            Line(model, model, ends, np.full(2, np.mean(errors[key][columns["model"] == model])), dash="dashed")
            for model in models
        )

    panels = tuple(
        Panel(f"NRMSE of {symbol}", "%", means(key), points=points(key))
        for key, symbol in (("nrmse", "q"), ("nrmse_qdot", "q̇"), ("nrmse_qddot", "q̈"))
    )
    caption = "Each model fitted without the fold and run freely over it (100 %: diverged, or missed everything). "
    caption += "Dashed: mean."
    return Figure("study-folds", "Cross-validation", caption, "fold left out", "1", panels)
