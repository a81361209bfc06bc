"""A small run whose truth is known: a double well driven by pulses, with every name as hostile as names can be."""

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np

from pipeline.device.device import device
from pipeline.diagnostics.datasheet import Datasheet, make_datasheet
from pipeline.diagnostics.run_data import LogData, RunData
from pipeline.fitting.regression import basis_values
from pipeline.models.paper.model import RbfPaperModel
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.metrics import nrmse
from pipeline.reporting.figure import Figure
from pipeline.reporting.run_report import figures_of
from pipeline.settings.prototype import Prototype
from pipeline.signals.log import log_of

WELL, MASS, STIFFNESS, DAMPING, PUSH = 0.012, 0.04, 12.0, 0.12, 3e-9  # m, kg, N/m at the wells, N s/m, N/V²
SPREAD = 0.02  # of all curves together, as posterior
HOSTILE = "$\\frac{1}{$ <script>window.pwned=1</script> \" ' --> </script>"
INTERVAL = 0.01
PROTOTYPE = Prototype.model_validate(
    {
        "name": "P1",
        "logs": {"train": ["train-1.csv"], "validation": ["other.csv"]},
        "channels": {name: {"channel": name, "unit": unit} for name, unit in (("q", "m"), ("v1", "V"), ("v2", "V"))},
        "plant": {"mass": {"value": MASS, "unit": "kg"}},
    }
)


@cache
def double_well() -> RbfPaperModel:
    """F = k/(2a²) (q² − a²) q with constant damping and constant, opposite pushes, in Gaussians; known to 2 %."""
    centres = np.linspace(-0.03, 0.03, 24)
    smoothing = 2.5  # wide: the polynomials are met to 1e-4
    width = smoothing * float(centres[1] - centres[0])
    q = np.linspace(centres[0], centres[-1], 400)
    basis = basis_values(q, centres, width)
    curves = [STIFFNESS / (2 * WELL**2) * (q**2 - WELL**2), np.full_like(q, DAMPING)]
    curves += [np.full_like(q, sign * PUSH) for sign in (1.0, -1.0)]
    weights = np.array([np.linalg.lstsq(basis, curve, rcond=1e-13)[0] for curve in curves])
    spread = SPREAD * weights.reshape(-1, 1)
    return RbfPaperModel(centres=centres, smoothing=smoothing, weights=weights, lag_s=4e-3, mass_kg=MASS, spread=spread)


def pulses(seconds: float, seed: int) -> tuple[FloatArray, FloatArray]:
    """Time and alternating 1 s pulses of 3.3 to 3.6 kV with rests of 1 s."""
    rng = np.random.default_rng(seed)
    t = np.arange(0.0, seconds, INTERVAL)
    v = np.zeros((t.size, 2))
    for k, start in enumerate(np.arange(1.0, seconds - 1.0, 2.0)):
        v[(t >= start) & (t < start + 1.0), k % 2] = 1e3 * rng.uniform(3.3, 3.6)
    return t, v


def log_data(role: str, name: str, seed: int, *, seconds: float = 30.0, gap: bool = False) -> LogData:
    """A log of the double well with 3 µm of noise and free runs of two models."""
    t, v = pulses(seconds, seed)
    truth = double_well().simulate(t, v, -WELL, 0.0)
    noise = 3e-6 * np.random.default_rng(seed + 100).standard_normal(t.size)
    q = truth.q + noise
    segment = np.zeros(t.size, dtype=np.int32)
    if gap:
        hole = (t > 10.2) & (t < 10.8)
        q[hole], segment[hole], segment[t >= 10.8] = np.nan, -1, 1
    known = np.where(segment < 0, np.nan, 1.0)
    columns = {"t": t, "q": q, "v1": v[:, 0], "v2": v[:, 1], "segment": segment}
    off = truth.q + 1e-4 * np.sin(t)
    free = {"t": t, "qdot": truth.qdot, "qddot": truth.qddot, "phi": truth.q * 800.0}
    diverged = np.where(t < 5.0, off, np.nan)
    return LogData(
        role=role,
        name=name,
        source=f"logs/{name}{HOSTILE}.csv",
        record=columns,
        motion=log_of({**columns, "qdot": truth.qdot * known, "qddot": truth.qddot * known}),
        predictions={"rbf": {**free, "q": off}, "sindy": {**free, "q": diverged}},
        outcomes={
            "rbf": {"status": "ok", "diverged_at_s": None},
            "sindy": {"status": "diverged", "diverged_at_s": 5.0},
        },
        record_notes={"raw_rows": 300_000, "raw_step": 1e-4, "gaps_in_time": int(gap)},
        kinematics_notes={
            "method": "tvregdiff",
            "order": 3,
            "interval_s": INTERVAL,
            "unit_si": 1e-3,
            "stretches": [{"alpha": 1e-6, "noise_std": 3e-3, "converged": True}],
        },
    )


