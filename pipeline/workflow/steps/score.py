"""Free runs over a log, the outcomes they leave open, and their scores: one row for each model and signal."""

import time
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from ...device.device import Device
from ...models.base import DynamicModel, FreeRun, HasTubes, predictor
from ...models.free_runs import DRAWS, Tubes, drawn_runs, free_run, tubes_of
from ...numerics.arrays import FloatArray
from ...numerics.metrics import signal_range
from ...scoring.intervals import SEED, Interval, excess_over_lowest
from ...scoring.scores import (
    SHORTEST_HORIZON,
    HorizonError,
    MeasuredPath,
    Predict,
    Score,
    horizon_errors,
    score_run,
)
from ...scoring.wells import NoWells, Wells, places_of_rest, pulse_outcomes
from ...signals.log import Log
from ...store.columns import NOTED_COLUMNS
from ...store.manifest import TIMES
from ...units.units import HORIZONS, SIGNALS, signal_units

_RESTARTS = 60


def validated(
    log: Log, model: DynamicModel, wells: Wells | NoWells, trained: Sequence[Log], plant: Device
) -> tuple[FreeRun, Tubes | None, dict[str, Any]]:
    """The free run of a model over a log, its tubes, and notes on it.

    Parameters
    ----------
    log : Log
        The log.
    model : DynamicModel
        The model.
    wells : Wells or NoWells
        The wells of the device, as far as the model has them too.
    trained : sequence of Log
        The training logs.
    plant : Device
        Its inputs, and whether it is the joint.
    """
    began = time.process_time()
    result = free_run(log, model)
    notes: dict[str, Any] = {TIMES: {"simulate_s": time.process_time() - began}}
    notes["horizons"] = _horizons(log, model, plant)
    notes["basis_functions"] = model.describe().get("basis_functions")
    ensemble = drawn_runs(log, model) if isinstance(model, HasTubes) or isinstance(wells, Wells) else None
    notes |= trust_notes(log, wells, trained, ensemble, plant)
    tubes = tubes_of(result.q, ensemble, model)
    notes["in_tube"] = None if tubes is None else tubes.coverage(log.q)
    return result, tubes, notes


def measured_path(log: Log, model: DynamicModel) -> tuple[MeasuredPath, Predict]:
    """A log as the predictions of a model are compared with it, and what predicts."""
    v = log.drive_of(fine=model.fine_voltages).copy()
    v[~log.recorded] = np.nan
    return MeasuredPath(log.t, v, log.q, log.qdot), predictor(model)


def _horizons(log: Log, model: DynamicModel, plant: Device) -> dict[str, Any]:
    """NRMSE of q after fixed times, from restarts along the log; none after times that its samples do not have."""
    shortest = SHORTEST_HORIZON * log.interval * (1.0 - 1e-9)
    possible = [h for h, _ in HORIZONS.values() if h == 0.0 or shortest <= h <= log.duration]
    path, predict = measured_path(log, model)
    errors = dict(
        zip(possible, horizon_errors(predict, path, possible, plant=plant, most_starts=_RESTARTS), strict=True)
    )
    return {name: asdict(errors.get(h, HorizonError(h, None, None, 0, 0))) for name, (h, _) in HORIZONS.items()}


def trust_notes(
    log: Log, wells: Wells | NoWells, trained: Sequence[Log], ensemble: FloatArray | None, plant: Device
) -> dict[str, Any]:
    """Notes beside the free run of a model over a log.

    Parameters
    ----------
    log : Log
        The log.
    wells : Wells or NoWells
        The wells of the device.
    trained : sequence of Log
        The training logs.
    ensemble : FloatArray, shape (draws, N), or None
        Free runs of the draws, from `pipeline.models.free_runs.drawn_runs`.
    plant : Device
        Its inputs, and whether it is the joint.

    Returns
    -------
    dict
        ``outside_training``, share of the log's samples in states (q, q̇) that no training sample was near, and
        ``outcomes``: for each rest after a pulse its end ``at_s``, the probability ``right`` of the well at larger q,
        and whether it is ``ambiguous``; None for a model without an ensemble or a device without two wells.
    """
    from ...fitting.information import share_outside

    return {
        "outside_training": share_outside(*_valid([log]), *_valid(trained)),
        "outcomes": _outcomes(log, wells, ensemble, plant=plant),
    }


def _valid(logs: Sequence[Log]) -> tuple[FloatArray, FloatArray]:
    return np.concatenate([log.known_q for log in logs]), np.concatenate([log.qdot[log.valid] for log in logs])


