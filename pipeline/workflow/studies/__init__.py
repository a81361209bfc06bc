"""Studies of a finished run: sweeps, excitation, control, the paper's figures."""
