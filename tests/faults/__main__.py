"""`python -m tests.faults`: every fault, or with `--sample` some of each kind; the counts go into the docs with a date.

A test counts what it tried in its docstring's sense through the fixture `count`; tests without it count as one.
"""

import platform
import re
import sys
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path

import pytest

from pipeline import __version__

PAGE = Path(__file__).resolve().parents[2] / "docs" / "reference" / "faults.md"
BEGIN, END = "<!-- counts: begin -->", "<!-- counts: end -->"
PLACES = (
    "tests/faults",
    "tests/runs/test_snapshots.py",
    "tests/runs/test_outputs.py",
    "tests/runs/test_verification.py",
    "tests/batch/test_hostile_places.py",
    "tests/rig_logs/test_hostile.py",
    "tests/test_units.py",
)


class Counter:
    """Collects from pytest what was counted, how it ended, and what it cost."""

    def __init__(self) -> None:
        self.rows: dict[str, list[object]] = {}

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Add one phase of a test to the row of its function."""
        if report.when == "setup" and report.passed:
            return
        name = re.sub(r"\[.*\]$", "", report.nodeid)
        tried, failed, skipped, seconds, said = self.rows.setdefault(name, [0, 0, 0, 0.0, []])
        properties = dict(report.user_properties)
        if report.when == "teardown":
            if "counted" in properties:
                said.append(properties["counted"])  # type: ignore[attr-defined]
            seconds = float(seconds) + float(properties.get("processor_seconds", 0.0))  # type: ignore[arg-type]
        elif report.skipped:
            skipped = int(skipped) + 1  # type: ignore[call-overload]
        else:
            tried = int(tried) + 1  # type: ignore[call-overload]
        failed = int(failed) + int(report.failed)  # type: ignore[call-overload]
        self.rows[name] = [tried, failed, skipped, seconds, said]


def page(counter: Counter, mode: str, kept: list[str]) -> str:
    """The block of the page, with the lines that are `kept` from before."""
    today = f"{datetime.now(UTC):%d %B %Y}"
    machine = f"{platform.system()} {platform.release()}, Python {platform.python_version()}, debist {__version__}"
    head = [
        f"Counted by `python -m tests.faults{mode}` on {today}, {machine}.",
        "",
        "| test | cases | failed | skipped | counted in them | processor time |",
        "|---|---|---|---|---|---|",
    ]
    rows = {line.split("`")[1]: line for line in kept if line.startswith("| `")}
    if kept:
        head = [line for line in kept if line and not line.startswith("| `")]
        head.insert(1, "")
    for name, (tried, failed, skipped, seconds, said) in counter.rows.items():
        told = "; ".join([*map(str, said), *([f"counted apart, {today}"] if kept else [])])  # type: ignore[call-overload]
        cost = f"{float(seconds):.0f} s" if seconds else ""  # type: ignore[arg-type]
        name = name.removeprefix("tests/")
        rows[name] = f"| `{name}` | {tried} | {failed} | {skipped} | {told} | {cost} |"
    return "\n".join([BEGIN, *head, *(rows[name] for name in sorted(rows)), END])


def main(arguments: Sequence[str]) -> int:
    """Run the tests and renew the page; pytest's exit code. Of tests that are named only their rows are renewed."""
    sample = "--sample" in arguments
    counter = Counter()
    chosen = [argument for argument in arguments if argument != "--sample"]
    code = pytest.main(
        [*(chosen or PLACES), "-q", "-m", "not long" if sample else "long or not long"], plugins=[counter]
    )
    text = PAGE.read_text(encoding="utf-8")
    before, _, rest = text.partition(BEGIN)
    block, _, after = rest.partition(END)
    kept = block.splitlines() if chosen else []
    PAGE.write_text(before + page(counter, " --sample" if sample else "", kept) + after, encoding="utf-8")
    return int(code)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
