"""Files of siblings: read as they come, filed in a run, and taken from there as a prior."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

from pipeline.errors import CorruptArtifactError, InputError
from pipeline.fitting.population import NormalPopulation
from pipeline.runs import layout
from pipeline.runs.run_folder import RunFolder
from pipeline.runs.trees import read_tree
from pipeline.settings import Prototype

if TYPE_CHECKING:
    from pipeline.device_parameters import JointParameters


def read_siblings(path: Path) -> dict[str, Any]:
    """The tree of a file of `debist fleet learn`, checked.

    Raises
    ------
    InputError
        There is no such file, or it is none of siblings.
    """
    from pipeline.models.hybrid.siblings import from_tree

    try:
        tree = read_tree(path)
        from_tree(tree)
    except CorruptArtifactError as error:
        raise InputError(f"{path}: is no file of siblings ({error})") from error
    return tree


def shown_siblings(run: RunFolder, prototype: Prototype) -> NormalPopulation | None:
    """What siblings teach, for the page; None where the settings name none."""
    from pipeline.models.hybrid.siblings import from_tree

    return None if prototype.plant.siblings is None else from_tree(run.read_tree(layout.SIBLINGS))[1]


def siblings_of(run: RunFolder, parameters: "JointParameters | None") -> NormalPopulation:
    """What siblings teach, as the run holds it.

    Raises
    ------
    InputError
        They were learnt about another parameter set than the run's.
    """
    from pipeline.models.hybrid.siblings import from_tree

    about, population, _ = from_tree(run.read_tree(layout.SIBLINGS))
    if parameters is None or about != parameters:
        raise InputError("plant.siblings: they were learnt about another parameter set than plant.parameters; use that")
    return population
