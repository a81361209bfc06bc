"""debist in Python: models and runs for notebooks and scripts."""
