"""The assessment of the main model: errors and their causes, wells, rivals, generalisation, trust."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ..scoring.wells import NoWells, Wells, snaps
from ..signals.findings import Finding, Number
from ..system.names import ROLE_WORDS, log_title
from .grades import THRESHOLDS, Check, graded, of_finding
from .run_data import LogData, RunData
from .sentences import unit_of

BRIEF = 0.1
"""Share of a log that one place lasts at most."""
MOST_OF_IT = 0.8
"""Least share of the squared error that one place causes."""
RIVAL_SURELY = 2e-3
"""A baseline is mentioned where it is surely better by more than this NRMSE."""


def instrument_findings(data: RunData, model: str) -> Iterator[Finding]:
    """Findings on instruments beyond their limits; none in a run that did not measure them."""
    rows = [row for row in data.instruments if row["model"] == model]
    logs = dict.fromkeys((row["role"], row["log"]) for row in rows)
    of_logs = {log: [row for row in rows if (row["role"], row["log"]) == log] for log in logs}
    displacement = data.device.displacement.symbol
    trained = [log for log in of_logs if log[0] == "train"]
    if len(trained) == 2:  # each was compared with the other, which does not show which one is wrong
        own, _ = (of_logs.pop(log) for log in trained)
        title, other = (log_title(*log) for log in trained)
        if own[0]["exchanged"] != "none":
            yield Finding("unlike_training", "poor", title, other)
        else:
            for finding in _beyond(own, f"{title} and the {other}", displacement):
                yield replace(finding, code="disagreement")
    for log, own in of_logs.items():
        title = log_title(*log)
        if own[0]["status"] == "another device":
            left = Number(float(own[0]["residual_ratio"]))
            yield Finding("another_device", "poor", title, numbers={"residual_ratio": left})
        else:
            if own[0]["exchanged"] != "none":
                yield Finding("exchanged", "poor", title, own[0]["exchanged"])
            yield from _beyond(own, title, displacement)


def _beyond(rows: Sequence[Mapping[str, Any]], title: str, displacement: str) -> Iterator[Finding]:
    """The instruments of a log that are off by more than their limits."""
    for row in rows:
        if row["beyond"]:
            unit = unit_of(row["quantity"], displacement)
            yield Finding(
                "instrument",
                "fair",
                title,
                row["quantity"],
                {
                    "estimate": Number(float(row["estimate"]), unit, float(row["standard_error"])),
                    "limit": Number(float(row["limit"]), unit),
                    "correction": Number(float(row["correction"]), unit),
                },
            )


def causes(data: RunData, worst: Mapping[str, Any], ratio: float, wells: Wells | NoWells) -> list[Finding]:
    """Findings on a validation log with `ratio` times the error of the training logs, unless a measurement explains it.

    Parameters
    ----------
    data : RunData
        The run.
    worst : mapping
        Row of the score table of the validation log with the largest error.
    ratio : float
        That error over the largest of the training logs.
    wells : Wells or NoWells
        Of the run.

    Returns
    -------
    list of Finding
        The passage over the barrier that causes the ratio, else the ratio itself. Empty where instruments, another
        device or extrapolation have findings of their own.
    """
    title = log_title(worst["role"], worst["log"])
    numbers = {"ratio": Number(ratio)}
    severity = THRESHOLDS["generalisation"].grade(ratio)
    if severity != "good":
        by_instruments = any(finding.log == title for finding in instrument_findings(data, worst["model"]))
        if by_instruments or THRESHOLDS["outside"].grade(worst.get("outside_training") or 0.0) != "good":
            return []
        log = next(log for log in data.logs if (log.role, log.name) == (worst["role"], worst["log"]))
        passage = {} if isinstance(wells, NoWells) else _one_passage(log, worst["model"], wells)
        if passage:
            return [Finding("one_passage", "fair", title, worst["model"], passage | numbers)]
    return [Finding("generalisation", severity, title, worst["model"], numbers)]


def _one_passage(log: LogData, model: str, wells: Wells) -> dict[str, Number]:
    """Share of the squared error behind one passage over the barrier, and when it is; empty where there is none.

    The passage is the slowest of the measured and the modelled ones within the tenth of the log that errs most.
    """
    if model not in log.predictions:
        return {}
    q = np.asarray(log.motion.q)
    own = np.asarray(log.predictions[model]["q"])
    squares = np.nan_to_num((q - own) ** 2)
    length = max(1, round(BRIEF * squares.size))
    sums = np.concatenate(([0.0], np.cumsum(squares)))
    windows = sums[length:] - sums[:-length]
    begin = int(np.argmax(windows))
    share = float(windows[begin] / sums[-1]) if sums[-1] > 0.0 else 0.0
    crossings = [row for run in (q, own) for row in snaps(run, wells).tolist() if begin - 1 <= row < begin + length]
    if share < MOST_OF_IT or not crossings:
        return {}

    def speed(row: int) -> float:
        """Change of q about a row, of measurement or model, whichever moves less."""
        return min(abs(float(run[min(row + 1, run.size - 1)] - run[max(row - 1, 0)])) for run in (q, own))

    return {"share": Number(share), "time": Number(float(log.motion.t[min(crossings, key=speed)]), "s")}


def model_checks(
    data: RunData, model: str, rest_errors: tuple[float, float] | None, wells: Wells | NoWells
) -> Iterator[Check]:
    """The main model: free-run error, wells, generalisation, and by how much its two rests err.

    Parameters
    ----------
    data : RunData
        The run.
    model : str
        The main model.
    rest_errors : (float, float) or None
        Errors of its rests left and right [m or rad].
    wells : Wells or NoWells
        The wells in the data.
    """
    by_role = {
        role: [s for s in data.scores if s["model"] == model and s["role"] == role and s["signal"] == "q"]
        for role in ("train", "validation")
    }
    judged, where = (by_role["validation"], "validation") if by_role["validation"] else (by_role["train"], "train")
    if where == "train":
        yield of_finding("model", Finding("validation", "fair", subject=f"{data.device.input_word}s"))
    yield from _ended_early(model, data.descriptions.get(model, {}), judged)
    errors = [s["nrmse"] for s in judged if s["nrmse"] is not None]
    if errors:
        yield graded("model", "nrmse", max(errors), log=f"worst {ROLE_WORDS[where]} log", subject=model)
    if isinstance(wells, NoWells):  # the scores then count rests as wells that are none
        judged = [{**s, "switch_accuracy": None, "outcomes": None} for s in judged]
    right = [s["switch_accuracy"] for s in judged if s["switch_accuracy"] is not None]
    if right:
        yield graded("model", "switch_accuracy", min(right))
    yield from _constant_checks(data, judged)
    yield from _rival_checks(data, judged)
    yield from (of_finding("data", finding) for finding in instrument_findings(data, model))
    yield from _trust_checks(judged)
    train = [s["nrmse"] for s in by_role["train"] if s["nrmse"]]
    # A still smaller error on the training data is no fault if the error is good.
    if where == "validation" and train and errors and max(errors) > THRESHOLDS["nrmse"].good:
        worst = max((s for s in judged if s["nrmse"] is not None), key=lambda score: score["nrmse"])
        yield from (of_finding("model", finding) for finding in causes(data, worst, max(errors) / max(train), wells))
    if rest_errors is not None and isinstance(wells, Wells):
        yield graded("model", "wells", max(abs(error) for error in rest_errors) / (wells.right - wells.left))


def _constant_checks(data: RunData, judged: Sequence[Mapping[str, Any]]) -> Iterator[Check]:
    """The log that its own mean predicts better, most of all."""
    beaten = [
        (own["nrmse"] / spread, spread, own)
        for own in judged
        if own["nrmse"] is not None and own["nrmse"] > (spread := _spread(data, own))
    ]
    if beaten:
        _, spread, own = max(beaten, key=lambda entry: entry[0])
        numbers = {"constant": Number(spread), "own": Number(own["nrmse"])}
        yield of_finding(
            "model", Finding("constant", "poor", log_title(own["role"], own["log"]), own["model"], numbers)
        )


def _spread(data: RunData, score: Mapping[str, Any]) -> float:
    """NRMSE of q of a constant, its mean, on the log of a score; infinite where q is constant."""
    q = next(log for log in data.logs if (log.role, log.name) == (score["role"], score["log"])).motion.q
    q = q[np.isfinite(q)]
    return float(np.std(q) / np.ptp(q)) if np.ptp(q) > 0.0 else np.inf


def _rival_checks(data: RunData, judged: Sequence[Mapping[str, Any]]) -> Iterator[Check]:
    """The log that another model of the run predicts surely better, most of all, or that this one diverged on."""
    checks = []
    for own in judged:
        others = {
            s["model"]: s["nrmse"]
            for s in data.scores
            if s["nrmse"] and all(s[key] == own[key] for key in ("role", "log", "signal"))
        }
        if others:
            best = min(others, key=others.__getitem__)
            if own["nrmse"] is None and others[best] < _spread(data, own):  # one that a constant beats is no help
                checks.append((np.inf, best, others[best], own))
            elif own["nrmse"] is not None and (own.get("above_lowest_low") or 0.0) > RIVAL_SURELY:
                checks.append((own["nrmse"] / others[best], best, others[best], own))
    if checks:
        ratio, best, error, own = max(checks, key=lambda check: check[0])
        log = log_title(own["role"], own["log"])
        subject = f"{best}, {own['model']}"
        if own["nrmse"] is None:  # a free run that diverged has no ratio
            yield of_finding("model", Finding("rival", "poor", log, subject, {"error": Number(error)}))
        else:
            numbers = {"error": Number(error), "own": Number(own["nrmse"])}
            yield graded("model", "rival", ratio, log=log, subject=subject, numbers=numbers)


def _ended_early(model: str, description: Mapping[str, Any], judged: Sequence[Mapping[str, Any]]) -> Iterator[Check]:
    """A fit that had not converged, and free runs that diverged."""
    if description.get("converged") is False:
        yield of_finding("model", Finding("converged", "fair", subject=model))
    times = {str(s["log"]): Number(float(s["diverged_at_s"]), "s") for s in judged if s["status"] != "ok"}
    if times:
        yield of_finding("model", Finding("divergence", "poor", subject=model, numbers=times))


def _trust_checks(judged: Sequence[Mapping[str, Any]]) -> Iterator[Check]:
    """Ambiguous switching outcomes, and states outside the training data."""
    outcomes = sum(s.get("outcomes") or 0 for s in judged)
    if outcomes:
        open_ones = sum(s.get("ambiguous_outcomes") or 0 for s in judged)
        yield graded(
            "model",
            "ambiguous",
            open_ones / outcomes,
            numbers={"open": Number(open_ones), "outcomes": Number(outcomes)},
        )
    known = (s for s in judged if s.get("outside_training") is not None)
    most = max(known, key=lambda score: score["outside_training"], default=None)
    if most is not None:
        check = graded("model", "outside", float(most["outside_training"]), log=log_title(most["role"], most["log"]))
        right = all(s["nrmse"] is not None and THRESHOLDS["nrmse"].grade(s["nrmse"]) == "good" for s in judged)
        yield replace(check, grade="fair") if right and check.grade == "poor" else check
