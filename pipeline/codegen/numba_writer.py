"""Kernels in numba from graphs: operations go straight to the compiler, for one joint or several side by side.

`kernel` takes arrays, `formula` numbers.

Written as Python source they would pass numba's type inference one by one, 2 ms each; here they cost a tenth of that.
Vector instructions are written out, so they do not depend on an optimiser.
"""

# mypy: disable-error-code="no-untyped-def,no-untyped-call,call-overload"

import hashlib
import math
from collections.abc import Sequence
from itertools import islice
from typing import Any

from llvmlite import ir

from ..numerics.compiled import FAST, TypingError, intrinsic, lower_builtin, type_callable, types
from .graph import Graph, GraphSequence, Operation, apply

_FLAGS = tuple(sorted(FAST))
_REAL = ir.DoubleType()
_SINGLE = ir.FloatType()
_LANE, _PLACE = ir.IntType(32), ir.IntType(64)
_FUNCTIONS = {"sqrt": "llvm.sqrt", "abs": "llvm.fabs", "floor": "llvm.floor"}


def kernel(
    graph: Graph, width: int = 1, value: str | None = None, common: tuple[str, ...] = (), single: bool = False
) -> Any:
    """A function for compiled code of one tuple: the inputs' arrays, then the outputs', all float64 and contiguous.

    With `width` joints side by side every array holds rows of `width` numbers, one for each joint, but for the inputs
    `common` to all of them. The output named `value`, if any, is a number that is returned. In `single` precision all
    are float32, and twice as many fit into a register.

    Parameters
    ----------
    graph : Graph
        The operations.
    width : int
        Joints side by side.
    value : str, optional
        Name of the output, of one entry, that is returned as a number.
    common : tuple of str
        Names of the inputs that all joints share.
    single : bool
        True if numbers are float32.
    """
    real, number = (_SINGLE, types.float32) if single else (_REAL, types.float64)
    names = [name for name in [*graph.inputs, *graph.outputs] if name != value]

    def generate(context, builder, signature, arguments):
        """LLVM code: a call of the graph's function with the arrays' addresses."""
        function = _function(builder.module, graph, names, width, value, common, real)
        addresses = _addresses(context, builder, names, signature.args[0], arguments[0])
        result = builder.call(function, list(addresses.values()))
        return context.get_dummy_value() if value is None else result

    return _of_arrays(names, number, types.none if value is None else number, generate)


def sequence_kernel(sequence: GraphSequence) -> Any:
    """A function for compiled code of one tuple: the given arrays, float64 and contiguous."""

    def generate(context, builder, signature, arrays):
        """LLVM code: the graphs one after another, on the given arrays and on local ones."""
        pointers = _addresses(context, builder, sequence.given, signature.args[0], arrays[0])
        for name, size in sequence.local.items():
            with builder.goto_entry_block():
                pointers[name] = builder.bitcast(builder.alloca(ir.ArrayType(_REAL, size)), _REAL.as_pointer())
        for call in sequence.calls:
            graph = sequence.graphs[call[0]]
            # Without the compiler's liberties the digits are those of C.
            function = _function(builder.module, graph, graph.arguments, 1, None, (), _REAL, flags=())
            builder.call(function, [pointers[array] for array in sequence.places(call)])
        return context.get_dummy_value()

    return _of_arrays(sequence.given, types.float64, types.none, generate)


def _of_arrays(names: Sequence[str], number: Any, returned: Any, generate: Any) -> Any:
    """The function of a tuple of contiguous arrays of one kind of `number`, whose code `generate` writes."""

    @intrinsic
    def run(typing_context, arrays):
        """The kernel."""
        given = list(arrays) if isinstance(arrays, types.BaseTuple) else []
        if len(given) != len(names) or not all(
            isinstance(a, types.Array) and a.layout == "C" and a.dtype == number for a in given
        ):
            raise TypingError(f"a kernel takes contiguous arrays of {number} {', '.join(names)}, not {arrays}")
        return returned(arrays), generate

    return run


