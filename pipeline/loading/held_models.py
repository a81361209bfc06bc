"""What a run holds: the identified models, the headline first, the comparisons, and the controller."""

from collections.abc import Sequence
from typing import Any

from pipeline.errors import InputError
from pipeline.loading.documents import read_document
from pipeline.runs import layout
from pipeline.runs.run_folder import RunFolder
from pipeline.settings import Prototype

IDENTIFIED = "identified"
"""Note of ``model.h5``: names of its models, the headline first."""

CHOICE = "choice"
"""Note of ``model.h5``: the decision of "auto", as `pipeline.models.choose.Choice.to_json` writes it."""
EQUATIONS = "equations"
"""Note of ``model.h5``: name of the joint that "auto" fitted and did not choose; control is designed on it."""
WORST = 0.15
"""NRMSE of q on a validation log above which a model does not know where the device is."""
TITLES = ("linear", "map", "pulse-to-right", "pulse-to-left", "design")


def identified_models(run: RunFolder, prototype: Prototype) -> tuple[str, ...]:
    """Names of the identified models, the headline first; as the settings say ("auto") before there are any."""
    made = run.manifest.artifacts.get(layout.MODELS)
    return tuple(made.notes.get(IDENTIFIED, prototype.identify.models)) if made else prototype.identify.models


def compared_models(run: RunFolder, prototype: Prototype) -> tuple[str, ...]:
    """Names of the compared models that the run holds."""
    return tuple(name for name in prototype.baselines if layout.baseline(name) in run.manifest.artifacts)


def model_artifact(run: RunFolder, prototype: Prototype, name: str | None) -> tuple[str, str]:
    """Name of a model, the headline if none is given, and the artifact that holds it.

    Raises
    ------
    InputError
        The run holds no such model.
    """
    identified, compared = identified_models(run, prototype), compared_models(run, prototype)
    wanted = identified[0] if name is None else name
    if name is not None and name == _beside(run):
        return name, layout.MODELS
    if wanted in compared:
        return wanted, layout.baseline(wanted)
    if wanted not in identified or layout.MODELS not in run.manifest.artifacts:
        held = (*(identified if layout.MODELS in run.manifest.artifacts else ()), *compared)
        raise InputError(
            f"{run.root}: holds no model {wanted!r}; it holds {', '.join(held)}"
            if held
            else f"{run.root}: holds no model yet; `debist identify {run.root}` makes one"
        )
    return wanted, layout.MODELS


def controlled_model(run: RunFolder, prototype: Prototype) -> tuple[str, str]:
    """Name of the model on which control is designed, the joint beside the headline if there is one; its artifact."""
    return model_artifact(run, prototype, _beside(run))


def _beside(run: RunFolder) -> str | None:
    """Name of the joint that "auto" fitted and did not choose."""
    made = run.manifest.artifacts.get(layout.MODELS)
    return made.notes.get(EQUATIONS) if made else None


def load_design(run: RunFolder) -> dict[str, Any]:
    """The designed controller of a run.

    Raises
    ------
    InputError
        None was designed for the present model.
    """
    name = layout.control("design")
    if name not in run.manifest.artifacts:
        raise InputError(f"{run.root}: no controller was designed yet; `debist control design {run.root}` does it")
    document = read_document(run, name)
    if document["origin"] != run.record(layout.MODELS).content_hash:
        raise InputError(
            f"{run.root}: its controller was designed for another model; `debist control design {run.root}` renews it"
        )
    return document


def made_control(run: RunFolder) -> tuple[str, ...]:
    """Titles of what `debist control` made of the present model of a run."""
    artifacts = run.manifest.artifacts
    if layout.MODELS not in artifacts:
        return ()
    present = run.record(layout.MODELS).content_hash
    names = ((title, layout.control(title)) for title in TITLES)
    return tuple(t for t, name in names if name in artifacts and present in artifacts[name].recipe.inputs.values())


def control_documents(run: RunFolder, titles: Sequence[str]) -> dict[str, dict[str, Any]]:
    """What was made, by title."""
    return {title: read_document(run, layout.control(title)) for title in titles}


def failed_validations(run: RunFolder, name: str) -> list[str]:
    """On which validation logs a model diverges, or errs by more than `WORST`; a sentence each, none without scores."""
    if layout.SCORES not in run.manifest.artifacts:
        return []
    table = run.read_table(layout.SCORES)
    rows = (table["model"] == name) & (table["role"] == "validation") & (table["signal"] == "q")
    failures = []
    for log, status, error in zip(table["log"][rows], table["status"][rows], table["nrmse"][rows], strict=True):
        if status != "ok" or not error <= WORST:
            failure = "diverges" if status != "ok" else f"has an NRMSE of {100.0 * error:.0f} % of q"
            failures.append(f"the model {name} {failure} on the validation log {log}")
    return failures
