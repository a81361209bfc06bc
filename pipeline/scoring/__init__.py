"""How well a free run meets a measurement: NRMSE, wells, switches, horizons, intervals, ranking, cross-validation."""
