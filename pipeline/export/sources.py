"""The model as text for other tools: C99 for a real-time target, MATLAB with lookup tables, one JSON document.

A MATLAB function also runs in Simulink and GNU Octave; the MAT file beside it holds the tables. The JSON document has
states, constants, curves, units, validity range, and a run to check against.
"""

import io
import json
from pathlib import Path
from typing import Any

import numpy as np

from ..codegen.text_writer import c_function, matlab_function
from ..errors import InputError
from ..numerics.fixed_step import AHEAD, ALL_SHARES, NODES, SHARES
from ..store.atomic import write_bytes, write_text
from ..store.manifest import to_json
from ..system.package import program_version
from ..units.units import MASS
from .subject import SCALARS, Exported, Realisation, Subject, curve_tables
from .templates import constant, render, write_texts

_DESCRIPTION_BYTES = 116
FORMAT = "debist-model/1"
_BETWEEN = {"linear": "linear", "cubic": "cubic spline", "zero": "held"}
CHECK_SAMPLES = 500
"""Samples of the run to check against: five seconds at 10 ms."""


def write_c(subject: Subject, folder: Path) -> Exported:
    """Write ``IDENTIFIER.h`` and ``IDENTIFIER.c``."""
    return Exported(write_texts(folder, c_sources(subject, subject.realisation())))


def c_sources(subject: Subject, realisation: Realisation, *, flow: bool = False) -> dict[str, str]:
    """Header and source by file name; with `flow` the rates for an integrator with steps of its own are in it."""
    fields = model_fields(subject, realisation)
    fields["functions"] = [
        c_function(name, graph, SCALARS) for name, graph in realisation.functions.items() if flow or name != "flow"
    ]
    return {
        f"{subject.identifier}.h": render("model.h.j2", fields),
        f"{subject.identifier}.c": render("model.c.j2", fields),
    }


def model_fields(subject: Subject, realisation: Realisation) -> dict[str, Any]:
    """Fields of the templates, except the functions."""
    validity = subject.validity
    spans = {"Q": validity.q, "QDOT": validity.qdot, **{f"V{i}": span for i, span in enumerate(validity.v, start=1)}}
    return {
        "title": f"Dynamic model of the joint {subject.prototype}",
        "version": program_version(),
        "subject": subject,
        "realisation": realisation,
        "validity": validity,
        "unit": validity.q_unit,
        "id": subject.identifier,
        "ID": subject.identifier.upper(),
        "step": constant(realisation.step),
        "constant": constant,
        "bounds": bounds(subject),
        "ranges": [
            pair for name, (low, high) in spans.items() for pair in ((f"{name}_MIN", low), (f"{name}_MAX", high))
        ],
        "k": realisation.inputs,
        "n": len(realisation.states),
        "base": realisation.base,
        "lagged": "lag" in realisation.functions,
        "held": realisation.held,
        "method": {"nodes": NODES, "ahead": AHEAD, "shares": SHARES, "all": ALL_SHARES},
    }


def bounds(subject: Subject) -> list[str]:
    """The validity range in words."""
    v = subject.validity
    return [
        f"q from {v.q[0]:.6g} to {v.q[1]:.6g} {v.q_unit}",
        f"its velocity from {v.qdot[0]:.4g} to {v.qdot[1]:.4g} {v.q_unit}/s",
        *(
            f"v{i} from {low:.6g} to {high:.6g} {unit}"
            for i, ((low, high), unit) in enumerate(zip(v.v, v.v_units, strict=True), start=1)
        ),
        f"samples every {v.sample_interval:g} s",
    ]


def write_matlab(subject: Subject, folder: Path) -> Exported:
    """Write ``IDENTIFIER.m`` and ``IDENTIFIER_data.mat``.

    The MAT file holds breakpoints and tables for Simulink's 1-D Lookup Table blocks under the names `q_bp`, `F_table`,
    `d_table`, …. It also has the structs `units` and `validity`, and in `check` a log with the model's own run.
    """
    from scipy.io import savemat

    script = folder / f"{subject.identifier}.m"
    data = folder / f"{subject.identifier}_data.mat"
    write_text(script, function_source(subject))
    buffer = io.BytesIO()
    savemat(buffer, variables(subject), long_field_names=True, oned_as="row")  # type: ignore[arg-type]  # takes streams
    # The header of a MAT file begins with a text. SciPy writes the time into it; the same model shall give equal files.
    title = f"debist {program_version()}, {subject.identifier}".encode("ascii", "replace")
    header = title[:_DESCRIPTION_BYTES].ljust(_DESCRIPTION_BYTES)
    write_bytes(data, header + buffer.getvalue()[_DESCRIPTION_BYTES:])
    return Exported([script, data])


def function_source(subject: Subject) -> str:
    """The function that runs the model freely."""
    realisation = subject.realisation()
    return render(
        "model.m.j2",
        model_fields(subject, realisation)
        | {
            "functions": [
                matlab_function(name, graph, SCALARS) for name, graph in realisation.functions.items() if name != "flow"
            ],
            "z": max(1, len(realisation.hysteresis_states)),
        },
    )


def variables(subject: Subject) -> dict[str, Any]:
    """Variables of the MAT file, all in SI."""
    v = subject.validity
    run = subject.model.simulate(subject.t, subject.v, *subject.start)
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
        arrays["q_bp"] = table["q"][None, :]
        arrays[f"{table['name']}_table"] = table["values"][None, :]
        units[f"{table['name']}_table"] = table["unit"].replace("·", ".")
    if "q_bp" in arrays:
        arrays["mass"] = float(getattr(subject.model, "mass_kg", 1.0))
        units["mass"] = MASS[v.q_unit].replace("·", ".").replace("²", "2")
    return arrays | {"units": units, "source": f"{subject.prototype}, {subject.name}, {subject.origin}"}


def write_json(subject: Subject, folder: Path) -> Exported:
    """Write ``IDENTIFIER.json``."""
    target = folder / f"{subject.identifier}.json"
    write_text(target, json.dumps(document(subject), indent=1, ensure_ascii=False, allow_nan=False) + "\n")
    return Exported([target])


def document(subject: Subject) -> dict[str, Any]:
    """The document; every number in SI, units beside the numbers or in the keys."""
    t = subject.t[:CHECK_SAMPLES]
    v = subject.v[:CHECK_SAMPLES]
    run = subject.model.simulate(t, v, *subject.start)
    facts: dict[str, Any] = to_json(
        {
            "format": FORMAT,
            "prototype": subject.prototype,
            "model": subject.name,
            "origin": {"content": subject.origin, "debist": program_version()},
            "validity": vars(subject.validity),
            "description": subject.model.describe(),
            "equations": _equations(subject),
            "curves": curve_tables(subject),
            "check": {
                "t_s": t,
                "v": v,
                "q0": subject.start[0],
                "qdot0": subject.start[1],
                "q": run.q,
                "status": run.status,
            },
        }
    )
    return facts


def _equations(subject: Subject) -> dict[str, Any] | None:
    """States, constants and integration; none for a model whose equations cannot be written down elsewhere."""
    try:
        realisation = subject.realisation()
    except InputError:
        return None
    return {
        "structure": realisation.structure,
        "states": [vars(state) for state in realisation.states],
        "hysteresis_states": [vars(state) for state in realisation.hysteresis_states],
        "constants_si": realisation.constants,
        "integration": {
            "scheme": "classical Runge-Kutta, fixed step",
            "step_s": realisation.step,
            "inputs_between_samples": _BETWEEN[realisation.between],
            "delay_s": realisation.delay,
        },
    }