def scores(log: LogData) -> list[dict[str, Any]]:
    """Rows of the score table for q of both models."""
    error = nrmse(log.motion.q, log.predictions["rbf"]["q"])
    common = {"log": log.name, "role": log.role, "signal": "q", "unit": "m", "n": len(log.motion.t)}
    limits = {"nrmse_low": None if error is None else 0.8 * error, "nrmse_high": None if error is None else 1.2 * error}
    good = {"nrmse": error, "rmse": 7e-5, "status": "ok", "diverged_at_s": None, "switch_accuracy": 1.0}
    bad = {"nrmse": None, "rmse": None, "status": "diverged", "diverged_at_s": 5.0, "switch_accuracy": 0.1}
    empty = {"nrmse_low": None, "nrmse_high": None, "well_agreement": 0.2}
    return [common | limits | good | {"model": "rbf", "well_agreement": 1.0}, common | empty | bad | {"model": "sindy"}]


@cache
def run_data() -> RunData:
    """Two logs, a main model with a posterior, and a baseline that diverges."""
    logs = (log_data("train", "train-1", 0), log_data("validation", "other", 1, gap=True))
    return RunData(
        prototype=PROTOTYPE.model_copy(update={"name": "P1" + HOSTILE}),
        device=device(PROTOTYPE),
        logs=logs,
        models={"rbf": double_well()},
        descriptions={
            "rbf": {"structure": HOSTILE, "rank": 40, "ridge": 1e-2, "converged": True},
            "sindy": {"equations": ["q̈ [m/s²] = +1.5e-05 m^-1 s^-2·q -2 s^-1·q̇", HOSTILE]},
        },
        scores=tuple(row for log in logs for row in scores(log)),
        provenance={
            "prototype": {"name": HOSTILE},
            "prototype_file": f"{HOSTILE}.toml",
            "versions": {"debist": "0.1.0", "numpy": "2.0"},
            "artifacts": [
                {"artifact": name, "stage": "ingest", "algorithm": "1", "content_hash": "0" * 64, "bytes": size}
                for name, size in (("a", 10), ("b", 9), ("c", 100))
            ],
            "sources": [{"log": "training log train-1", "file": HOSTILE, "sha256": "f" * 64}],
        },
    )


@cache
def run_sheet() -> Datasheet:
    """The datasheet of that run."""
    return make_datasheet(run_data())


@cache
def run_figures() -> Mapping[str, Figure]:
    """The figures of that run."""
    return figures_of(run_data(), run_sheet())


def figures_of_one_log() -> Mapping[str, Figure]:
    """Those figures without the ones of the training log, which are drawn as those of the other log are."""
    return {name: figure for name, figure in run_figures().items() if not name.startswith("train-")}


def without_models(data: RunData) -> RunData:
    """The same run as an older tool left it: free runs and scores, but no models to load and no φ."""
    logs = tuple(
        replace(
            log,
            predictions={m: {k: c for k, c in t.items() if k != "phi"} for m, t in log.predictions.items()},
            record_notes={},
            kinematics_notes={},
        )
        for log in data.logs
    )
    return replace(data, models={}, descriptions={}, logs=logs)
