"""Results of a run or a batch: scores, assessment, instruments, states of tasks, and the progress of a batch."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from ..system.names import shell_word
from ..units.quantity import percent, quantity
from .console import StatusLine, brief, emit_json, emit_table, emit_text, printable

if TYPE_CHECKING:
    from ..workflow.batch import Outcome
    from ..workflow.engine import TaskStatus
    from ..workflow.members import Member
    from ..workflow.progress import MemberState


def emit_scores(run: Path, *, as_json: bool, details: bool = False, with_report: bool = False) -> None:
    """Print the scores: the short table of the scores, or with details every number of every log; as records for JSON.

    With a report, the JSON document holds its assessment and its path too.
    """
    from ..reporting.tables import lines, main_table
    from ..workflow.report_data import load_datasheet, load_scores
    from ..workflow.stage_validate import score_tables, shown_scores

    if as_json:
        page = {"verdict": load_datasheet(run)["verdict"], "report": run / "report.html"} if with_report else {}
        emit_json({"scores": load_scores(run), **page})
    elif details:
        tables = score_tables(run)
        for table in tables:
            heading, *rows = lines(table)
            for log in dict.fromkeys(row[0] for row in rows):
                emit_table(log, heading[1:], [row[1:] for row in rows if row[0] == log])
        emit_text("\n".join(table.explanation for table in tables))
    else:
        short = main_table(shown_scores(run))
        emit_table(short.where, short.heading, short.rows)
        emit_text(f"{short.explanation}\nIntervals, every log, horizons and times: --details")


def emit_instruments(run: Path) -> None:
    """Print what the instruments of the logs read beyond their limits, with the lines to write in the settings."""
    from ..reporting.instrument_table import instrument_table
    from ..workflow.report_data import instruments_shown

    rows, parts, displacement = instruments_shown(run)
    if not rows:
        return
    table = instrument_table(rows, parts, displacement)
    if table.rows:
        emit_table("instruments", table.heading, table.rows, numeric_from=None)
    emit_text(table.explanation)
    if table.entries:
        emit_text("To correct a log, write in place of it in [logs]:")
    for line in table.entries:
        typer.echo(printable(line))  # one line, however narrow the terminal: it is pasted


def emit_assessment(run: Path) -> None:
    """Print the assessment of the report and where the report lies."""
    from ..workflow.report_data import load_datasheet

    assessment = load_datasheet(run)["verdict"]
    emit_text(f"assessment: data {assessment['data']}, model {assessment['model']}")
    for check in assessment["checks"]:
        if check["grade"] != "good":
            emit_text(f"  {check['about']}, {check['grade']}: {check['statement']}", indent="    ")
    emit_text(f"report: {run / 'report.html'}")


def emit_table_2(table: Iterable[Mapping[str, Any]]) -> None:
    """Print the rows of the paper's Table 2 (`pipeline.reporting.paper_page.table_2`)."""
    from ..reporting.paper_page import table_2_row

    rows = [
        (row["log"], row["model"], *(f"{value} ({printed})" if printed else value for value, printed in row["cells"]))
        for row in map(table_2_row, table)
    ]
    emit_table(
        "Table 2 of the paper: NRMSE in %, in brackets as printed",
        ("log", "model", "q", "φ", "q̇", "q̈")[: len(rows[0])],
        rows,
        numeric_from=2,
    )


def emit_stale_exports(run: Path) -> None:
    """Warn, on stderr, of exports that were made from another model than the run now holds."""
    from ..workflow.export import stale_exports

    if stale := stale_exports(run):
        verb = "was made" if len(stale) == 1 else "were made"
        typer.echo(f"warning: {brief(stale)} {verb} from another model than the run now holds; export again", err=True)


