"""Text of a function from a graph: C99 or MATLAB (and GNU Octave)."""

import math
import textwrap
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from ..errors import CorruptArtifactError
from .graph import Graph, GraphSequence, Operation

_OPERATORS = {"add": "+", "sub": "-", "mul": "*", "div": "/", "lt": "<", "le": "<="}
_LONGEST = 90
"""Characters of an expression that is written where it is used, if it is used once."""
_CONDITIONS = frozenset({"lt", "le", "and", "or", "not", "finite"})
"""Operations whose value is true or false."""


class Code(str):
    """Text that the program itself has written in the language of a file."""

    __slots__ = ()


def number(value: float) -> Code:
    """A real number to the last bit, as C and MATLAB read it.

    Raises
    ------
    CorruptArtifactError
        It is not finite.
    """
    if not math.isfinite(value):
        raise CorruptArtifactError(f"a constant of the model is {value}; make the model anew, then export it")
    return Code(repr(float(value)))


@dataclass(frozen=True)
class Language:
    """Syntax of a language for the parts of graphs.

    `element` takes array and entry, `number` a float; `functions` are texts with places for operands, `fetched` one for
    array, entry and what is added to it, `as_number` one for a condition that is calculated with.
    """

    element: Callable[[str, int], str]
    number: Callable[[float], str]
    functions: dict[str, str]
    assign: str
    fetched: str
    as_number: str


C99 = Language(
    lambda array, entry: f"{array}[{entry}]",
    lambda value: f"R({number(value)})",
    {
        "sqrt": "M(sqrt)({})", "exp": "M(exp)({})", "expm1": "M(expm1)({})", "tanh": "M(tanh)({})", "sin": "M(sin)({})",
        "cos": "M(cos)({})", "abs": "M(fabs)({})", "floor": "M(floor)({})", "min": "least({}, {})",
        "max": "largest({}, {})",
        "and": "({} && {})", "or": "({} || {})", "not": "!{}", "finite": "isfinite({})",
        "choose": "({} ? {} : {})", "where": "({} ? {} : R(0.0))", "neg": "(-{})",
        "sign": "((real)(({0} > 0) - ({0} < 0)))",
    },
    "const {} {} = {};",
    "{}[{} + (int){}]",
    "(real){}",
)  # fmt: skip

MATLAB = Language(
    lambda array, entry: f"{array}({entry + 1})",
    number,
    {
        "sqrt": "sqrt({})", "exp": "exp({})", "expm1": "expm1({})", "tanh": "tanh({})", "sin": "sin({})",
        "cos": "cos({})", "abs": "abs({})", "floor": "floor({})", "min": "min({}, {})", "max": "max({}, {})",
        "and": "({} && {})", "or": "({} || {})", "not": "~{}", "finite": "isfinite({})",
        "choose": "choose({}, {}, {})", "where": "choose({}, {}, 0.0)", "neg": "(-{})", "sign": "sign({})",
    },
    "{1} = {2};",
    "{}(1 + {} + {})",
    "{}",
)  # fmt: skip


def c_function(name: str, graph: Graph, scalars: frozenset[str]) -> Code:
    """A static C function of the inputs, then of the outputs that are not inputs."""
    typed = [
        f"real {array}" if array in scalars else f"{'' if array in graph.outputs else 'const '}real *{array}"
        for array in graph.arguments
    ]
    used = {i for operation in graph.operations if not _kept(graph, operation) for i in operation.operands}
    stored = {each.place[0] for each in graph.operations if each.name == "store" and not _kept(graph, each)}
    read = stored | {operation.place[0] for i, operation in enumerate(graph.operations) if i in used}
    unused = [f"(void){array};" for array in graph.arguments if array not in read]
    body = "\n".join(f"    {line}" for line in [*unused, *_lines(graph, C99, scalars)])
    head = textwrap.fill(f"static void {name}({', '.join(typed)})", 116, subsequent_indent="    ")
    return Code(f"{head}\n{{\n{body}\n}}\n")


