"""A run as a Process Run Crate: settings, raw logs, artifacts, versions and hashes in one RO-Crate.

The crate holds all that another machine needs to check the run and to repeat it:

    NAME.toml          the settings, with paths into the crate
    inputs/            raw logs, parameter set, measured curves
    environment.txt    interpreter, platform, and the version of every package that the run was made with
    run/               the run folder
    ro-crate-metadata.json

https://w3id.org/ro/wfrun/process/0.5, on RO-Crate 1.1.
"""

import hashlib
import io
import json
import mimetypes
import shutil
import tempfile
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from pipeline.runs.atomic import atomic_path
from pipeline.runs.hashing import file_sha256
from pipeline.runs.manifest import MANIFEST, Manifest, stage_file
from pipeline.runs.run_folder import RunFolder

PROFILE = "https://w3id.org/ro/wfrun/process/0.5"
_TERMS = {"contentHash": "urn:debist:content-hash"}
_FORMATS = {".parquet": "application/vnd.apache.parquet", ".h5": "application/x-hdf5", ".toml": "application/toml"}
NAME = "environment.txt"


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
    environments : mapping of str to str
        File names of the environments of the run by their keys.
    """

    name: str
    settings: str
    inputs: Mapping[str, Path]
    environments: Mapping[str, str]


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
    crate.root_dataset["mentions"] = _actions(crate, run, packed, made.isoformat(timespec="seconds"))
    with tempfile.TemporaryDirectory(prefix="debist-") as place, atomic_path(target) as temporary:
        zipped = Path(place) / "crate.zip"  # write_zip adds that ending to names without it
        crate.write_zip(zipped)
        shutil.copyfile(zipped, temporary)


def _conform(crate: Any) -> None:
    from rocrate.model.contextentity import ContextEntity

    profile = ContextEntity(
        crate, PROFILE, {"@type": "CreativeWork", "name": "Process Run Crate", "version": PROFILE.rsplit("/", 1)[1]}
    )
    crate.root_dataset["conformsTo"] = [crate.add(profile)]


def _actions(crate: Any, run: RunFolder, packed: Packed, ended: str) -> list[Any]:
    """What was executed: one action, or one for each environment that some of the artifacts were made in."""
    objects, results, actions = _inputs(crate, packed), _results(crate, run), list[Any]()
    for number, key in enumerate(sorted(results, key=[*packed.environments, ""].index), 1):
        suffix = "" if number == 1 else f"-{number}"
        recorded = [_environment(crate, run, packed, key)] if key else []
        action = crate.add_action(
            _software(crate, _versions(run.manifest, key), suffix),
            identifier=f"#run{suffix}",
            object=objects + recorded,
            result=results[key],
            properties={
                "name": f"debist run {packed.name}",
                "description": f"debist run {packed.name}.toml -o run",
                "endTime": ended,
                "actionStatus": "http://schema.org/CompletedActionStatus",
            },
        )
        actions.append(action)
    return actions


def _versions(manifest: Manifest, key: str) -> Mapping[str, str]:
    """Versions of what moves digits, in an environment; those of the last write where none was recorded."""
    packages = manifest.environments.get(key, {}).get("packages", {})
    return {name: packages.get(name, last) for name, last in manifest.versions.items()}


def _software(crate: Any, versions: Mapping[str, str], suffix: str) -> Any:
    from rocrate.model.contextentity import ContextEntity

    entities = {
        name: crate.add(
            ContextEntity(
                crate, f"#{name}{suffix}", {"@type": "SoftwareApplication", "name": name, "softwareVersion": number}
            )
        )
        for name, number in versions.items()
    }
    debist = entities.pop("debist")
    debist["softwareRequirements"] = list(entities.values())
    return debist


def _inputs(crate: Any, packed: Packed) -> list[Any]:
    settings = _add_text(crate, f"{packed.name}.toml", packed.settings, "Settings")
    return [settings] + [
        _add_file(crate, source, name, {"name": f"Input {source.name}"}) for name, source in packed.inputs.items()
    ]


def _environment(crate: Any, run: RunFolder, packed: Packed, key: str) -> Any:
    text = environment_text(run.manifest.environments[key])
    return _add_text(crate, packed.environments[key], text, "Versions of interpreter and packages")


def _results(crate: Any, run: RunFolder) -> Mapping[str, list[Any]]:
    """The artifacts by the environment that made them; the manifest is a result of each."""
    results: dict[str, list[Any]] = {}
    for name, record in sorted(run.manifest.artifacts.items()):
        properties = {"name": f"{record.recipe.stage}: {name}", "contentHash": record.content_hash}
        results.setdefault(record.environment, []).append(
            _add_file(crate, run.checked(name), f"run/{name}", properties)
        )
    about = {MANIFEST: "Recipes and hashes of all artifacts"}
    stages = [stage for stage in run.manifest.stages if not run.stage_problem(stage)]
    about |= {stage_file(stage): f"Content hashes of the stage {stage}" for stage in stages}
    lists = [_add_file(crate, run.path(name), f"run/{name}", {"name": title}) for name, title in about.items()]
    return {key: [*lists, *made] for key, made in results.items()}


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


def environment_files(manifest: Manifest) -> dict[str, str]:
    """File names of the recorded environments by key: ``environment.txt`` is the one that made the most artifacts."""
    made = Counter(record.environment for record in manifest.artifacts.values())
    order = sorted(manifest.environments, key=lambda key: (-made[key], key))
    return {key: NAME if n == 1 else f"environment-{n}.txt" for n, key in enumerate(order, 1)}


def environment_text(described: Mapping[str, Any]) -> str:
    """One ``name==version`` for each installed package, in the form that pip reads; the rest as comments."""
    packages = dict(described["packages"])
    head = [
        f"# {described['interpreter']} on {described['platform']}",
        f"# debist {packages.pop('debist', 'of unknown version')}: install it from its repository",
    ]
    return "\n".join([*head, *(f"{name}=={number}" for name, number in sorted(packages.items()))]) + "\n"


def toml_text(document: Mapping[str, Any]) -> str:
    """Settings as TOML; keys without a value (None) are left out.

    Parameters
    ----------
    document : mapping
        JSON values. Sub-mappings become tables, mappings within those inline tables.
    """
    lines = [f"{key} = {_toml(value)}" for key, value in document.items() if not isinstance(value, Mapping | None)]
    for key, value in document.items():
        if isinstance(value, Mapping) and any(entry is not None for entry in value.values()):
            lines += ["", f"[{key}]"]
            lines += [f"{name} = {_toml(entry)}" for name, entry in value.items() if entry is not None]
    return "\n".join(lines) + "\n"


def _toml(value: Any) -> str:
    if isinstance(value, Mapping):
        inside = ", ".join(f"{key} = {_toml(entry)}" for key, entry in value.items() if entry is not None)
        return f"{{ {inside} }}" if inside else "{}"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_toml, value))}]"
    # Texts, numbers and truth values are written alike in JSON and TOML, but for one control character.
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
