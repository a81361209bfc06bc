"""Scores of free runs against measurements: NRMSE, wells, switches, horizons, intervals, ranking, cross-validation."""
