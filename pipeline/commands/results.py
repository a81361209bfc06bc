"""Uses of runs: `debist diff`, `series`, `fleet learn`, `export`, `paper`, `study` and `verify`."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from ..errors import CorruptArtifactError, InputError
from ..system.names import Target
from ..units.quantity import percent
from .boundary import group
from .console import (
    Force,
    Json,
    Progress,
    Quiet,
    Run,
    Runs,
    emit_json,
    emit_table,
    emit_text,
    printable,
    run_of,
    with_units,
)
from .outcome import emit_table_2

if TYPE_CHECKING:
    from ..workflow.studies.diff import RunDifferences
    from ..workflow.studies.fleet import LearntFile
    from ..workflow.verify import Verified


_LONGEST = 60
_OF_HASH = 16


def diff(
    runs: Annotated[list[Path], typer.Argument(metavar="RUN...", help="Two or more run folders.")],
    as_json: Json = False,
) -> None:
    """Runs side by side: only what differs in settings, versions, raw logs, scores, facts of the device and artifacts.

    NRMSE in percent, a fraction in JSON; artifacts are compared with those of the first run. Exit code 0
    whether they differ or not. Example: debist diff runs/P1 runs/P1b
    """
    from ..workflow.studies.diff import diff_runs

    if len(runs) < 2:
        raise InputError(f"{runs[0]}: name a second run to compare it with")
    different = diff_runs(runs)
    if as_json:
        emit_json(asdict(different) | {"equal": different.equal})
    else:
        _emit_differences(different)


def _emit_differences(runs: "RunDifferences") -> None:
    """Print what differs, table by table."""
    tables = [
        ("settings", "key", [(row.key, *map(_text, row.values)) for row in runs.settings]),
        ("versions", "package", [(row.key, *map(_text, row.values)) for row in runs.versions]),
        ("raw logs (SHA-256)", "log", [(row.key, *(_text(v)[:_OF_HASH] for v in row.values)) for row in runs.sources]),
        ("NRMSE of free runs", "log · model · signal", [(row.key, *map(percent, row.values)) for row in runs.scores]),
        ("facts", "fact", [(row.key, *map(_text, row.values)) for row in runs.facts]),
    ]
    for title, head, rows in tables:
        if rows:
            emit_table(
                title,
                (head, *runs.names),
                rows,
                numeric_from=1 if title in ("NRMSE of free runs", "facts") else len(runs.names) + 1,
            )
    for name, compared in zip(runs.names[1:], runs.artifacts, strict=True):
        differing = [
            (c.artifact, c.state, "" if c.deviation is None else f"{c.deviation:.1e}", c.column)
            for c in compared
            if c.state not in ("equal", "drawn")
        ]
        if differing:
            emit_table(f"artifacts of {name}", ("artifact", "state", "deviation", "in"), differing, numeric_from=2)
    if same := [title for title, _, rows in tables if not rows]:
        emit_text(f"equal: {', '.join(same)}{', artifacts' if runs.equal else ''}")


def _text(value: object) -> str:
    if value is None or isinstance(value, float):
        return "–" if value is None else f"{value:.6g}"
    text = ", ".join(map(str, value)) if isinstance(value, list | tuple) else str(value)
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}…"


def export(
    run: Annotated[Path, typer.Argument(metavar="RUN", help="Run folder.", callback=run_of)],
    target: Annotated[Target, typer.Option("--to", help="Form of the export.")],
    model: Annotated[
        str | None, typer.Option("--model", help="Model that is exported [default: the main model].")
    ] = None,
    output: Annotated[
        Path | None, typer.Option("-o", metavar="DIR", help="Folder of the files [default: RUN/exports].")
    ] = None,
    force: Force = False,
    as_json: Json = False,
) -> None:
    """Write the identified model for another tool, or the run with all its inputs as an RO-Crate (`--to crate`).

    Units (SI) and validity range travel along with a model. `--to controller` writes the controller that
    `debist control design` made, as C99, as a MATLAB function and as an FMU.

    Example: debist export runs/P1 --to fmu
    """
    from ..workflow.export import export_run

    exported = export_run(run, target, model=model, output=output, force=force)
    if as_json:
        emit_json(vars(exported))
    else:
        typer.echo("\n".join(map(str, exported.written)))
        for note in exported.notes:
            typer.echo(f"note: {note}", err=True)


def paper(
    source: Annotated[Path, typer.Argument(metavar="RUN|PROTOTYPE.toml", help="Run folder, or settings file.")],
    output: Annotated[
        Path | None,
        typer.Option("-o", metavar="DIR", help="Folder of the recipe's run [default: RUN-paper]."),
    ] = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Every figure and table of the paper under its number, printed values beside computed ones (NRMSE in percent).

    Differentiates, identifies and simulates by the recipe of the paper in a run of its own; writes paper.html, and the
    figures as paper/*.svg and *.pdf. Example: debist paper runs/P1
    """
    from ..workflow.studies.paper import run_paper

    with Progress(quiet=quiet or as_json) as progress:
        recipe = run_paper(source, output, progress)
    if as_json:
        emit_json(
            {"page": str(recipe.root / "paper.html"), "figures": str(recipe.root / "paper"), "table_2": recipe.table}
        )
    else:
        emit_table_2(recipe.table)
        typer.echo(f"page: {recipe.root / 'paper.html'}\nfigures: {recipe.root / 'paper'}")


