"""What stages and tools load: the device by its settings, parameter sets, raw logs in SI, trajectories."""
