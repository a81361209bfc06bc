"""Conversion formulas of MDF channels: a text in the log, of which nothing but arithmetic is done.

asammdf gives raw numbers, without a word, where numexpr refuses a formula; or, where sympy is installed, has sympy run
it as Python. So no formula is left to it. Here it is parsed, not executed, and its tree is worked out node by node.
"""

import ast
import operator
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

_LONGEST = 1000
_OPERATORS: dict[type[ast.AST], Callable[..., Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
    ast.USub: operator.neg,
    ast.UAdd: operator.pos,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
}
_SAME = ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "log", "log10", "sqrt", "abs", "floor", "ceil")
_FUNCTIONS: dict[str, Callable[..., Any]] = {name: getattr(np, name) for name in _SAME} | {
    **{prefix + name: getattr(np, f"arc{name}") for name in ("sin", "cos", "tan") for prefix in ("a", "arc")},
    **{"ln": np.log, "pow": np.power},
}


def formula_of(conversion: Any) -> str | None:
    """The formula of a channel's conversion, "" for one hidden within a table of conversions; None without any."""
    if conversion is None:
        return None
    text = str(getattr(conversion, "formula", "") or "")
    if text:
        return text
    inner = (getattr(conversion, "referenced_blocks", None) or {}).values()
    return "" if any(formula_of(block) is not None for block in inner if hasattr(block, "conversion_type")) else None


def convert(formula: str, raw: NDArray[Any]) -> NDArray[np.float64]:
    """Work out a formula in X (or X1) for raw samples, in float64.

    Raises
    ------
    ValueError
        It is no arithmetic of numbers, X and the usual functions.

    Notes
    -----
    Letters count the same in both cases, since asammdf has turned every x in the text into X, also that of exp.
    """
    if len(formula) > _LONGEST:
        raise ValueError(f"it has {len(formula)} characters, more than {_LONGEST}")
    values = np.asarray(raw, dtype=np.float64)
    try:
        tree = ast.parse(formula.strip().lower(), mode="eval")
        with np.errstate(all="ignore"):  # what has no value is NaN, as a missing sample is
            result = _worked_out(tree.body, values)
    except (SyntaxError, RecursionError, MemoryError, TypeError, OverflowError) as error:
        raise ValueError(f"it cannot be worked out ({type(error).__name__})") from error
    return np.broadcast_to(np.asarray(result, dtype=np.float64), values.shape)


def _worked_out(node: ast.AST, x: NDArray[np.float64]) -> Any:
    def of(inner: ast.AST) -> Any:
        return _worked_out(inner, x)

    match node:
        case ast.Constant(value=int() | float() as number):
            return np.float64(number)
        case ast.Name(id="x" | "x1"):
            return x
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATORS:
            return _OPERATORS[type(op)](of(left), of(right))
        case ast.UnaryOp(op=op, operand=operand) if type(op) in _OPERATORS:
            return _OPERATORS[type(op)](of(operand))
        case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in _OPERATORS:
            return np.asarray(_OPERATORS[type(op)](of(left), of(right)), dtype=np.float64)
        case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]) if name in _FUNCTIONS:
            return _FUNCTIONS[name](*map(of, arguments))
    raise ValueError(f"{ast.unparse(node)[:40]!r} is no arithmetic that is known here")
