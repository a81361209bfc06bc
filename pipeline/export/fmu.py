"""The model as an FMU (FMI 2.0): model exchange and co-simulation, C source and, with a compiler, a binary."""

import io
import math
import platform
import shutil
import subprocess
import tempfile
import uuid
import zipfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..store.atomic import write_bytes
from ..system.package import program_version
from .sources import bounds, c_sources, model_fields
from .subject import Exported, Realisation, Subject
from .templates import asset, render

_NAMESPACE = uuid.UUID("6b1d7c4e-5f0e-5e6e-9a59-6d0f3b7a9c11")
_EPOCH = (1980, 1, 1, 0, 0, 0)
"""Time of all files in the archive."""
FLAGS = ("-std=c99", "-O2", "-ffp-contract=off")
"""Flags of every compiler; without contraction the digits are those of debist on any processor."""
_COMPILING = 120.0
"""Seconds after which a compiler is given up; it takes two."""


@dataclass(frozen=True)
class Compiler:
    """A compiler of a system's binaries, the ending of its libraries, and its own flags."""

    name: str
    ending: str
    flags: tuple[str, ...]


COMPILERS = {
    "linux64": Compiler("gcc", ".so", ("-fPIC", "-fvisibility=hidden")),
    "win64": Compiler("x86_64-w64-mingw32-gcc", ".dll", ("-static-libgcc", "-Wl,--no-insert-timestamp")),
}
"""Platforms by the folder of FMI 2.0."""


def write_fmu(subject: Subject, folder: Path) -> Exported:
    """Write ``IDENTIFIER.fmu``; equal models give equal bytes with the same compiler.

    Notes
    -----
    Binaries are those of the compilers that are here: `gcc` on Linux, x86-64, and MinGW's for Windows. The notes say
    what the FMU lacks.
    """
    realisation = subject.realisation()
    return packed(
        fmu_sources(subject, realisation), description(subject, realisation, guid(subject)), subject.identifier, folder
    )


def packed(sources: dict[str, str], description: str, identifier: str, folder: Path) -> Exported:
    """Write ``IDENTIFIER.fmu`` of C sources, which ``fmu.c`` includes, and the model description.

    Parameters
    ----------
    sources : dict of str to str
        C files by name, ``fmu.c`` among them.
    description : str
        ``modelDescription.xml``.
    identifier : str
        Name of the FMU and of its functions.
    folder : Path
        Path of the output.
    """
    files = {f"sources/{name}": text.encode() for name, text in sources.items()}
    files["modelDescription.xml"] = description.encode()
    binaries = _compiled(sources, identifier)
    notes = [
        f"the FMU holds C source only for {system}: no working {compiler.name} here; import it where sources are "
        f"compiled, or export it where there is one"
        for system, compiler in COMPILERS.items()
        if system not in binaries
    ]
    files |= {f"binaries/{system}/{identifier}{COMPILERS[system].ending}": code for system, code in binaries.items()}
    target = folder / f"{identifier}.fmu"
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(files):
            archive.writestr(zipfile.ZipInfo(name, _EPOCH), files[name], zipfile.ZIP_DEFLATED)
    write_bytes(target, buffer.getvalue())
    return Exported([target], notes)


def fmu_sources(subject: Subject, realisation: Realisation) -> dict[str, str]:
    """The C files of the FMU; ``fmu.c`` includes the others."""
    flow = "flow" if "flow" in realisation.functions else "rates"
    return {
        **c_sources(subject, realisation, flow=flow == "flow"),
        "fmi2.h": asset("fmi2.h"),
        "fmu_common.h": asset("fmu_common.h"),
        "fmu.c": render(
            "fmu.c.j2",
            model_fields(subject, realisation)
            | {
                "guid": guid(subject),
                "flow": flow,
                "facts": facts(subject, realisation),
            },
        ),
    }


def guid(subject: Subject) -> str:
    """Identity of the FMU: the model's content and the version that wrote it."""
    return identity(subject.prototype, subject.name, subject.origin)


def identity(*content: str) -> str:
    """A GUID of the parts of an FMU and the version that wrote it."""
    return f"{{{uuid.uuid5(_NAMESPACE, '/'.join((program_version(), *content)))}}}"


def _compiled(sources: dict[str, str], identifier: str) -> dict[str, bytes]:
    """The binary for each system that a compiler here makes code for."""
    here = (platform.system(), platform.machine()) == ("Linux", "x86_64")
    with tempfile.TemporaryDirectory() as place:
        for name, text in sources.items():
            (Path(place) / name).write_text(text, encoding="utf-8", newline="\n")
        made = {
            system: _library(Path(place), identifier, compiler)
            for system, compiler in COMPILERS.items()
            if here or system == "win64"
        }
    return {system: code for system, code in made.items() if code is not None}


def _library(place: Path, identifier: str, compiler: "Compiler") -> bytes | None:
    """``fmu.c`` of a folder as a library; None without a compiler, or where it fails."""
    program = shutil.which(compiler.name)
    library = place / f"{identifier}{compiler.ending}"
    if program is None:
        return None
    words = [program, *FLAGS, *compiler.flags, "-shared", "fmu.c", "-o", library.name, "-lm"]
    try:
        subprocess.run(words, cwd=place, capture_output=True, check=True, timeout=_COMPILING)
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
        return None
    return library.read_bytes()


