"""`debist verify`, `debist repair`, `debist sign`: is everything as it was written, and by whom?"""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from pipeline.commands.console import Json, Progress, Quiet, Run, emit_json, emit_table, printable

if TYPE_CHECKING:
    from pipeline.runs.verification import Verified
    from pipeline.tools.verify import VerifiedRun

_MOST_NAMED = 20


def verify(
    run: Run,
    against: Annotated[
        Path | None, typer.Option("--against", metavar="RUN", help="Compare the content with that of another run.")
    ] = None,
    every: Annotated[
        bool, typer.Option("--all", help="RUN is a folder of runs: check each, and the fleet tables.")
    ] = False,
    key: Annotated[
        Path | None, typer.Option("--key", metavar="FILE", help="Check the signature too, with the key in this file.")
    ] = None,
    as_json: Json = False,
) -> None:
    """Check every file of a run; exit code 4 if anything does not have the bytes that were written.

    Files that debist did not write there are named. With --against also whether another run, of another machine for
    instance, holds the same content; where floating point forbids that, whether it is the same to 6 digits (of the
    largest magnitude of a column); exit code 4 if not. Example: debist verify runs/P1 --against crate/run
    """
    from pipeline.tools.verify import verify_all, verify_everything

    if every:
        _emit_all(verify_all(run), as_json)
        return
    found, signed = verify_everything(run, key)
    if against is not None and not found.problems:
        from pipeline.commands.results import emit_comparison
        from pipeline.tools.diff import compare_runs

        emit_comparison(run, against, compare_runs(run, against), as_json=as_json)
        return
    _emit(found, signed, as_json)
    _fail_where(run, found)


def repair(
    run: Run,
    prototype: Annotated[
        Path | None,
        typer.Argument(metavar="[PROTOTYPE.toml]", help="Settings, for a run whose manifest is damaged."),
    ] = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Set aside what is damaged in a run and make it anew from what is intact and from the raw logs.

    Nothing is deleted: damaged files keep a name with .corrupt-. Example: debist repair runs/P1
    """
    from pipeline.tools.verify import repair_run

    with Progress(quiet=quiet) as progress:
        done, found = repair_run(run, progress, prototype)
    redone = [status for status in done if not status.up_to_date]
    if as_json:
        emit_json({"redone": [vars(status) for status in redone], **vars(found)})
    else:
        typer.echo(f"{len(redone)} of {len(done)} tasks done anew; {found.checked} artifacts, " + _state(found))
    _fail_where(run, found)


def sign(
    run: Run,
    key: Annotated[Path, typer.Option("--key", metavar="FILE", help="File with the key.")],
    new_key: Annotated[bool, typer.Option("--new-key", help="Make the key and write it to that file first.")] = False,
    as_json: Json = False,
) -> None:
    """Sign a run, so that who has the same key can tell whether anything in it was replaced (HMAC-SHA-256).

    Example: debist sign runs/P1 --key lab.key --new-key; then, elsewhere: debist verify runs/P1 --key lab.key
    """
    from pipeline.runs.verification import make_key
    from pipeline.tools.verify import sign_run

    if new_key:
        make_key(key)
    written = sign_run(run, key)
    if as_json:
        emit_json({"signature": written})
    else:
        typer.echo(printable(f"{written}: signed; check it by `debist verify {run} --key {key}`"))


def _emit(found: "Verified", signed: str, as_json: bool) -> None:
    if as_json:
        emit_json(vars(found) | ({"signed": signed} if signed else {}))
        return
    if not found.problems:
        when = f"; signed {signed}" if signed else ""
        typer.echo(printable(f"{found.checked} artifacts checked, {_state(found)}{when}"))
    for name in found.unknown[:_MOST_NAMED]:
        typer.echo(printable(f"not written by debist: {name}"), err=True)
    if len(found.unknown) > _MOST_NAMED:
        typer.echo(f"and {len(found.unknown) - _MOST_NAMED} more", err=True)


def _state(found: "Verified") -> str:
    return f"{len(found.problems)} not as they were written" if found.problems else "all intact"


def _emit_all(runs: "list[VerifiedRun]", as_json: bool) -> None:
    from pipeline.errors import CorruptArtifactError

    if as_json:
        emit_json({"runs": [{"run": run.root, **vars(run.found), "failure": run.failure} for run in runs]})
    else:
        rows = [
            (
                str(run.root),
                str(run.found.checked),
                str(len(run.found.problems)),
                str(len(run.found.unknown)),
                _first(run),
            )
            for run in runs
        ]
        emit_table("verified", ("run", "files", "problems", "unknown", "first"), rows)
    bad = [str(run.root) for run in runs if not run.intact]
    if bad:
        raise CorruptArtifactError(f"{len(bad)} of {len(runs)} are not intact: {', '.join(bad)}; `debist repair` each")


def _first(run: "VerifiedRun") -> str:
    return run.failure or next((f"{p['artifact']} {p['problem']}" for p in run.found.problems), "")


def _fail_where(run: Path, found: "Verified") -> None:
    from pipeline.errors import CorruptArtifactError

    if found.problems:
        raise CorruptArtifactError(
            "; ".join(f"{p['artifact']} (stage {p['stage']}) {p['problem']}" for p in found.problems)
            + f"; `debist repair {run}` sets aside and rebuilds what is damaged"
        )
