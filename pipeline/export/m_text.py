"""A program as the text of MATLAB functions, which GNU Octave runs too. Arrays are rows, indices count from one."""

from collections.abc import Sequence

import numpy as np

from pipeline.export.program import (
    Array,
    Assign,
    Branch,
    Copy,
    Declare,
    Element,
    Expression,
    Fill,
    Function,
    Invocation,
    Invoke,
    Leave,
    Loop,
    Name,
    Number,
    Operation,
    Program,
    Return,
    Statement,
    expressions,
)

_PRECEDENCE = {"or": 1, "and": 2, "==": 3, "!=": 3, "<": 3, "<=": 3, ">": 3, ">=": 3, "+": 5, "-": 5, "*": 6, "/": 6}
_WORDS = {"or": "||", "and": "&&", "!=": "~="}
_FUNCTIONS = frozenset({"sqrt", "exp", "expm1", "tanh", "sin", "cos", "abs", "isfinite", "min", "max", "choose"})
_TAKEN = _FUNCTIONS | frozenset(
    {"break", "case", "catch", "else", "elseif", "end", "for", "function", "global", "if", "otherwise", "persistent",
     "return", "switch", "try", "while", "length", "beta", "gamma", "size", "zeros", "spline", "i", "j"}
)  # fmt: skip


def function_text(program: Program, function: Function) -> str:
    """One local function, with its first docstring line as comment and the constant arrays that it uses."""
    outputs = [f"out{i}" for i in range(len(function.results))] + [clear(each.name) for each in function.changed]
    head = f"function {_listed(outputs)}{clear(function.name)}({_arguments(function.parameters)})"
    lines = [head, f"%{clear(function.name).upper()} {function.summary}"]
    used = {part.name for part in expressions(function.body) if isinstance(part, Name)}
    for name in (name for name in program.arrays if name in used):
        lines.append(f"    persistent {name}")
        lines.append(f"    if isempty({name}), {name} = {matrix(program.arrays[name])}; end")
    return "\n".join([*lines, *_block(function.body, 1), "end"])


def matrix(array: np.ndarray) -> str:
    """An array as a literal: a row, or rows; every number to the last bit."""
    if array.size == 0:
        return f"zeros({', '.join(str(n) for n in array.shape)})"
    rows = np.atleast_2d(array)
    return "[" + "; ".join(" ".join(repr(float(x)) for x in row) for row in rows) + "]"


def clear(name: str) -> str:
    """The name, changed if MATLAB has it already."""
    return f"{name}_" if name in _TAKEN else name


def _arguments(parameters: Sequence[Name]) -> str:
    return ", ".join(clear(each.name) for each in parameters)


def _listed(outputs: list[str]) -> str:
    if not outputs:
        return ""
    return f"{outputs[0]} = " if len(outputs) == 1 else f"[{', '.join(outputs)}] = "


def _block(body: "Sequence[Statement]", depth: int) -> list[str]:
    pad = "    " * depth
    return [pad + line for statement in body for line in _statement(statement)]


def _statement(statement: Statement) -> list[str]:
    match statement:
        case Declare(name):
            extent = name.type
            if not isinstance(extent, Array):
                return []
            shape = extent.shape if len(extent.shape) > 1 else (1, *extent.shape)
            return [f"{clear(name.name)} = zeros({', '.join(str(n) for n in shape)});"]
        case Assign(target, value):
            return [f"{text(target)} = {text(value)};"]
        case Fill(array, start, stop, value):
            return [f"{clear(array.name)}({start + 1}:{stop}) = {text(value)};"]
        case Copy(target, source):
            return [f"{clear(target.name)} = {clear(source.name)};"]
        case Invocation(function, arguments, targets):
            pairs = zip(function.parameters, arguments, strict=True)
            outputs = [text(each) for each in targets]
            outputs += [text(argument) for parameter, argument in pairs if parameter in function.changed]
            return [f"{_listed(outputs)}{clear(function.name)}({', '.join(text(each) for each in arguments)});"]
        case Loop(variable, start, stop, body):
            last = Number(int(stop.value) - 1) if isinstance(stop, Number) else Operation("-", (stop, Number(1)), "int")
            return [f"for {clear(variable.name)} = {text(start)}:{text(last)}", *_block(body, 1), "end"]
        case Branch(condition, then, otherwise):
            rest = ["else", *_block(otherwise, 1)] if otherwise else []
            return [f"if {text(condition)}", *_block(then, 1), *rest, "end"]
        case Leave():
            return ["break"]
        case Return(values):
            return [*(f"out{i} = {text(value)};" for i, value in enumerate(values)), "return"]


def text(expression: Expression, outer: int = 0) -> str:
    """An expression, with no more parentheses than it needs."""
    match expression:
        case Number(value, _):
            written = repr(value) if isinstance(value, int) else repr(float(value))
            return f"({written})" if value < 0 and outer > 5 else written
        case Name(name):
            return clear(name)
        case Element(array, index):
            return f"{clear(array.name)}({', '.join(_from_one(each) for each in index)})"
        case Invoke(function, arguments):
            return f"{clear(function.name)}({', '.join(text(each) for each in arguments)})"
        case Operation("neg", (operand,)):
            return f"-{text(operand, 7)}" if outer <= 5 else f"(-{text(operand, 7)})"
        case Operation("not", (operand,)):
            return f"~({text(operand)})"
        case Operation("square", (operand,)):
            return f"({text(operand)})^2"
        case Operation(operator, arguments) if operator in _FUNCTIONS:
            return f"{operator}({', '.join(text(each) for each in arguments)})"
        case Operation(operator, arguments):
            level = _PRECEDENCE[operator]
            inside = [text(each, level + (i > 0)) for i, each in enumerate(arguments)]
            joined = f" {_WORDS.get(operator, operator)} ".join(inside)
            return f"({joined})" if level < outer else joined
    raise AssertionError(expression)  # all expressions are listed above


def _from_one(index: Expression) -> str:
    match index:
        case Number(value):
            return str(int(value) + 1)
        case Operation("+", (Number(value), rest)) | Operation("+", (rest, Number(value))):
            return f"{int(value) + 1} + {text(rest, 6)}"
        case _:
            return f"{text(index)} + 1"
