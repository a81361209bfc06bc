"""Python kernels of the controller as C: what numba compiles, read and written again for a real-time target."""
