"""Writes `pipeline.generated` from the equations; developers only."""
