"""Why prototypes of a batch failed: a text file for each, with what its process printed, until it does well."""

import re
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from ..store.atomic import write_text
from ..store.manifest import MANIFEST
from ..system.plain_files import read_plain
from .members import FAILED

_LARGEST = 1 << 20
_HEAD = re.compile(r"exit code (-?\d{1,10}): ([^\n]*)")


class Failure(NamedTuple):
    """How a prototype failed: exit code, reason in one line, and when [s since the epoch]."""

    exit_code: int
    reason: str
    time: float


def failure_file(output: Path, name: str) -> Path:
    """Where the failure of a prototype is kept."""
    return output / FAILED / f"{name}.txt"


def keep_failure(output: Path, name: str, exit_code: int, reason: str, printed: str) -> None:
    """Write down how a prototype failed, with what its process printed."""
    head = f"exit code {exit_code}: {' '.join(reason.split())}\n"
    write_text(failure_file(output, name), f"{head}\n{printed}", within=output)


def forget_failure(output: Path, name: str) -> None:
    """Remove it: the prototype is run again, or is up to date."""
    with suppress(OSError):
        failure_file(output, name).unlink(missing_ok=True)


def failure(output: Path, name: str) -> Failure | None:
    """How a prototype failed last; None where it did not, or where something was written into its run since."""
    path = failure_file(output, name)
    try:
        text = read_plain(path, _LARGEST).decode("utf-8", "replace")
        time = path.stat().st_mtime
    except OSError:
        return None
    head = _HEAD.match(text)
    if head is None or _changed(output / name) > time:
        return None
    return Failure(int(head[1]), head[2], time)


def failed_names(output: Path) -> list[str]:
    """The prototypes whose failure is kept."""
    return sorted(path.stem for path in (output / FAILED).glob("*.txt"))


def _changed(run: Path) -> float:
    """When the manifest of a run was written [s since the epoch]; 0 where there is none."""
    with suppress(OSError):
        return (run / MANIFEST).stat().st_mtime
    return 0.0
