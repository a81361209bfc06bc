"""Runs from settings and logs: stages, what is redone and why, batches, and uses of a run."""
