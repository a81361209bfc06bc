"""`python -m tests.faults`: every fault, or with `--sample` some of each kind; the counts go into the docs with a date.

A test counts what it tried in its docstring's sense through the fixture `count`; tests without it count as one.
"""

import platform
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path

import pytest

from pipeline import __version__

PAGE = Path(__file__).resolve().parents[2] / "docs" / "reference" / "faults.md"
BEGIN, END = "<!-- counts: begin -->", "<!-- counts: end -->"
PLACES = (
    "tests/faults",
    "tests/runs/test_snapshots.py",
    "tests/runs/test_other_systems.py",
    "tests/runs/test_outputs.py",
    "tests/runs/test_trees.py",
    "tests/runs/test_verification.py",
    "tests/batch/test_hostile_places.py",
    "tests/rig_logs/test_hostile.py",
    "tests/test_units.py",
)


@dataclass
class Row:
    """The tests of one file."""

    tried: int = 0
    failed: int = 0
    skipped: int = 0
    seconds: float = 0.0
    counted: list[str] = field(default_factory=list)


class Counter:
    """Collects from pytest what was counted, how it ended, and what it cost."""

    def __init__(self) -> None:
        self.rows: dict[str, Row] = {}

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Add one phase of a test to the row of its file."""
        if report.when == "setup" and report.passed:
            return
        row = self.rows.setdefault(report.nodeid.partition("::")[0].removeprefix("tests/"), Row())
        properties = dict(report.user_properties)
        if report.when == "teardown":
            row.counted += [str(properties["counted"])] if properties.get("counted") else []
            row.seconds += float(properties.get("processor_seconds", 0.0))  # type: ignore[arg-type]
        elif report.skipped:
            row.skipped += 1
        else:
            row.tried += 1
        row.failed += int(report.failed)


def page(rows: dict[str, Row], mode: str) -> str:
    """The block of the page."""
    today = f"{datetime.now(UTC):%d %B %Y}"
    machine = f"{platform.system()} {platform.release()}, Python {platform.python_version()}, debist {__version__}"
    lines = [
        f"Counted by `python -m tests.faults{mode}` on {today}, {machine}.",
        "",
        "| tests | cases | failed | skipped | counted in them | processor time |",
        "|---|---|---|---|---|---|",
    ]
    for name, row in sorted(rows.items()):
        cost = f"{row.seconds:.0f} s" if row.seconds else ""
        counted = "; ".join(row.counted)
        lines.append(f"| `{name}` | {row.tried} | {row.failed} | {row.skipped} | {counted} | {cost} |")
    return "\n".join([BEGIN, *lines, END])


def main(arguments: Sequence[str]) -> int:
    """Run the tests and renew the page; pytest's exit code."""
    sample = "--sample" in arguments
    counter = Counter()
    code = pytest.main([*PLACES, "-q", "-m", "not long" if sample else "long or not long"], plugins=[counter])
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(BEGIN)
    text = before + page(counter.rows, " --sample" if sample else "") + rest.partition(END)[2]
    PAGE.write_text(text, encoding="utf-8")
    return int(code)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
