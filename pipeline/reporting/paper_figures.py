"""Figures of the paper: 1b and 3 to 7 from the analytical model, 8 and 11 to 15 of its recipe on a measured log.

With those of `debist physics` and of the studies.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..device.device import JOINT
from ..diagnostics.run_data import LogData
from ..numerics.arrays import BoolArray, FloatArray
from ..signals.differentiate import AlphaStudy
from ..store.columns import StudyName
from ..units.quantity import prefixed
from .figure import Figure, Line, Panel, Points, Role

if TYPE_CHECKING:
    from ..device.parameters import JointParameters
    from ..models.analytical.bifurcation import Characteristics
    from ..models.analytical.reduced_order import BeamModes, Motions
    from ..models.analytical.statics import JointEquilibrium

COLOURED = ("first", "second", "both", "fourth", "fifth")
"""Roles that take the colours of the models, in their order."""
_ROLES = {"off": "measured", "left": "v1", "right": "v2"}
"""Colours: black without voltage; the left and the right membrane have theirs in all figures."""
_STATES = {"off": "no voltage", "left": "left on", "right": "right on", "both": "both on"}
_SHOWN = (-0.018, 0.018)
_HIGHEST = 0.01
"""Displacements and largest height of the screws [m] in the diagrams of equilibria."""
PATH_REACH = 0.02
PATH_DEGREE = 9
"""Displacement [m] to which figure 6b reaches, and the degree of its polynomials."""
ZOOM = (24.0, 30.0)
"""Segment of figure 13 [s]."""
_OTHERS = ("v1", "analytical", "raw", "measured")
"""Colours of the α that were not chosen."""
PERCENT = 100.0


def _role(state: str) -> Role:
    return _ROLES.get(state, state)


def _by_stability(label: str, role: Role, x: FloatArray, y: FloatArray, stable: BoolArray) -> Iterator[Line]:
    """Solid where stable, dotted where not; the pieces share their end points."""
    for marked, dash in ((stable, "solid"), (~stable, "dotted")):
        shown = marked | np.concatenate(([False], marked[:-1]))
        if marked.any():
            yield Line(label, role, x, np.where(shown, y, np.nan), dash, wide=True)  # type: ignore[arg-type]


def _equilibria(result: "Characteristics") -> Panel:
    lines = [
        line
        for state, branches in result.diagrams.items()
        for branch in branches
        for line in _by_stability(_STATES[state], _role(state), branch.y[:, 0], branch.parameter, branch.stable)
    ]
    for text, limit in (("bistable from", result.z_b_min), ("switchable to", result.z_b_max)):
        if limit is not None and limit <= _HIGHEST:
            ends = np.array(_SHOWN)
            lines.append(
                Line(f"{text} z_b = {prefixed(limit, 'm', 2)} mm", "reference", ends, np.full(2, limit), "solid")
            )
    return Panel("z_b", "m", tuple(lines), x_limits=_SHOWN, y_limits=(0.0, _HIGHEST))


def _force(result: "Characteristics", *states: str) -> Panel:
    """Force that holds the tip."""
    shown = {state: result.paths[state] for state in states or result.paths}
    return Panel(
        "F",
        "N",
        tuple(line for s, p in shown.items() for line in _by_stability(_STATES[s], _role(s), p.q, p.force, p.stable)),
        y_limits=None if states else (-0.1, 0.1),
    )


def _energy(result: "Characteristics") -> Panel:
    path = result.paths["off"]
    barrier = "no barrier" if result.barrier is None else f"barrier {prefixed(result.barrier, 'µ', 0)} µJ"
    lines = _by_stability(f"no voltage: {barrier}", "measured", path.q, path.energy - path.energy.min(), path.stable)
    return Panel("U", "J", tuple(lines))


def _capacitances(result: "Characteristics") -> tuple[Panel, Panel]:
    path = result.paths["off"]
    c, slope = (
        tuple(Line(name, _role(name), path.q, values[:, side], "solid") for side, name in enumerate(("left", "right")))
        for values in (path.capacitance, path.capacitance_slope)
    )
    return Panel("C", "F", c), Panel("dC/dq", "F/m", slope)


def _over_q(name: str, title: str, *panels: Panel) -> Figure:
    return Figure(name, title, caption="", x_name="q", x_unit="m", panels=panels, columns=2)


def paper_joint_figures(result: "Characteristics") -> dict[str, Figure]:
    """Figures 1b and 3 to 5: energy and force without voltage, equilibria over z_b, F(q), C_i(q) and dC_i/dq."""
    return {
        "fig-01b": _over_q("double-well", "Potential energy and force", _energy(result), _force(result, "off")),
        "fig-03": _over_q("equilibria", "Equilibria over z_b", _equilibria(result)),
        "fig-04": _over_q("force", "Force over displacement", _force(result)),
        "fig-05": _over_q("capacitance", "Capacitance and its derivative", *_capacitances(result)),
    }


def characteristics_figure(result: "Characteristics") -> Figure:
    """Figures 3 to 5, the double well and the tip rotation on the static path."""
    path = result.paths["off"]
    return _over_q(
        "characteristics",
        "Characteristic curves of the joint",
        _equilibria(result),
        _force(result),
        _energy(result),
        Panel("φ", "rad", (Line("no voltage", "measured", path.q, path.phi, "solid"),)),
        *_capacitances(result),
    )


def equilibria_figure(
    joint: "JointParameters", rests: "list[JointEquilibrium]", energy: tuple[Any, Any] | None
) -> Figure:
    """Statics (eqs. 13 to 15): the energy over q with its equilibria, and the beam's shape in each.

    `energy` is q [m] and the total potential [J] along the held joint; None where it snaps although it is held.
    Dotted where it is unstable.
    """
    from ..models.analytical.reduced_order import beam_shapes

    lowest = min((e.energy for e in rests), default=0.0)
    held = () if energy is None else (Line("held at q", "measured", energy[0], energy[1] - lowest, "solid"),)
    points: list[Points] = []
    shapes: list[Line] = []
    for role, e in zip(COLOURED, rests, strict=False):
        name = f"q = {round(1e3 * e.q, 2) + 0.0:.2f} mm".replace("-", "−") + ("" if e.stable else ", unstable")
        at = np.array([e.q]), np.array([e.energy - lowest])
        points.append(Points(name, role, *at, "dot" if e.stable else "ring"))
        x, w = beam_shapes(e.qm[None, :], joint.l)
        shapes.append(Line(name, role, x, w[0], "solid" if e.stable else "dotted", wide=True))
    return _over_q(
        "equilibria",
        "Total potential, and the beam in its equilibria",
        Panel("U − ½ΣCv² − Fq", "J", held, points=tuple(points), x=("q", "m")),
        Panel("w", "m", tuple(shapes), x=("x", "m")),
    )


def modes_figure(joint: "JointParameters", modes: "BeamModes", t: FloatArray) -> Figure:
    """Figure 6: modes of a motion at times t [s], and the static path with its polynomials (eq. 24)."""
    names = [f"mode {number}: {100 * share:.3g} %" for number, share in enumerate(modes.energy_share, start=1)]
    shapes = (
        *(Line(name, role, modes.x, w, "solid") for name, role, w in zip(names, COLOURED, modes.shapes, strict=False)),
        Line("model, widest", "measured", modes.x, modes.widest, "dashed"),
    )
    amplitudes = tuple(
        Line(name, role, t, a, "solid") for name, role, a in zip(names, COLOURED, modes.amplitudes.T, strict=False)
    )
    bending, axial = _static_path(joint)
    return Figure(
        "modes",
        "Modes of the beam, and the static path",
        caption="",
        x_name="",
        x_unit="",
        panels=(
            Panel("mode shape", "1", shapes, x=("x", "m")),
            Panel("amplitude", "m", amplitudes, x=("t", "s")),
            Panel("share of w(l)", "m", bending, x=("q", "m")),
            Panel("u₀", "m", axial, x=("q", "m")),
        ),
        columns=2,
    )


def _static_path(joint: "JointParameters") -> tuple[tuple[Line, ...], tuple[Line, ...]]:
    """The static path q_m(q), bending as shares of w(l) and axial, and the polynomials fitted to it."""
    from numpy.polynomial.polynomial import polyfit, polyval

    from ..models.analytical.statics import static_path

    path = static_path(joint, np.linspace(-PATH_REACH, PATH_REACH, 161), np.zeros(2))
    # One polynomial in q for each Ritz coordinate, as the paper fits them (figure 6b)
    place = path.q / np.max(np.abs(path.q))
    shapes = np.stack([polyfit(place, column, PATH_DEGREE) for column in path.qm.T], axis=1)
    fitted = polyval(path.q / PATH_REACH, shapes)
    polynomial = f"polynomials of degree {PATH_DEGREE}"
    lines = [
        (
            Line(name, COLOURED[column % 3], path.q, joint.l**power * path.qm[:, column], "solid"),
            Line(polynomial, "measured", path.q, joint.l**power * fitted[column], "dashed"),
        )
        for column, (name, power) in enumerate((("q₂ l²", 2), ("q₃ l³", 3), ("q₄ l⁴", 4), ("u₀", 0)))
    ]
    return tuple(line for pair in lines[:3] for line in pair), lines[3]


def motion_figure(motions: "Motions") -> Figure:
    """Figure 7: full-order and reduced motion under the same voltages."""
    full = motions.full
    reduced = motions.reduced
    return Figure(
        "motion",
        "Full-order against reduced model",
        caption="",
        x_name="t",
        x_unit="s",
        panels=(
            Panel(
                "v",
                "V",
                tuple(Line(n, _role(n), full.t, motions.v[:, k], "solid") for k, n in enumerate(("left", "right"))),
            ),
            *(
                Panel(
                    name,
                    unit,
                    (
                        Line("full order, 10 states", "measured", full.t, a, "solid"),
                        Line("reduced to q", "both", full.t, b, "dashed"),
                    ),
                )
                for name, unit, a, b in (("q", "m", full.q, reduced.q), ("q̇", "m/s", full.qdot, reduced.qdot))
            ),
        ),
    )


def basis_figure(q: FloatArray, bells: FloatArray, weights: FloatArray) -> Figure:
    """Figure 8b: the basis functions at q (n, M), and c(q) as their weighted sum; weights (M,) [N/m]."""
    functions = tuple(Line(f"{len(weights)} basis functions", "v1", q, bell) for bell in bells.T)
    terms = tuple(Line("its terms", "raw", q, term) for term in (bells * weights).T)
    return _over_q(
        "basis",
        "Basis functions",
        Panel("φᵢ", "1", functions),
        Panel("c", "N/m", (*terms, Line("weighted sum", "rbf-paper", q, bells @ weights, "solid"))),
    )


def lag_figure(search: Mapping[str, FloatArray]) -> Figure:
    """Rank and condition number at each accepted step of the search for T_z (§ 4.2)."""
    lag = search["lag_s"]
    return Figure(
        "lag-search",
        "Search for T_z",
        caption="",
        x_name="T_z",
        x_unit="s",
        panels=tuple(
            Panel(
                title,
                "1",
                (Line("accepted steps", "measured", lag, search[key], "solid"),),
                points=(Points("taken", "rbf-paper", lag[-1:], search[key][-1:], "ring"),),
                log=key == "condition",
                whole=key == "rank",
            )
            for title, key in (("rank", "rank"), ("condition number", "condition"))
        ),
        columns=2,
        x_log=True,
    )


def signals_figure(log: LogData) -> Figure:
    """Figure 11a: voltages, position, velocity and acceleration of a log."""
    motion = log.motion
    return Figure(
        "signals",
        "Excitation and measured motion",
        caption="",
        x_name="time",
        x_unit="s",
        panels=(
            Panel(
                "v",
                "V",
                tuple(
                    Line(side, name, motion.t, v)
                    for side, name, v in zip(("left", "right"), ("v1", "v2"), motion.v.T, strict=True)
                ),
            ),
            *(
                Panel(name, unit, (Line("measured", "measured", motion.t, values),))
                for name, unit, values in (("q", "m", motion.q), ("q̇", "m/s", motion.qdot), ("q̈", "m/s²", motion.qddot))
            ),
        ),
    )


def basis_study_figure(
    columns: Mapping[str, FloatArray], units: Mapping[str, str], chosen: tuple[int, float]
) -> Figure:
    """Figure 11b: errors and condition over M for several σ_n, the chosen pair marked."""
    figure = study_figure("basis", columns, units)
    here = (columns["basis_functions"] == chosen[0]) & (columns["smoothing"] == chosen[1])
    x = columns["basis_functions"][here]
    factors = {"nrmse": PERCENT}
    return replace(
        figure,
        panels=tuple(
            replace(
                panel, points=(Points("the recipe", "measured", x, factors.get(key, 1.0) * columns[key][here], "ring"),)
            )
            for key, panel in zip(("mse", "condition", "nrmse"), figure.panels, strict=True)
        ),
    )


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
        panels.append(
            Panel(
                name,
                unit,
                (Line("all α", "measured", study.alphas, values),),
                points=(ring,),
                log=True,
                x=("α", "mm·s"),
                x_log=True,
            )
        )
    return Figure(
        "alpha", "Regularisation parameter", caption="", x_name="t", x_unit="s", panels=tuple(panels), columns=2
    )


def curves_figure(curves: Mapping[str, Mapping[str, FloatArray]], q: FloatArray) -> Figure:
    """Figure 14: restoring force, damping and both ∂C/∂q by model; every curve is whole within its axes."""
    units = replace(JOINT, known_mass=1.0).curve_units
    shown = (("F", "F", "F"), ("d", "d", "d"), ("dC1_dq", "∂C₁/∂q", "dC"), ("dC2_dq", "∂C₂/∂q", "dC"))
    return _over_q(
        "curves",
        "Characteristic curves",
        *(
            Panel(title, units[unit], tuple(Line(model, model, q, own[key]) for model, own in curves.items()))
            for key, title, unit in shown
        ),
    )


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
    return Figure(
        "study-alpha",
        "Regularisation parameter",
        caption="Small α leaves noise in the acceleration (roughness), large α smooths the motion away (misfit).",
        x_name="α",
        x_unit=units["alpha"],
        panels=tuple(
            Panel(
                title,
                units[key],
                (Line("longest segment of the first training log", "v1", columns["alpha"], columns[key]),),
                log=True,
            )
            for key, title in (("misfit", "misfit"), ("roughness", "roughness of q̈"))
        ),
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

    return Figure(
        "study-basis",
        "Basis functions and smoothing",
        caption=(
            "Training error of the acceleration, conditioning, and free-run error on the logs held out (100 %: "
            "diverged, or missed everything)."
        ),
        x_name="basis functions M",
        x_unit="1",
        panels=(
            Panel("MSE of q̈", units["mse"], lines("mse"), log=True),
            Panel("condition number", "1", lines("condition"), log=True),
            Panel("NRMSE of q", "%", lines("nrmse")),
        ),
        whole=True,
    )


def _data(columns: Columns, _: Mapping[str, str]) -> Figure:
    rows = columns["noise"] == 0.0
    order = np.argsort(columns["samples"][rows])
    x = columns["samples"][rows][order]
    median, low, high = (PERCENT * columns[key][rows][order] for key in ("nrmse", "nrmse_low", "nrmse_high"))
    return Figure(
        "study-data",
        "Amount of training data",
        caption="Free-run error on the logs held out against the amount of training data; repeats at random places.",
        x_name="training samples",
        x_unit="1",
        panels=(
            Panel(
                "NRMSE of q",
                "%",
                (Line("median", "v1", x, median),),
                points=(
                    Points("smallest", "reference", x, low, "ring"),
                    Points("largest", "reference", x, high, "cross"),
                ),
            ),
        ),
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
        panels.append(Panel("constant F" if drift == 0.0 else f"F + {PERCENT * drift:g} %", "%", lines, log=True))
    return Figure(
        "study-online",
        "Online identification",
        caption=(
            "Recursive least squares: error of the restoring force against that of the whole log, over its range. "
            "Below, a growth of the restoring force is planted in the log, and the estimate has to follow it."
        ),
        x_name="length of the stream",
        x_unit="s",
        panels=tuple(panels),
    )
