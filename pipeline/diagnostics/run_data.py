"""Everything that a report is made of, as the stage read it from the run folder."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..device.device import Device
from ..models.base import DynamicModel
from ..settings.prototype import Prototype
from ..signals.log import Log
from ..store.columns import StudyName
from ..system.names import log_title, true_name

Columns = Mapping[str, Any]
WHY = "chosen because"
"""Key of the reason for which "auto" chose a model."""


@dataclass(frozen=True)
class LogData:
    """One log.

    Attributes
    ----------
    role, name, source : str
        train or validation; name in the run; path as the settings give it.
    record : mapping of str to array
        Columns of the fine record; NaN where masked.
    motion : Log
        The log at the sample interval with its derivatives; NaN where masked.
    predictions : mapping of model to columns
        Free runs at the samples of `motion`.
    outcomes : mapping of model to notes
        ``status`` and ``diverged_at_s`` of each.
    record_notes, kinematics_notes : mapping
        Notes of ingest and differentiate on their results.
    """

    role: str
    name: str
    source: str
    record: Columns
    motion: Log
    predictions: Mapping[str, Columns]
    outcomes: Mapping[str, Mapping[str, Any]]
    record_notes: Mapping[str, Any]
    kinematics_notes: Mapping[str, Any]

    @property
    def key(self) -> str:
        """``role-name``, as in the figures' file names."""
        return f"{self.role}-{self.name}"

    @property
    def title(self) -> str:
        """Name of the log for readers, as in tables."""
        return log_title(self.role, true_name(self.source))


@dataclass(frozen=True)
class Study:
    """A hyperparameter study as its table holds it: columns and their units by name."""

    name: StudyName
    columns: Columns
    units: Mapping[str, str]


@dataclass(frozen=True)
class RunData:
    """One run.

    Attributes
    ----------
    prototype : Prototype
        The settings.
    device : Device
        Units, action of the inputs and mass, by the settings.
    logs : tuple of LogData
    models : mapping of str to DynamicModel
        In the order of the settings; the first is the main model.
    descriptions : mapping of str to mapping
        `describe()` of each.
    scores : sequence of records
        Rows of the score table.
    studies : sequence of Study
    measured_curves : mapping of str to FloatArray
        ``q`` and measured ``F``, ``d``, ``dC1_dq``, ``dC2_dq``, as far as there are any.
    accepted : tuple of str
        Findings against the data that the settings accept, or that the parameter set makes up for.
    choice : mapping or None
        Choice of "auto" between the models (`pipeline.models.choose.Choice`), if it was made.
    log_checks : sequence of mapping
        Rows of `debist check` as its JSON has them.
    instruments : sequence of mapping
        Rows of ``instruments.parquet``; none in a run without it.
    control : mapping of str to mapping
        Results of `debist control` for the present model, by title.
    provenance : mapping
        Printed, not used: ``prototype`` (settings), ``versions``, ``artifacts`` and ``sources`` (rows),
        ``prototype_file``, ``folder`` of the run as seen from there.
    """

    prototype: Prototype
    device: Device
    logs: tuple[LogData, ...]
    models: Mapping[str, DynamicModel]
    descriptions: Mapping[str, Mapping[str, Any]]
    scores: tuple[Mapping[str, Any], ...]
    provenance: Mapping[str, Any]
    studies: tuple[Study, ...] = field(default=())
    measured_curves: Columns = field(default_factory=dict)
    accepted: tuple[str, ...] = ()
    log_checks: tuple[Mapping[str, Any], ...] = ()
    instruments: tuple[Mapping[str, Any], ...] = ()
    control: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    choice: Mapping[str, Any] | None = None

    @property
    def why_chosen(self) -> str:
        """Reason of "auto" for the main model; empty where it had no choice, as the device cannot be the joint."""
        choice = self.choice or {}
        had_one = self.prototype.may_be_a_joint or choice.get("held_out_error")
        return str(choice.get("reason") or "") if had_one else ""

    @property
    def model_names(self) -> tuple[str, ...]:
        """Every model with a free run, the main model first."""
        return tuple(dict.fromkeys([*self.models, *(name for log in self.logs for name in log.predictions)]))

    def role(self, role: str) -> tuple[LogData, ...]:
        """The logs of one role."""
        return tuple(log for log in self.logs if log.role == role)


def judged_log(data: RunData) -> LogData:
    """The log on which the main model errs most: of the validation logs, or of the training logs without any."""
    logs = data.role("validation") or data.role("train")
    errors = {
        (s["role"], s["log"]): np.inf if s["nrmse"] is None else float(s["nrmse"])
        for s in data.scores
        if s["signal"] == "q" and s["model"] == data.model_names[0]
    }
    return max(logs, key=lambda log: errors.get((log.role, log.name), 0.0))
