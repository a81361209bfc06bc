"""A raw log's inspection as tables."""

from dataclasses import asdict

import typer

from pipeline.commands.console import emit_table, printable
from pipeline.numerics.sampling.timebase import TimeQuality
from pipeline.rig_logs.inspection import InspectedChannel, Inspection


def emit_inspection(inspection: Inspection) -> None:
    """Print the channels, the time bases and the notes."""
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
            typer.echo(f"gap of {1e3 * (stop - start):.4g} ms from {start:.6g} s to {stop:.6g} s")
    for note in inspection.notes:
        typer.echo(printable(note))


def _channel_row(channel: InspectedChannel) -> tuple[str, ...]:
    quality = channel.quality
    base = "–" if channel.time_base is None else str(channel.time_base)
    values = (str(quality.n), f"{quality.smallest:.6g}", f"{quality.largest:.6g}")
    return (channel.name, channel.unit or "not stated", *values, base, "; ".join(channel.remarks))


def _time_row(index: int, base: TimeQuality) -> tuple[str, ...]:
    facts = asdict(base)
    counts = (str(facts[name]) for name in ("gaps", "repeated", "backward", "not_finite"))
    return (
        str(index),
        f"{base.rate:.6g}",
        f"{base.start:.6g}",
        f"{base.stop:.6g}",
        f"{1e6 * base.jitter:.3g}",
        *counts,
    )
