"""Raw logs before there is a run: a first settings file, what a log holds, and whether the settings fit."""

import os
from collections.abc import Iterable, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from ..units.quantity import prefixed, quantity, stamped
from .console import Json, Progress, PrototypeFile, Quiet, emit_json, emit_table, emit_text, with_units

if TYPE_CHECKING:
    from ..numerics.arrays import FloatArray, IntArray
    from ..rig_logs.inspection import InspectedChannel, Inspection
    from ..workflow.inspection import LogExcitation
    from ..workflow.studies.excitation_design import Design


def emit_design(design: "Design", files: Iterable[Path]) -> None:
    """Print the visits per centre, the criteria beside those of plain pulses, and the files."""
    designed = design.designed
    plain = design.plain
    emit_visits(
        "Simulated samples per basis centre, one every 10 ms",
        1e3 * design.weights.centres,
        designed.visits.table,
        ("left", "right"),
        "mm",
    )
    emit_table(
        "The sequence beside alternating full pulses",
        ("", "designed", "alternating"),
        [
            ("information per weight [nats]", f"{designed.log_information:.2f}", f"{plain.log_information:.2f}"),
            (
                "log det on unit-norm columns, per weight",
                f"{designed.conditioning.log_det:.2f}",
                f"{plain.conditioning.log_det:.2f}",
            ),
            ("condition number", f"{designed.conditioning.condition:.0f}", f"{plain.conditioning.condition:.0f}"),
            ("cells with 20 samples [%]", prefixed(designed.covered, "%", 0), prefixed(plain.covered, "%", 0)),
            ("passages between the wells", *(" / ".join(map(str, each.crossings)) for each in (designed, plain))),
        ],
    )
    emit_text(f"relative D-efficiency {design.efficiency:.2f} ({len(design.bursts)} bursts)")
    typer.echo("\n".join(map(str, files)))


def emit_visits(title: str, centres: "FloatArray", counts: "IntArray", inputs: Sequence[str], unit: str) -> None:
    """Print the samples nearest to each centre, and those of them under each input.

    Parameters
    ----------
    title : str
        Title of the table.
    centres : FloatArray, shape (M,)
        Centres in `unit`.
    counts : IntArray, shape (M, 1 + K)
        Samples nearest to each centre, all of them and those under each of K inputs.
    inputs : sequence of str
        Names of the inputs.
    unit : str
        Unit of q.
    """
    emit_table(
        title,
        (f"q [{unit}]", "samples", *(f"{name} acting" for name in inputs)),
        [(f"{centre:.2f}", *map(str, row)) for centre, row in zip(centres, counts, strict=True)],
        numeric_from=0,
    )


_OF_TIME_BASES = dict.fromkeys(
    ("start", "stop", "step", "shortest", "longest", "jitter", "gap_limit", "repeated_at", "backward_at", "gaps_at"),
    "s",
)
_PLACES = ("not_finite_at", "longest_frozen", "frozen_at", "spikes_at")
"""Times and durations of a time base and of a channel, which get their unit in JSON."""


def inspection_document(inspection: "Inspection", excitation: "LogExcitation | str") -> Any:
    """Everything for `--json`: the log in its own units, the excitation in SI; without one, the reason."""
    from ..store.manifest import to_json

    coverage = (
        {"excitation": None, "excitation_reason": excitation}
        if isinstance(excitation, str)
        else {"excitation": _excitation_document(excitation)}
    )
    document = asdict(inspection)
    document["time_bases"] = [with_units(base, _OF_TIME_BASES) for base in document["time_bases"]]
    for channel in document["channels"]:
        in_time = channel["time_base"] is not None  # else by the number of the sample
        units = dict.fromkeys(_PLACES, "s" if in_time else "samples") | {"band": "Hz" if in_time else ""}
        hum = [with_units(line, {"frequency": "Hz"}) for line in channel["quality"]["hum"]]
        channel["quality"] = with_units(channel["quality"] | {"hum": hum}, units)
    return to_json(document | coverage)


def _excitation_document(excitation: "LogExcitation") -> dict[str, Any]:
    """The excitation in SI."""
    shown = {
        name: value
        for name, value in asdict(excitation).items()
        if name not in ("factor", "unit", "plant", "excitation")
    }
    q, v = excitation.plant.displacement.symbol, excitation.plant.inputs[0].symbol
    facts = asdict(excitation.excitation)
    facts["wells"] = with_units(facts["wells"], dict.fromkeys(("left", "right", "barrier"), q))
    return {"excitation": with_units(facts, {"centres": q, "largest": v})} | with_units(shown, {"interval": "s"})


def emit_inspection(inspection: "Inspection", excitation: "LogExcitation | str") -> None:
    """Print the channels, the time bases, the notes, and what the log excites."""
    emit_table(
        f"{inspection.path}: {inspection.format}, {inspection.size / 1e6:.2f} MB",
        ("channel", "unit", "samples", "smallest", "largest", "time base", "remarks"),
        [_channel_row(channel) for channel in inspection.channels],
        numeric_from=None,
    )
    if inspection.time_bases:
        emit_table(
            "Time bases",
            ("no.", "rate [Hz]", "from [s]", "to [s]", "jitter [µs]", "gaps", "repeated", "backward", "not finite"),
            [_time_row(index, asdict(base)) for index, base in enumerate(inspection.time_bases)],
        )
    gaps = (
        f"gap of {quantity(stop - start, 's')} from {stamped(start)} to {stamped(stop)} s"
        for base in inspection.time_bases
        for start, stop in base.gaps_at
    )
    emit_text("\n".join((*gaps, *inspection.notes)))
    if isinstance(excitation, str):
        emit_text(f"excitation: {excitation}")
    else:
        _emit_excitation(excitation)


