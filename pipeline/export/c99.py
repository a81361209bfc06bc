"""The model as one C99 source and its header, for a real-time target."""

from pathlib import Path
from typing import Any

from pipeline import __version__
from pipeline.codegen.text_writer import c_function
from pipeline.export.subject import SCALARS, Exported, Realisation, Subject
from pipeline.export.templates import constant, render
from pipeline.runs.atomic import write_text
from pipeline.solvers.fixed_step import AHEAD, ALL_SHARES, NODES, SHARES


def write_c(subject: Subject, folder: Path) -> Exported:
    """Write ``IDENTIFIER.h`` and ``IDENTIFIER.c``."""
    realisation = subject.realisation()
    written = []
    for name, text in c_sources(subject, realisation).items():
        write_text(folder / name, text)
        written.append(folder / name)
    return Exported(written)


def c_sources(subject: Subject, realisation: Realisation, *, flow: bool = False) -> dict[str, str]:
    """Header and source by file name; with `flow` the rates for an integrator with steps of its own are in it."""
    fields = model_fields(subject, realisation)
    chosen = [name for name in realisation.functions if flow or name != "flow"]
    fields["functions"] = [c_function(name, realisation.functions[name], SCALARS) for name in chosen]
    return {
        f"{subject.identifier}.h": render("model.h.j2", fields),
        f"{subject.identifier}.c": render("model.c.j2", fields),
    }


def model_fields(subject: Subject, realisation: Realisation) -> dict[str, Any]:
    """Fields of the templates, except the functions."""
    validity = subject.validity
    ranges = [("Q_MIN", validity.q[0]), ("Q_MAX", validity.q[1])]
    ranges += [("QDOT_MIN", validity.qdot[0]), ("QDOT_MAX", validity.qdot[1])]
    for i, (low, high) in enumerate(validity.v, start=1):
        ranges += [(f"V{i}_MIN", low), (f"V{i}_MAX", high)]
    return {
        "title": f"Dynamic model of the joint {subject.prototype}",
        "version": __version__,
        "subject": subject,
        "realisation": realisation,
        "validity": validity,
        "unit": validity.q_unit,
        "id": subject.identifier,
        "ID": subject.identifier.upper(),
        "step": constant(realisation.step),
        "constant": constant,
        "bounds": bounds(subject),
        "ranges": ranges,
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
    lines = [f"q from {v.q[0]:.6g} to {v.q[1]:.6g} {v.q_unit}"]
    lines += [f"its velocity from {v.qdot[0]:.4g} to {v.qdot[1]:.4g} {v.q_unit}/s"]
    lines += [
        f"v{i} from {low:.6g} to {high:.6g} {unit}"
        for i, ((low, high), unit) in enumerate(zip(v.v, v.v_units, strict=True), start=1)
    ]
    return [*lines, f"samples every {v.sample_interval:g} s"]
