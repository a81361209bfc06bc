"""The training data of a prototype, as all fits take them."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...device.device import device
from ...device.parameters import JointParameters
from ...fitting.population import NormalPopulation
from ...models.analytical.statics import rotation_nodes
from ...models.model_type import KnownCurves, Training
from ...settings.prototype import Prototype
from ...signals.log import EDGE, Log
from ...store.tables import Table
from ...system.progress import OnProgress, silent

_LEAST_PART = 5 * EDGE
"""Valid samples of a part of a log that is no more than its beginning."""


@dataclass(frozen=True)
class PriorKnowledge:
    """What a fit takes beside the logs: measured characteristic curves, and what siblings teach."""

    curves: Table | None = None
    siblings: NormalPopulation | None = None


def training(
    logs: Sequence[Log],
    prototype: Prototype,
    parameters: JointParameters | None,
    prior_knowledge: PriorKnowledge | None = None,
    on_progress: OnProgress = silent,
) -> Training:
    """The training data of a prototype.

    Parameters
    ----------
    logs : sequence of Log
        The training logs.
    prototype : Prototype
        Settings.
    parameters : JointParameters or None
        Parameter set of the analytical joint.
    prior_knowledge : PriorKnowledge, optional
        What is known beside the logs.
    on_progress : callable
        Receives what a fit is doing.
    """
    plant = device(prototype)
    beside = prior_knowledge or PriorKnowledge()
    parts = [part for log in logs for part in log.parts()]
    return Training(
        segments=tuple(segment for log in logs for segment in log.segments()),
        records=tuple(part.to_fit() for part in _long_enough(parts)),
        units=(plant.displacement.symbol, plant.inputs[0].symbol),
        inputs=plant.action,
        known_mass=plant.known_mass,
        parameters=parameters,
        known_curves=None if beside.curves is None else _known_curves(beside.curves, len(plant.inputs)),
        siblings=beside.siblings,
        identify=prototype.identify,
        compare=prototype.compare,
        log_units=(plant.displacement.factor, plant.inputs[0].factor),
        inputs_before=prototype.plant.inputs_before,
        rotation=None if plant.angle is None or parameters is None else rotation_nodes(parameters),
        on_progress=on_progress,
    )


def _long_enough(parts: Sequence[Log]) -> list[Log]:
    """The parts of logs that hold more than their beginning, or else the longest of them."""
    long_enough = [part for part in parts if np.count_nonzero(part.valid) > _LEAST_PART]
    return long_enough or [max(parts, key=lambda part: len(part.t))]


def fitted_parts(log: Log) -> list[Log]:
    """The parts of a log as fits take them."""
    return [part.to_fit() for part in _long_enough(log.parts())]


def _known_curves(table: Table, inputs: int) -> KnownCurves:
    slopes = [table.get(f"dC{k}_dq") for k in range(1, inputs + 1)]
    return KnownCurves(table["q"], table.get("F"), tuple(None if slope is None else 0.5 * slope for slope in slopes))
