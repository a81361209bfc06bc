"""Memory of linear algebra, where the address space is limited (`ulimit -v`).

OpenBLAS needs room for its buffer while it is loaded, or at its first product. Without that room it tries for ever, or
ends the process without an error.
"""

import mmap

from .isolation import resource

BUFFERS = 2**28
"""Address space [bytes] that OpenBLAS and what is imported with it need; tried at limits from 120 to 700 MB."""


def is_limited() -> bool:
    """True under a limit of address space."""
    return resource is not None and resource.getrlimit(resource.RLIMIT_AS)[0] != resource.RLIM_INFINITY


def claim_room(size: int) -> None:
    """Claim so much address space [bytes] for a moment, if it is limited.

    Raises
    ------
    OSError
        There is less.
    """
    if is_limited():
        mmap.mmap(-1, size).close()


def load_linear_algebra() -> None:
    """Have OpenBLAS take its memory now, if the address space is limited.

    Raises
    ------
    OSError
        There is too little.
    """
    if is_limited():
        claim_room(BUFFERS)
        import numpy as np
        from scipy.linalg.blas import dgemm

        dgemm(1.0, np.eye(3), np.eye(3) @ np.eye(3))
