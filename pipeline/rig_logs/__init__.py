"""Raw logs of test rigs: one reader per format, run in a guarded child process."""
