"""Export: an identified model, or the whole run, in the form another tool reads."""

from collections.abc import Iterator, Mapping
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from typing import Any, get_args

from ..errors import CorruptArtifactError, InputError
from ..export.subject import Exported, Subject
from ..settings.file import toml_text
from ..settings.logs import ROLES, log_label
from ..settings.prototype import Prototype
from ..store import layout
from ..store.atomic import refuse_link, run_lock
from ..store.hashing import file_sha256
from ..store.outputs import new_outputs, rebased, written_files
from ..store.run_folder import RunFolder
from ..system.names import Target, log_name
from .prior_knowledge import named_files
from .run_contents import failed_validations, load_design, model_artifact, subject

_TAKES_NONE = {
    "crate": "it is the whole run",
    "controller": "it is what `debist control design` made, on the joint's equations",
}
MODELS = ("c", "fmu", "json", "matlab")
"""Exports of a model alone."""


def export_run(
    root: Path, target: Target, *, model: str | None = None, output: Path | None = None, force: bool = False
) -> Exported:
    """Write a model of a run for another tool.

    Parameters
    ----------
    root : Path
        Run folder.
    target : {"c", "controller", "crate", "fmu", "json", "matlab"}
        The form; "crate" is the whole run with its inputs, "controller" what `debist control design` made.
    model : str, optional
        Name of an identified model or of a baseline, the main model if left out; none for a crate or a controller.
    output : Path, optional
        Folder of the files; ``RUN/exports`` if left out.
    force : bool
        Replace files that no export wrote, or that were changed since.

    Returns
    -------
    Exported
        The files, and what their user should know.

    Raises
    ------
    InputError
        No such form or model, a form that cannot carry the model or takes none, or a file of others lies where it goes.
    """
    if target not in get_args(Target):
        raise InputError(f"no export {target!r}; there are {', '.join(get_args(Target))}")
    if model is not None and target in ("crate", "controller"):
        raise InputError(f"a {target} takes no --model: {_TAKES_NONE[target]}")
    run = RunFolder.open(root)
    prototype = run.prototype
    if target == "controller" and not prototype.may_be_a_joint:
        raise InputError(f"{root}: a controller is for a joint with two membranes, not for another device")
    if output is None:
        refuse_link(root / layout.EXPORTS)
    folder = output or root / layout.EXPORTS
    with (
        run_lock(root) if output is None else nullcontext(),
        new_outputs(folder, "export", force=force, made_from=_origin(run, prototype, target, model)) as staged,
    ):
        exported = _write(target, run, prototype, model, staged)
    return replace(exported, written=[rebased(path, staged, folder) for path in exported.written])


def stale_exports(root: Path) -> list[str]:
    """Files in ``RUN/exports`` that were made from another model, or design, than the run now holds."""
    held = {name: record.content_hash for name, record in RunFolder.open(root).manifest.artifacts.items()}
    return [
        f"{layout.EXPORTS}/{name}"
        for name, entry in written_files(root / layout.EXPORTS).items()
        if isinstance(origin := entry.get("made_from"), dict) and (root / layout.EXPORTS / name).is_file()
        if any(held.get(artifact) != content for artifact, content in origin.items())
    ]


def _origin(run: RunFolder, prototype: Prototype, target: Target, model: str | None) -> dict[str, str]:
    """The artifact that an export is made from, and its content; a crate may be of a run without a model."""
    if target == "crate" and layout.MODELS not in run.manifest.artifacts:
        return {}
    _, artifact = model_artifact(run, prototype, model)
    design = layout.control("design")
    origin = [artifact, design] if target == "controller" and design in run.manifest.artifacts else [artifact]
    return {name: run.record(name).content_hash for name in origin}


def _write(target: Target, run: RunFolder, prototype: Prototype, model: str | None, folder: Path) -> Exported:
    if target == "crate":
        return export_crate(run, prototype, folder)
    if target == "controller":
        return _controller(run, prototype, folder)
    exported = write_model(target, subject(run, prototype, model), folder)
    failed = failed_validations(run, model_artifact(run, prototype, model)[0])
    return replace(exported, notes=[*exported.notes, *(f"{problem}: do not trust its free runs" for problem in failed)])


