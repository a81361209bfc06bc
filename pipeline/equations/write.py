"""Writes `pipeline.generated` from `pipeline.equations`: ``python -m pipeline.equations.write``. Needs CasADi.

A test compares the committed files with what this writes.
"""

import sys
import textwrap
from typing import Any

import casadi as ca

from pipeline import generated
from pipeline.codegen.graph import Graph
from pipeline.equations import condensed_joint, full_joint
from pipeline.equations.graphs import graph, graphs

_FULL = """Kernels of the full-order joint.

Inputs: `qm`, `qm_dot`, `qm_ddot` shape (4,) Ritz coordinates [1/m, 1/m², 1/m³, m] and their rates; `z` shape (3,)
Maxwell strains and friction state; `v_squared` shape (2,) [V²]; `force` shape (1,) [N]; `p` shape (41,) parameters
in the order of `parameters.VECTOR_NAMES`. The arguments after them are outputs, written in full."""

_HEADER = '''"""{summary}

Written by ``python -m pipeline.equations.write`` from `pipeline.equations.{source}`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph
'''


def _module(summary: str, source: str, constants: dict[str, Any], found: dict[str, Graph]) -> str:
    parts = [_HEADER.format(summary=summary, source=source)]
    for name, value in constants.items():
        parts.append(f"\n{name} = " + "\n    ".join(textwrap.wrap(repr(value), 110, break_long_words=False)) + "\n")
    for name, one in found.items():
        body = "\n".join(textwrap.wrap(one.text, 116, break_long_words=False, break_on_hyphens=False))
        parts.append(f'\n{name} = Graph(\n    {one.inputs!r},\n    {one.outputs!r},\n    """\n{body}\n    """,\n)\n')
    return "".join(parts)


def _condensed() -> dict[str, str]:
    j, s = condensed_joint, condensed_joint.symbols()
    still = {"x": s.x, "u": s.u, "k": s.k, "c": s.c}
    moving = still | {"z": s.z}
    shape = j.shape(s)
    kernels = {
        "RATES": (moving | {"start": s.start}, {"rates": j.rates(s, j.friction_of(s, j.moved_stops(s)))}),
        "SHAPE": (still, {"forces": shape, "by_shape": ca.jacobian(shape, s.x[[2, 4]])}),
        "INERTIA": ({"x": s.x, "k": s.k}, {"mass": ca.vertcat(*j.frame_inertia(s)[:3])}),
    }
    linear = j.linearised(s)
    by_k, slopes = linear.pop("by_k"), linear.pop("c_q")
    exact = {"JACOBIAN": (moving | {"c_q": slopes}, linear), "BY_CONSTANTS": (moving, {"by_k": by_k})}
    names = ("CONSTANTS", "TIP_CONSTANTS", "CORRECTIONS", "STATES", "STOPS", "CREEPS", "BRANCHES")
    return {
        "condensed_joint.py": _module(
            "The condensed joint: rates, forces at rest and inertia.",
            "condensed_joint",
            {name: getattr(j, name) for name in names},
            graphs(kernels, "k"),
        ),
        "condensed_joint_jacobian.py": _module(
            "Exact derivatives of the condensed joint's rates.", "condensed_joint", {}, graphs(exact, "k")
        ),
    }


