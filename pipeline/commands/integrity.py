"""`debist verify`: is everything as it was written?"""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from ..errors import CorruptArtifactError
from .console import Json, Run, emit_json, emit_table, printable

if TYPE_CHECKING:
    from ..workflow.verify import Verified, VerifiedRun

_MOST_NAMED = 20


def verify(
    run: Run,
    against: Annotated[
        Path | None, typer.Option("--against", metavar="RUN", help="Compare the content with that of another run.")
    ] = None,
    every: Annotated[
        bool, typer.Option("--all", help="RUN is a folder of runs: check each, and the fleet tables.")
    ] = False,
    as_json: Json = False,
) -> None:
    """Check every file of a run; exit code 4 if one does not have the bytes that were written or does not belong there.

    With --against also whether another run, of another machine for instance, holds the same content; where floating
    point forbids that, whether it is the same to 6 digits (of the largest magnitude of a column); exit code 4 if not.
    Example: debist verify runs/P1 --against crate/run
    """
    from ..workflow import verify as tool

    if every:
        _emit_all(tool.verify_all(run), as_json)
        return
    checked = tool.verify_everything(run)
    if against is not None and checked.intact:
        from ..workflow.studies.diff import compare_runs
        from .results import emit_comparison

        emit_comparison(run, against, compare_runs(run, against), as_json=as_json)
        return
    _emit(checked, as_json)
    _fail_where(run, checked)
    _fail_beside(run, checked)


def _emit(checked: "Verified", as_json: bool) -> None:
    if as_json:
        emit_json(vars(checked))
        return
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


def _emit_all(runs: "list[VerifiedRun]", as_json: bool) -> None:
    if as_json:
        emit_json({"runs": [{"run": run.root, **vars(run.result), "failure": run.failure} for run in runs]})
    else:
        rows = [
            (
                str(run.root),
                str(run.result.checked),
                str(len(run.result.problems)),
                str(len(run.result.unknown) + len(run.result.leftover)),
                _first(run),
            )
            for run in runs
        ]
        emit_table("verified", ("run", "files", "problems", "unknown", "first"), rows)
    bad = [str(run.root) for run in runs if not run.intact]
    if bad:
        raise CorruptArtifactError(
            f"{len(bad)} of {len(runs)} are not intact: {', '.join(bad)}; `debist verify` names why"
        )


def _first(run: "VerifiedRun") -> str:
    problems = (f"{p['artifact']} {p['problem']}" for p in run.result.problems)
    others = (f"{name} does not belong there" for name in (*run.result.unknown, *run.result.leftover))
    return run.failure or next(iter((*problems, *others)), "")


def _fail_where(run: Path, checked: "Verified") -> None:
    if checked.problems:
        raise CorruptArtifactError(
            "; ".join(f"{p['artifact']} (stage {p['stage']}) {p['problem']}" for p in checked.problems)
            + "; `debist run` sets aside what is damaged and makes it anew"
        )


def _fail_beside(run: Path, checked: "Verified") -> None:
    if checked.unknown:
        raise CorruptArtifactError(f"{run}: {len(checked.unknown)} files do not belong to the run; move them elsewhere")
    if checked.leftover:
        raise CorruptArtifactError(f"{run}: a run was interrupted; `debist run` completes it and removes what it left")
