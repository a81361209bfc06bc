"""`python -m tests.faults`: every fault, or with `--sample` some of each kind; prints the counts.

A test counts what it tried in its docstring's sense through the fixture `count`; tests without it count as one.
"""

import sys
from collections.abc import Sequence
from dataclasses import dataclass, field

import pytest

PLACES = (
    "tests/faults",
    "tests/runs/test_snapshots.py",
    "tests/runs/test_other_systems.py",
    "tests/runs/test_outputs.py",
    "tests/runs/test_trees.py",
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


def table(rows: dict[str, Row]) -> str:
    """One row for each file."""
    lines = [
        "| tests | cases | failed | skipped | counted in them | processor time |",
        "|---|---|---|---|---|---|",
    ]
    for name, row in sorted(rows.items()):
        cost = f"{row.seconds:.0f} s" if row.seconds else ""
        counted = "; ".join(row.counted)
        lines.append(f"| `{name}` | {row.tried} | {row.failed} | {row.skipped} | {counted} | {cost} |")
    return "\n".join(lines)


def main(arguments: Sequence[str]) -> int:
    """Run the tests and print the table; pytest's exit code."""
    sample = "--sample" in arguments
    counter = Counter()
    code = pytest.main([*PLACES, "-q", "-m", "not long" if sample else "long or not long"], plugins=[counter])
    print(table(counter.rows))
    return int(code)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