def _addresses(context: Any, builder: Any, names: Sequence[str], kinds: Any, arrays: Any) -> dict[str, Any]:
    """Address of the numbers of each array of a tuple."""
    return {
        name: context.make_array(kind)(context, builder, builder.extract_value(arrays, i)).data
        for i, (name, kind) in enumerate(zip(names, kinds, strict=True))
    }


def _function(
    module: Any,
    graph: Graph,
    names: list[str],
    width: int,
    value: str | None,
    common: tuple[str, ...],
    real: Any,
    flags: tuple[str, ...] = _FLAGS,
) -> Any:
    """The function of a graph in a module: written once, and called from wherever the graph is used."""
    digest = hashlib.sha256(f"{graph.text} {names} {value} {common} {flags}".encode()).hexdigest()[:16]
    kind = ir.FunctionType(ir.VoidType() if value is None else real, [real.as_pointer()] * len(names))
    function = function_of(module, kind, f"graph.{digest}.{width}.{real}")
    if function.is_declaration:
        function.linkage = "linkonce_odr"
        function.attributes.add("noinline")
        function.attributes.add("nounwind")
        builder = ir.IRBuilder(function.append_basic_block())
        writer = _Writer(builder, dict(zip(names, function.args, strict=True)), width, flags, common, real)
        writer.write(graph)
        builder.ret_void() if value is None else builder.ret(writer.value)
    return function


def function_of(module: Any, kind: Any, name: str) -> Any:
    """The function of this name in a module, declared if it is not there."""
    return module.globals.get(name) or ir.Function(module, kind, name)


def formula(graph: Graph) -> Any:
    """A function of one tuple of numbers, the inputs' entries in order; it returns the outputs' as a tuple.

    Compiled code has the operations in place. Plain Python calls it with traced values or numbers.
    """
    count = sum(graph.inputs.values())
    given_type = types.UniTuple(types.float64, count)

    def run(numbers):
        """The formula."""
        return tuple(apply(graph, *numbers))

    @type_callable(run)
    def typed(context):
        """Typing function of the calls."""

        def of(numbers):
            """The signature for a tuple of numbers."""
            if not isinstance(numbers, types.BaseTuple) or len(numbers) != count:
                raise TypingError(f"a formula takes {count} numbers of {', '.join(graph.inputs)}, not {numbers}")
            return types.UniTuple(types.float64, sum(graph.outputs.values()))(given_type)

        return of

    @lower_builtin(run, given_type)
    def generate(context, builder, signature, arguments):
        """LLVM code: the graph's operations, in place."""
        given = (builder.extract_value(arguments[0], i) for i in range(count))
        arrays = {name: list(islice(given, size)) for name, size in graph.inputs.items()}
        writer = _Writer(builder, {}, 1)
        outputs = graph.inline(
            lambda name, operands: writer.value_of(Operation(name, ()), operands), writer.number, **arrays
        )
        values = [writer.as_real(value) for entries in outputs.values() for value in entries]
        return context.make_tuple(builder, signature.return_type, values)

    return run


