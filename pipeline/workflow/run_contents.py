"""Contents of a run for fits, exports and control: its logs, its models, and the documents of control."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from ..device.device import device
from ..errors import InputError
from ..export.subject import Subject, Validity
from ..models.base import DynamicModel
from ..models.free_runs import start_of
from ..models.model_type import model_from_tree
from ..numerics.arrays import FloatArray, sample_interval
from ..settings.logs import ROLES, Role
from ..settings.prototype import Prototype
from ..signals.log import UNKNOWN, Corrections, Log, log_of, voltages
from ..store import layout
from ..store.run_folder import RunFolder
from ..store.tables import Table
from ..system.names import shell_word
from ..units.units import TIME, parse_quantity
from .steps.identify import EQUATIONS, IDENTIFIED

WORST = 0.15
"""NRMSE of q on a validation log above which a model does not know where the device is."""
TITLES = ("linear", "map", "pulse-to-right", "pulse-to-left", "design")


def sources(prototype: Prototype, *roles: Role) -> tuple[str, ...]:
    """The artifacts that `load_motion` reads, of the logs in these roles, or in all."""
    return tuple(
        artifact(role, log)
        for role, log, _ in layout.logs(prototype)
        if role in (roles or ROLES)
        for artifact in (layout.kinematics, layout.record)
    )


def load_motion(run: RunFolder, prototype: Prototype, role: Role, log: str) -> Log:
    """A log of a run, with its derivatives.

    Parameters
    ----------
    run : RunFolder
        The run.
    prototype : Prototype
        Its settings.
    role : {"train", "validation"}
        Role of the log.
    log : str
        Its name in the run.
    """
    kinematics, fine = (run.read_table(artifact(role, log)) for artifact in (layout.kinematics, layout.record))
    return motion(kinematics, fine, prototype, run.record(layout.record(role, log)).notes.get(UNKNOWN, ()))


def load_logs(run: RunFolder, prototype: Prototype, *roles: Role) -> list[Log]:
    """The logs of a run in these roles, or all."""
    logs = layout.logs(prototype)
    return [load_motion(run, prototype, role, log) for role, log, _ in logs if role in (roles or ROLES)]


def motion(kinematics: Table, fine: Table | None, prototype: Prototype, unknown: Sequence[Sequence[float]] = ()) -> Log:
    """A log from its tables.

    Parameters
    ----------
    kinematics : Table
        Columns t, q, qdot, qddot, v1, v2, segment, and perhaps velocity, at the sample interval.
    fine : Table or None
        The uniform record with the inputs between those samples.
    prototype : Prototype
        Its settings state what the inputs were before the log: where they were zero, they begin at zero.
    unknown : sequence of (float, float)
        Spans [s] in which the inputs were not recorded.
    """
    log = log_of(kinematics, None if fine is None else between(kinematics["t"], fine), unknown)
    if prototype.plant.inputs_before == "zero":
        first = int(np.argmax(log.valid))
        log.v[first] = 0.0
        if log.fine is not None:
            log.fine[first, 0] = 0.0
    return log


def between(t: FloatArray, fine: Table) -> FloatArray | None:
    """The inputs of the fine record in each interval of t, shape (N, r, K); None where it is not finer."""
    grid = fine["t"]
    refined = round(sample_interval(t) / sample_interval(grid))
    if refined == 1:
        return None
    # The record ends with the last sample or within the interval behind it, where nothing is simulated.
    first = int(np.searchsorted(grid, t[0] - 1e-9))
    v = voltages(fine)
    places = np.minimum(first + np.arange(len(t) * refined), len(v) - 1)
    return np.asarray(v[places].reshape(len(t), refined, -1))


def corrections(prototype: Prototype) -> dict[tuple[Role, str], Corrections]:
    """Corrections stated in [logs], by each log's role and its name in the run.

    Raises
    ------
    InputError
        A zero in another unit than that of q, or a gain of an input that the device has not.
    """
    plant = device(prototype)
    stated = dict[tuple[Role, str], Corrections]()
    for role, log, part in layout.log_parts(prototype):
        where = f"{prototype.name}: logs.{role}: {part.file}"
        if len(plant.inputs) == 1 and part.gain.v2 != 1.0:
            raise InputError(f"{where}: gain.v2 is stated, but [channels] has no v2; leave it out")
        stated[role, log] = Corrections(
            gains=(part.gain.v1, part.gain.v2)[: len(plant.inputs)],
            zero=parse_quantity(part.zero, (plant.displacement.symbol,), f"{where}: zero"),
            gain_q=part.gain.q,
            delay=parse_quantity(part.delay, TIME, f"{where}: delay"),
            clock=part.clock,
        )
    return stated


def identified_models(run: RunFolder, prototype: Prototype) -> tuple[str, ...]:
    """Names of the identified models, the main model first; as the settings say ("auto") before there are any."""
    made = run.manifest.artifacts.get(layout.MODELS)
    return tuple(made.notes.get(IDENTIFIED, prototype.identify.models)) if made else prototype.identify.models


def compared_models(run: RunFolder, prototype: Prototype) -> tuple[str, ...]:
    """Names of the compared models that the run holds."""
    return tuple(name for name in prototype.baselines if layout.baseline(name) in run.manifest.artifacts)


def model_artifact(run: RunFolder, prototype: Prototype, name: str | None) -> tuple[str, str]:
    """Name of a model, the main model if none is given, and the artifact that holds it.

    Raises
    ------
    InputError
        The run holds no such model.
    """
    identified = identified_models(run, prototype)
    compared = compared_models(run, prototype)
    wanted = identified[0] if name is None else name
    if name is not None and name == joint_beside(run):
        return name, layout.MODELS
    if wanted in compared:
        return wanted, layout.baseline(wanted)
    if wanted not in identified or layout.MODELS not in run.manifest.artifacts:
        held = (*(identified if layout.MODELS in run.manifest.artifacts else ()), *compared)
        raise InputError(
            f"{run.root}: holds no model {wanted!r}; it holds {', '.join(held)}"
            if held
            else f"{run.root}: holds no model yet; `debist identify {shell_word(run.root)}` makes one"
        )
    return wanted, layout.MODELS


def joint_beside(run: RunFolder) -> str | None:
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
    makes = f"`debist control design {shell_word(run.root)}`"
    if name not in run.manifest.artifacts:
        raise InputError(f"{run.root}: no controller was designed yet; {makes} does it")
    document = run.read_document(name)
    if document["origin"] != run.record(layout.MODELS).content_hash:
        raise InputError(f"{run.root}: its controller was designed for another model; {makes} renews it")
    return document


def made_control(run: RunFolder) -> tuple[str, ...]:
    """Titles of what `debist control` made of the present model of a run."""
    artifacts = run.manifest.artifacts
    if layout.MODELS not in artifacts:
        return ()
    present = run.record(layout.MODELS).content_hash
    names = ((title, layout.control(title)) for title in TITLES)
    return tuple(t for t, name in names if name in artifacts and present in artifacts[name].recipe.inputs.values())


def failed_validations(run: RunFolder, name: str) -> Iterator[str]:
    """Sentences on validation logs on which a model diverges, or errs by more than `WORST`; none without scores."""
    if layout.SCORES not in run.manifest.artifacts:
        return
    table = run.read_table(layout.SCORES)
    rows = (table["model"] == name) & (table["role"] == "validation") & (table["signal"] == "q")
    for log, status, error in zip(table["log"][rows], table["status"][rows], table["nrmse"][rows], strict=True):
        if status != "ok" or not error <= WORST:
            failure = "diverges" if status != "ok" else f"has an NRMSE of {100.0 * error:.0f} % of q"
            yield f"the model {name} {failure} on the validation log {log}"


def load_run_model(run: RunFolder, prototype: Prototype, name: str | None = None) -> DynamicModel:
    """An identified model or a baseline of the run; the main model if none is named.

    Raises
    ------
    InputError
        The run holds no such model.
    """
    chosen, artifact = model_artifact(run, prototype, name)
    return model_from_tree(chosen, run.read_tree(artifact, chosen))


def subject(run: RunFolder, prototype: Prototype, name: str | None) -> Subject:
    """A model of the run, the main model if none is named, and what travels along with it."""
    chosen, artifact = model_artifact(run, prototype, name)
    # The first validation log, or the first training log where there is none; of one with gaps the longest part.
    role, log, _ = max(layout.logs(prototype), key=lambda entry: entry[0] == "validation")
    return subject_on(
        load_motion(run, prototype, role, log).longest_part(),
        model_from_tree(chosen, run.read_tree(artifact, chosen)),
        prototype,
        logs=load_logs(run, prototype, "train"),
        name=chosen,
        origin=run.record(artifact).content_hash,
    )


def subject_on(
    check: Log, model: DynamicModel, prototype: Prototype, logs: Sequence[Log], name: str, origin: str
) -> Subject:
    """A model called `name`, identified from the kinematics of `logs`, with the log `check` that travels along.

    The clock of that log begins at zero, as an exported model does: `hybrid` takes a later one for time in use.

    Parameters
    ----------
    check : Log
        The log that travels along.
    model : DynamicModel
        The model.
    prototype : Prototype
        Settings of the run.
    logs : sequence of Log
        Training logs, whose ranges bound the model.
    name : str
        Name of the model.
    origin : str
        Content hash of what holds it.
    """
    t, _, q0, qdot0 = start_of(check, model)
    return Subject(
        prototype=prototype.name,
        name=name,
        model=model,
        validity=_validity_of(logs, prototype),
        origin=origin,
        t=t - t[0],
        v=check.v,
        start=(q0, qdot0),
        curve_units=device(prototype).curve_units,
    )


def _validity_of(logs: Sequence[Log], prototype: Prototype) -> Validity:
    """Ranges of the training logs."""
    plant = device(prototype)

    def span(values: list[np.ndarray]) -> tuple[float, float]:
        """Smallest and largest of all logs."""
        return min(float(np.nanmin(x)) for x in values), max(float(np.nanmax(x)) for x in values)

    return Validity(
        q=span([log.q for log in logs]),
        qdot=span([log.qdot for log in logs]),
        v=tuple(span([log.v[:, k] for log in logs]) for k in range(logs[0].v.shape[1])),
        sample_interval=prototype.ingest.sample_interval,
        q_unit=plant.displacement.symbol,
        v_units=tuple(unit.symbol for unit in plant.inputs),
    )
