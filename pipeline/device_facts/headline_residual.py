"""The residual of the headline model on one log."""

import numpy as np

from pipeline.device_facts.residual_analysis import Residual, analyse_residual
from pipeline.device_facts.run_data import LogData, RunData, inputs_of, squared_inputs


def headline_residual(data: RunData, log: LogData) -> Residual | None:
    """Analysis of its free run's residual of q against what acts on the device; None of a short or missing run."""
    model = data.model_names[0]
    if model not in log.predictions:
        return None
    inputs = inputs_of(log.kinematics)
    acting = np.square(inputs) if squared_inputs(data) else inputs
    return analyse_residual(log.kinematics["q"], log.predictions[model]["q"], acting, log.interval)
