"""The model as an FMU (FMI 2.0): model exchange and co-simulation, C source and, with a compiler, a binary."""

import io
import platform
import shutil
import subprocess
import tempfile
import uuid
import zipfile
from pathlib import Path

from pipeline import __version__
from pipeline.export.c99 import asset, c_sources, model_fields, template
from pipeline.export.fmu_description import description, facts
from pipeline.export.realisation import Realisation, realise
from pipeline.export.subject import Exported, Subject
from pipeline.runs.atomic import write_bytes

_NAMESPACE = uuid.UUID("6b1d7c4e-5f0e-5e6e-9a59-6d0f3b7a9c11")
_EPOCH = (1980, 1, 1, 0, 0, 0)
FLAGS = (
    "-std=c99",
    "-O2",
    "-ffp-contract=off",
    "-fPIC",
    "-fvisibility=hidden",
)
"""Of the compiler; without contraction the digits are those of debist on any processor."""


def write_fmu(subject: Subject, folder: Path) -> Exported:
    """Write ``IDENTIFIER.fmu``; equal models give equal bytes with the same compiler.

    Notes
    -----
    Without `gcc` on Linux, x86-64, the FMU holds its source only, and the notes say so.
    """
    realisation = realise(subject.model, subject.validity.sample_interval, subject.validity.q_unit)
    sources = fmu_sources(subject, realisation)
    return packed(sources, description(subject, realisation, guid(subject)), subject.identifier, folder)


def packed(sources: dict[str, str], description: str, identifier: str, folder: Path) -> Exported:
    """Write ``IDENTIFIER.fmu`` of C sources, which ``fmu.c`` includes, and the model description."""
    files = {f"sources/{name}": text.encode() for name, text in sources.items()}
    files["modelDescription.xml"] = description.encode()
    binary = _compiled(sources, identifier)
    notes = []
    if binary is None:
        notes.append(
            "the FMU holds C source only: no working gcc for Linux on x86-64 here; import it where sources are "
            "compiled, or export it on a machine with gcc"
        )
    else:
        files[f"binaries/linux64/{identifier}.so"] = binary
    target = folder / f"{identifier}.fmu"
    write_bytes(target, _zipped(files))
    return Exported([target], notes)


def fmu_sources(subject: Subject, realisation: Realisation) -> dict[str, str]:
    """The C files of the FMU; ``fmu.c`` includes the others."""
    flow = "flow" if "flow" in realisation.functions else "rates"
    fields = model_fields(subject, realisation) | {
        "guid": guid(subject),
        "flow": flow,
        "facts": facts(subject, realisation),
    }
    return {
        **c_sources(subject, realisation, flow=flow == "flow"),
        "fmi2.h": asset("fmi2.h"),
        "fmu_common.h": asset("fmu_common.h"),
        "fmu.c": template("fmu.c.j2").render(fields),
    }


def guid(subject: Subject) -> str:
    """Identity of the FMU: the model's content and the version that wrote it."""
    return identity(subject.prototype, subject.name, subject.origin)


def identity(*content: str) -> str:
    """A GUID of what an FMU is made of and the version that wrote it."""
    return f"{{{uuid.uuid5(_NAMESPACE, '/'.join((__version__, *content)))}}}"


def _compiled(sources: dict[str, str], identifier: str) -> bytes | None:
    compiler = shutil.which("gcc")
    if compiler is None or (platform.system(), platform.machine()) != ("Linux", "x86_64"):
        return None
    with tempfile.TemporaryDirectory() as place:
        for name, text in sources.items():
            (Path(place) / name).write_text(text, encoding="utf-8")
        library = f"{identifier}.so"
        done = subprocess.run(
            [compiler, *FLAGS, "-shared", "fmu.c", "-o", library, "-lm"], cwd=place, capture_output=True
        )
        if done.returncode:
            return None
        return (Path(place) / library).read_bytes()


def _zipped(files: dict[str, bytes]) -> bytes:
    """A ZIP archive without times."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(files):
            archive.writestr(zipfile.ZipInfo(name, _EPOCH), files[name], zipfile.ZIP_DEFLATED)
    return buffer.getvalue()
