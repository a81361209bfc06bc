"""The verdict on data and models: every threshold of a grade stands here, with its reason."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from pipeline.device_facts.run_data import LogData, RunData
from pipeline.identification.coverage import coverage
from pipeline.names import ROLE_WORDS, log_title
from pipeline.numerics.arrays import FloatArray, sample_interval
from pipeline.scoring.wells import NoWells, Wells, snaps
from pipeline.si_prefix import moment, percent, quantity, significant
from pipeline.signals.inputs import voltages
from pipeline.signals.noise import below_resolution, noise_std, rounding
from pipeline.signals.signal_quality import examine_signal

Grade = Literal["good", "fair", "poor"]
GRADES: tuple[Grade, ...] = ("good", "fair", "poor")
RIVAL_SURELY = 2e-3
"""NRMSE by which a baseline must surely be nearer before it is told."""
NOT_DECIMATED = 0.9
"""Least sample interval of a log over that of its kinematics at which both have the same noise."""


@dataclass(frozen=True)
class Threshold:
    """Up to `good` a number is good, up to `fair` fair, beyond it poor; the other way round if `more_is_better`."""

    good: float
    fair: float
    reason: str
    more_is_better: bool = False

    def grade(self, value: float) -> Grade:
        """The grade of a value."""
        sign = -1.0 if self.more_is_better else 1.0
        if sign * value <= sign * self.good:
            return "good"
        return "fair" if sign * value <= sign * self.fair else "poor"


THRESHOLDS = {
    "masked": Threshold(0.01, 0.1, "every gap costs two filter lengths of rows, and a free run must pass it unchecked"),
    "noise": Threshold(1e-3, 1e-2, "noise of 0.1 % of the range is a twentieth of the paper's model error (2.1 %)"),
    "rails": Threshold(1e-3, 1e-2, "samples at a sensor's rail are no measurement, and bend the curves there"),
    "switches": Threshold(
        10, 4, "the force between the wells is only seen while the device snaps, 0.1 s at a time", True
    ),
    "coverage": Threshold(
        20, 5, "samples per basis centre: below five, its weights follow noise and ridge, not data", True
    ),
    "extrapolation": Threshold(0.01, 0.05, "outside the range of the training data curves are continued, not measured"),
    "nrmse": Threshold(0.021, 0.057, "2.1 % is what the paper's RBF model reaches for q, 5.7 % its analytical one"),
    "lyapunov": Threshold(0.057, 0.155, "the limits of nrmse times e: what an error has grown to by chaos alone"),
    "rival": Threshold(1.0, 4.0, "times the error of the best baseline: where one is surely nearer, take that one"),
    "switch_accuracy": Threshold(0.99, 0.9, "one wrong well costs a whole stroke until the next pulse", True),
    "ambiguous": Threshold(0.1, 0.3, "ambiguous outcomes come true about half of the time on simulated prototypes"),
    "outside": Threshold(0.01, 0.05, "in states (q, q̇) that no training sample was near the model is a guess"),
    "generalisation": Threshold(
        3.0, 10.0, "validation over training error: a model that has learnt the noise shows a large ratio"
    ),
    "measured_facts": Threshold(
        2.5, 5.0, "standard deviations between model and measurement: beyond 2.5 chance explains one fact in eighty"
    ),
    "wells": Threshold(
        0.03, 0.1, "a rest between pulses still creeps and rings by 1 to 3 % of the distance of the wells"
    ),
}

OF_WELLS = ("switches", "switch_accuracy", "ambiguous", "wells")
"""Thresholds that say nothing of a device without two wells."""

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
"""What leaves rows without a measurement: ingest's note with its number, one and several of it, and what to do."""


@dataclass(frozen=True)
class Check:
    """One judged number: what it is, its grade, the sentence with the number, and what to do unless it is good."""

    about: Literal["data", "model"]
    name: str
    grade: Grade
    statement: str
    advice: str


def overall(checks: Iterable[Check]) -> Grade:
    """The worst grade of all."""
    return max((check.grade for check in checks), key=GRADES.index, default="good")


def data_checks(data: RunData, wells: Wells | NoWells) -> list[Check]:
    """The measurement: gaps, noise, rails, excitation, and whether validation stays inside the training range."""
    advice = "judge every number with that in mind, or record again without it"
    checks = [Check("data", "accepted", "poor", f"used all the same: {text}", advice) for text in data.accepted]
    checks.append(_masked_check(data))
    span, noise, rails = _signal_numbers(data)
    checks.append(_noise_check(data, span, noise))
    share = percent(rails) if rails > 0.0 else "none"
    text = f"{share} of the samples of q stay at its largest or smallest value"
    if data.rails_kept and rails > 0.0:  # the user has said what they are
        checks.append(Check("data", "rails", "good", f'{text}, where it rests ([ingest] rails = "keep")', ""))
    else:
        checks.append(_check("data", "rails", rails, text, RAILS_ADVICE))
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
        checks.append(_check("data", "switches", count, text, advice))
    checks += _coverage_checks(data)
    return checks + _extrapolation_checks(data)