def _full() -> dict[str, str]:
    j, s = full_joint, full_joint.symbols()
    static = j.elastic_energy(s) - 0.5 * ca.dot(j.capacitances(s), s.v_squared)
    gradient, residual, rates = ca.gradient(static, s.qm), j.residual(s), j.internal_rates(s)
    q, slope, u_y = j.tip(s)
    tip = ca.vertcat(q, ca.atan(slope), u_y, *j.stretches(s))
    at = {"qm": s.qm, "v_squared": s.v_squared, "p": s.p}
    unloaded = {"qm": s.qm, "p": s.p}
    moving = {"qm": s.qm, "qm_dot": s.qm_dot, "z": s.z, "v_squared": s.v_squared, "force": s.force, "p": s.p}
    symmetric = {"hessian": ca.jacobian(gradient, s.qm), "damping": ca.hessian(j.viscous_dissipation(s), s.qm_dot)[0]}
    symmetric |= {"mass": ca.jacobian(residual, s.qm_ddot)}
    # The lower half of a symmetric matrix is taken from the upper, which is then all that is computed.
    hessian, damping, mass = (ca.triu2symm(ca.triu(matrix)) for matrix in symmetric.values())
    tau = -ca.substitute(residual, s.qm_ddot, ca.SX.zeros(4))
    linear = {
        "r_q": ca.jacobian(residual, s.qm),
        "r_v": ca.jacobian(residual, s.qm_dot),
        "r_z": ca.jacobian(residual, s.z),
        "z_q": ca.jacobian(rates, s.qm),
        "z_v": ca.jacobian(rates, s.qm_dot),
        "z_z": ca.diag(ca.jacobian(rates, s.z)),
        "r_s": ca.jacobian(residual, s.v_squared),
    }
    packed = {"x": ca.vertcat(s.qm, s.qm_dot, s.z), "v_squared": s.v_squared, "force": s.force, "p": s.p}
    kernels = {
        "statics": (
            "U − ½ΣC_i v_i² [J], returned; its gradient (4,) and Hessian (4, 4) in q_m.",
            at,
            {"gradient": gradient, "hessian": hessian, "energy": static},
        ),
        "static_sensitivity": (
            "Derivative of the static gradient with respect to the parameters, (4, 41).",
            at,
            {"gradient_p": ca.jacobian(gradient, s.p)},
        ),
        "tip": (
            "q [m], φ [rad], u_y [m], λ1, λ2 of left and right (5,) and their derivatives in q_m (5, 4).",
            unloaded,
            {"values": tip, "jacobian": ca.jacobian(tip, s.qm)},
        ),
        "capacitance": (
            "C_1, C_2 [F] (2,) and ∂C_i/∂q_m (2, 4).",
            unloaded,
            {"values": j.capacitances(s), "jacobian": ca.jacobian(j.capacitances(s), s.qm)},
        ),
        "dissipation": (
            "Damping matrix D (4, 4), coupling of z to the forces (4, 3), ∂λ_{3,i}/∂q_m (2, 4).",
            unloaded,
            {
                "damping": damping,
                "coupling": j.coupling(s),
                "thickness_jacobian": ca.jacobian(j.thickness_stretches(s), s.qm),
            },
        ),
        "dynamics": (
            "Mass matrix M (4, 4), right-hand side τ (4,) of M q̈_m = τ, and ż (3,).",
            moving,
            {"mass": mass, "tau": tau, "z_dot": rates},
        ),
        "linearisation": (
            "Derivatives of the residual r = M q̈_m − τ and of ż in q_m, q̇_m, z; and of r in v_i² (4, 2).",
            moving | {"qm_ddot": s.qm_ddot},
            linear,
        ),
        "motion": (
            "As `dynamics`, of x = [q_m, q̇_m, z] (11,): M, and q̇_m, τ, ż in `right` (11,).",
            packed,
            {"mass": mass, "right": ca.vertcat(s.qm_dot, tau, rates)},
        ),
        "motion_slopes": (
            "As `linearisation`, of x = [q_m, q̇_m, z] (11,), q̈_m = `a` (4,): r_q, r_v, r_z, z_q, z_v, z_z, r_s (79,).",
            packed | {"a": s.qm_ddot},
            {"slopes": ca.vertcat(*(ca.vec(block.T) for block in linear.values()))},
        ),
        "energy_flow": (
            "T, U, Maxwell and friction energy [J], work rate of voltages and force, dissipated power [W], (6,).",
            moving,
            {"flow": ca.vertcat(*j.energy_flow(s))},
        ),
    }
    found = {name.upper(): graph(inputs, outputs) for name, (_, inputs, outputs) in kernels.items()}
    functions = [_function(name, docstring, found[name.upper()]) for name, (docstring, _, _) in kernels.items()]
    text = _module(_FULL, "full_joint", {}, found) + "".join(functions)
    imports = "from pipeline.codegen.graph import Graph\n"
    imports += "from pipeline.codegen.numba_writer import kernel\nfrom pipeline.numerics.arrays import FloatArray\n"
    imports += "from pipeline.compiled import compiled\n"
    return {"analytical_joint.py": text.replace("from pipeline.codegen.graph import Graph\n", imports, 1)}


def _function(name: str, docstring: str, source: Graph) -> str:
    """A compiled function of arrays; a last output of one entry is returned."""
    value = next((output for output in source.outputs if output == "energy"), None)
    arguments = [argument for argument in [*source.inputs, *source.outputs] if argument != value]
    signature = ", ".join(f"{argument}: FloatArray" for argument in arguments)
    call = f"_{name}(({', '.join(arguments)}))"
    return (
        f"\n\n_{name} = kernel({name.upper()}, value={value!r})\n"
        "\n\n@compiled(inline='always')\n"
        f"def {name}({signature}) -> {'float' if value else 'None'}:\n"
        f'    """{docstring}"""\n' + (f"    found: float = {call}\n    return found\n" if value else f"    {call}\n")
    )


def texts() -> dict[str, str]:
    """File name and text of every generated module."""
    return _condensed() | _full()


if __name__ == "__main__":
    sys.setrecursionlimit(100_000)  # a chain of operations is walked by recursion
    for file_name, text in texts().items():
        with open(f"{generated.__path__[0]}/{file_name}", "w", encoding="utf-8") as target:  # noqa: PTH123 - no paths here
            target.write(text)
