"""Graphs of operations, and the writers that turn them into compiled kernels, C99 and MATLAB."""
