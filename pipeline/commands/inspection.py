"""A raw log's inspection as tables, and `debist check`: are the logs what the settings say?"""

from collections.abc import Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated, Any

import typer

from pipeline.commands.console import Json, Progress, PrototypeFile, Quiet, emit_json, emit_table, emit_text
from pipeline.commands.excitation import emit_visits
from pipeline.si_prefix import quantity

if TYPE_CHECKING:
    from pipeline.checks.rows import CheckRow
    from pipeline.rig_logs.inspection import InspectedChannel, Inspection
    from pipeline.signals.timebase import TimeQuality
    from pipeline.tools.inspection import LogExcitation


def inspection_document(inspection: "Inspection", excitation: "LogExcitation | str") -> Any:
    """Everything for `--json`: the log in its own units, the excitation in SI; without one, the reason."""
    from pipeline.runs.manifest import to_json

    if isinstance(excitation, str):
        coverage: dict[str, Any] = {"excitation": None, "excitation_reason": excitation}
    else:
        shown = {name: value for name, value in asdict(excitation).items() if name not in ("factor", "unit", "joint")}
        coverage = {"excitation": shown}
    return to_json(asdict(inspection) | coverage)


def emit_inspection(inspection: "Inspection", excitation: "LogExcitation | str") -> None:
    """Print the channels, the time bases, the notes, and what the log excites."""
    from pipeline.rig_logs.remarks import stamped

    emit_table(
        f"{inspection.path}: {inspection.format}, {inspection.size / 1e6:.2f} MB",
        ("channel", "unit", "samples", "smallest", "largest", "time base", "remarks"),
        [_channel_row(channel) for channel in inspection.channels],
        numeric_from=7,
    )
    if inspection.time_bases:
        emit_table(
            "Time bases",
            ("no.", "rate [Hz]", "from [s]", "to [s]", "jitter [µs]", "gaps", "repeated", "backward", "not finite"),
            [_time_row(index, base) for index, base in enumerate(inspection.time_bases)],
        )
    for base in inspection.time_bases:
        for start, stop in base.gaps_at:
            emit_text(f"gap of {quantity(stop - start, 's')} from {stamped(start)} to {stamped(stop)} s")
    for note in inspection.notes:
        emit_text(note)
    if isinstance(excitation, str):
        emit_text(f"excitation: {excitation}")
    else:
        _emit_excitation(excitation)


def _emit_excitation(coverage: "LogExcitation") -> None:
    from pipeline.scoring.wells import Wells

    shown = coverage.excitation
    title = f"Samples per basis centre, one every {1e3 * coverage.interval:g} ms"
    emit_visits(title, shown.centres, shown.visits, coverage.inputs, coverage.factor, coverage.unit)
    if isinstance(shown.wells, Wells):
        left, right = (coverage.factor * rest for rest in (shown.wells.left, shown.wells.right))
        emit_text(
            f"rests at {left:.2f} and {right:.2f} {coverage.unit}; snaps {shown.switches[0]} times to the right and "
            f"{shown.switches[1]} to the left; condition number of the regressor {shown.conditioning.condition:.0f}"
        )
    if coverage.assumed:
        emit_text("the channels were taken by name and unit; --settings PROTOTYPE.toml says which they are")
    rows = [(shortfall.finding, shortfall.add) for shortfall in coverage.shortfalls]
    if rows:
        emit_table("Not excited", ("finding", "add"), rows, numeric_from=2)
        if coverage.joint:
            emit_text("`debist rig excite` designs a sequence for a joint with two membranes")
    else:
        emit_text("everything is excited")


def _channel_row(channel: "InspectedChannel") -> tuple[str, ...]:
    quality = channel.quality
    base = "–" if channel.time_base is None else str(channel.time_base)
    values = (str(quality.n), f"{quality.smallest:.6g}", f"{quality.largest:.6g}")
    return (channel.name, channel.unit or "not stated", *values, base, "; ".join(channel.remarks))


def _time_row(index: int, base: "TimeQuality") -> tuple[str, ...]:
    facts = asdict(base)
    counts = (str(facts[name]) for name in ("gaps", "repeated", "backward", "not_finite"))
    return (
        str(index),
        f"{base.rate:.6g}",
        f"{base.start:.6g}",
        f"{base.stop:.6g}",
        f"{round(1e6 * base.jitter, 4):.3g}",
        *counts,
    )


def check(
    place: PrototypeFile,
    details: Annotated[bool, typer.Option("--details", help="Also the numbers beside those of the table.")] = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Sides, signs, delays, time base, mass and device: are the logs what the settings say? Nothing is fitted.

    Delays in ms, rates in Hz, pushes in m/s². Exit code 3 if the model would be wrong. `debist run` does it first.
    Example: debist check P1.toml
    """
    from pipeline.stages.check import verdict
    from pipeline.tools.inspection import check as check_tool

    with Progress(quiet=quiet) as progress:
        prototype, rows = check_tool(place, progress)
    if as_json:
        emit_json({"prototype": prototype.name, "rows": [asdict(row) for row in rows]})
    else:
        emit_rows(prototype.name, rows, details=details)
    verdict(rows, prototype)


def emit_rows(name: str, rows: "Sequence[CheckRow]", *, details: bool) -> None:
    """Print the numbers side by side, the logs as columns, and below them in words what is remarkable."""
    from pipeline.checks.rows import beside

    header, table = beside(rows)
    emit_table(f"{name}: are the logs what the settings say?", header, table, numeric_from=len(header))
    for row in rows:
        if row.state == "note":
            emit_text(f"note: {row.sentence}: {row.advice}", indent="  ")
        elif details and row.more:
            emit_text(row.sentence, indent="  ")
    if all(row.state in ("ok", "not seen") for row in rows):
        emit_text("nothing speaks against it")
