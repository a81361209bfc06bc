"""Signals of least total variation: a primal-dual Newton method in linear time."""
