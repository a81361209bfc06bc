"""What the program takes, gives and needs, and where it does not fit: for scripts and assistants that choose a tool."""

from typing import Any, get_args

from pipeline import __version__
from pipeline.model_list import ENTRIES
from pipeline.names import Target

INPUTS = {
    "raw logs": "MAT, MDF 3 and 4, CSV, Parquet, HDF5, NPY, NPZ, TDMS, workbooks, compressed; any length",
    "signals": "one displacement or angle q; one or two inputs v1, v2; optionally a measured velocity",
    "settings": "one TOML file: name, logs, channels with units; the others have defaults",
    "arrays": "`debist.identify(t, q, v1, v2)`, SI units",
}
OUTPUTS = {
    "debist run": "uniform records, derivatives, models, predictions, scores, as Parquet and HDF5",
    "debist report, debist show": "page, datasheet with wells, switching voltages, stiffness, ring-down",
    "debist validate, debist compare": "errors with 95 % intervals, baselines beside the model",
    "debist control": "linear models, switching maps, pulses, a controller",
    "debist export": "the model as C99, FMU, MATLAB, JSON; the controller as C99, MATLAB and FMU; the run as a crate",
    "debist rig": "excitation sequences, simulated logs",
}
PRECONDITIONS = (
    "q and the inputs share one clock, or their delay is constant; `debist check` measures it.",
    "Units are known; nothing is guessed.",
    "`hybrid` needs two squared inputs, a displacement in metres, and logs that visit both wells.",
    "Training and validation logs are different logs of the same device.",
    "The excitation reaches every place where predictions are wanted.",
    "Linux, macOS or Windows; Python 3.11 to 3.13.",
)
NOT_SUITABLE = (
    "The device has more than one degree of freedom that matters, more than two inputs, or several outputs.",
    "Contacts occur anywhere but at the ends of the travel.",
    "The motion is chaotic and long predictions are wanted.",
    "Predictions are needed outside the range of the logs.",
    "The model must adapt while the joint runs.",
    "Proof on a measured bistable joint is required: all joints so far are simulated.",
)


def capabilities() -> dict[str, Any]:
    """The capability sheet as a JSON document."""
    return {
        "program": "debist",
        "version": __version__,
        "inputs": INPUTS,
        "outputs": OUTPUTS,
        "models": [entry.name for entry in ENTRIES],
        "exports": list(get_args(Target)),
        "preconditions": list(PRECONDITIONS),
        "not_suitable_when": list(NOT_SUITABLE),
    }
