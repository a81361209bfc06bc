"""The designed controller as one C99 source and its header, with the interface that test benches call."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pipeline import __version__
from pipeline.codegen.text_writer import c_function
from pipeline.control.law import CONTROLLER_STATE, RAMP, Law, begin_control, control
from pipeline.control.observer import PERIOD
from pipeline.export.c99 import number, template
from pipeline.export.kernels.c_text import constants_text, function_text
from pipeline.export.kernels.kernel_reader import Record
from pipeline.export.kernels.program import Array, Operation, Program, expressions
from pipeline.export.kernels.translate import Translator
from pipeline.export.subject import Exported
from pipeline.generated.condensed_joint import INERTIA, RATES, SHAPE
from pipeline.joint.condensed_kernels import joint_rates, mass_matrix, shape_forces
from pipeline.runs.atomic import write_text


@dataclass(frozen=True)
class ControllerSubject:
    """A controller and what is said of it.

    Attributes
    ----------
    prototype, model, origin : str
        Names of prototype and model, content hash of the artifact that holds the model.
    law : Law
        The controller's constants.
    lag : float
        Time constant of the converters [s] that it was designed for.
    places : (float, float, float)
        Readings [m] of the left well, the unstable equilibrium and the right well.
    """

    prototype: str
    model: str
    origin: str
    law: Law
    lag: float
    places: tuple[float, float, float]


def write_controller(subject: ControllerSubject, folder: Path, name: str = "controller") -> Exported:
    """Write ``NAME.h`` and ``NAME.c``."""
    written = []
    for file, text in controller_sources(subject, name).items():
        write_text(folder / file, text)
        written.append(folder / file)
    return Exported(written)


def controller_sources(subject: ControllerSubject, name: str = "controller") -> dict[str, str]:
    """Header and source by file name."""
    program, law = controller_program(subject.law), subject.law
    used = [part for function in program.functions for part in expressions(function.body)]
    left, saddle, right = subject.places
    low, high = (
        law.observer.gain * q + law.observer.offset for q in (law.first, law.first + law.step * (len(law.rests) - 1))
    )
    fields: dict[str, Any] = {
        "version": __version__,
        "prototype": subject.prototype.replace("*/", "* /"),
        "model": subject.model,
        "origin": subject.origin,
        "law": law,
        "lag": subject.lag,
        "low": low,
        "high": high,
        "left": left,
        "saddle": saddle,
        "right": right,
        "ramp_ms": round(1e3 * RAMP * PERIOD),
        "name": name,
        "constants": constants_text(program),
        "functions": [
            *(c_function(each, graph, frozenset()) for each, graph in program.graphs.items()),
            *(function_text(function) for function in program.functions),
        ],
        "squares": any(isinstance(part, Operation) and part.operator == "square" for part in used),
        "size": CONTROLLER_STATE,
        "period": number(PERIOD),
    }
    return {
        f"{name}.h": template("controller.h.j2").render(fields),
        f"{name}.c": template("controller.c.j2").render(fields),
    }


def controller_program(law: Law) -> Program:
    """The kernels of a controller as a program."""
    c, state, v = Record(law), Array((CONTROLLER_STATE,)), Array((2,))
    translator = Translator({joint_rates: RATES, shape_forces: SHAPE, mass_matrix: INERTIA})
    translator.function(begin_control, ("real", c, state), "begin_control")
    translator.function(control, (state, "real", "real", c, v), "control")
    return translator.program