def _masked_check(data: RunData) -> Check:
    """Rows that are no measurement, what made them so, and what to do about each; the ends of a log that were cut off
    count.
    """
    cut = sum(float(log.record_notes.get("cut_off_s", 0.0)) / log.interval for log in data.logs)
    rows = sum(len(log.kinematics["t"]) for log in data.logs) + cut
    masked = (sum(int(np.count_nonzero(log.kinematics["segment"] < 0)) for log in data.logs) + cut) / rows
    counts = [
        (sum(int(log.record_notes.get(key, 0)) for log in data.logs), one, several, advice)
        for key, one, several, advice in MASKS
    ]
    named = [f"{count} {one if count == 1 else several}" for count, one, several, _ in counts if count]
    what = " and ".join(named)
    if masked:
        text = f"{percent(masked)} of the rows are masked, by {what or 'samples that are not finite'}"
    else:
        text = f"{what} left out, and no row masked" if what else "no gaps"
    advice = "; ".join(advice for count, _, _, advice in counts if count and advice) or "repair the recorder"
    return _check("data", "masked", masked, text, advice)


def _extrapolation_checks(data: RunData) -> list[Check]:
    """Validation samples outside the range of the training data."""
    outside = _outside(data)
    if outside is None:
        return []
    share = percent(outside) if outside > 0.0 else "none"
    text = f"{share} of the validation samples lie outside the range of the training data"
    advice = f"train on a log with the larger strokes and {data.input_word}s"
    return [_check("data", "extrapolation", outside, text, advice)]


def _coverage_checks(data: RunData) -> list[Check]:
    """Samples at the centres between the outermost two, where the range is over however often it is visited."""
    inner = centre_visits(data)[1][1:-1]
    if inner.size == 0:
        return []
    samples = f"{int(inner.min())} training sample{'s' if inner.min() != 1.0 else ''}"
    text = f"the least visited of {inner.size} basis centres inside the range has {samples} around it"
    fills = ", `debist rig excite` fills them" if data.joint else ""
    advice = f"excite the thin places (`debist inspect` names them{fills}); or fewer centres"
    return [_check("data", "coverage", float(inner.min()), text, advice)]


def _noise_check(data: RunData, span: float, noise: float) -> Check:
    """Noise over the range of q [both m or rad], or where the sensor's steps hide it, what these round off."""
    steps = max(log.record_notes.get("resolution") or 0.0 for log in data.logs)
    if below_resolution(noise, steps):
        share = significant(100.0 * steps / span, 2)
        text = (
            f"q comes in steps of {quantity(steps, data.displacement)}, {share} % of its range; its noise is below that"
        )
        return _check("data", "noise", rounding(steps) / span, text, "use the sensor's finer range")
    text = (
        f"noise of q is {quantity(noise, data.displacement)} RMS, {significant(100.0 * noise / span, 2)} % of its range"
    )
    return _check("data", "noise", noise / span, text, "average or shield the sensor, or raise alpha")


def model_checks(
    data: RunData, model: str, rest_errors: tuple[float, float] | None, wells: Wells | NoWells
) -> list[Check]:
    """The headline model: free-run error, wells, generalisation, and by how much its two rests err."""
    by_role = {
        role: [s for s in data.scores if s["model"] == model and s["role"] == role and s["signal"] == "q"]
        for role in ("train", "validation")
    }
    judged, where = (by_role["validation"], "validation") if by_role["validation"] else (by_role["train"], "train")
    checks = [] if where == "validation" else [_no_validation(data)]
    checks += _ended_early(model, data.descriptions.get(model, {}), judged)
    chaotic = [s for s in judged if s.get("lyapunov_per_s")]
    checks += _chaos_checks(chaotic, model)
    judged = [s for s in judged if s not in chaotic]
    errors = [s["nrmse"] for s in judged if s["nrmse"] is not None]
    if errors:
        text = f"free-run NRMSE of q of {model} is {percent(max(errors))} on the worst {ROLE_WORDS[where]} log"
        causes = f"at one switch (friction, {data.input_word} delay) or throughout (alpha, centres)"
        checks.append(_check("model", "nrmse", max(errors), text, f"look where residuals grow: {causes}"))
    if isinstance(wells, NoWells):  # what the scores say of wells is of rests that are none
        judged = [{**s, "switch_accuracy": None, "outcomes": None} for s in judged]
    right = [s["switch_accuracy"] for s in judged if s["switch_accuracy"] is not None]
    if right:
        share = percent(min(right)) if min(right) < 1.0 else "all"
        text = f"{share} of the pulses end in the well that was measured"
        advice = "near the switching voltage the outcome is sensitive: train on pulses of that size"
        checks.append(_check("model", "switch_accuracy", min(right), text, advice))
    checks += [*_constant_checks(data, judged), *_rival_checks(data, judged)]
    checks += _trust_checks(judged)
    train = [s["nrmse"] for s in by_role["train"] if s["nrmse"] and not s.get("lyapunov_per_s")]
    # Beside an error that is good as it is, a yet smaller one on the training data is no fault.
    if where == "validation" and train and errors and max(errors) > THRESHOLDS["nrmse"].good:
        ratio = max(errors) / max(train)
        text = f"the validation error is {significant(ratio, 2)} times the training error"
        checks.append(_check("model", "generalisation", ratio, text, "fewer basis functions, or richer training logs"))
    if rest_errors is not None and isinstance(wells, Wells):
        off = max(abs(error) for error in rest_errors) / (wells.right - wells.left)
        text = f"modelled and measured rests differ by up to {percent(off)} of the distance of the wells"
        checks.append(_check("model", "wells", off, text, "longer rests at zero voltage in both wells, for training"))
    return checks


