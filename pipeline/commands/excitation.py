"""What a log excites, or a designed sequence would, as tables."""

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from pipeline.commands.console import emit_table, emit_text
from pipeline.si_prefix import quantity

if TYPE_CHECKING:
    from pipeline.fitting.coverage import Coverage
    from pipeline.numerics.arrays import FloatArray
    from pipeline.tools.excitation_design import Design
    from pipeline.tools.next_log import NextLog


def emit_design(design: "Design | NextLog", files: Iterable[Path]) -> None:
    """Print what the design is expected to bring, and the files."""
    from pipeline.tools.next_log import NextLog

    if isinstance(design, NextLog):
        _emit_next_log(design)
    else:
        _emit_first_log(design)
    typer.echo("\n".join(map(str, files)))


def _emit_next_log(design: "NextLog") -> None:
    """Print how sure the free run is and will be."""
    rows = [
        (what, quantity(sd, "m", like=design.now), f"{100.0 * sd / design.stroke:.3f} %")
        for what, sd in (
            ("with the logs of the run", design.now),
            ("with a usual log as well", design.usual),
            ("with the designed log as well", design.designed),
        )
    ]
    title = f"Expected standard deviation of the free run, programme {design.programme}"
    emit_table(title, ("", "RMS", "of its range"), rows)
    emit_text(
        f"{len(design.bursts)} bursts; expected error with the designed log over that with a usual one: "
        f"{design.designed / design.usual:.2f}, as far as the model's equations are those of the device"
    )


def _emit_first_log(design: "Design") -> None:
    """Print the visits per centre, and the criteria beside those of plain pulses."""
    designed, plain = design.designed, design.plain
    names = ("left", "right")
    emit_visits(
        "Simulated samples per basis centre, one every 10 ms", design.weights.centres, designed.visits, names, 1e3, "mm"
    )
    rows = [
        ("information per weight [nats]", f"{designed.log_information:.2f}", f"{plain.log_information:.2f}"),
        (
            "log det on unit-norm columns, per weight",
            f"{designed.conditioning.log_det:.2f}",
            f"{plain.conditioning.log_det:.2f}",
        ),
        ("condition number", f"{designed.conditioning.condition:.0f}", f"{plain.conditioning.condition:.0f}"),
        ("cells with 20 samples [%]", f"{100 * designed.covered:.0f}", f"{100 * plain.covered:.0f}"),
        ("passages between the wells", _counts(designed.crossings), _counts(plain.crossings)),
    ]
    emit_table("The sequence beside alternating full pulses", ("", "designed", "alternating"), rows)
    emit_text(f"relative D-efficiency {design.efficiency:.2f} ({len(design.bursts)} bursts)")


def emit_visits(
    title: str, centres: "FloatArray", visits: "Coverage", inputs: Sequence[str], factor: float, unit: str
) -> None:
    """Print the samples nearest to each centre, and those of them under each input."""
    rows = [
        (f"{factor * centre:.2f}", str(count), *map(str, driven))
        for centre, count, driven in zip(centres, visits.visits, visits.driven.T, strict=True)
    ]
    emit_table(title, (f"q [{unit}]", "samples", *(f"{name} acting" for name in inputs)), rows, numeric_from=0)


def _counts(crossings: Sequence[int]) -> str:
    return " / ".join(map(str, crossings))
