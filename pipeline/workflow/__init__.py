"""From settings and logs to a finished run: stages, what is redone and why, batches, and uses of a run."""
