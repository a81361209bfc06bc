"""All checks of a prototype's logs, as rows."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pipeline.checks import limits
from pipeline.checks.declared import Declared
from pipeline.checks.device_rows import device_rows
from pipeline.checks.input_rows import input_rows
from pipeline.checks.log_facts import log_facts
from pipeline.checks.motion_rows import motion_rows, start_rows
from pipeline.checks.rows import CheckRow
from pipeline.checks.weak_form import LogSignals

_MOSTLY = 0.5
"""Share of each half of a log that is not masked where the halves are compared."""


def check_logs(logs: Sequence[LogSignals], declared: Declared) -> list[CheckRow]:
    """Look at every log, then compare each with the first, which is a training log.

    Cost: 0.6 s of processor time for each log of 40,000 samples, half of it for its halves.
    """
    facts = [log_facts(log, declared.sample_interval, squared=declared.squared, joint=declared.joint) for log in logs]
    lags = [fact.lag for fact in facts if fact.lag is not None]  # a lag is the device's, so one log may show it for all
    facts = [replace(fact, lag=lags[0]) if lags and fact.lag is None else fact for fact in facts]
    rows = [row for fact in facts for row in (*motion_rows(fact, declared), *input_rows(fact, declared))]
    shown = {row.what for row in rows if row.state == "ok" and row.what.startswith("push")}  # in another log
    rows = [replace(row, state="not seen") if row.state == "note" and row.what in shown else row for row in rows]
    rows += start_rows(facts)
    beside = [row for other in facts[1:] for row in device_rows(facts[0], other, declared)]
    superseded = {(log, row.what) for row in beside for log in (facts[0].signals.name, row.log)}
    changes = [row for log in logs for row in _changes_within(log, declared)]
    return [*(row for row in rows if (row.log, row.what) not in superseded), *beside, *changes]


def _changes_within(log: LogSignals, declared: Declared) -> list[CheckRow]:
    """What differs between the halves of a joint's log, as two logs are compared; a worn joint changes a little too."""
    middle, measured = len(log.t) // 2, np.isfinite(log.q)
    long = np.ptp(log.t) >= 2.0 * limits.SURE_LENGTH * declared.sample_interval
    if not (declared.joint and long and min(measured[:middle].mean(), measured[middle:].mean()) > _MOSTLY):
        return []
    first, second = (
        log_facts(
            replace(log, name=f"{log.name}, {name} half", t=log.t[part], q=log.q[part], v=log.v[part]),
            declared.sample_interval, squared=declared.squared, joint=True,
        )
        for name, part in (("first", slice(middle)), ("second", slice(middle, None)))
    )  # fmt: skip
    advice = (
        "the log is not of one piece: were sensor, probes or leads touched in between? Then leave out what is before "
        "or behind that ({ file, start, stop } in [logs])"
    )
    return [
        replace(row, log=log.name, what=f"{row.what}, second half", state="note", gate=None, advice=advice)
        for row in device_rows(first, second, declared)
        if row.state == "wrong" or (row.state == "note" and row.what != "same device")
    ]
