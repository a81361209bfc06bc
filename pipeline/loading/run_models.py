"""A model of a run, loaded alone or with all that travels along when it is exported."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from pipeline.loading.device import device
from pipeline.loading.free_runs import start_of
from pipeline.loading.held_models import model_artifact
from pipeline.loading.parts import longest_rows, part
from pipeline.loading.trajectories import load_motion, training_tables
from pipeline.models.base import DynamicModel
from pipeline.models.kind import model_from_tree
from pipeline.runs import layout
from pipeline.runs.run_folder import RunFolder
from pipeline.runs.tables import Table
from pipeline.settings import Prototype
from pipeline.signals.trajectory import voltages

if TYPE_CHECKING:
    from pipeline.export.subject import Subject, Validity


def load_run_model(run: RunFolder, prototype: Prototype, name: str | None = None) -> DynamicModel:
    """An identified model or a baseline of the run; the headline if none is named.

    Raises
    ------
    InputError
        The run holds no such model.
    """
    chosen, artifact = model_artifact(run, prototype, name)
    return model_from_tree(chosen, run.read_tree(artifact, chosen))


def subject(run: RunFolder, prototype: Prototype, name: str | None) -> "Subject":
    """A model of the run, the headline if none is named, and what travels along with it."""
    from pipeline.export.subject import Subject

    chosen, artifact = model_artifact(run, prototype, name)
    model, check = load_run_model(run, prototype, chosen), _check_log(run, prototype)
    start = start_of(check, model)
    return Subject(
        prototype=prototype.name,
        name=chosen,
        model=model,
        validity=validity_of(training_tables(run, prototype), prototype),
        origin=run.record(artifact).content_hash,
        t=start.t,
        v=voltages(check),
        start=(start.q0, start.qdot0),
        curve_units=device(prototype).curve_units,
    )


def _check_log(run: RunFolder, prototype: Prototype) -> Table:
    """The first validation log, or the first training log where there is none; of one with gaps the longest part."""
    role, log, _ = max(layout.logs(prototype), key=lambda entry: entry[0] == "validation")
    table = load_motion(run, prototype, role, log)
    return part(table, longest_rows(table))


def validity_of(tables: Sequence[Table], prototype: Prototype) -> "Validity":
    """What the kinematics of training logs span."""
    from pipeline.export.subject import Validity

    plant = device(prototype)

    def span(values: list[np.ndarray]) -> tuple[float, float]:
        """Smallest and largest of all logs."""
        return min(float(np.nanmin(x)) for x in values), max(float(np.nanmax(x)) for x in values)

    inputs = [name for name in ("v1", "v2") if name in tables[0]]
    return Validity(
        q=span([table["q"] for table in tables]),
        qdot=span([table["qdot"] for table in tables]),
        v=tuple(span([table[name] for table in tables]) for name in inputs),
        sample_interval=prototype.ingest.sample_interval,
        q_unit=plant.displacement.symbol,
        v_units=tuple(unit.symbol for unit in plant.inputs),
    )
