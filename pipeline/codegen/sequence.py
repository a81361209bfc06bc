"""Graphs that are called one after another on named arrays: compiled by numba, as C99 and as MATLAB.

A sequence is what a law with stages is made of, as a Runge-Kutta step that calls the same rates four times: each graph
is written once, and the calls say in which arrays it finds its inputs and leaves its outputs.
"""

# mypy: disable-error-code="no-untyped-def,no-untyped-call,call-overload"

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from llvmlite import ir

from ..numerics.compiled import TypingError, intrinsic, types
from .graph import Graph
from .numba_writer import write_graph
from .text_writer import Code, arguments

Call = tuple[str, dict[str, str]]
"""Name of a graph, and the arrays used for some of its inputs and outputs; the others have their own names."""


@dataclass(frozen=True)
class GraphSequence:
    """Calls of graphs.

    Attributes
    ----------
    graphs : dict of Graph
        By name.
    calls : tuple of Call
        In order.
    given : tuple of str
        Arrays that come from outside; all others live during a run only.
    """

    graphs: dict[str, Graph]
    calls: tuple[Call, ...]
    given: tuple[str, ...]

    def places(self, call: Call) -> list[str]:
        """The arrays of a call, in the order of the graph's inputs and outputs."""
        name, other = call
        return [other.get(array, array) for array in arguments(self.graphs[name])]

    @cached_property
    def local(self) -> dict[str, int]:
        """Length of every array that is not given."""
        sizes: dict[str, int] = {}
        for name, other in self.calls:
            for array, size in self.graphs[name].outputs.items():
                place = other.get(array, array)
                if place not in self.given:
                    sizes[place] = size
        return sizes

    def changed(self) -> list[str]:
        """Given arrays that are written."""
        outputs = {other.get(array, array) for name, other in self.calls for array in self.graphs[name].outputs}
        return [array for array in self.given if array in outputs]


def sequence_kernel(sequence: GraphSequence) -> Any:
    """A function for compiled code of one tuple: the given arrays, float64 and contiguous."""

    def generate(context, builder, signature, arrays):
        """LLVM code: the graphs one after another, on the given arrays and on local ones."""
        (kinds,) = signature.args
        values = [builder.extract_value(arrays[0], i) for i in range(len(sequence.given))]
        pointers = {
            name: context.make_array(kind)(context, builder, value).data
            for name, kind, value in zip(sequence.given, kinds, values, strict=True)
        }
        for name, size in sequence.local.items():
            with builder.goto_entry_block():
                space = builder.alloca(ir.ArrayType(ir.DoubleType(), size))
            pointers[name] = builder.bitcast(space, ir.DoubleType().as_pointer())
        for call in sequence.calls:
            function = _function(builder.module, call[0], sequence.graphs[call[0]])
            builder.call(function, [pointers[array] for array in sequence.places(call)])
        return context.get_dummy_value()

    @intrinsic
    def run(typing_context, arrays):
        """The sequence."""
        kinds = list(arrays) if isinstance(arrays, types.BaseTuple) else []
        if len(kinds) != len(sequence.given) or not all(
            isinstance(a, types.Array) and a.layout == "C" and a.dtype == types.float64 for a in kinds
        ):
            raise TypingError(f"a sequence takes contiguous arrays of float64 {', '.join(sequence.given)}")
        return types.none(arrays), generate

    return run


def _function(module: Any, name: str, graph: Graph) -> Any:
    """The function of one graph in a module that is being made."""
    symbol = f"graph_{name}"
    if symbol not in module.globals:
        names = arguments(graph)
        kind = ir.FunctionType(ir.VoidType(), [ir.DoubleType().as_pointer()] * len(names))
        function = ir.Function(module, kind, symbol)
        function.linkage = "internal"
        builder = ir.IRBuilder(function.append_basic_block("entry"))
        write_graph(graph, builder, dict(zip(names, function.args, strict=True)))
        builder.ret_void()
    return module.globals[symbol]


def c_sequence(name: str, sequence: GraphSequence) -> Code:
    """A static C function of the given arrays; those of its graphs are made by `c_function`."""
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
