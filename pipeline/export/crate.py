"""A run as a Process Run Crate: settings, raw logs, artifacts, versions and hashes in one RO-Crate.

The crate holds all that another machine needs to check the run and to repeat it:

    NAME.toml          the settings, with paths into the crate
    inputs/            raw logs, parameter set, measured curves
    environment.txt    versions of Python and of the packages that the run was made with
    run/               the run folder
    ro-crate-metadata.json

https://w3id.org/ro/wfrun/process/0.5, on RO-Crate 1.1.
"""

import mimetypes
import re
import shutil
import tempfile
from collections.abc import Mapping
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from ..store.atomic import atomic_path
from ..store.hashing import file_sha256
from ..store.manifest import MANIFEST, stage_file
from ..store.run_folder import RunFolder

PROFILE = "https://w3id.org/ro/wfrun/process/0.5"
_FORMATS = {".parquet": "application/vnd.apache.parquet", ".h5": "application/x-hdf5", ".toml": "application/toml"}
NAME = "environment.txt"
_PIN = re.compile("[A-Za-z0-9][A-Za-z0-9._-]*==[A-Za-z0-9][A-Za-z0-9.!+_-]*")


def write_crate(
    run: RunFolder, name: str, settings: str, inputs: Mapping[str, Path], more: Mapping[str, str], target: Path
) -> None:
    """Write an intact run and what goes along as a zip file.

    Parameters
    ----------
    run : RunFolder
        The run.
    name : str
        Name of the prototype.
    settings : str
        Its settings as TOML, with paths into the crate.
    inputs : mapping of str to Path
        Files that the settings name, by their paths in the crate.
    more : mapping of str to str
        Files that are written for the crate, likewise.
    target : Path
        The zip file.
    """
    from rocrate.rocrate import ROCrate

    crate = ROCrate(gen_preview=False, version="1.1")
    crate.name = f"Run of {name}"
    crate.description = f"Models identified from the rig logs of the prototype {name} by debist"
    crate.license = "not stated by the run"
    crate.datePublished = date = datetime.fromtimestamp((run.root / MANIFEST).stat().st_mtime, UTC)
    crate.metadata.extra_contexts.append("https://w3id.org/ro/terms/workflow-run/context")
    crate.metadata.extra_terms["contentHash"] = "urn:debist:content-hash"
    crate.root_dataset["conformsTo"] = [
        _entity(crate, PROFILE, "CreativeWork", "Process Run Crate", version=PROFILE.rsplit("/", 1)[1])
    ]
    with tempfile.TemporaryDirectory(prefix="debist-") as place:
        objects, results = _files(
            crate,
            run,
            {f"{name}.toml": settings, NAME: environment_text(run.manifest.versions), **more},
            inputs,
            Path(place),
        )
        software = {
            name: _entity(crate, f"#{name}", "SoftwareApplication", name, softwareVersion=number)
            for name, number in run.manifest.versions.items()
        }
        program = software.pop("debist")
        program["softwareRequirements"] = list(software.values())  # the packages that move digits
        crate.root_dataset["mentions"] = [
            crate.add_action(
                program,
                identifier="#run",
                object=objects,
                result=results,
                properties={
                    "name": f"debist run {name}",
                    "description": f"debist run {name}.toml -o run",
                    "endTime": date.isoformat(timespec="seconds"),
                    "actionStatus": "http://schema.org/CompletedActionStatus",
                },
            )
        ]
        zipped = Path(place) / "crate.zip"  # write_zip adds that ending to names without it
        crate.write_zip(zipped)
        with atomic_path(target) as temporary:
            shutil.copyfile(zipped, temporary)


def _entity(crate: Any, key: str, kind: str, name: str, **properties: str) -> Any:
    from rocrate.model.contextentity import ContextEntity

    return crate.add(ContextEntity(crate, key, {"@type": kind, "name": name, **properties}))


def _files(
    crate: Any, run: RunFolder, texts: Mapping[str, str], inputs: Mapping[str, Path], place: Path
) -> tuple[list[Any], list[Any]]:
    """Texts, which wait in the folder `place`, and inputs; manifest and artifacts."""
    for name, text in texts.items():
        (place / name).parent.mkdir(parents=True, exist_ok=True)
        (place / name).write_text(text, encoding="utf-8", newline="\n")
    objects = [
        *(_file(crate, place / name, name, name) for name in texts),
        *(_file(crate, source, name, f"Input {source.name}") for name, source in inputs.items()),
    ]
    results = [
        _file(crate, run.root / MANIFEST, f"run/{MANIFEST}", "Recipes and hashes of all artifacts"),
        *(
            _file(
                crate,
                run.checked(name),
                f"run/{name}",
                f"{record.recipe.stage}: {name}",
                contentHash=record.content_hash,
            )
            for name, record in sorted(run.manifest.artifacts.items())
        ),
    ]
    for stage in run.manifest.stages:
        if not run.stage_problem(stage):
            name = stage_file(stage)
            results.append(_file(crate, run.path(name), f"run/{name}", f"Content hashes of the stage {stage}"))
    return objects, results


def _file(crate: Any, source: Path, name: str, title: str, **more: str) -> Any:
    return crate.add_file(
        source,
        dest_path=name,
        properties={
            "name": title,
            **more,
            "encodingFormat": _FORMATS.get(source.suffix)
            or mimetypes.guess_type(name)[0]
            or "application/octet-stream",
            "contentSize": str(source.stat().st_size),
            "sha256": file_sha256(source),
        },
    )


def environment_text(versions: Mapping[str, str]) -> str:
    """One ``name==version`` for each package, in the form that pip reads; the rest as comments."""
    pins = [f"{name}=={number}" for name, number in versions.items()]
    # An option of pip is no pin, and debist comes from its repository.
    lines = [pin if _PIN.fullmatch(pin) and not pin.startswith("debist=") else f"# {pin}" for pin in pins]
    return "\n".join("".join(c if c.isprintable() else " " for c in line) for line in lines) + "\n"