def study(
    kind: Annotated[Literal["alpha", "basis", "data", "online"], typer.Argument(help="What is studied.")],
    run: Annotated[Path, typer.Argument(metavar="RUN", help="Run folder with kinematics.", callback=run_of)],
    jobs: Annotated[int, typer.Option("--jobs", min=1, help="Processes at a time, for basis.")] = 1,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Study one thing on the logs of a run: alpha, basis, data, or online.

    alpha: over- and under-smoothing against the regularisation parameter (figure 11c), and the one that is chosen.
    basis: number M and width of the basis functions of rbf-paper (figure 11b).
    data: free-run NRMSE of rbf-paper against the amount of training data and added noise [m].
    online: recursive least squares over the training logs (§ 4.1), and a planted drift of 10 %.

    NRMSE as fractions; alpha in the unit of the settings, the rest in SI units. Writes studies/KIND.parquet (SI units)
    and .svg.

    Example: debist study alpha runs/P1
    """
    from ..reporting.tables import study_conclusion
    from ..store.manifest import to_json
    from ..workflow.studies.study import run_study

    with Progress(quiet=quiet or as_json) as progress:
        result = run_study(run, kind, progress, jobs=jobs)
    if as_json:
        of_notes = {"automatic_alpha": result.units.get("alpha", ""), "noise_std": result.units.get("misfit", "")}
        columns = with_units(result.columns, result.units)
        emit_json(to_json({"columns": columns, "figure": result.figure, "notes": with_units(result.notes, of_notes)}))
    else:
        columns, conclusion = study_conclusion(kind, result.columns, result.units, result.notes)
        emit_table(
            f"Study of {kind}",
            list(columns),
            [[f"{value:.4g}" for value in row] for row in zip(*columns.values(), strict=True)],
            numeric_from=0,
        )
        emit_text(f"{conclusion}\nfigure: {result.figure}" if conclusion else f"figure: {result.figure}")


_MOST_NAMED = 20


def verify(run: Run, as_json: Json = False) -> None:
    """Check every file of a run; exit code 4 if one does not have the bytes that were written or does not belong there.

    Example: debist verify runs/P1
    """
    from ..workflow import verify as tool

    checked = tool.verify_everything(run)
    if as_json:
        emit_json(vars(checked))
    else:
        _emit_verified(checked)
    if checked.problems:
        raise CorruptArtifactError(
            "; ".join(f"{p['artifact']} (stage {p['stage']}) {p['problem']}" for p in checked.problems)
            + "; `debist run` sets aside what is damaged and makes it anew"
        )
    if checked.unknown:
        raise CorruptArtifactError(f"{run}: {len(checked.unknown)} files do not belong to the run; move them elsewhere")
    if checked.leftover:
        raise CorruptArtifactError(f"{run}: a run was interrupted; `debist run` completes it and removes what it left")


def _emit_verified(checked: "Verified") -> None:
    if checked.intact:
        typer.echo(f"{checked.checked} artifacts checked, all intact")
    for what, names in (
        ("does not belong to the run", checked.unknown),
        ("left by an interrupted run", checked.leftover),
    ):
        for name in names[:_MOST_NAMED]:
            typer.echo(printable(f"{what}: {name}"), err=True)
        if len(names) > _MOST_NAMED:
            typer.echo(f"and {len(names) - _MOST_NAMED} more", err=True)


fleet_group = group("A prior for the next joint, from many joints of one drawing.")
_QUANTITIES_SHOWN = 15


@fleet_group.command()
def learn(
    runs: Annotated[
        list[Path], typer.Argument(metavar="RUN...", help="Runs with the model hybrid, or folders of a batch.")
    ],
    output: Annotated[
        Path,
        typer.Option("-o", metavar="FILE", help="File of the prior (.h5), for plant.siblings."),
    ],
    as_json: Json = False,
) -> None:
    """Learn a prior of the next joint from identified ones: mean, spread, correlations of deviations; odd joints.

    From five joints on; all need the parameter set that the next joint has. Lengths in m, all other units SI, odd
    quantities in percent where they are positive. Example: debist fleet learn runs -o siblings.h5
    """
    from ..workflow.studies.fleet import learn_siblings

    siblings = learn_siblings(runs, output)
    for name, reason in siblings.left_out.items():
        typer.echo(printable(f"warning: {name} is left out: {reason}"), err=True)
    if as_json:
        emit_json(
            {
                "file": siblings.path,
                "siblings": siblings.siblings,
                "left_out": siblings.left_out,
                "quantities": [vars(quantity) for quantity in siblings.learnt.quantities],
                "odd": [vars(odd) for odd in siblings.learnt.odd],
                "log_evidence_gain": siblings.learnt.gains,
            }
        )
    else:
        _emit_learnt(siblings)


def _emit_learnt(siblings: "LearntFile") -> None:
    quantities = siblings.learnt.quantities
    gains = sorted(siblings.learnt.gains.values())
    emit_table(
        f"{len(siblings.siblings)} joints, the best known quantities",
        ("quantity", "mean deviation", "spread", "unit", "spread over the prior's"),
        [
            (quantity.name, f"{quantity.mean:.3g}", f"{quantity.spread:.2g}", quantity.unit, f"{quantity.share:.2f}")
            for quantity in quantities[:_QUANTITIES_SHOWN]
        ],
    )
    halved = sum(quantity.share < 0.5 for quantity in quantities)
    emit_text(
        f"{halved} of {len(quantities)} quantities have less than half the prior's spread; with the other joints as "
        f"prior, the logs of a joint are exp({gains[len(gains) // 2]:.0f}) times as probable (median)"
    )
    odd = [f"odd: {o.name}: {o.quantity} {o.size:+.3g} ± {o.error:.2g} {o.unit}" for o in siblings.learnt.odd]
    emit_text("\n".join(odd or ["no joint is odd"]))
    emit_text(f"written: {siblings.path}; name it in [plant] siblings, or give it to debist batch --siblings")


def series(
    runs: Runs,
    at: Annotated[
        str | None,
        typer.Option("--at", metavar="TIME,…", help="Date (2026-03-01) or day of each run [default: in this order]."),
    ] = None,
    as_json: Json = False,
) -> None:
    """Drift and steps of the facts of one device over several runs, with 95 % intervals; SI units in JSON.

    Rests, barriers, switching voltages, stiffness, capacitance gains, charging time, creep and the laser's zero. A
    change is claimed where chance explains it in one of twenty series at most; four runs are the least.

    Example: debist series runs/day0 runs/day7 runs/day14 runs/day30 --at 0,7,14,30
    """
    from ..reporting.tables import SERIES_COLUMNS, series_conclusion, series_rows
    from ..workflow.studies.fleet import series_of

    facts = series_of(runs, at)
    if as_json:
        emit_json(asdict(facts))
    else:
        emit_table(f"{len(facts.names)} runs of one device, ± 95 %", SERIES_COLUMNS, series_rows(facts))
        emit_text(series_conclusion(facts))
