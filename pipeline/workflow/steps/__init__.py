"""The steps from a log to scores, as functions of logs, device and settings: no paths, no artifacts."""
