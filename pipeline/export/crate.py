"""A run as a Process Run Crate: settings, raw logs, artifacts, versions and hashes in one RO-Crate.

The crate holds all that another machine needs to check the run and to repeat it:

    NAME.toml          the settings, with paths into the crate
    inputs/            raw logs and parameter set
    environment.txt    interpreter, platform, and the version of every package
    run/               the run folder
    ro-crate-metadata.json

https://w3id.org/ro/wfrun/process/0.5, on RO-Crate 1.1.
"""

import hashlib
import io
import mimetypes
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from pipeline.artifacts.atomic import atomic_path
from pipeline.artifacts.hashing import file_sha256
from pipeline.artifacts.manifest import MANIFEST
from pipeline.artifacts.run_folder import RunFolder

PROFILE = "https://w3id.org/ro/wfrun/process/0.5"
_TERMS = {"contentHash": "urn:debist:content-hash"}
_FORMATS = {".parquet": "application/vnd.apache.parquet", ".h5": "application/x-hdf5", ".toml": "application/toml"}


@dataclass(frozen=True)
class Packed:
    """What goes into a crate beside the run.

    Attributes
    ----------
    name : str
        Name of the prototype.
    settings : str
        Its settings as TOML, with paths into the crate.
    inputs : mapping of str to Path
        Files that the settings name, by their paths in the crate.
    environment : str
        Versions of interpreter and packages.
    """

    name: str
    settings: str
    inputs: Mapping[str, Path]
    environment: str


def write_crate(run: RunFolder, packed: Packed, target: Path) -> None:
    """Write the crate as a zip file.

    Parameters
    ----------
    run : RunFolder
        Intact.
    packed : Packed
        What goes along.
    target : Path
        The zip file.
    """
    from rocrate.rocrate import ROCrate

    crate = ROCrate(gen_preview=False, version="1.1")
    made = datetime.fromtimestamp((run.root / MANIFEST).stat().st_mtime, UTC)
    crate.name = f"Run of {packed.name}"
    crate.description = f"Models identified from the rig logs of the prototype {packed.name} by debist"
    crate.license = "not stated by the run"
    crate.datePublished = made
    crate.metadata.extra_contexts.append("https://w3id.org/ro/terms/workflow-run/context")
    crate.metadata.extra_terms.update(_TERMS)
    _conform(crate)
    objects = _inputs(crate, packed)
    results = _results(crate, run)
    action = crate.add_action(
        _software(crate, run.manifest.versions),
        identifier="#run",
        object=objects,
        result=results,
        properties={
            "name": f"debist run {packed.name}",
            "description": f"debist run {packed.name}.toml -o run",
            "endTime": made.isoformat(timespec="seconds"),
            "actionStatus": "http://schema.org/CompletedActionStatus",
        },
    )
    crate.root_dataset["mentions"] = [action]
    with atomic_path(target) as temporary:
        # write_zip adds the ending .zip to names without it
        zipped = temporary.with_name(f"{temporary.name}.zip")
        try:
            crate.write_zip(zipped)
            zipped.replace(temporary)
        finally:
            zipped.unlink(missing_ok=True)


def _conform(crate: Any) -> None:
    from rocrate.model.contextentity import ContextEntity

    profile = ContextEntity(
        crate, PROFILE, {"@type": "CreativeWork", "name": "Process Run Crate", "version": PROFILE.rsplit("/", 1)[1]}
    )
    crate.root_dataset["conformsTo"] = [crate.add(profile)]


def _software(crate: Any, versions: Mapping[str, str]) -> Any:
    from rocrate.model.contextentity import ContextEntity

    entities = {
        name: crate.add(
            ContextEntity(crate, f"#{name}", {"@type": "SoftwareApplication", "name": name, "softwareVersion": number})
        )
        for name, number in versions.items()
    }
    debist = entities.pop("debist")
    debist["softwareRequirements"] = list(entities.values())
    return debist


def _inputs(crate: Any, packed: Packed) -> list[Any]:
    texts = {f"{packed.name}.toml": packed.settings, "environment.txt": packed.environment}
    described = {f"{packed.name}.toml": "Settings", "environment.txt": "Versions of interpreter and packages"}
    added = [_add_text(crate, name, text, described[name]) for name, text in texts.items()]
    return added + [
        _add_file(crate, source, name, {"name": f"Input {source.name}"}) for name, source in packed.inputs.items()
    ]


def _results(crate: Any, run: RunFolder) -> Sequence[Any]:
    results = [
        _add_file(crate, run.root / MANIFEST, f"run/{MANIFEST}", {"name": "Recipes and hashes of all artifacts"})
    ]
    for name, record in sorted(run.manifest.artifacts.items()):
        properties = {"name": f"{record.recipe.stage}: {name}", "contentHash": record.content_hash}
        results.append(_add_file(crate, run.checked(name), f"run/{name}", properties))
    return results


def _add_file(crate: Any, source: Path, name: str, properties: Mapping[str, str]) -> Any:
    more = {
        "encodingFormat": _FORMATS.get(source.suffix) or mimetypes.guess_type(name)[0] or "application/octet-stream",
        "contentSize": str(source.stat().st_size),
        "sha256": file_sha256(source),
    }
    return crate.add_file(source, dest_path=name, properties={**properties, **more})


def _add_text(crate: Any, name: str, text: str, description: str) -> Any:
    content = text.encode()
    properties = {
        "name": description,
        "encodingFormat": _FORMATS.get(Path(name).suffix, "text/plain"),
        "contentSize": str(len(content)),
        "sha256": hashlib.sha256(content).hexdigest(),
    }
    return crate.add_file(io.StringIO(text), dest_path=name, properties=properties)