def _no_validation(data: RunData) -> Check:
    new = f"an error on the training data says nothing of new {data.input_word}s"
    text, advice = "no validation log: errors are those of training", f"add a log under [logs] validation: {new}"
    return Check("model", "validation", "fair", text, advice)


def _constant_checks(data: RunData, judged: Sequence[Mapping[str, Any]]) -> list[Check]:
    """Logs that their own mean predicts better."""
    found = []
    for own in judged:
        spread = _spread(data, own)
        if own["nrmse"] is not None and own["nrmse"] > spread:
            found.append((own["nrmse"] / spread, spread, own))
    if not found:
        return []
    _, spread, own = max(found, key=lambda each: each[0])
    text = (
        f"a constant, its mean, predicts the {log_title(own['role'], own['log'])} better than {own['model']}: "
        f"{percent(spread)} for {percent(own['nrmse'])}"
    )
    advice = (
        "do not use this model; see whether the inputs act linearly or by their squares ([plant] inputs), and whether "
        "a controller held the device where it is unstable: free runs of such a log part from it whatever the model"
    )
    return [Check("model", "constant", "poor", text, advice)]


def _spread(data: RunData, score: Mapping[str, Any]) -> float:
    """NRMSE of q of a constant, its mean, on the log of a score; infinite where q is constant."""
    q = next(log for log in data.logs if (log.role, log.name) == (score["role"], score["log"])).kinematics["q"]
    q = q[np.isfinite(q)]
    return float(np.std(q) / np.ptp(q)) if np.ptp(q) > 0.0 else np.inf


def _rival_checks(data: RunData, judged: Sequence[Mapping[str, Any]]) -> list[Check]:
    """Where another model of the run predicts a log surely better, or at all where this one diverged."""
    rivals = {(s["role"], s["log"], s["model"]): s["nrmse"] for s in data.scores if s["signal"] == "q"}
    found = []
    for own in judged:
        others = {m: e for (*log, m), e in rivals.items() if e and log == [own["role"], own["log"]]}
        if not others:
            continue
        best = min(others, key=lambda name: others[name])
        if own["nrmse"] is None and others[best] < _spread(data, own):  # one that a constant beats is no help
            found.append((np.inf, best, others[best], own))
        elif own["nrmse"] is not None and (own.get("above_lowest_low") or 0.0) > RIVAL_SURELY:
            found.append((own["nrmse"] / others[best], best, others[best], own))
    if not found:
        return []
    ratio, best, error, own = max(found, key=lambda each: each[0])
    name, log = own["model"], log_title(own["role"], own["log"])
    if own["nrmse"] is None:
        text = f"{best} predicts the {log} with {percent(error)}, where {name} diverged"
    else:
        text = f"{best} predicts the {log} surely better than {name}: {percent(error)} for {percent(own['nrmse'])}"
    advice = (
        f"take {best} for predictions (`--model {best}`), or help {name}: more and longer logs, or decide what is "
        "known of the device in [identify] (force, damping, drag, gain, friction, drive)"
    )
    return [_check("model", "rival", ratio, text, advice)]


def not_converged(model: str) -> tuple[str, str]:
    """What is said of such a fit, and what to do."""
    advice = "raise [identify] time_limit, or simplify the model (force, damping, gain, friction)"
    return f"the fit of {model} had not converged when it ended, so its error may be chance", advice


