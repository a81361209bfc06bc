"""How well a free run meets a measurement: wells, switches, horizons, intervals, cross-validation."""
