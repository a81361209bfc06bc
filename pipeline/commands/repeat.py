"""The comparison of two runs."""

from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

import typer

from pipeline.commands.console import emit_json, emit_table
from pipeline.errors import CorruptArtifactError
from pipeline.tools.repeat import STATES, Comparison

_ALARMING = ("differs", "missing")


def emit_comparison(run: Path, other: Path, found: Sequence[Comparison], *, as_json: bool) -> None:
    """Print what is not equal, and how many artifacts are.

    Raises
    ------
    CorruptArtifactError
        An artifact differs by more than rounding, or is missing.
    """
    if as_json:
        emit_json({"artifacts": [asdict(comparison) for comparison in found]})
    else:
        unequal = [c for c in found if c.state != "equal"]
        if unequal:
            rows = [
                (c.artifact, c.state, "" if c.deviation is None else f"{c.deviation:.1e}", c.column) for c in unequal
            ]
            emit_table(f"{run} and {other}", ("artifact", "state", "deviation", "in"), rows, numeric_from=2)
            for state in dict.fromkeys(c.state for c in unequal):
                typer.echo(f"{state}: {STATES[state]}")
        typer.echo(f"{len(found) - len(unequal)} of {len(found)} artifacts have the same content hash")
    apart = [comparison.artifact for comparison in found if comparison.state in _ALARMING]
    if apart:
        raise CorruptArtifactError(
            f"{run}: not the content of {other}: {', '.join(apart)}; compare settings and versions in both manifests"
        )
