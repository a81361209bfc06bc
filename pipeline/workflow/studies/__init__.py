"""Studies of a finished run: sweeps, folds, excitation, control, the paper's figures."""
