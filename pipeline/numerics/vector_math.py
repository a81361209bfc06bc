"""What a loop needs to be turned into vector instructions: options of the compiler, and functions without branches."""

from typing import TYPE_CHECKING

from pipeline.numerics.arrays import FloatArray

FAST = {"contract", "arcp", "nsz"}
"""Liberties of the compiler: fused operations, reciprocals, and the sign of zero; NaN stays NaN."""

if TYPE_CHECKING:

    def quintics(table: FloatArray, cell: int, x: float, out: FloatArray, first: int, stride: int, count: int) -> None:
        """Quintics at x with the coefficients `table` (cells, 6, 16) of a cell, to `out[first + i stride]`.

        i < `count`, at most 16, is a number known to the compiler.
        """
else:
    from llvmlite import ir
    from numba.core import types
    from numba.extending import intrinsic
    from numba.np.arrayobj import make_array

    _VECTOR, _INTEGER = ir.VectorType(ir.DoubleType(), 16), ir.IntType(64)

    @intrinsic(prefer_literal=True)
    def quintics(typing_context, table, cell, x, out, first, stride, count):
        """Quintics at x with the coefficients `table` (cells, 6, 16) of a cell, to `out[first + i stride]`."""

        def generate(context, builder, signature, arguments):
            """LLVM code: Horner's rule for a row of 16, of which `count` are stored."""
            data, target = (make_array(signature.args[i])(context, builder, arguments[i]).data for i in (0, 3))
            start = builder.mul(arguments[1], ir.Constant(_INTEGER, 96))

            def row(number):
                place = builder.gep(data, [builder.add(start, ir.Constant(_INTEGER, 16 * number))], inbounds=True)
                return builder.load(builder.bitcast(place, _VECTOR.as_pointer()), align=8)

            undefined = ir.Constant(_VECTOR, ir.Undefined)
            single = builder.insert_element(undefined, arguments[2], ir.Constant(ir.IntType(32), 0))
            lanes = ir.Constant(ir.VectorType(ir.IntType(32), 16), [0] * 16)
            spread, total = builder.shuffle_vector(single, undefined, lanes), row(5)
            for number in range(4, -1, -1):
                product = builder.fmul(total, spread, flags=("contract",))
                total = builder.fadd(product, row(number), flags=("contract",))
            place = arguments[4]
            for i in range(count.literal_value):
                value = builder.extract_element(total, ir.Constant(ir.IntType(32), i))
                builder.store(value, builder.gep(target, [place], inbounds=True))
                place = builder.add(place, arguments[5])
            return context.get_dummy_value()

        if not isinstance(count, types.IntegerLiteral):
            return None
        whole = types.int64
        return types.none(table, whole, types.float64, out, whole, whole, count), generate
