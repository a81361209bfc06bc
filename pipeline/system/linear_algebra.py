"""Linear algebra takes its memory when this is imported, where address space is limited (`ulimit -v`).

OpenBLAS needs room for its buffer while it is loaded, or at its first product. Without that room it tries for ever, or
ends the process without an error.
"""

import mmap

from .isolation import resource

LIMITED = resource is not None and resource.getrlimit(resource.RLIMIT_AS)[0] != resource.RLIM_INFINITY
"""True under a limit of address space."""

if LIMITED:
    mmap.mmap(-1, 1 << 28).close()  # room for what follows, else an OSError
    import numpy as np
    from scipy.linalg.blas import dgemm

    dgemm(1.0, np.eye(3), np.eye(3) @ np.eye(3))