def _ended_early(model: str, description: Mapping[str, Any], judged: Sequence[Mapping[str, Any]]) -> list[Check]:
    """A fit that had not converged, and free runs that diverged."""
    checks = []
    if description.get("converged") is False:
        checks.append(Check("model", "converged", "fair", *not_converged(model)))
    diverged = [s for s in judged if s["status"] != "ok"]
    if diverged:
        at = ", ".join(f"{s['log']} at t = {moment(s['diverged_at_s'])}" for s in diverged)
        advice = "see its last second under “Measured against models”; train on data that reach as far"
        checks.append(Check("model", "divergence", "poor", f"the free run of {model} diverged: {at}", advice))
    return checks


def _chaos_checks(chaotic: Sequence[Mapping[str, Any]], model: str) -> list[Check]:
    """Free runs that part from any that start beside them: judged after the time in which they do so e-fold."""
    checks = []
    for s in chaotic:
        error, after = s.get("nrmse_lyapunov"), f"{1.0 / s['lyapunov_per_s']:.2g} s"
        if error is not None:
            text = (
                f"{s['log']} is chaotic (free runs part e-fold in {after}); "
                f"{model} errs by {percent(error)} after that time"
            )
            checks.append(_check("model", "lyapunov", error, text, "a smaller sample interval, or a richer structure"))
    return checks


def _trust_checks(judged: Sequence[Mapping[str, Any]]) -> list[Check]:
    """Outcomes that hinge on less than the model knows, and states that it was never trained on."""
    checks = []
    outcomes = sum(s.get("outcomes") or 0 for s in judged)
    if outcomes:
        open_ones = sum(s.get("ambiguous_outcomes") or 0 for s in judged)
        text = f"{open_ones or 'none'} of {outcomes} outcomes after pulses are too close for the model to call"
        advice = "do not trust the well after these pulses; train on pulses of that size and length"
        checks.append(_check("model", "ambiguous", open_ones / outcomes, text, advice))
    outside = [s["outside_training"] for s in judged if s.get("outside_training") is not None]
    if outside:
        share = percent(max(outside)) if max(outside) > 0.0 else "none"
        text = f"{share} of the samples lie in states (q, q̇) that no training sample was near"
        found = _check("model", "outside", max(outside), text, "train on motions as large and as fast")
        errors = [s["nrmse"] for s in judged]
        right = all(error is not None and THRESHOLDS["nrmse"].grade(error) == "good" for error in errors)
        checks.append(replace(found, grade="fair") if right and found.grade == "poor" else found)
    return checks


def _check(about: Literal["data", "model"], name: str, value: float, statement: str, advice: str) -> Check:
    return Check(about, name, THRESHOLDS[name].grade(value), statement, advice)


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
        found = examine_signal(t, q, sample_interval(t))
        spans.append(found.largest - found.smallest)
        rails.append(found.low_rail + found.high_rail)
        # The differentiator sees the noise at the log's own rate; the record's is what the filter left of it.
        notes = log.kinematics_notes
        of_q = notes.get("stretches", ()) if notes.get("of", "q") == "q" else ()
        stated = [s["noise_std"] * notes["unit_si"] for s in of_q if s.get("noise_std")]
        noises.append(min(max(stated, default=found.noise), _noise_of_residual(data, log)))
    return max(spans) or 1.0, max(noises), max(rails)


def _noise_of_residual(data: RunData, log: LogData) -> float:
    """Noise of q in what the headline's free run leaves, infinite where that says nothing of the sensor.

    Where the device moves within a few samples, differences of q take motion for noise (1.0 mV on an electronic
    resonator whose model errs by 0.24 mV); those of the residual have less of it. A log that was decimated has lost
    noise.
    """
    run = log.predictions.get(data.model_names[0])
    if run is None or log.record_notes.get("raw_step", 0.0) < NOT_DECIMATED * log.interval:
        return np.inf
    residual = log.kinematics["q"] - run["q"]
    known = residual[np.isfinite(residual) & (log.kinematics["segment"] >= 0)]
    return noise_std(known) or np.inf if known.size else np.inf


def _outside(data: RunData) -> float | None:
    validation = data.role("validation")
    if not validation:
        return None
    seen = [np.column_stack((log.kinematics["q"], voltages(log.kinematics))) for log in data.role("train")]
    low, high = np.nanmin(np.concatenate(seen), axis=0), np.nanmax(np.concatenate(seen), axis=0)
    rows = np.concatenate([np.column_stack((g.kinematics["q"], voltages(g.kinematics))) for g in validation])
    margin = 0.01 * (high - low)
    with np.errstate(invalid="ignore"):
        beyond = np.any((rows < low - margin) | (rows > high + margin), axis=1)
    return float(np.mean(beyond))