def emit_fleet_status(states: "Sequence[tuple[Path, list[TaskStatus], str]]", *, as_json: bool) -> None:
    """Print for each run its stale stages with the first reason, or why it cannot be read.

    A run whose report was never made is up to date in the table; JSON names the stage, as workflows make it.
    """
    from ..workflow.engine import FIRST_TIME

    if as_json:
        emit_json(
            {
                "runs": [
                    {
                        "run": root,
                        "stale": list(dict.fromkeys(r.stage for r in results if not r.up_to_date)),
                        "error": error,
                    }
                    for root, results, error in states
                ]
            }
        )
        return
    rows = []
    for root, results, error in states:
        stale = [result for result in results if not result.up_to_date]
        if stale and all(result.stage == "report" and result.reasons == [FIRST_TIME] for result in stale):
            rows.append((str(root), "up to date", f"without a report; `debist report {shell_word(root)}` makes it"))
        else:
            state = "unreadable" if error else "stale" if stale else "up to date"
            rows.append((str(root), state, error or brief([f"{r.stage} {r.title}: {r.reasons[0]}" for r in stale])))
    emit_table("runs", ("run", "state", "why"), rows, numeric_from=None)


def emit_fleet_progress(folder: Path, members: "Sequence[MemberState]", *, as_json: bool) -> None:
    """Print for each prototype of a batch whether it is done, running, stopped or failed."""
    from ..workflow.progress import STATES

    counts = {state: sum(member.state == state for member in members) for state in STATES}
    if as_json:
        emit_json(
            {
                "folder": folder,
                "counts": counts,
                "prototypes": [
                    vars(member) | {"since": member.since and member.since.isoformat()} for member in members
                ],
            }
        )
    else:
        emit_table(
            str(folder),
            ("prototype", "state", "since", "reason"),
            [(m.name, m.state, m.since.strftime("%Y-%m-%d %H:%M:%SZ") if m.since else "", m.reason) for m in members],
            numeric_from=None,
        )
        counted = ", ".join(f"{count} {state}" for state, count in counts.items() if count)
        emit_text(f"{len(members)} prototypes: {counted}")


def emit_members(members: "Sequence[Member]", *, as_json: bool) -> None:
    """Print the prototypes of a batch with their settings files and logs."""
    if as_json:
        emit_json({"prototypes": [asdict(member) for member in members]})
    else:
        emit_table(
            f"{len(members)} prototypes",
            ("prototype", "settings", "logs, or the mistake"),
            [
                (member.name, str(member.settings), member.error or ", ".join(log.name for log in member.logs))
                for member in members
            ],
            numeric_from=None,
        )


def summary(results: "Sequence[TaskStatus]") -> str:
    """One line on what was done."""
    redone = sum(not result.up_to_date for result in results)
    if not redone:
        return f"everything is up to date ({len(results)} tasks)"
    return f"{redone} of {len(results)} tasks done, {len(results) - redone} were up to date"


def emit_tasks(
    done: "Sequence[TaskStatus]", *, as_json: bool, results: Sequence[Mapping[str, Any]] | None = None
) -> None:
    """Print what a stage came to, a line for each log or model, and how many tasks were done; for JSON all of it."""
    if as_json:
        emit_json(
            {"tasks": [{**vars(task), "up_to_date": task.up_to_date} for task in done]}
            | ({} if results is None else {"results": results})
        )
    else:
        emit_text("\n".join(map(result_line, results or ())), indent="  ")
        typer.echo(summary(done))


def result_line(result: Mapping[str, Any]) -> str:
    """Line for the result of a stage for one log or model (`pipeline.workflow.report_data`)."""
    if "rows" in result:
        lost = f", {result['masked_rows']} of them masked" if result["masked_rows"] else ""
        gaps = f"{result['gaps']} gap{'s' if result['gaps'] != 1 else ''}"
        return f"{result['log']}: {result['rows']} rows every {quantity(result['interval_s'], 's')}{lost}; {gaps}"
    if "method" in result:
        alpha, noise = (" to ".join(f"{x:.3g}" for x in _ends(result[key])) for key in ("alphas", "noises"))
        shown = f", α = {alpha} {result['alpha_unit']}" if alpha else ""
        return f"{result['log']}: {result['method']}{shown}; noise of {result['of']} {noise} {result['noise_unit']}"
    seconds = "" if result["fit_s"] is None else f" in {result['fit_s']:.1f} s"
    chosen = f"; chosen: {result['reason']}" if result["reason"] else ""
    return f"{result['model']}: identified{seconds}{', the main model' if result['headline'] else ''}{chosen}"