def _outcomes(log: Log, wells: Wells | NoWells, ensemble: FloatArray | None, plant: Device) -> dict[str, Any] | None:
    places = log.part_rows()
    rests = places_of_rest(log.q, log.v, log.interval, plant=plant)
    after = [rest for rest in rests if any(rows.start < rest.start and rest.stop <= rows.stop for rows in places)]
    if ensemble is None or not isinstance(wells, Wells) or not after:
        return None
    right, ambiguous = pulse_outcomes(ensemble, after, wells)
    return {
        "draws": DRAWS,
        "at_s": [float(log.t[rest.stop - 1]) for rest in after],
        "right": right.tolist(),
        "ambiguous": ambiguous.tolist(),
    }


@dataclass(frozen=True)
class ComparedRun:
    """A free run: measured and calculated by signal, and its notes (``status`` and ``diverged_at_s`` at least)."""

    pairs: Mapping[str, tuple[FloatArray, FloatArray]]
    notes: Mapping[str, Any]


def rows_of_log(
    plant: Device, measured: Log, runs: Mapping[str, ComparedRun], wells: Wells | NoWells
) -> list[dict[str, Any]]:
    """The scores of several free runs over a log, one row per model and signal, by the columns of ``scores.parquet``.

    Parameters
    ----------
    plant : Device
        Its units, and whether it can be the joint.
    measured : Log
        The log.
    runs : mapping of str to ComparedRun
        Free runs by model.
    wells : Wells or NoWells
        The wells of the device.
    """
    above = {signal: _above_lowest(runs, signal, measured.interval, plant=plant) for signal in SIGNALS}
    return [
        {"model": model} | row | _band("above_lowest", above[row["signal"]].get(model))
        for model, compared in runs.items()
        for row in score_rows(plant, measured, compared, wells)
    ]


def _above_lowest(
    runs: Mapping[str, ComparedRun], signal: str, interval: float, plant: Device
) -> dict[str, Interval | None]:
    """Excess of each model's error over the lowest, in NRMSE; diverged runs are left out."""
    pairs = {m: r.pairs[signal] for m, r in runs.items() if signal in r.pairs and r.notes["status"] == "ok"}
    errors = {
        model: (calculated - measured) / span
        for model, (measured, calculated) in pairs.items()
        if (span := signal_range(measured))
    }
    return excess_over_lowest(errors, interval, plant=plant)


def score_rows(plant: Device, measured: Log, compared: ComparedRun, wells: Wells | NoWells) -> list[dict[str, Any]]:
    """The scores of a free run over kinematics, one row per signal, by the columns of ``scores.parquet``.

    Errors by horizon, outcomes and what else a stage noted of the run are columns where its notes hold them.

    Parameters
    ----------
    plant : Device
        Units of the device.
    measured : Log
        The log with its derivatives.
    compared : ComparedRun
        The free run, with its notes.
    wells : Wells or NoWells
        The wells in the data.
    """
    units = signal_units(plant.displacement.symbol)
    scores = score_run(
        compared.pairs,
        measured.v,
        measured.interval,
        status=compared.notes["status"],
        diverged_at_s=compared.notes["diverged_at_s"],
        wells=wells,
        plant=plant,
        rng=np.random.default_rng(SEED),
    )
    more: dict[str, Any] = {c.key: compared.notes[c.key] for c in NOTED_COLUMNS if c.key in compared.notes}
    if outcomes := compared.notes.get("outcomes"):
        more |= {"outcomes": len(outcomes["ambiguous"]), "ambiguous_outcomes": sum(outcomes["ambiguous"])}
    for name, error in compared.notes.get("horizons", {}).items():
        band = error["interval"] or {"low": None, "high": None}
        more |= {f"nrmse_{name}": error["nrmse"]} | {f"nrmse_{name}_{end}": band[end] for end in ("low", "high")}
    return [
        _score_row(score) | {"unit": units[score.signal]} | (more if score.signal == "q" else {}) for score in scores
    ]


def _score_row(score: Score) -> dict[str, Any]:
    """A score by the columns of ``scores.parquet``, its intervals as their two ends."""
    row: dict[str, Any] = {}
    for name, value in vars(score).items():
        row |= _band(name.removesuffix("_interval"), value) if name.endswith("_interval") else {name: value}
    return row


def _band(of: str, band: Interval | None) -> dict[str, float | None]:
    """The columns of an interval."""
    return {f"{of}_low": band.low if band else None, f"{of}_high": band.high if band else None}
