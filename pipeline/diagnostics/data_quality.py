"""The assessment of the measurement: gaps, noise, rails, excitation, and whether validation stays inside training."""

import numpy as np

from ..numerics.arrays import FloatArray, sample_interval
from ..scoring.wells import NoWells, Wells, snaps
from ..signals.findings import Finding, Number
from ..signals.noise import below_resolution, noise_std, rounding
from ..signals.signal_quality import examine_signal
from .grades import Check, graded, of_finding
from .run_data import LogData, RunData
from .sentences import MASKS

NOT_DECIMATED = 0.9
"""Least sample interval of a log over that of its kinematics at which both have the same noise."""


def data_checks(data: RunData, wells: Wells | NoWells) -> list[Check]:
    """The measurement: gaps, noise, rails, excitation, and whether validation stays inside the training range."""
    spans, noises, rails = zip(*(_numbers_of_log(data, log) for log in data.logs), strict=True)
    advice = "judge every number with that in mind, or record again without it"
    checks = [
        *(Check("data", "accepted", "poor", f"used all the same: {text}", advice) for text in data.accepted),
        *_remark_checks(data),
        _masked_check(data),
        _noise_check(data, max(spans) or 1.0, max(noises)),
    ]
    if data.prototype.ingest.rails == "keep" and max(rails) > 0.0:  # the user has said what they are
        kept = Finding("rails", "good", subject="kept", numbers={"value": Number(max(rails))})
        checks.append(of_finding("data", kept))
    else:
        checks.append(graded("data", "rails", max(rails)))
    kind = "joint" if data.device.joint else ""
    if isinstance(wells, Wells):
        count = sum(len(snaps(log.motion.q, wells)) for log in data.role("train"))
        checks.append(graded("data", "switches", count, subject=kind))
    elif data.device.joint:  # another device need not have two
        checks.append(of_finding("data", Finding("no_wells", "fair", subject=wells.reason)))
    inner = centre_visits(data)[1][1:-1]  # the outermost two centres lie at the ends of the range
    if inner.size:
        checks.append(
            graded("data", "coverage", float(inner.min()), subject=kind, numbers={"centres": Number(inner.size)})
        )
    return checks + _extrapolation_checks(data)


def _remark_checks(data: RunData) -> list[Check]:
    """Every remark on a log, and every (!) of the checks; masked and split samples are graded by their share."""
    advice = "see to it, or judge every number with that in mind"
    return [
        Check("data", "remark", "good" if text in dealt_with else "fair", f"{log.title}: {text}", advice)
        for log in data.logs
        for dealt_with in (log.record_notes.get("dealt_with", ()),)
        for text in map(str, log.record_notes.get("warnings", ()))
        if text not in (*log.record_notes.get("accepted", ()), *data.accepted)  # which have a row of their own
    ] + [
        Check("data", "check", "fair", f"{row['log']}: {row['what']}: {row['found']}", row["advice"])
        for row in data.log_checks
        if row["state"] == "note"
    ]


def _masked_check(data: RunData) -> Check:
    """Share of the rows without a measurement, with the count of each cause; the cut-off ends of a log count too."""
    cut = sum(float(log.record_notes.get("cut_off_s", 0.0)) / log.motion.interval for log in data.logs)
    masked = sum(int(np.count_nonzero(~log.motion.valid)) for log in data.logs) + cut
    counts = {cause: sum(int(log.record_notes.get(cause, 0)) for log in data.logs) for cause in MASKS}
    return graded(
        "data",
        "masked",
        masked / (sum(len(log.motion.t) for log in data.logs) + cut),
        numbers={cause: Number(count) for cause, count in counts.items() if count},
    )


def _extrapolation_checks(data: RunData) -> list[Check]:
    """Validation samples outside the range of the training data."""
    validation = data.role("validation")
    if not validation:
        return []
    trained = [np.column_stack((log.motion.q, log.motion.v)) for log in data.role("train")]
    low = np.nanmin(np.concatenate(trained), axis=0)
    high = np.nanmax(np.concatenate(trained), axis=0)
    rows = np.concatenate([np.column_stack((g.motion.q, g.motion.v)) for g in validation])
    margin = 0.01 * (high - low)
    rows = rows[np.isfinite(rows).all(axis=1)]
    beyond = np.any((rows < low - margin) | (rows > high + margin), axis=1)
    return [graded("data", "extrapolation", float(np.mean(beyond)))] if rows.size else []


def _noise_check(data: RunData, span: float, noise: float) -> Check:
    """Noise over the range of q [both m or rad], or the rounding error where the sensor's steps hide the noise."""
    unit = data.device.displacement.symbol
    steps = max(log.record_notes.get("resolution") or 0.0 for log in data.logs)
    if below_resolution(noise, steps):
        numbers = {"steps": Number(steps, unit), "share": Number(steps / span)}
        return graded("data", "noise", rounding(steps) / span, subject="steps", numbers=numbers)
    return graded("data", "noise", noise / span, numbers={"noise": Number(noise, unit)})


def centre_visits(data: RunData) -> tuple[FloatArray, FloatArray]:
    """Centres over the training range [m or rad], and the training samples nearest to each, both (centres,)."""
    from ..fitting.information import coverage

    q = np.concatenate([log.motion.q for log in data.role("train")])
    q = q[np.isfinite(q)]
    places = np.linspace(q.min(), q.max(), data.prototype.identify.basis_functions)
    return places, coverage(places, [q], [np.zeros((q.size, 0))]).visits.astype(np.float64)


def _numbers_of_log(data: RunData, log: LogData) -> tuple[float, float, float]:
    """Range of q, noise of q and share of rail samples of one log."""
    t = log.record["t"]
    quality = examine_signal(t, log.record["q"], sample_interval(t))
    # The differentiator works on the noise at the log's own rate; the record has what the filter left of it.
    notes = log.kinematics_notes
    of_q = notes.get("stretches", ()) if notes.get("of", "q") == "q" else ()
    stated = (s["noise_std"] * notes["unit_si"] for s in of_q if s.get("noise_std"))
    return (
        quality.largest - quality.smallest,
        min(max(stated, default=quality.noise), _noise_of_residual(data, log)),
        quality.low_rail + quality.high_rail,
    )


def _noise_of_residual(data: RunData, log: LogData) -> float:
    """Noise of q in the residual of the main model's free run, infinite where the residual does not show the sensor.

    Where the device moves within a few samples, differences of q contain motion: 1.0 mV on an electronic resonator
    whose model errs by 0.24 mV. Differences of the residual contain less of it. A decimated log has lost noise.
    """
    run = log.predictions.get(data.model_names[0])
    if run is None or log.record_notes.get("raw_step", 0.0) < NOT_DECIMATED * log.motion.interval:
        return np.inf
    residual = log.motion.q - run["q"]
    valid = residual[np.isfinite(residual) & log.motion.valid]
    return (noise_std(valid) or np.inf) if valid.size else np.inf