def _emit_excitation(coverage: "LogExcitation") -> None:
    shown = coverage.excitation
    emit_visits(
        f"Samples per basis centre, one every {1e3 * coverage.interval:g} ms",
        coverage.factor * shown.centres,
        shown.visits.table,
        coverage.inputs,
        coverage.unit,
    )
    if coverage.rests is not None:
        left, right = coverage.rests
        emit_text(
            f"rests at {left:.2f} and {right:.2f} {coverage.unit}; snaps {shown.switches[0]} times to the right and "
            f"{shown.switches[1]} to the left; condition number of the regressor {shown.conditioning.condition:.0f}"
        )
    if coverage.assumed:
        emit_text("the channels were chosen by name and unit; --settings PROTOTYPE.toml names them")
    rows = [(shortfall.finding, shortfall.add) for shortfall in coverage.shortfalls]
    if rows:
        emit_table("Not excited", ("finding", "add"), rows, numeric_from=None)
        if coverage.plant.joint:
            emit_text("`debist rig excite` designs a sequence for a joint with two membranes")
    else:
        emit_text("everything is excited")


def _channel_row(channel: "InspectedChannel") -> tuple[str, ...]:
    quality = channel.quality
    base = "–" if channel.time_base is None else str(channel.time_base)
    values = (str(quality.n), f"{quality.smallest:.6g}", f"{quality.largest:.6g}")
    return (channel.name, channel.unit or "not stated", *values, base, "; ".join(channel.remarks))


def _time_row(index: int, base: dict[str, Any]) -> tuple[str, ...]:
    counts = (str(base[name]) for name in ("gaps", "repeated", "backward", "not_finite"))
    numbers = (f"{number:.6g}" for number in (1.0 / base["step"], base["start"], base["stop"]))
    return (str(index), *numbers, f"{round(1e6 * base['jitter'], 4):.3g}", *counts)


def check(
    place: PrototypeFile,
    details: Annotated[bool, typer.Option("--details", help="Also the numbers beside those of the table.")] = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Sides, signs, units, time base, mass and rests: are the logs what the settings say? Nothing is fitted.

    Rates in Hz, fields in V/µm. Exit code 3 if the model would be wrong. `debist run` does it first.
    Example: debist check P1.toml
    """
    from ..diagnostics.check import beside, check_rows
    from ..workflow.inspection import check as check_tool
    from ..workflow.stage_check import assess

    with Progress(quiet=quiet) as progress:
        prototype, findings = check_tool(place, progress)
    rows = check_rows(findings)
    if as_json:
        emit_json({"prototype": prototype.name, "rows": [asdict(row) for row in rows]})
    else:
        header, table = beside(rows)
        emit_table(f"{prototype.name}: are the logs what the settings say?", header, table, numeric_from=None)
        for row in rows:
            if row.state == "note":
                emit_text(f"note: {row.remark}", indent="  ")
            elif details and row.more:
                emit_text(f"{row.log}: {row.what}: {row.found}; {row.more}", indent="  ")
        if all(row.state in ("ok", "not seen") for row in rows):
            emit_text("no contradiction; gains, zeros, delays and clocks are measured after the fit")
    assess(findings, prototype)


def init(
    logs: Annotated[
        list[Path], typer.Argument(metavar="LOG...", help="Raw logs of one device: MAT, MDF4, CSV, Parquet or HDF5.")
    ],
    output: Annotated[
        Path | None,
        typer.Option("-o", metavar="P.toml", help="File to write; no file is overwritten [default: print]."),
    ] = None,
    as_json: Json = False,
) -> None:
    """A starting settings file for raw logs; what cannot be known is left for you to fill in.

    Units are those of the logs where they state them; which log is for validation is proposed by its name.
    Example: debist init train.mat validation.mat -o P1.toml
    """
    from ..errors import InputError
    from ..rig_logs.draft import toml_draft
    from ..rig_logs.inspection import inspect_log
    from ..store.atomic import write_text
    from ..system.names import shell_word

    if output is not None and os.path.lexists(output):
        raise InputError(f"{output}: exists; give another name, or delete it first")
    paths = [str(log) if output is None else _path_from(output.parent, log) for log in logs]
    where = "this file" if output is not None else "the current folder; -o P.toml writes them from its own"
    draft = toml_draft([inspect_log(log) for log in logs], paths, where)
    if output is not None:
        write_text(output, draft)
    if as_json:
        emit_json({"toml": draft})
    elif output is not None:
        emit_text(f"{output}: fill in what is marked, then `debist check {shell_word(output)}`")
    else:
        typer.echo(draft, nl=False)


def _path_from(folder: Path, log: Path) -> str:
    """The path of a log from a folder, with strokes as TOML files have them; from the root on another drive."""
    try:
        path = os.path.relpath(os.path.abspath(log), os.path.realpath(folder))  # noqa: PTH100
    except ValueError:
        path = os.path.abspath(log)  # noqa: PTH100
    return path.replace(os.sep, "/")


def inspect(
    log: Annotated[Path, typer.Argument(metavar="LOG", help="Raw log: MAT, MDF4, CSV, Parquet or HDF5.")],
    settings: Annotated[
        Path | None,
        typer.Option("--settings", metavar="PROTOTYPE.toml", help="Which channel is what [default: by name and unit]."),
    ] = None,
    as_json: Json = False,
) -> None:
    """Channels, units, rates, gaps, saturation and hum of a raw log; what it does not excite, and what to add.

    Times in s, rates in Hz, values in the log's own units. Example: debist inspect train.mat
    """
    from ..workflow.inspection import inspect as inspect_stage

    inspection, excitation = inspect_stage(log, settings)
    if as_json:
        emit_json(inspection_document(inspection, excitation))
    else:
        emit_inspection(inspection, excitation)
