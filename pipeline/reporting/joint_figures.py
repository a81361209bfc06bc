"""Figures 1b and 3 to 7 of the paper from the analytical model, and those of `debist physics`."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from ..numerics.arrays import BoolArray, FloatArray
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
    lines = [line for s, p in shown.items() for line in _by_stability(_STATES[s], _role(s), p.q, p.force, p.stable)]
    return Panel("F", "N", tuple(lines), y_limits=None if states else (-0.1, 0.1))


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
    rotation = Panel("φ", "rad", (Line("no voltage", "measured", path.q, path.phi, "solid"),))
    panels = (_equilibria(result), _force(result), _energy(result), rotation, *_capacitances(result))
    return _over_q("characteristics", "Characteristic curves of the joint", *panels)


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
    potential = Panel("U − ½ΣCv² − Fq", "J", held, points=tuple(points), x=("q", "m"))
    beam = Panel("w", "m", tuple(shapes), x=("x", "m"))
    return _over_q("equilibria", "Total potential, and the beam in its equilibria", potential, beam)


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
    panels = (
        Panel("mode shape", "1", shapes, x=("x", "m")),
        Panel("amplitude", "m", amplitudes, x=("t", "s")),
        Panel("share of w(l)", "m", bending, x=("q", "m")),
        Panel("u₀", "m", axial, x=("q", "m")),
    )
    return Figure(
        "modes", "Modes of the beam, and the static path", caption="", x_name="", x_unit="", panels=panels, columns=2
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
    voltages = tuple(Line(n, _role(n), full.t, motions.v[:, k], "solid") for k, n in enumerate(("left", "right")))
    panels = (
        Panel("v", "V", voltages),
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
    )
    return Figure("motion", "Full-order against reduced model", caption="", x_name="t", x_unit="s", panels=panels)
