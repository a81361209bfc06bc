"""A program as the text of C99 functions without library calls beyond <math.h>."""

import textwrap

import numpy as np

from pipeline.export.kernels.program import (
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
    Skip,
    Statement,
    expressions,
)

_PRECEDENCE = {"or": 1, "and": 2, "==": 3, "!=": 3, "<": 4, "<=": 4, ">": 4, ">=": 4, "+": 5, "-": 5, "*": 6, "/": 6}
_WORDS = {"or": "||", "and": "&&"}
_FUNCTIONS = {
    "sqrt": "M(sqrt)",
    "exp": "M(exp)",
    "expm1": "M(expm1)",
    "tanh": "M(tanh)",
    "sin": "M(sin)",
    "cos": "M(cos)",
    "abs": "M(fabs)",
    "isfinite": "isfinite",
    "min": "least",
    "max": "largest",
    "square": "square",
}
_RESERVED = """
    auto break case char const continue default do double else enum extern float for goto if inline int long register
    restrict return short signed sizeof static struct switch typedef union unsigned void volatile while
    sin cos tan sqrt exp expm1 log pow fabs tanh y0 y1 yn j0 j1 jn gamma div abs floor ceil index real least largest
    square M R
"""
_TAKEN = frozenset(_RESERVED.split())


def constants_text(program: Program) -> str:
    """Constants that the functions use: indices as an enumeration, numbers and arrays with their values."""
    used = {
        part.name
        for function in program.functions
        for part in expressions(function.body)
        if isinstance(part, Number | Name)
    }
    numbers = {name: value for name, value in program.numbers.items() if name in used}
    whole = [f"{name} = {value}" for name, value in numbers.items() if isinstance(value, int)]
    lines = ["enum {\n" + _wrapped(whole) + "\n};"] if whole else []
    for name, value in numbers.items():
        if not isinstance(value, int):
            lines.append(f"static const real {name} = {literal(value)};")
    for name, array in program.arrays.items():
        if name in used:
            kind = "int" if np.issubdtype(array.dtype, np.integer) else "real"
            entries = [str(x) if kind == "int" else literal(float(x)) for x in array.ravel()] or ["0"]
            lines.append(f"static const {kind} {name}[{len(entries)}] = {{\n{_wrapped(entries)}\n}};")
    return "\n".join(lines)


def literal(value: float) -> str:
    """A real number to the last bit, in double or single precision as the file is compiled."""
    return f"R({float(value)!r})"


def function_text(function: Function) -> str:
    """One function, `static`, with its first docstring line as comment."""
    comment = f"/* {function.summary.replace('*/', '* /')} */\n" if function.summary else ""
    used = {part.name for part in expressions(function.body) if isinstance(part, Name)}
    idle = [f"    (void){clear(each.name)};" for each in function.parameters if each.name not in used]
    body = "\n".join([*idle, *_statements(function, function.body, 1)])
    return f"{comment}static {_head(function)}\n{{\n{body}\n}}"


def clear(name: str) -> str:
    """The name, changed if C or its library has it already."""
    return f"{name}_" if name in _TAKEN else name


def _head(function: Function) -> str:
    parts = []
    for parameter in function.parameters:
        if isinstance(parameter.type, Array):
            kind = "int" if parameter.type.integer else "real"
            constant = "" if parameter in function.changed else "const "
            parts.append(f"{constant}{kind} *{clear(parameter.name)}")
        else:
            parts.append(f"{_kind(parameter)} {clear(parameter.name)}")
    returned = "void"
    if _by_value(function):
        returned = _kind(Name("", function.results[0]))
    else:
        parts += [f"real *out{i}" for i in range(len(function.results))]
    head = f"{returned} {clear(function.name)}("
    return "\n".join(textwrap.wrap(f"{head}{', '.join(parts) or 'void'})", 110, subsequent_indent="    "))


def _by_value(function: Function) -> bool:
    return len(function.results) == 1 and not isinstance(function.results[0], Array)


def _kind(name: Name) -> str:
    return "int" if name.type in ("int", "bool") else "real"


def _statements(function: Function, body: "list[Statement] | tuple[Statement, ...]", depth: int) -> list[str]:
    lines: list[str] = []
    pad, fresh = "    " * depth, ""
    for statement in body:
        if isinstance(statement, Declare) and not isinstance(statement.name.type, Array):
            if fresh == _kind(statement.name):  # several in one line
                lines[-1] = f"{lines[-1][:-1]}, {clear(statement.name.name)};"
                continue
            fresh = _kind(statement.name)
        else:
            fresh = ""
        lines += [pad + line for line in _statement(function, statement)]
        if isinstance(statement, Return):
            break
    if depth == 1 and lines and lines[-1] == f"{pad}return;":
        lines.pop()
    return lines


