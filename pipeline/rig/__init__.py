"""The virtual rig: simulated prototypes that write raw logs as a test bench would."""
