"""All checks of a prototype's logs, as rows."""

from collections.abc import Sequence
from dataclasses import replace

from pipeline.checks.declared import Declared
from pipeline.checks.device_rows import device_rows
from pipeline.checks.input_rows import input_rows
from pipeline.checks.log_facts import log_facts
from pipeline.checks.motion_rows import motion_rows, start_rows
from pipeline.checks.rows import CheckRow
from pipeline.checks.weak_form import LogSignals


def check_logs(logs: Sequence[LogSignals], declared: Declared) -> list[CheckRow]:
    """Look at every log, then compare each with the first, which is a training log.

    Cost: 0.3 s of processor time for each log of 40,000 samples.
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
    return [*(row for row in rows if (row.log, row.what) not in superseded), *beside]