def matlab_function(name: str, graph: Graph, scalars: frozenset[str]) -> Code:
    """A MATLAB function that takes the same arguments and returns the outputs."""
    body = "\n".join(f"    {line}" for line in _lines(graph, MATLAB, scalars))
    return Code(f"function [{', '.join(graph.outputs)}] = {name}({', '.join(graph.arguments)})\n{body}\nend\n")


def c_sequence(name: str, sequence: GraphSequence) -> Code:
    """A static C function of the given arrays; `c_function` writes the functions of its graphs."""
    changed = sequence.changed()
    given = ", ".join(f"{'' if array in changed else 'const '}real *{array}" for array in sequence.given)
    local = ", ".join(f"{array}[{size}]" for array, size in sequence.local.items())
    body = [f"real {local};"] if local else []
    body += [f"{call[0]}({', '.join(sequence.places(call))});" for call in sequence.calls]
    return Code(f"static void {name}({given})\n{{\n" + "".join(f"    {line}\n" for line in body) + "}\n")


def matlab_sequence(name: str, sequence: GraphSequence) -> Code:
    """A MATLAB function that takes the given arrays and returns those that it changes.

    A graph leaves some entries of an output as they are, so arrays exist before they are filled.
    """
    lines = [f"{array} = zeros({size}, 1);" for array, size in sequence.local.items()]
    for call in sequence.calls:
        outputs = [call[1].get(array, array) for array in sequence.graphs[call[0]].outputs]
        lines.append(f"[{', '.join(outputs)}] = {call[0]}({', '.join(sequence.places(call))});")
    head = f"function [{', '.join(sequence.changed())}] = {name}({', '.join(sequence.given)})"
    return Code(head + "\n" + "".join(f"    {line}\n" for line in lines) + "end\n")


def _lines(graph: Graph, language: Language, scalars: frozenset[str]) -> Iterator[str]:
    """One statement for each value that is used often or is long, then the stores."""
    operations = graph.operations
    uses = [0] * len(operations)
    for operation in operations:
        for i in operation.operands:
            uses[i] += not _kept(graph, operation)
    text: list[str] = []
    for i, operation in enumerate(operations):
        operands = [text[j] for j in operation.operands]
        array, entry = operation.place
        keep = uses[i] > 1
        match operation.name:
            case "store":
                expression = ""
                if not _kept(graph, operation):
                    yield f"{language.element(array, entry)} = {_bare(operands[0])};"
            case "constant":
                expression = language.number(operation.value)
                keep = False
            case "input":
                expression = array if array in scalars else language.element(array, entry)
                keep = array in graph.outputs  # it may be overwritten before it is read
            case "fetch":
                expression = language.fetched.format(array, entry, operands[0])
                keep = True
            case name if name in _OPERATORS:
                numbers = [
                    language.as_number.format(text) if operations[j].name in _CONDITIONS else text
                    for j, text in zip(operation.operands, operands, strict=True)
                ]
                expression = f"({numbers[0]} {_OPERATORS[name]} {numbers[1]})"
            case name:
                expression = language.functions[name].format(*operands)
        if uses[i] and (keep or len(expression) > _LONGEST):
            yield language.assign.format("int" if operation.name in _CONDITIONS else "real", f"w{i}", _bare(expression))
            expression = f"w{i}"
        text.append(expression)


def _kept(graph: Graph, operation: Operation) -> bool:
    """True if the operation stores the value that is there already."""
    return operation.name == "store" and graph.operations[operation.operands[0]].place == operation.place


def _bare(expression: str) -> str:
    """Text without the outer pair of parentheses."""
    if not (expression.startswith("(") and expression.endswith(")")):
        return expression
    depth = 0
    for i, letter in enumerate(expression):
        depth += (letter == "(") - (letter == ")")
        if depth == 0:
            return expression[1:-1] if i == len(expression) - 1 else expression
    return expression
