"""Scores of free runs against their log: one row for each model and signal."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ...device.device import Device
from ...numerics.arrays import FloatArray
from ...numerics.metrics import signal_range
from ...scoring.intervals import SEED, Interval, excess_over_lowest
from ...scoring.wells import NoWells, Wells
from ...signals.log import Log
from ...store.columns import NOTED_COLUMNS
from ...units.units import SIGNALS, signal_units

if TYPE_CHECKING:
    from ...scoring.scores import Score


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
    """How far the error of each model lies above the lowest, in NRMSE; diverged runs are no part of the field."""
    pairs = {m: r.pairs[signal] for m, r in runs.items() if signal in r.pairs and r.notes["status"] == "ok"}
    errors = {
        model: (calculated - measured) / span
        for model, (measured, calculated) in pairs.items()
        if (span := signal_range(measured))
    }
    return excess_over_lowest(errors, interval, SEED, plant=plant)


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
    from ...scoring.scores import response_errors, score_run

    units = signal_units(plant.displacement.symbol)
    v = measured.v
    interval = measured.interval
    rng = np.random.default_rng(SEED)
    status = compared.notes["status"]
    diverged_at = compared.notes["diverged_at_s"]
    scores = score_run(
        compared.pairs, v, interval, status=status, diverged_at_s=diverged_at, wells=wells, plant=plant, rng=rng
    )
    more: dict[str, Any] = {c.key: compared.notes[c.key] for c in NOTED_COLUMNS if c.key in compared.notes}
    outcomes = compared.notes.get("outcomes")
    if outcomes:
        more |= {"outcomes": len(outcomes["ambiguous"]), "ambiguous_outcomes": sum(outcomes["ambiguous"])}
    for name, error in compared.notes.get("horizons", {}).items():
        band = error["interval"] or {"low": None, "high": None}
        more |= {f"nrmse_{name}": error["nrmse"]} | {f"nrmse_{name}_{end}": band[end] for end in ("low", "high")}
    if isinstance(wells, Wells):
        switches = response_errors(*compared.pairs["q"], v, interval, wells, rng, plant=plant)
        more |= {"rise_error_s": switches.rise_s, "settling_error_s": switches.settling_s}
        more |= _band("rise_error", switches.rise_interval, "_s")
        more |= _band("settling_error", switches.settling_interval, "_s")
    return [
        _score_row(score) | {"unit": units[score.signal]} | (more if score.signal == "q" else {}) for score in scores
    ]


def _score_row(score: "Score") -> dict[str, Any]:
    """A score by the columns of ``scores.parquet``, its intervals as their two ends."""
    row: dict[str, Any] = {}
    for name, value in vars(score).items():
        row |= _band(name.removesuffix("_interval"), value) if name.endswith("_interval") else {name: value}
    return row


def _band(of: str, band: Interval | None, unit: str = "") -> dict[str, float | None]:
    """The columns of an interval."""
    return {f"{of}_low{unit}": band.low if band else None, f"{of}_high{unit}": band.high if band else None}
