"""A model outside a run: saved with its settings and what travels along, loaded again, and exported."""

import json
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any, ClassVar

import numpy as np

from ..device.device import device
from ..errors import CorruptArtifactError, InputError
from ..export.subject import Exported, Subject, Validity
from ..models.model_file import ModelFile, Sizes, Span, Table, Unit, columns_of, read_part
from ..models.model_type import StoredModel, model_from_tree
from ..numerics.arrays import FloatArray
from ..settings.file import translated
from ..settings.prototype import Prototype, parse_prototype
from ..signals.log import Log
from ..store.hashing import tree_hash
from ..store.outputs import new_outputs, rebased
from ..store.trees import read_tree, write_tree
from ..workflow.export import MODELS, write_model
from ..workflow.run_contents import subject_on

_CHECK = "check"
"""Group of the file with what travels along beside the model."""


class _File(ModelFile):
    """Metadata that are saved beside the model."""

    sizes: ClassVar[Sizes] = {"N": (2, 10_000_000), "K": (1, 2)}
    name: str
    """Name of the model, and of its group."""
    settings_json: str
    """Settings, as JSON."""
    t: Annotated[FloatArray, Table("N"), Unit("s")]
    """Times of the log that an export is checked on."""
    v: Annotated[FloatArray, Table("N K"), Unit("SI")]
    """Inputs of the model."""
    start: Annotated[FloatArray, Table("2"), Unit("SI")]
    """Displacement and velocity at its beginning."""
    q: Annotated[Span, Unit("SI")]
    """Least and largest displacement of the training logs."""
    qdot: Annotated[Span, Unit("SI")]
    """Least and largest velocity."""
    inputs: Annotated[FloatArray, Table("K 2"), Unit("SI")]
    """Least and largest value of each input."""


def subject_of(model: StoredModel, prototype: Prototype, logs: Sequence[Log]) -> Subject:
    """A model that was identified from kinematics, with its bounds; an export is checked on the first log."""
    return subject_on(
        logs[0].longest_part(), model, prototype, logs=logs, name=model.name, origin=tree_hash(model.to_tree())
    )


def save_model(path: Path, subject: Subject, prototype: Prototype) -> None:
    """Write a model with its settings as HDF5; a file of that name is replaced.

    Raises
    ------
    InputError
        The model cannot be filed, or the file cannot be written.
    """
    if not hasattr(subject.model, "to_tree"):
        raise InputError(f"the model {subject.name} cannot be saved; identify another one")
    bounds = subject.validity
    beside = {
        "name": subject.name,
        "settings_json": json.dumps(prototype.model_dump(mode="json"), sort_keys=True),
        "t": subject.t,
        "v": subject.v,
        "start": np.array(subject.start),
        "q": np.array(bounds.q),
        "qdot": np.array(bounds.qdot),
        "inputs": np.array(bounds.v),
    }

    files: dict[str, type[Any]] = {_CHECK: _File, subject.name: type(subject.model)}
    write_tree(path, {_CHECK: beside, subject.name: subject.model.to_tree()}, columns_of(device(prototype), files))


def load_saved(path: Path) -> tuple[Subject, Prototype]:
    """A model that `save_model` wrote, with its settings.

    Raises
    ------
    InputError
        There is no such file.
    CorruptArtifactError
        The file is damaged, or no saved model.
    """
    import h5py

    advice = "`Model.save` writes one, and `debist.open_run` opens the folder of a run"
    if not path.is_file():
        raise InputError(f"{path}: no such file; {advice}")
    tree = read_tree(path) if h5py.is_hdf5(path) else {}
    if not isinstance(tree.get(_CHECK), dict):
        raise CorruptArtifactError(f"{path}: is no saved model; {advice}")
    held = read_part(_File, tree[_CHECK], "in the file", "identify")
    if not isinstance(model_tree := tree.get(held.name), dict):
        raise CorruptArtifactError(f"{path}: holds no model {held.name!r}, which it names; save it again")
    try:
        document: Any = json.loads(held.settings_json)
        if not isinstance(document, dict):
            raise ValueError("no tables")
        prototype = parse_prototype(translated(document), str(path))
    except (ValueError, InputError, RecursionError) as error:
        raise CorruptArtifactError(f"{path}: its settings cannot be read ({error}); save the model again") from error
    model = model_from_tree(held.name, model_tree)
    plant = device(prototype)
    bounds = Validity(
        q=tuple(held.q),
        qdot=tuple(held.qdot),
        v=tuple(tuple(row) for row in held.inputs),
        sample_interval=prototype.ingest.sample_interval,
        q_unit=plant.displacement.symbol,
        v_units=tuple(unit.symbol for unit in plant.inputs),
    )
    subject = Subject(
        prototype=prototype.name,
        name=held.name,
        model=model,
        validity=bounds,
        origin=tree_hash(model_tree),
        t=held.t,
        v=held.v,
        start=(float(held.start[0]), float(held.start[1])),
        curve_units=plant.curve_units,
    )
    return subject, prototype


def export_model(subject: Subject, target: str, folder: Path) -> Exported:
    """Write a model for another tool.

    Parameters
    ----------
    subject : Subject
        The model with its bounds.
    target : {"c", "fmu", "json", "matlab"}
        The form.
    folder : Path
        Folder of the files.

    Raises
    ------
    InputError
        No such form of a model, a form that cannot carry it, or a file of others lies where it goes.
    """
    if target not in MODELS:
        raise InputError(f"no export {target!r} of a model alone; there are {', '.join(MODELS)}")
    with new_outputs(folder, "export", made_from={"model": subject.origin}) as staged:
        exported = write_model(target, subject, staged)
    return replace(exported, written=[rebased(path, staged, folder) for path in exported.written])
