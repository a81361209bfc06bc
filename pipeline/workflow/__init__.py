"""Runs from settings and logs: stages, reasons to redo them, batches, and uses of a run."""
