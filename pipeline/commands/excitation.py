"""What a log excites, or a designed sequence would, as tables."""

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from pipeline.commands.console import emit_table, emit_text

if TYPE_CHECKING:
    from pipeline.fitting.coverage import Coverage
    from pipeline.numerics.arrays import FloatArray
    from pipeline.tools.excitation_design import Design


def emit_design(design: "Design", files: Iterable[Path]) -> None:
    """Print the visits per centre, the criteria beside those of plain pulses, and the files."""
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
    typer.echo("\n".join(map(str, files)))


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
