"""One module per stage: inputs, settings, run, outputs. Stages meet only through artifacts."""
