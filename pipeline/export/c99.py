"""The model as one C99 source and its header, for a real-time target."""

from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

from jinja2 import Environment, PackageLoader, StrictUndefined

from pipeline import __version__
from pipeline.export.c_text import constants_text, function_text
from pipeline.export.kernel_reader import Record
from pipeline.export.program import Array, Program
from pipeline.export.realisation import Realisation
from pipeline.export.realise import realise
from pipeline.export.subject import Exported, Subject
from pipeline.export.translate import Translator
from pipeline.runs.atomic import write_text


def write_c(subject: Subject, folder: Path) -> Exported:
    """Write ``IDENTIFIER.h`` and ``IDENTIFIER.c``."""
    realisation = realise(subject.model, subject.validity.sample_interval, subject.validity.q_unit)
    written = []
    for name, text in c_sources(subject, realisation).items():
        write_text(folder / name, text)
        written.append(folder / name)
    return Exported(written)


def c_sources(subject: Subject, realisation: Realisation, *, flow: bool = False) -> dict[str, str]:
    """Header and source by file name; with `flow` the rates for an integrator with steps of its own are in it."""
    program, fields = translated(realisation, flow=flow), model_fields(subject, realisation)
    fields |= {
        "constants": constants_text(program),
        "functions": [function_text(function) for function in program.functions],
    }
    return {
        f"{subject.identifier}.h": template("model.h.j2").render(fields),
        f"{subject.identifier}.c": template("model.c.j2").render(fields),
    }


def translated(realisation: Realisation, *, flow: bool = False) -> Program:
    """The kernels of a model as a program whose functions carry the kernels' names."""
    k, n, z = realisation.inputs, len(realisation.states), max(1, len(realisation.memories))
    v, u, x, memory, base, y = (
        Array((k,)),
        Array((k,)),
        Array((n,)),
        Array((z,)),
        Array((realisation.base,)),
        Array((3,)),
    )
    c = Record(realisation.constants)
    translator, kernels = Translator(), realisation.kernels
    translator.function(kernels.drive, (v, c, u), "drive")
    translator.function(kernels.start, ("real", "real", u, c, x, memory), "start")
    translator.function(kernels.begin, (x, memory, "real", c, base), "begin")
    translator.function(kernels.rates, (x, memory, base, u, c, x), "rates")
    translator.function(kernels.finish, (base, c, x, memory), "finish")
    translator.function(kernels.read, (x, x, c, y), "read")
    translator.function(kernels.inside, (x, c), "inside")
    if kernels.lag:
        translator.function(kernels.lag, (u, u, u, "real", c, x), "lag")
    if flow:
        translator.function(kernels.flow, (x, memory, base, u, c, x), "flow")
    for function in translator.program.functions:
        if function.name in _FILLED:  # the same for every model, even where one leaves an array as it is
            function.changed = [each for each in function.parameters if each.name in _FILLED[function.name]]
    return translator.program


_FILLED = {
    "drive": ("u",),
    "start": ("x", "z"),
    "begin": ("base",),
    "rates": ("dx",),
    "finish": ("x", "z"),
    "read": ("y",),
    "flow": ("dx",),
    "lag": ("before", "within", "after", "x"),
}
"""What each kernel fills (`pipeline.export.realisation.Kernels`)."""


@cache
def _environment() -> Environment:
    made = Environment(  # noqa: S701 - source code, not HTML; attributes of XML are quoted where they are filled in
        loader=PackageLoader("pipeline.export", "assets"), undefined=StrictUndefined, keep_trailing_newline=True
    )
    made.filters["quoted"] = lambda value: quoteattr(str(value))
    return made


def template(name: str) -> Any:
    """A template of the exports."""
    return _environment().get_template(name)


def asset(name: str) -> str:
    """A file that is taken as it is."""
    return files("pipeline.export").joinpath("assets", name).read_text(encoding="utf-8")


def number(value: float) -> str:
    """A real number to the last bit."""
    return f"({float(value)!r})" if value < 0.0 else repr(float(value))


def model_fields(subject: Subject, realisation: Realisation) -> dict[str, Any]:
    """What the templates ask for, but for the program itself."""
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
        "step": number(realisation.step),
        "number": number,
        "bounds": bounds(subject),
        "ranges": ranges,
        "k": realisation.inputs,
        "n": len(realisation.states),
        "base": realisation.base,
        "lagged": realisation.kernels.lag is not None,
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