def _statement(function: Function, statement: Statement) -> list[str]:
    match statement:
        case Declare(name) if isinstance(name.type, Array):
            return [f"real {clear(name.name)}[{max(1, name.type.size)}] = {{0}};"]
        case Declare(name):
            return [f"{_kind(name)} {clear(name.name)};"]
        case Assign(target, value, declares):
            kind = f"{_kind(target)} " if declares and isinstance(target, Name) else ""
            if isinstance(value, Operation) and value.operator in "+-*/" and value.arguments[0] == target:
                return [f"{text(target)} {value.operator}= {text(value.arguments[1])};"]
            return [f"{kind}{text(target)} = {text(value)};"]
        case Fill(array, start, stop, value):
            return [f"for (int i = {start}; i < {stop}; i++) {clear(array.name)}[i] = {text(value)};"]
        case Copy(target, source):
            size = target.type.size if isinstance(target.type, Array) else 1
            return [f"for (int i = 0; i < {size}; i++) {clear(target.name)}[i] = {clear(source.name)}[i];"]
        case Invocation():
            return [_invocation(statement)]
        case Loop(variable, start, stop, body):
            i = clear(variable.name)
            head = f"for (int {i} = {text(start)}; {i} < {text(stop)}; {i}++) {{"
            return [head, *_statements(function, body, 1), "}"]
        case Branch(condition, then, otherwise):
            lines = [f"if ({text(condition)}) {{", *_statements(function, then, 1)]
            return [*lines, "} else {", *_statements(function, otherwise, 1), "}"] if otherwise else [*lines, "}"]
        case Leave():
            return ["break;"]
        case Skip():
            return ["continue;"]
        case Return(values):
            return _return(function, values)


def _invocation(statement: Invocation) -> str:
    function = statement.function
    arguments = [text(each) for each in statement.arguments]
    if _by_value(function):
        call = f"{clear(function.name)}({', '.join(arguments)});"
        return f"{text(statement.targets[0])} = {call}" if statement.targets else f"(void){call}"
    for target in statement.targets:
        arguments.append(text(target) if isinstance(target.type, Array) else f"&{text(target)}")
    return f"{clear(function.name)}({', '.join(arguments)});"


def _return(function: Function, values: tuple[Expression, ...]) -> list[str]:
    if _by_value(function):
        return [f"return {text(values[0])};"]
    lines = []
    for i, value in enumerate(values):
        if isinstance(value.type, Array):
            lines.append(f"for (int i = 0; i < {value.type.size}; i++) out{i}[i] = {text(value)}[i];")
        else:
            lines.append(f"*out{i} = {text(value)};")
    return [*lines, "return;"]


def text(expression: Expression, outer: int = 0) -> str:
    """An expression, with no more parentheses than it needs."""
    match expression:
        case Number(value, name):
            return name or (str(value) if isinstance(value, int) else literal(value))
        case Name(name):
            return clear(name)
        case Element(array, index):
            return f"{clear(array.name)}[{_place(array, index)}]"
        case Invoke(function, arguments):
            return f"{clear(function.name)}({', '.join(text(each) for each in arguments)})"
        case Operation("neg", (operand,)):
            return f"-{text(operand, 7)}"
        case Operation("not", (operand,)):
            return f"!({text(operand)})"
        case Operation("choose", (condition, one, other)):
            return f"(({text(condition)}) ? {text(one)} : {text(other)})"
        case Operation(operator, arguments) if operator in _FUNCTIONS:
            return f"{_FUNCTIONS[operator]}({', '.join(text(each) for each in arguments)})"
        case Operation(operator, arguments):
            level = _PRECEDENCE[operator]
            inside = [text(each, level + (i > 0)) for i, each in enumerate(arguments)]
            joined = f" {_WORDS.get(operator, operator)} ".join(inside)
            return f"({joined})" if level < outer else joined
    raise AssertionError(expression)  # all expressions are listed above


def _place(array: Name, index: tuple[Expression, ...]) -> str:
    """The entry's place in row-major order."""
    assert isinstance(array.type, Array)  # noqa: S101 - made only of arrays
    if len(index) == 1:
        return text(index[0])
    row, column = index
    extent = array.type.shape[1]
    if isinstance(row, Number):
        row_start = int(row.value) * extent
        return f"{row_start} + {text(column)}" if row_start else text(column)
    start = f"{text(row, 6)} * {extent}"
    return start if column == Number(0) else f"{start} + {text(column, 5)}"


def _wrapped(entries: list[str], per_line: int = 4) -> str:
    return ",\n".join(
        "    " + ", ".join(entries[start : start + per_line]) for start in range(0, len(entries), per_line)
    )
