"""The verdict on the measurement: gaps, noise, rails, excitation, and whether validation stays inside training."""

import re

import numpy as np

from pipeline.device_facts.grades import Check, graded
from pipeline.device_facts.run_data import LogData, RunData
from pipeline.fitting.coverage import coverage
from pipeline.numerics.arrays import FloatArray, sample_interval
from pipeline.scoring.wells import NoWells, Wells, snaps
from pipeline.si_prefix import percent, quantity, significant
from pipeline.signals.noise import below_resolution, noise_std, rounding
from pipeline.signals.signal_quality import examine_signal
from pipeline.signals.trajectory import voltages

NOT_DECIMATED = 0.9
"""Least sample interval of a log over that of its kinematics at which both have the same noise."""

RAILS_ADVICE = 'widen the sensor\'s range, or where the device does rest there set [ingest] rails = "keep"'

MASKS = (
    (
        "masked_without_target", "sample without a target", "samples without a target",
        'keep the target within the sensor\'s sight, or where the device does rest there set [ingest] lost = "keep"',
    ),
    (
        "masked_at_rails", "sample at the ends of q's range", "samples at the ends of q's range",
        RAILS_ADVICE,
    ),
    ("masked_spikes", "spike", "spikes", ""),  # single samples: no row is lost to them alone
    (
        "gaps_in_time", "gap in the recording", "gaps in the recording",
        "repair the recorder, or record again what the gaps cut",
    ),
)  # fmt: skip
"""Causes of rows without a measurement: ingest's note with the number, its noun and plural, and what to do."""


DEALT_WITH = re.compile(
    r"masked|split there|start anew|not finite|single-sample|extreme .*saturated|kept|interpolated$|accepted"
    r"|taken as uniform|a clock of its own"
)
"""Remarks on what is left out of fits and scores, or what the user has decided on."""


def data_checks(data: RunData, wells: Wells | NoWells) -> list[Check]:
    """The measurement: gaps, noise, rails, excitation, and whether validation stays inside the training range."""
    advice = "judge every number with that in mind, or record again without it"
    checks = [Check("data", "accepted", "poor", f"used all the same: {text}", advice) for text in data.accepted]
    checks += _remark_checks(data)
    checks.append(_masked_check(data))
    span, noise, rails = _signal_numbers(data)
    checks.append(_noise_check(data, span, noise))
    share = percent(rails) if rails > 0.0 else "none"
    text = f"{share} of the samples of q stay at its largest or smallest value"
    if data.rails_kept and rails > 0.0:  # the user has said what they are
        checks.append(Check("data", "rails", "good", f'{text}, where it rests ([ingest] rails = "keep")', ""))
    else:
        checks.append(graded("data", "rails", rails, text, RAILS_ADVICE))
    train = data.role("train")
    if isinstance(wells, NoWells):
        if data.joint:  # another device need not have two
            advice = "if the device is bistable, pulse both sides with rests of 1 s between"
            checks.append(Check("data", "switches", "fair", f"no two wells in the data: {wells.reason}", advice))
    else:
        count = sum(len(snaps(log.kinematics["q"], wells)) for log in train)
        text = f"the training logs switch wells {count} times"
        advice = "record more pulses that snap it both ways" + (
            "; `debist rig excite` designs a sequence" if data.joint else ""
        )
        checks.append(graded("data", "switches", count, text, advice))
    checks += _coverage_checks(data)
    return checks + _extrapolation_checks(data)


def _remark_checks(data: RunData) -> list[Check]:
    """Every remark on a log, and every (!) of the checks; what was masked or split is graded by its share."""
    advice = "see to it, or judge every number with that in mind"
    remarks = [
        (log.title, str(text))
        for log in data.logs
        for text in log.record_notes.get("warnings", ())
        if text not in log.record_notes.get("accepted", ())  # which have a row of their own
    ]
    checks = [
        Check("data", "remark", "good" if DEALT_WITH.search(text) else "fair", f"{title}: {text}", advice)
        for title, text in remarks
        if text not in data.accepted
    ]
    return checks + [
        Check("data", "check", "fair", f"{row['log']}: {row['what']}: {row['found']}", row["advice"])
        for row in data.log_checks
        if row["state"] == "note"
    ]


def _masked_check(data: RunData) -> Check:
    """Rows that are no measurement, what made them so, and what to do about each; the ends of a log that were cut off
    count.
    """
    cut = sum(float(log.record_notes.get("cut_off_s", 0.0)) / log.interval for log in data.logs)
    rows = sum(len(log.kinematics["t"]) for log in data.logs) + cut
    masked = (sum(int(np.count_nonzero(log.kinematics["segment"] < 0)) for log in data.logs) + cut) / rows
    counts = [
        (sum(int(log.record_notes.get(key, 0)) for log in data.logs), single, several, advice)
        for key, single, several, advice in MASKS
    ]
    named = [f"{count} {single if count == 1 else several}" for count, single, several, _ in counts if count]
    what = " and ".join(named)
    if masked:
        text = f"{percent(masked)} of the rows are masked, by {what or 'samples that are not finite'}"
    else:
        text = f"{what} left out, and no row masked" if what else "no gaps"
    advice = "; ".join(advice for count, _, _, advice in counts if count and advice) or "repair the recorder"
    return graded("data", "masked", masked, text, advice)


