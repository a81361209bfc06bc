"""Parts of compiled loops: copies, and LU of 4×4 systems, cheaper than a call of LAPACK.

`FAST` is what lets the compiler turn a loop into vector instructions.
"""

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
    factors, pivots : shapes (n, n) and (n,)
        From `factorise`.
    right : FloatArray, shape (n · count,)
        Right-hand sides, row by row; the solutions (output).
    count : int
        How many there are.
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