def _ends(values: Sequence[float]) -> list[float]:
    """The smallest and the largest value, where they differ."""
    return sorted({min(values), max(values)}) if values else []


def emit_status(title: str, states: "Sequence[TaskStatus]", *, as_json: bool) -> None:
    """Print for each task whether it is up to date, and why not."""
    if as_json:
        emit_tasks(states, as_json=True)
    else:
        emit_table(
            title,
            ("stage", "task", "state", "why"),
            [(r.stage, r.title, "up to date" if r.up_to_date else "to do", brief(r.reasons)) for r in states],
            numeric_from=None,
        )


_MOST_NAMED = 4


class BatchProgress(StatusLine):
    """One line on stderr per finished prototype; below them, on a terminal, those that run and the share done."""

    def __init__(self, total: int, *, quiet: bool = False) -> None:
        super().__init__(quiet=quiet)
        self._total = total
        self._done = 0
        self._running: list[str] = []

    @property
    def kept(self) -> str:
        """The finished prototypes."""
        return (
            f"{self._done} of {self._total} prototypes are done; the same command goes on with the rest, and "
            "--collect makes tables of what is there"
        )

    def started(self, name: str) -> None:
        """Show it among those that run."""
        self._running.append(name)
        self._show_running()

    def finished(self, outcome: "Outcome") -> None:
        """Say how it went."""
        self._done += 1
        self._running.remove(outcome.name)
        if not self._quiet:
            well = "done" if outcome.processor_seconds else "up to date"  # which needs no process
            state = f"failed: {outcome.reason}" if outcome.failed else well
            # In a cluster's log each line stands alone.
            stamp = f"{datetime.now(UTC):%Y-%m-%dT%H:%M:%SZ} " if self._line is None else ""
            self.say(f"{stamp}[{self._done}/{self._total}] {outcome.name}: {state} ({outcome.seconds:.1f} s)")
        self._show_running()

    def _show_running(self) -> None:
        more = f" and {len(self._running) - _MOST_NAMED} more" if len(self._running) > _MOST_NAMED else ""
        names = f": {', '.join(self._running[:_MOST_NAMED])}{more}" if self._running else ""
        self.show(f"{self._done} of {self._total} prototypes{names}", self._done / self._total)


def emit_outcomes(outcomes: "Sequence[Outcome]", output: Path, *, as_json: bool) -> None:
    """Print how every prototype went, with its NRMSE of q on the validation logs."""
    if as_json:
        emit_json({"output": output, "prototypes": [asdict(outcome) for outcome in outcomes]})
        return
    emit_table(
        f"{output}",
        ("prototype", "state", "validation NRMSE of q, or the reason"),
        [
            (
                outcome.name,
                "not started" if outcome.exit_code is None else "failed" if outcome.failed else "ok",
                outcome.reason or _summary(output / outcome.name),
            )
            for outcome in outcomes
        ],
        numeric_from=None,
    )
    if cost := sum(outcome.processor_seconds for outcome in outcomes):
        memory = max(outcome.memory_bytes for outcome in outcomes)
        counted = f"; at most {memory / 1e6:.0f} MB of memory in a process" if memory else ""
        typer.echo(f"{cost:.1f} s of processor time{counted}")


def _summary(run: Path) -> str:
    from ..workflow.report_data import load_scores

    scores = [s for s in load_scores(run) if s["role"] == "validation" and s["signal"] == "q"]
    errors = (f"{s['model']} {percent(s['nrmse']) if s['status'] == 'ok' else 'diverged'}" for s in scores)
    return ", ".join(errors) or "no validation log"
