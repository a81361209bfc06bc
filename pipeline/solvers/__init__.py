"""Integrators and continuation of equilibria."""