def _extrapolation_checks(data: RunData) -> list[Check]:
    """Validation samples outside the range of the training data."""
    outside = _outside(data)
    if outside is None:
        return []
    share = percent(outside) if outside > 0.0 else "none"
    text = f"{share} of the validation samples lie outside the range of the training data"
    advice = f"train on a log with the larger strokes and {data.input_word}s"
    return [graded("data", "extrapolation", outside, text, advice)]


def _coverage_checks(data: RunData) -> list[Check]:
    """Samples at the centres between the outermost two, which lie at the ends of the range."""
    inner = centre_visits(data)[1][1:-1]
    if inner.size == 0:
        return []
    samples = f"{int(inner.min())} training sample{'s' if inner.min() != 1.0 else ''}"
    text = f"the least visited of {inner.size} basis centres inside the range has {samples} around it"
    fills = ", `debist rig excite` fills them" if data.joint else ""
    advice = f"excite the thin places (`debist inspect` names them{fills}); or fewer centres"
    return [graded("data", "coverage", float(inner.min()), text, advice)]


def _noise_check(data: RunData, span: float, noise: float) -> Check:
    """Noise over the range of q [both m or rad], or where the sensor's steps hide it, what these round off."""
    steps = max(log.record_notes.get("resolution") or 0.0 for log in data.logs)
    if below_resolution(noise, steps):
        share = significant(100.0 * steps / span, 2)
        text = (
            f"q comes in steps of {quantity(steps, data.displacement)}, {share} % of its range; its noise is below that"
        )
        return graded("data", "noise", rounding(steps) / span, text, "use the sensor's finer range")
    text = (
        f"noise of q is {quantity(noise, data.displacement)} RMS, {significant(100.0 * noise / span, 2)} % of its range"
    )
    return graded("data", "noise", noise / span, text, "average or shield the sensor, or raise alpha")


def centre_visits(data: RunData) -> tuple[FloatArray, FloatArray]:
    """Centres over the training range [m or rad], and the training samples nearest to each, both (centres,)."""
    q = np.concatenate([log.kinematics["q"] for log in data.role("train")])
    q = q[np.isfinite(q)]
    places = np.linspace(q.min(), q.max(), data.centres)
    return places, coverage(places, [q], [np.zeros((q.size, 0))]).visits.astype(np.float64)


def _signal_numbers(data: RunData) -> tuple[float, float, float]:
    """Range of q, its largest noise and rail share over the logs."""
    spans, noises, rails = [], [], []
    for log in data.logs:
        t, q = log.record["t"], log.record["q"]
        quality = examine_signal(t, q, sample_interval(t))
        spans.append(quality.largest - quality.smallest)
        rails.append(quality.low_rail + quality.high_rail)
        # The differentiator works on the noise at the log's own rate; the record has what the filter left of it.
        notes = log.kinematics_notes
        of_q = notes.get("stretches", ()) if notes.get("of", "q") == "q" else ()
        stated = [s["noise_std"] * notes["unit_si"] for s in of_q if s.get("noise_std")]
        noises.append(min(max(stated, default=quality.noise), _noise_of_residual(data, log)))
    return max(spans) or 1.0, max(noises), max(rails)


def _noise_of_residual(data: RunData, log: LogData) -> float:
    """Noise of q in the residual of the headline's free run, infinite where the residual does not show the sensor.

    Where the device moves within a few samples, differences of q take motion for noise (1.0 mV on an electronic
    resonator whose model errs by 0.24 mV); those of the residual have less of it. A log that was decimated has lost
    noise.
    """
    run = log.predictions.get(data.model_names[0])
    if run is None or log.record_notes.get("raw_step", 0.0) < NOT_DECIMATED * log.interval:
        return np.inf
    residual = log.kinematics["q"] - run["q"]
    valid = residual[np.isfinite(residual) & (log.kinematics["segment"] >= 0)]
    return noise_std(valid) or np.inf if valid.size else np.inf


def _outside(data: RunData) -> float | None:
    validation = data.role("validation")
    if not validation:
        return None
    trained = [np.column_stack((log.kinematics["q"], voltages(log.kinematics))) for log in data.role("train")]
    low, high = np.nanmin(np.concatenate(trained), axis=0), np.nanmax(np.concatenate(trained), axis=0)
    rows = np.concatenate([np.column_stack((g.kinematics["q"], voltages(g.kinematics))) for g in validation])
    margin = 0.01 * (high - low)
    rows = rows[np.isfinite(rows).all(axis=1)]
    beyond = np.any((rows < low - margin) | (rows > high + margin), axis=1)
    return float(np.mean(beyond)) if rows.size else None