_BASE_UNITS: dict[str, dict[str, int]] = {
    "1": {},
    "m": {"m": 1},
    "m/s": {"m": 1, "s": -1},
    "m/s2": {"m": 1, "s": -2},
    "rad": {"rad": 1},
    "rad/s": {"rad": 1, "s": -1},
    "rad/s2": {"rad": 1, "s": -2},
    "s": {"s": 1},
    "1/s": {"s": -1},
    "1/s2": {"s": -2},
    "V": {"kg": 1, "m": 2, "s": -3, "A": -1},
    "V/s": {"kg": 1, "m": 2, "s": -4, "A": -1},
    "V/s2": {"kg": 1, "m": 2, "s": -5, "A": -1},
}


@dataclass(frozen=True)
class FmuVariable:
    """A ScalarVariable; a unit of None makes it an integer."""

    name: str
    unit: str | None
    meaning: str
    causality: str
    variability: str
    initial: str = ""
    start: float | None = None
    derivative: int = 0
    nominal: float | None = None


def facts(subject: Subject, realisation: Realisation) -> list[FmuVariable]:
    """Validity bounds, sample interval, step and delay: constants of the FMU, in this order."""
    v = subject.validity
    spans = [("q", "displacement of", v.q, v.q_unit)]
    spans += [
        (f"v{i}", f"value of input {i} in", *of) for i, of in enumerate(zip(v.v, v.v_units, strict=True), start=1)
    ]
    return [
        *(
            _constant(f"{name}_{end}", bound, unit, f"{word} {meaning} the training logs")
            for name, meaning, span, unit in spans
            for end, word, bound in zip(("min", "max"), ("least", "largest"), span, strict=True)
        ),
        _constant(
            "sample_interval", v.sample_interval, "s", "interval of the samples on which the model was identified"
        ),
        _constant("longest_step", realisation.step, "s", "longest internal step of co-simulation"),
        _constant("delay", realisation.delay, "s", "outputs belong to a time this much later than the voltages"),
    ]


def _constant(name: str, value: float, unit: str, meaning: str) -> FmuVariable:
    return FmuVariable(name, unit, meaning, "local", "constant", "exact", start=value)


def variables(subject: Subject, realisation: Realisation) -> list[FmuVariable]:
    """All variables; their positions are the value references of the source."""
    unit = subject.validity.q_unit
    declared = [
        *(
            FmuVariable(f"v{i}", symbol, f"input {i}, as measured", "input", "continuous", start=0.0)
            for i, symbol in enumerate(subject.validity.v_units, start=1)
        ),
        FmuVariable("q", unit, "displacement of the joint, positive to the right", "output", "continuous"),
        FmuVariable("qdot", f"{unit}/s", "its velocity", "output", "continuous"),
        FmuVariable("qddot", f"{unit}/s2", "its acceleration", "output", "continuous"),
        FmuVariable("check", None, "0, or 1 (q) + 2 (a voltage) beyond the training range", "output", "discrete"),
        *(
            FmuVariable(name, symbol, meaning, "parameter", "fixed", "exact", start=start)
            for name, symbol, meaning, start in (
                ("q_start", unit, "displacement at the start, after a long rest there", subject.start[0]),
                ("qdot_start", f"{unit}/s", "velocity at the start", subject.start[1]),
            )
        ),
    ]
    states = [
        FmuVariable(x.name, x.unit, x.meaning, "local", "continuous", "calculated", nominal=x.nominal)
        for x in realisation.states
    ]
    units = [x.unit.replace("/s", "/s2") if "/s" in x.unit else f"{x.unit}/s" for x in realisation.states]
    rates = [
        FmuVariable(f"der({x.name})", unit, "", "local", "continuous", "calculated", derivative=derivative)
        for derivative, (x, unit) in enumerate(zip(realisation.states, units, strict=True), start=len(declared) + 1)
    ]
    return [*declared, *states, *rates, *facts(subject, realisation)]


def description(subject: Subject, realisation: Realisation, guid: str) -> str:
    """``modelDescription.xml``."""
    declared = variables(subject, realisation)
    places = {fact.name: i for i, fact in enumerate(declared, start=1)}
    outputs = [places[fact.name] for fact in declared if fact.causality == "output"]
    derivatives = [places[fact.name] for fact in declared if fact.derivative]
    fields: dict[str, Any] = model_fields(subject, realisation) | {
        "guid": guid,
        "description": f"{realisation.structure}. Training range: {'; '.join(bounds(subject))}.",
        "variables": declared,
        "units": [(name, _BASE_UNITS.get(name)) for name in sorted({fact.unit for fact in declared if fact.unit})],
        "stop": math.ceil(float(subject.t[-1] - subject.t[0])),
        "outputs": outputs,
        "derivatives": derivatives,
        "initial": sorted([*outputs, *(places[x.name] for x in realisation.states), *derivatives]),
    }
    return render("modelDescription.xml.j2", fields)
