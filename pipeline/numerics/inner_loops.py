"""Parts of compiled loops: copies, LU of 4×4 systems, cheaper than a call of LAPACK, and quintics in vector registers.

`FAST` is what lets the compiler turn a loop into vector instructions.
"""

from typing import TYPE_CHECKING

from .arrays import FloatArray, IntArray
from .compiled import inner, part


@inner
def copy_into(target: FloatArray, source: FloatArray) -> None:
    """target[:] = source, shapes (n,): an assignment of slices compiles seconds longer, for what it could raise."""
    for i in range(len(target)):
        target[i] = source[i]


@inner
def factorise(matrix: FloatArray, pivots: IntArray) -> bool:
    """LU with partial pivoting, in place; False if a pivot vanishes or is not finite.

    Parameters
    ----------
    matrix : FloatArray, shape (n, n)
        Overwritten by the factors.
    pivots : IntArray, shape (n,)
        Row taken at each step (output).

    Notes
    -----
    Cost: n³/3 multiply-adds; 40 ns for n = 4.
    """
    n = matrix.shape[0]
    for k in range(n):
        best = k
        for i in range(k + 1, n):
            if abs(matrix[i, k]) > abs(matrix[best, k]):
                best = i
        pivots[k] = best
        if not abs(matrix[best, k]) > 0.0 or abs(matrix[best, k]) > 1e300:
            return False
        if best != k:
            for j in range(n):
                matrix[k, j], matrix[best, j] = matrix[best, j], matrix[k, j]
        for i in range(k + 1, n):
            matrix[i, k] /= matrix[k, k]
            for j in range(k + 1, n):
                matrix[i, j] -= matrix[i, k] * matrix[k, j]
    return True


@part
def solve_factorised(factors: FloatArray, pivots: IntArray, right: FloatArray, count: int) -> None:
    """Solve with the factors of `factorise` for `count` right-hand sides.

    `right` (n · count,), row by row, becomes the solutions.

    Parameters
    ----------
    factors : FloatArray, shape (n, n)
        From `factorise`.
    pivots : IntArray, shape (n,)
        From `factorise`.
    right : FloatArray, shape (n · count,)
        Right-hand sides row by row; becomes the solutions.
    count : int
        Number of right-hand sides.
    """
    n = factors.shape[0]
    for k in range(n):
        other = pivots[k]
        if other != k:
            for c in range(count):
                right[k * count + c], right[other * count + c] = right[other * count + c], right[k * count + c]
    for k in range(n):
        for i in range(k + 1, n):
            factor = factors[i, k]
            for c in range(count):
                right[i * count + c] -= factor * right[k * count + c]
    for k in range(n - 1, -1, -1):
        for j in range(k + 1, n):
            factor = factors[k, j]
            for c in range(count):
                right[k * count + c] -= factor * right[j * count + c]
        pivot = factors[k, k]
        for c in range(count):
            right[k * count + c] /= pivot


FAST = {"contract", "arcp", "nsz"}
"""Liberties of the compiler: fused operations, reciprocals, and the sign of zero; NaN stays NaN."""

if TYPE_CHECKING:

    def quintics(table: FloatArray, cell: int, x: float, out: FloatArray, first: int, stride: int, count: int) -> None:
        """Quintics at x with the coefficients `table` (cells, 6, 16) of a cell, to `out[first + i stride]`.

        i < `count`, at most 16, is a number known to the compiler.
        """
else:
    from llvmlite import ir

    from .compiled import intrinsic, types

    _VECTOR = ir.VectorType(ir.DoubleType(), 16)
    _INTEGER = ir.IntType(64)

    @intrinsic(prefer_literal=True)
    def quintics(typing_context, table, cell, x, out, first, stride, count):
        """Quintics at x with the coefficients `table` (cells, 6, 16) of a cell, to `out[first + i stride]`."""

        def generate(context, builder, signature, arguments):
            """LLVM code: Horner's rule for a row of 16, of which `count` are stored."""
            data, target = (context.make_array(signature.args[i])(context, builder, arguments[i]).data for i in (0, 3))
            start = builder.mul(arguments[1], ir.Constant(_INTEGER, 96))

            def row(number):
                place = builder.gep(data, [builder.add(start, ir.Constant(_INTEGER, 16 * number))], inbounds=True)
                return builder.load(builder.bitcast(place, _VECTOR.as_pointer()), align=8)

            undefined = ir.Constant(_VECTOR, ir.Undefined)
            single = builder.insert_element(undefined, arguments[2], ir.Constant(ir.IntType(32), 0))
            broadcast = ir.Constant(ir.VectorType(ir.IntType(32), 16), [0] * 16)
            spread = builder.shuffle_vector(single, undefined, broadcast)
            total = row(5)
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
