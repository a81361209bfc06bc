"""The analytical joint (section 3 of the paper): parameters, equilibria, statics, dynamics, reduction, calibration."""
