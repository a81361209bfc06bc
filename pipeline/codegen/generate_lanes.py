"""The text of `body_lanes.py`: the rates of `pipeline.joint.body` for several joints side by side.

A Jacobian by differences runs fifty joints that differ in one constant each, through the same arithmetic. Laid side
by side, row by row in one array, a compiler turns that arithmetic into vector instructions, four joints in each. The
equations stand once, in `body.py`; this program rewrites every `x[i]` there as `block[(X + i) * LANES + j]` within a
loop over j, and nothing else. A test holds the two against each other.

After a change of `body.py`: ``python -m pipeline.codegen.generate_lanes > lanes.py``, move that to
``pipeline/generated/body_lanes.py``, then ``ruff check --fix`` and ``ruff format`` it.
"""

import ast
import inspect
import sys

from pipeline.joint import body
from pipeline.joint.correction_table import VALUES

_ROWS = {"k": "CONSTANTS", "x": "STATE", "z": "STOP", "start": "START", "rates": "RATE"}
_GIVEN = {"u1": "INPUT", "u2": "INPUT + 1"}
_PARTS = ("beam", "membrane", "frame_inertia")
_OPTIONS = "cache=True, error_model='numpy', fastmath=FAST"
_HEADER = '''"""Rates of `pipeline.joint.body` for `LANES` joints side by side, written by `generate_lanes`.

`block` is one flat array of rows of `LANES` numbers, one for each joint. Constants, state, stop operators, inputs and
corrections are read, the rates are written.
"""

import numba

from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.vector_math import FAST, root
from pipeline.joint.body import {names}
from pipeline.joint.correction_table import VALUES

LANES = 8
CONSTANTS = 0
STATE = len(ENTRIES)
START = STATE + STATES
RATE = START + STATES
STOP = RATE + STATES
INPUT = STOP + STOPS
CORRECTION = INPUT + 2
TOTAL = CORRECTION + VALUES
ROWS = TOTAL + STATES
"""First row of each kind, and the number of rows."""
'''


class _Lanes(ast.NodeTransformer):
    """Every element of a row becomes that of lane j."""

    def visit_Subscript(self, node: ast.Subscript) -> ast.AST:
        self.generic_visit(node)
        if isinstance(node.value, ast.Name) and node.value.id in _ROWS:
            return _element(f"{_ROWS[node.value.id]} + ({ast.unparse(node.slice)})", node.ctx)
        return node

    def visit_Call(self, node: ast.Call) -> ast.AST:
        self.generic_visit(node)
        if ast.unparse(node.func) == "math.sqrt":
            node.func = ast.Name("root", ast.Load())
        if isinstance(node.func, ast.Name) and node.func.id in _PARTS:
            node.args = [ast.Name("block", ast.Load()), ast.Name("j", ast.Load()), *node.args[1:]]
        if isinstance(node.func, ast.Name) and node.func.id == "corrections":
            return ast.Tuple([_element(f"CORRECTION + {i}", ast.Load()) for i in range(VALUES)], ast.Load())
        return node


def _element(row: str, context: ast.expr_context) -> ast.Subscript:
    return ast.Subscript(ast.Name("block", ast.Load()), _expression(f"({row}) * LANES + j"), context)


def _expression(text: str) -> ast.expr:
    return ast.parse(text, mode="eval").body


def _function(name: str) -> ast.FunctionDef:
    """A kernel of `body` with its arrays as rows of lanes; of its docstring the first line stays."""
    found: ast.FunctionDef = ast.parse(inspect.getsource(getattr(body, name).py_func)).body[0]  # type: ignore[assignment]
    summary = str(ast.get_docstring(found)).partition("\n")[0]
    found.body[0] = ast.Expr(ast.Constant(summary))
    transformed: ast.FunctionDef = _Lanes().visit(found)
    return transformed


def source() -> str:
    """The text of the module, not yet formatted."""
    parts = []
    for name in _PARTS:
        function = _function(name)
        first, second = ast.arg("block", function.args.args[0].annotation), ast.arg("j", ast.Name("int"))
        function.args.args = [first, second, *function.args.args[1:]]
        function.decorator_list = [_expression(f"numba.njit(inline='always', {_OPTIONS})")]
        parts.append(ast.unparse(ast.fix_missing_locations(function)))
    rates = _function("body_rates")
    rates.args.args = [ast.arg("block", ast.Name("FloatArray"))]
    given = [ast.parse(f"{name} = block[({row}) * LANES + j]").body[0] for name, row in _GIVEN.items()]
    loop = ast.For(ast.Name("j", ast.Store()), _expression("range(LANES)"), [*given, *rates.body[1:]], [])
    rates.body, rates.decorator_list = (
        [rates.body[0], loop],
        [_expression(f"numba.njit(forceinline=True, {_OPTIONS})")],
    )
    rates.name = "lane_rates"
    parts.append(ast.unparse(ast.fix_missing_locations(rates)))
    text = "\n\n\n".join(parts)
    used = {node.id for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Name) and node.id.startswith("_")}
    names = sorted(used | {"BRANCHES", "CREEPS", "ENTRIES", "STATES", "STOPS"})
    return _HEADER.format(names=", ".join(names)) + "\n\n" + text + "\n"


if __name__ == "__main__":
    sys.stdout.write(source())
