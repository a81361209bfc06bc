"""The designed controller as C99 with the interface that test benches call, as a MATLAB function and as an FMU."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from ..codegen.graph import GraphSequence
from ..codegen.text_writer import Code, c_function, c_sequence, matlab_function, matlab_sequence
from ..control.controller import BEGIN, CONTROL, ESTIMATE, GRAPHS, OBSERVE, TABLES
from ..control.estimator import PERIOD, RAMP, STATUS
from ..control.law import CONTROLLER_STATE, SIDES, Law
from ..system.package import program_version
from .fmu import identity, packed
from .hybrid import states, stop_operators
from .subject import Exported, Variable
from .templates import asset, constant, render, write_texts

NAME = "controller"
_VARIABLES = (
    ("q", "reading of the laser; NaN if there is none", "input", "m"),
    ("target", "where the joint is to go", "input", "m"),
    ("v1", "voltage of the left membrane for this period", "output", "V"),
    ("v2", "voltage of the right membrane for this period", "output", "V"),
)
ESTIMATES = (
    Variable("displacement", "m", "displacement as the laser shows it"),
    *states()[1:],
    *stop_operators(),
    *(Variable(f"voltage_{side}", "V", f"voltage behind the converter on the {side}") for side in SIDES),
    Variable("moment", "N.m", "moment on the slope that the model does not explain"),
    Variable("status", "1", ", ".join(f"{number} {meaning}" for number, meaning in enumerate(STATUS))),
)
"""Outputs of the estimator, in this order (`pipeline.control.estimator.known_state`)."""


def write_controller(
    folder: Path,
    law: Law,
    lags: Sequence[float],
    places: tuple[float, float, float],
    *,
    prototype: str,
    model: str,
    origin: str,
) -> Exported:
    """Write ``controller.h``, ``.c``, ``.m`` and ``.fmu``.

    Parameters
    ----------
    folder : Path
        Folder of the files.
    law : Law
        The controller's constants.
    lags : sequence of float
        Time constants of the left and the right converter [s] that it was designed for.
    places : (float, float, float)
        Readings [m] of the left well, the unstable equilibrium and the right well.
    prototype, model, origin : str
        Names of prototype and model, content hash of the artifact that holds the model.
    """
    left, saddle, right = places
    low, high = (q + law.number("offset") for q in law.places)
    highest = law.number("highest")
    fields = {
        "version": program_version(),
        "prototype": prototype,
        "model": model,
        "origin": origin,
        "highest": highest,
        "lags": lags,
        "low": low,
        "high": high,
        "left": left,
        "saddle": saddle,
        "right": right,
        "start": float(left),
        "ramp_ms": round(1e3 * PERIOD * max(RAMP, highest / law.number("slew"))),
        "slew": law.number("slew") / PERIOD if law.number("slew") < highest else None,
        "average": law.number("allowed") if law.number("allowed") < highest else None,
        "name": NAME,
        "tables": {"e": law.numbers} | {table: getattr(law, table).ravel() for table in TABLES},
        "size": CONTROLLER_STATE,
        "estimates": ESTIMATES,
        "period": constant(PERIOD),
    }
    whole = fields | _functions("law_", c_function, c_sequence)
    sources = {f"{NAME}.h": render("controller.h.j2", whole), f"{NAME}.c": render("controller.c.j2", whole)}
    written = write_texts(
        folder,
        sources | {f"{NAME}.m": render("controller.m.j2", fields | _functions("c.", matlab_function, matlab_sequence))},
    )
    more = {
        "guid": identity(prototype, model, origin, sources[f"{NAME}.c"]),
        "variables": [
            *_VARIABLES,
            *((e.name, f"estimate for the next period: {e.meaning}", "output", e.unit) for e in ESTIMATES),
        ],
        "title": f"Controller of the joint {prototype}",
    }
    files = {name: asset(name) for name in ("fmi2.h", "fmu_common.h")}
    files["fmu.c"] = render("controller_fmu.c.j2", fields | more)
    unit = packed(sources | files, render("controllerDescription.xml.j2", fields | more), NAME, folder)
    return Exported([*written, *unit.written], unit.notes)


def _functions(
    law: str, of_graph: Callable[..., Code], of_sequence: Callable[[str, GraphSequence], Code]
) -> dict[str, Any]:
    """The functions in a language, and the numbers and tables of the law that they take, named behind `law`."""
    sequences = {"begin_control": BEGIN, "control": CONTROL, "observe": OBSERVE, "estimated": ESTIMATE}
    return {
        "begins": f"{law}e, {law}rests",
        "constants": ", ".join(law + table for table in ("e", *TABLES)),
        "observes": ", ".join(law + table for table in OBSERVE.given[3:]),
        "functions": [
            *(of_graph(name, graph, frozenset()) for name, graph in GRAPHS.items()),
            *(of_sequence(name, sequence) for name, sequence in sequences.items()),
        ],
    }
