"""Trust: what a free run leaves open, namely pulses whose well hinges on too little and states never trained on."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pipeline.loading.trajectories import drive, voltages
from pipeline.runs.tables import Table

if TYPE_CHECKING:
    from pipeline.models.base import Model
    from pipeline.numerics.arrays import FloatArray

_DRAWS = 32


def trust_notes(model: "Model", rows: Table, every_log: Sequence[Table], trained: Sequence[Table]) -> dict[str, Any]:
    """What is noted beside the free run of a model over a log.

    Parameters
    ----------
    model : Model
        Outcomes are noted for one that can draw an ensemble from its parameters' posterior.
    rows : Table
        The log from its first valid sample on.
    every_log : sequence of Table
        All logs of the device, in which its wells are found.
    trained : sequence of Table
        The training logs.

    Returns
    -------
    dict
        ``outside_training``, share of the log's samples in states (q, q̇) that no training sample was near, and
        ``outcomes``: for each rest after a pulse its end ``at_s``, the probability ``right`` of the right well, and
        whether it is ``ambiguous``; None for a model without an ensemble or a device without two wells.
    """
    from pipeline.identification.coverage import share_outside

    known, seen = _valid([rows]), _valid(trained)
    return {
        "outside_training": share_outside(*known, *seen),
        "outcomes": _outcomes(model, rows, every_log),
    }


def _valid(tables: Sequence[Table]) -> "tuple[FloatArray, FloatArray]":
    kept = [table["segment"] >= 0 for table in tables]
    q, qdot = (
        np.concatenate([table[name][k] for table, k in zip(tables, kept, strict=True)]) for name in ("q", "qdot")
    )
    return q, qdot


def _outcomes(model: "Model", rows: Table, every_log: Sequence[Table]) -> dict[str, Any] | None:
    from pipeline.scoring.wells import Wells, find_wells, pulse_outcomes, rests

    wells = find_wells([(table["q"], voltages(table), _interval(table)) for table in every_log])
    after = [rest for rest in rests(voltages(rows), _interval(rows)) if rest.start > 0]
    simulate_draws = getattr(model, "simulate_draws", None)
    if simulate_draws is None or not isinstance(wells, Wells) or not after:
        return None
    t, v = rows["t"], drive(rows, fine=model.fine_voltages)
    ensemble, _ = simulate_draws(t, v, float(rows["q"][0]), float(rows["qdot"][0]), count=_DRAWS)
    found = pulse_outcomes(ensemble, after, wells)
    ends = [float(t[rest.stop - 1]) for rest in after]
    return {"draws": _DRAWS, "at_s": ends, "right": found.right.tolist(), "ambiguous": found.ambiguous.tolist()}


def _interval(table: Table) -> float:
    return float((table["t"][-1] - table["t"][0]) / (len(table["t"]) - 1))
