"""The model for MATLAB, Simulink and GNU Octave: a function, and a MAT file with lookup tables."""

import io
from pathlib import Path
from typing import Any

import numpy as np
from scipy.io import savemat

from pipeline import __version__
from pipeline.codegen.text_writer import matlab_function
from pipeline.export.c99 import model_fields
from pipeline.export.subject import SCALARS, Exported, Subject, curve_tables
from pipeline.export.templates import render
from pipeline.runs.atomic import write_bytes, write_text
from pipeline.units import MASS

_DESCRIPTION_BYTES = 116


def write_matlab(subject: Subject, folder: Path) -> Exported:
    """Write ``IDENTIFIER.m`` and ``IDENTIFIER_data.mat``.

    The MAT file holds breakpoints and tables for Simulink's 1-D Lookup Table blocks under the names `q_bp`, `F_table`,
    `d_table`, …, the structs `units` and `validity`, and in `check` a log with the model's own run.
    """
    script, data = folder / f"{subject.identifier}.m", folder / f"{subject.identifier}_data.mat"
    write_text(script, function_source(subject))
    write_bytes(data, _mat_bytes(variables(subject), f"debist {__version__}, {subject.identifier}"))
    return Exported([script, data])


def function_source(subject: Subject) -> str:
    """The function that runs the model freely."""
    realisation = subject.realisation()
    fields = model_fields(subject, realisation) | {
        "functions": [
            matlab_function(name, graph, SCALARS) for name, graph in realisation.functions.items() if name != "flow"
        ],
        "z": max(1, len(realisation.hysteresis_states)),
    }
    return render("model.m.j2", fields)


def variables(subject: Subject) -> dict[str, Any]:
    """What the MAT file holds, all in SI."""
    v, run = subject.validity, subject.model.simulate(subject.t, subject.v, *subject.start)
    arrays: dict[str, Any] = {
        "validity": {
            "q": np.array(v.q),
            "qdot": np.array(v.qdot),
            "v": np.array(v.v),
            "sample_interval": v.sample_interval,
        },
        "check": {
            "t": subject.t[:, None],
            "v": subject.v,
            "q0": subject.start[0],
            "qdot0": subject.start[1],
            "q": run.q[:, None],
            "qdot": run.qdot[:, None],
        },
    }
    units = {"q_bp": v.q_unit, "t": "s", "q": v.q_unit, "qdot": f"{v.q_unit}/s", "v": v.v_units[0]}
    for table in curve_tables(subject):
        arrays["q_bp"] = table.q[None, :]
        arrays[f"{table.name}_table"] = table.values[None, :]
        units[f"{table.name}_table"] = table.unit.replace("·", ".")
    if "q_bp" in arrays:
        arrays["mass"] = float(getattr(subject.model, "mass", 1.0))
        units["mass"] = MASS[v.q_unit].replace("·", ".").replace("²", "2")
    return arrays | {"units": units, "source": f"{subject.prototype}, {subject.name}, {subject.origin}"}


def _mat_bytes(arrays: dict[str, Any], title: str) -> bytes:
    """A MAT v5 file whose header has a title in place of the time of writing."""
    buffer = io.BytesIO()
    savemat(buffer, arrays, long_field_names=True, oned_as="row")  # type: ignore[arg-type]  # takes streams too
    content = buffer.getvalue()
    return (
        title.encode("ascii", "replace")[:_DESCRIPTION_BYTES].ljust(_DESCRIPTION_BYTES) + content[_DESCRIPTION_BYTES:]
    )