def write_model(target: str, subject: Subject, folder: Path) -> Exported:
    """Write a model in the form of one of `MODELS`."""
    from ..export import fmu, sources

    writers = {"c": sources.write_c, "fmu": fmu.write_fmu, "json": sources.write_json, "matlab": sources.write_matlab}
    return writers[target](subject, folder)


def _controller(run: RunFolder, prototype: Prototype, folder: Path) -> Exported:
    from ..control.law import Law
    from ..export.controller import write_controller

    document = load_design(run)
    places = document["places_m"]
    return write_controller(
        folder,
        Law.from_json(document["law"]),
        document["lags_s"],
        (places["left"], places["saddle"], places["right"]),
        prototype=prototype.name,
        model=document["model"],
        origin=document["origin"],
    )


def export_crate(run: RunFolder, prototype: Prototype, folder: Path) -> Exported:
    """Write the run with its inputs as ``NAME.crate.zip``.

    Raises
    ------
    InputError
        A raw log, a table of curves or a prior is gone, or is not the one that the run was made from.
    CorruptArtifactError
        An artifact does not have the bytes that were written.
    """
    from ..export.crate import write_crate

    settings, inputs = _relocated(run, prototype)
    texts: dict[str, str] = {}
    parameters = prototype.plant.parameters
    if parameters is not None and parameters.endswith(".toml"):  # others ship with the program
        settings["plant"]["parameters"] = f"inputs/plant/{Path(parameters).name}"
        texts[settings["plant"]["parameters"]] = _recorded_parameters(run, parameters)
    target = folder / f"{prototype.folder}.crate.zip"
    write_crate(run, name=prototype.folder, settings=toml_text(settings), inputs=inputs, more=texts, target=target)
    return Exported([target])


def _recorded_parameters(run: RunFolder, name: str) -> str:
    """TOML of the parameter set that the run was made with; the recipes hold its values, and no hash of its file."""
    from ..device.parameters import NOMINAL, VECTOR_NAMES, parameter_file

    recipes = (record.recipe.settings for record in run.manifest.artifacts.values())
    values = next((recipe["parameters"] for recipe in recipes if recipe.get("parameters")), None)
    if values is None:
        raise InputError(
            f"{name}: no result of the run was made with this parameter set; `debist run` makes them first"
        )
    if not (isinstance(values, Mapping) and all(isinstance(values.get(key), float | int) for key in VECTOR_NAMES)):
        raise CorruptArtifactError(f"{run.root}: its recipes hold no values of {name}; run it again")
    return parameter_file(NOMINAL.with_values({key: float(values[key]) for key in VECTOR_NAMES}))


def _relocated(run: RunFolder, prototype: Prototype) -> tuple[dict[str, Any], dict[str, Path]]:
    """The settings with paths into the crate, and the files that go there."""
    settings = prototype.model_dump(mode="json")
    inputs = dict[str, Path]()
    home = Path(run.manifest.prototype_file)
    for role in ROLES:
        moved = []
        for log, stated in zip(getattr(prototype.logs, role), settings["logs"][role], strict=True):
            source = layout.source(log, home)
            place = f"inputs/{role}/{source.name}"
            if inputs.get(place, source) != source:  # parts of two files of one name
                place = f"inputs/{role}/{log_name(log_label(log))}/{source.name}"
            inputs[place] = source
            moved.append(place if isinstance(log, str) else {**stated, "file": place})
        settings["logs"][role] = moved
    for artifact, source in _sources(prototype, home):
        if not source.is_file():
            raise InputError(f"{source}: is gone; a crate holds the logs and tables of its run, put it back")
        if file_sha256(source) != run.record(artifact).recipe.inputs.get(source.name):
            raise InputError(f"{source}: changed since the run was made; run it again before it is packed")
    for key, _, name in named_files(prototype):
        table, _, entry = key.partition(".")
        settings[table][entry] = f"inputs/{table}/{Path(name).name}"
        inputs[settings[table][entry]] = layout.source(name, home)
    return settings, inputs


def _sources(prototype: Prototype, home: Path) -> Iterator[tuple[str, Path]]:
    """Every raw log, table of measured curves and prior: an artifact that was made of it, and its file."""
    for (role, log, _), (_, path, _) in zip(layout.logs(prototype), layout.raw_logs(prototype, home), strict=True):
        yield layout.signals(role, log), path
    yield from ((artifact, layout.source(name, home)) for _, artifact, name in named_files(prototype))
