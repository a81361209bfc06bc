"""Imports and kernels of every run, loaded once where the processes of a batch are forked."""

import importlib
import pkgutil
import signal
from pathlib import Path

signal.signal(signal.SIGINT, signal.SIG_IGN)  # the batch alone decides what Ctrl-C means, and imports take seconds

from ..system.machine import load_linear_algebra  # noqa: E402

load_linear_algebra()
import numpy as np  # noqa: E402

from ..signals.differentiate import differentiate  # noqa: E402
from ..system.package import full_name  # noqa: E402

_ROOMS = ("numerics", "generated", "signals", "store", "rig_logs", "scoring", "fitting", "models", "diagnostics")
_WITHIN_FUNCTIONS = (
    "scipy.signal", "scipy.optimize", "scipy.interpolate", "multiprocessing.popen_fork",
    full_name("workflow.run"), full_name("commands.outcome"), full_name("reporting.log_figures"),
)  # fmt: skip
"""Rooms that a run uses, and what they import within functions."""

for room in _ROOMS:
    for module in pkgutil.walk_packages([str(Path(__file__).parents[1] / room)], full_name(f"{room}.")):
        importlib.import_module(module.name)
for name in _WITHIN_FUNCTIONS:
    importlib.import_module(name)
samples = np.sin(0.1 * np.arange(40.0)) + 0.01 * (np.arange(40) % 3)
differentiate(samples, 0.001)
