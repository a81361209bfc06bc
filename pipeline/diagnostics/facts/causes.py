"""Why a log has a larger error than the training logs: its instruments, another device, one passage, extrapolation."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ...numerics.arrays import FloatArray
from ...scoring.wells import NoWells, Wells, snaps
from ...signals.findings import Finding, Number
from ...system.names import log_title
from .grades import THRESHOLDS
from .run_data import LogData, RunData

BRIEF = 0.1
"""Share of a log that one place lasts at most."""
MOST_OF_IT = 0.8
"""Share of the squared error that one place must make."""


def instrument_findings(data: RunData, model: str) -> list[Finding]:
    """Readings of the instruments beyond their limits; none in a run without a measurement of them."""
    rows = [row for row in data.instruments if row["model"] == model]
    findings = []
    logs = dict.fromkeys((row["role"], row["log"]) for row in rows)
    trained = [log for log in logs if log[0] == "train"]
    if len(trained) == 2:  # each is compared with the other: neither is the wrong one by that
        findings += _disagreements(rows, trained[0], log_title(*trained[1]), data.device.displacement.symbol)
        logs = dict.fromkeys(log for log in logs if log not in trained)
    for log in logs:
        of_log = [row for row in rows if (row["role"], row["log"]) == log]
        title = log_title(*log)
        if of_log[0]["status"] == "another device":
            ratio = Number(float(of_log[0]["residual_ratio"]))
            findings.append(Finding("another_device", "poor", title, numbers={"residual_ratio": ratio}))
            continue
        if of_log[0]["exchanged"] != "none":
            findings.append(Finding("exchanged", "poor", title, of_log[0]["exchanged"]))
        findings += [_instrument(row, title, data.device.displacement.symbol) for row in of_log if row["beyond"]]
    return findings


def _disagreements(
    rows: Sequence[Mapping[str, Any]], log: tuple[str, str], other: str, displacement: str
) -> list[Finding]:
    """What one of two training logs reads otherwise than the other one."""
    own = [row for row in rows if (row["role"], row["log"]) == log]
    if own[0]["exchanged"] != "none":
        return [Finding("unlike_training", "poor", log_title(*log), other)]
    found = [_instrument(row, log_title(*log), displacement) for row in own if row["beyond"]]
    return [replace(finding, code="disagreement", log=f"{finding.log} and the {other}") for finding in found]


def _instrument(row: Mapping[str, Any], title: str, displacement: str) -> Finding:
    unit = {"zero_q": displacement, "delay": "s"}.get(row["quantity"], "1")
    numbers = {
        "estimate": Number(float(row["estimate"]), unit, float(row["standard_error"])),
        "limit": Number(float(row["limit"]), unit),
        "correction": Number(float(row["correction"]), unit),
    }
    return Finding("instrument", "fair", title, row["quantity"], numbers)


def causes(data: RunData, worst: Mapping[str, Any], ratio: float, wells: Wells | NoWells) -> list[Finding]:
    """That a validation log has `ratio` times the error of the training logs, unless what was measured explains it.

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
        The passage over the barrier that makes it, nothing where instruments, another device or extrapolation have
        findings of their own, else the ratio itself.
    """
    title = log_title(worst["role"], worst["log"])
    severity = THRESHOLDS["generalisation"].grade(ratio)
    if severity == "good":
        return [Finding("generalisation", severity, title, worst["model"], {"ratio": Number(ratio)})]
    if any(finding.log == title for finding in instrument_findings(data, worst["model"])):
        return []
    if THRESHOLDS["outside"].grade(worst.get("outside_training") or 0.0) != "good":
        return []
    log = next(log for log in data.logs if (log.role, log.name) == (worst["role"], worst["log"]))
    passage = None if isinstance(wells, NoWells) else _one_passage(log, worst["model"], wells)
    if passage is not None:
        share, time = passage
        numbers = {"share": Number(share), "time": Number(time, "s"), "ratio": Number(ratio)}
        return [Finding("one_passage", "fair", title, worst["model"], numbers)]
    return [Finding("generalisation", severity, title, worst["model"], {"ratio": Number(ratio)})]


def _one_passage(log: LogData, model: str, wells: Wells) -> tuple[float, float] | None:
    """Share of the squared error behind one passage over the barrier, and when it is [s]; None where there is none.

    The passage is the slowest of the measured and the modelled ones within the tenth of the log that errs most.
    """
    if model not in log.predictions:
        return None
    q = np.asarray(log.kinematics["q"])
    own = np.asarray(log.predictions[model]["q"])
    squares = np.nan_to_num((q - own) ** 2)
    length = max(1, round(BRIEF * squares.size))
    sums = np.concatenate(([0.0], np.cumsum(squares)))
    windows = sums[length:] - sums[:-length]
    begin = int(np.argmax(windows))
    share = float(windows[begin] / sums[-1]) if sums[-1] > 0.0 else 0.0
    if share < MOST_OF_IT:
        return None
    crossings = [row for run in (q, own) for row in _crossings(run, wells) if begin - 1 <= row < begin + length]
    if not crossings:
        return None
    return share, float(log.kinematics["t"][_slowest(crossings, q, own)])


def _crossings(q: FloatArray, wells: Wells) -> Sequence[int]:
    return [int(row) for row in snaps(q, wells)]


def _slowest(crossings: Sequence[int], q: FloatArray, own: FloatArray) -> int:
    """The crossing at which measurement or model move least."""
    speeds = [
        min(abs(float(run[min(row + 1, run.size - 1)] - run[max(row - 1, 0)])) for run in (q, own)) for row in crossings
    ]
    return crossings[int(np.argmin(speeds))]
