"""All checks of a prototype's logs, as rows: each log by itself, without a model."""

from collections.abc import Sequence
from dataclasses import replace

from .declared import Declared
from .input_rows import input_rows
from .log_facts import log_facts
from .motion_rows import motion_rows, start_rows
from .rows import CheckRow
from .weak_form import LogSignals


def check_logs(logs: Sequence[LogSignals], declared: Declared) -> list[CheckRow]:
    """Look at every log; logs are compared by the fitted model, not here.

    Cost: 0.2 s of processor time for each log of 40,000 samples.
    """
    facts = [log_facts(log, declared.sample_interval, squared=declared.squared, joint=declared.joint) for log in logs]
    rows = [row for fact in facts for row in (*motion_rows(fact, declared), *input_rows(fact, declared))]
    shown = {row.what for row in rows if row.state == "ok" and row.what.startswith("push")}  # in another log
    rows = [replace(row, state="not seen") if row.state == "note" and row.what in shown else row for row in rows]
    return [*rows, *start_rows(facts)]
