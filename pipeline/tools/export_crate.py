"""Export of a whole run: a crate that another machine can check and repeat."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pipeline.errors import InputError
from pipeline.runs import layout
from pipeline.runs.hashing import file_sha256
from pipeline.runs.run_folder import RunFolder
from pipeline.settings import ROLES, Prototype

if TYPE_CHECKING:
    from pipeline.export.subject import Exported

_MOST_NAMED = 3


def export_crate(run: RunFolder, prototype: Prototype, folder: Path) -> "Exported":
    """Write the run with its inputs as ``NAME.crate.zip``.

    Raises
    ------
    InputError
        A raw log is gone, or is not the one that the run was made from.
    CorruptArtifactError
        An artifact does not have the bytes that were written.
    """
    from pipeline.export.crate import Packed, environment_files, toml_text, write_crate
    from pipeline.export.subject import Exported

    settings, inputs = _relocated(run, prototype)
    target = folder / f"{prototype.folder}.crate.zip"
    environments = environment_files(run.manifest)
    write_crate(run, Packed(prototype.folder, toml_text(settings), inputs, environments), target)
    return Exported([target], _notes(run, environments))


def _notes(run: RunFolder, environments: Mapping[str, str]) -> list[str]:
    made = {key: [n for n, r in run.manifest.artifacts.items() if r.environment == key] for key in ("", *environments)}
    unknown = made.pop("")
    notes = [f"the environment of {len(unknown)} artifacts was not recorded; a new run records it"] if unknown else []
    if len(made) > 1:
        told = "; ".join(f"{environments[key]}: {_some(names)}" for key, names in made.items())
        notes.append(f"the run was made in {len(made)} environments ({told}); a new run makes it in one")
    return notes


def _some(names: Sequence[str]) -> str:
    more = f" and {len(names) - _MOST_NAMED} more" if len(names) > _MOST_NAMED else ""
    return ", ".join(names[:_MOST_NAMED]) + more


def _relocated(run: RunFolder, prototype: Prototype) -> tuple[dict[str, Any], dict[str, Path]]:
    """The settings with paths into the crate, and the files that go there."""
    settings, inputs = prototype.model_dump(mode="json"), dict[str, Path]()
    home = Path(run.manifest.prototype_file)
    for role in ROLES:
        moved = []
        for source in (layout.source(log, home) for log in getattr(prototype.logs, role)):
            moved.append(f"inputs/{role}/{source.name}")
            inputs[moved[-1]] = source
        settings["logs"][role] = moved
    for role, log, source in _sources(prototype, home):
        made = run.record(layout.signals(role, log)).recipe.inputs[source.name]
        if not source.is_file():
            raise InputError(f"{source}: the raw log is gone; a crate holds the logs of its run, put it back")
        if file_sha256(source) != made:
            raise InputError(f"{source}: changed since the run was made; run it again before it is packed")
    parameters = prototype.plant.parameters
    if parameters is not None and parameters.endswith(".toml"):
        settings["plant"]["parameters"] = f"inputs/{Path(parameters).name}"
        inputs[settings["plant"]["parameters"]] = home.parent / parameters
    return settings, inputs


def _sources(prototype: Prototype, home: Path) -> Iterator[tuple[Any, str, Path]]:
    return ((role, log, layout.source(path, home)) for role, log, path in layout.logs(prototype))
