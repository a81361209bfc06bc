"""Siblings: what identified runs of one drawing teach the next joint, as a file that settings name."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from pipeline.errors import DebistError, InputError
from pipeline.loading.held_models import model_artifact
from pipeline.loading.run_models import load_run_model
from pipeline.loading.siblings import read_siblings
from pipeline.runs.manifest import MANIFEST
from pipeline.runs.run_folder import RunFolder, in_snapshot
from pipeline.runs.trees import write_tree

if TYPE_CHECKING:
    from pipeline.models.hybrid.model import HybridModel
    from pipeline.models.hybrid.siblings import Learnt


@dataclass(frozen=True)
class LearntFile:
    """A file of siblings.

    Attributes
    ----------
    path : Path
    siblings : tuple of str
        Their names.
    left_out : dict of str to str
        Runs that teach nothing, and why.
    learnt : Learnt
    """

    path: Path
    siblings: tuple[str, ...]
    left_out: dict[str, str]
    learnt: "Learnt"


def learn_siblings(roots: Sequence[Path], output: Path) -> LearntFile:
    """Learn from the `hybrid` of each run, and write the file.

    Parameters
    ----------
    roots : sequence of Path
        Run folders, and folders of batches, which stand for all runs in them.
    output : Path
        The file; one of siblings is replaced, another one is not.

    Raises
    ------
    InputError
        `output` is another file, two runs have one name, or the siblings have not one parameter set.
    DataRefusedError
        Too few runs can be learnt from.
    """
    from pipeline.models.hybrid.siblings import column, learn, to_tree

    if output.exists():
        read_siblings(output)
    models: dict[str, HybridModel] = {}
    origins: dict[str, str] = {}
    left_out: dict[str, str] = {}
    for root in _runs(roots):
        try:
            name, origin, model = in_snapshot(root, _sibling)
        except DebistError as error:
            left_out[str(root)] = str(error)
            continue
        if name in models:
            raise InputError(f"{root}: a second run of {name!r}; a joint teaches once, name one of its runs")
        models[name], origins[name] = model, origin
    learnt = learn(models)
    parameters = next(iter(models.values())).joint.parameters
    write_tree(output, to_tree(learnt, parameters, origins), column)
    return LearntFile(output, tuple(models), left_out, learnt)


def _runs(roots: Sequence[Path]) -> Iterator[Path]:
    for root in roots:
        inside = [] if (root / MANIFEST).exists() else sorted(path.parent for path in root.glob(f"*/{MANIFEST}"))
        yield from inside or [root]


def _sibling(run: RunFolder) -> tuple[str, str, "HybridModel"]:
    """Name of the prototype, content hash of its models, and the hybrid one."""
    from pipeline.models.hybrid.model import HybridModel

    prototype = run.prototype
    if prototype.plant.siblings is not None:
        raise InputError(
            f"{run.root}: was identified with siblings, and would teach what they did; identify it without"
        )
    model = load_run_model(run, prototype, "hybrid")
    if not isinstance(model, HybridModel):
        raise InputError(f"{run.root}: its hybrid is none")
    return prototype.name, run.record(model_artifact(run, prototype, "hybrid")[1]).content_hash, model
