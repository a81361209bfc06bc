"""What a loop needs to be turned into vector instructions: options of the compiler, and functions without branches."""

from typing import TYPE_CHECKING

FAST = {"contract", "arcp", "nsz"}
"""Liberties of the compiler: fused operations, reciprocals, and the sign of zero; NaN stays NaN."""

if TYPE_CHECKING:

    def root(x: float) -> float:
        """√x as the processor's instruction: `math.sqrt` is a call, which no loop can be vectorised around."""
else:
    from numba.core import types
    from numba.extending import intrinsic

    @intrinsic
    def root(typing_context, x):
        """√x as the processor's instruction."""

        def generate(context, builder, signature, arguments):
            return builder.call(builder.module.declare_intrinsic("llvm.sqrt", [arguments[0].type]), arguments)

        return types.float64(types.float64), generate
