"""Findings of a run on its logs, instruments and models; one module writes their sentences."""