class _Writer:
    """Emits the operations of one graph."""

    def __init__(
        self,
        builder: Any,
        pointers: dict[str, Any],
        width: int,
        flags: tuple[str, ...] = _FLAGS,
        common: tuple[str, ...] = (),
        real: Any = _REAL,
    ) -> None:
        self.builder = builder
        self.pointers = pointers
        self.width = width
        self.flags = flags
        self.common = common if width > 1 else ()
        self.value = None
        self.real = real
        self.bytes = 4 if real == _SINGLE else 8
        self.type = real if width == 1 else ir.VectorType(real, width)

    def write(self, graph: Graph) -> None:
        """Emit the operations of a graph in order."""
        values: list[Any] = []
        for operation in graph.operations:
            values.append(self.value_of(operation, [values[i] for i in operation.operands]))

    def value_of(self, operation: Operation, operands: list[Any]) -> Any:
        """Emit one operation."""
        build = self.builder
        name = operation.name
        match name:
            case "constant":
                return self.number(operation.value)
            case "input":
                return self._load(operation)
            case "lt" | "le":
                return build.fcmp_ordered("<" if name == "lt" else "<=", *operands)
            case "and" | "or":
                return getattr(build, f"{name}_")(*(self._truth(value) for value in operands))
            case "not":
                return build.not_(self._truth(operands[0]))
            case "where":
                return build.select(self._truth(operands[0]), self.as_real(operands[1]), self.number(0.0))
            case "choose":
                return build.select(self._truth(operands[0]), *(self.as_real(value) for value in operands[1:]))
        a, *more = (self.as_real(value) for value in operands)
        match name:
            case "store":
                return self._store(operation, a)
            case "fetch":
                return build.load(self._fetched(operation, a), align=self.bytes)
            case "finite":
                return build.fcmp_ordered("<", self.value_of(Operation("abs", ()), [a]), self.number(math.inf))
            case "add" | "sub" | "mul" | "div":
                return getattr(build, f"f{name}")(a, more[0], flags=self.flags)
            case "neg":
                return build.fneg(a, flags=self.flags)
            case "min" | "max":
                return build.select(build.fcmp_ordered("<" if name == "min" else ">", a, more[0]), a, more[0])
            case "sign":
                positive, negative = (build.fcmp_ordered(way, a, self.number(0.0)) for way in "><")
                low = build.select(negative, self.number(-1.0), self.number(0.0))
                return build.select(positive, self.number(1.0), low)
            case "sqrt" | "abs" | "floor":
                kind = f"f{8 * self.bytes}" if self.width == 1 else f"v{self.width}f{8 * self.bytes}"
                unary = ir.FunctionType(self.type, [self.type])
                return build.call(
                    function_of(build.module, unary, f"{_FUNCTIONS[name]}.{kind}"), [a], fastmath=self.flags
                )
        return self._of_library(name, a)

    def _of_library(self, name: str, a: Any) -> Any:
        """A function of the C library, called for one joint after the other."""
        name = name if self.real == _REAL else f"{name}f"
        function = function_of(self.builder.module, ir.FunctionType(self.real, [self.real]), name)
        if self.width == 1:
            return self.builder.call(function, [a])
        for i in range(self.width):
            lane = ir.Constant(_LANE, i)
            a = self.builder.insert_element(
                a, self.builder.call(function, [self.builder.extract_element(a, lane)]), lane
            )
        return a

    def _load(self, operation: Operation) -> Any:
        array, entry = operation.place
        if array not in self.common:
            return self.builder.load(self._place(operation), align=self.bytes)
        at = self.builder.gep(self.pointers[array], [ir.Constant(_PLACE, entry)], inbounds=True)
        single = self.builder.insert_element(
            ir.Constant(self.type, ir.Undefined),
            self.builder.load(at, align=self.bytes),
            ir.Constant(_LANE, 0),
        )
        broadcast = ir.Constant(ir.VectorType(_LANE, self.width), [0] * self.width)
        return self.builder.shuffle_vector(single, ir.Constant(self.type, ir.Undefined), broadcast)

    def _store(self, operation: Operation, value: Any) -> Any:
        if operation.place[0] not in self.pointers:
            self.value = value
            return value
        return self.builder.store(value, self._place(operation), align=self.bytes)

    def _place(self, operation: Operation) -> Any:
        array, entry = operation.place
        at = self.builder.gep(self.pointers[array], [ir.Constant(_PLACE, entry * self.width)], inbounds=True)
        return at if self.width == 1 else self.builder.bitcast(at, self.type.as_pointer())

    def _fetched(self, operation: Operation, index: Any) -> Any:
        """Address of a table's entry, for one joint."""
        array, entry = operation.place
        at = self.builder.add(self.builder.fptosi(index, _PLACE), ir.Constant(_PLACE, entry))
        return self.builder.gep(self.pointers[array], [at], inbounds=True)

    def number(self, value: float) -> Any:
        """A constant."""
        return ir.Constant(self.type, value if self.width == 1 else [value] * self.width)

    def as_real(self, value: Any) -> Any:
        """A truth as 0 or 1."""
        if self._is_real(value):
            return value
        return self.builder.select(value, self.number(1.0), self.number(0.0))

    def _truth(self, value: Any) -> Any:
        if not self._is_real(value):
            return value
        return self.builder.fcmp_unordered("!=", value, self.number(0.0))

    def _is_real(self, value: Any) -> bool:
        return bool(getattr(value.type, "element", value.type) == self.real)
