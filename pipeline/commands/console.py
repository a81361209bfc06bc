"""Tables and JSON on stdout, progress and log lines on stderr, and nothing from a file printed raw.

With the options and arguments that commands share.
"""

import errno
import json
import os
import shutil
import sys
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Annotated, Any, Self

import typer

from ..units.quantity import prefixed

if TYPE_CHECKING:
    from ..workflow.engine import Task

_PIPE_COLUMNS = 160
_SENTENCE = 21  # columns of the longest name of a model; longer texts may be wrapped
_GAP = 2  # columns between two of a table


def printable(text: str) -> str:
    """The text with every control character (terminal escapes, line feeds, direction marks) written out."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


printed: list[Any] = []
"""JSON documents that the command has printed: there is one at most."""


def with_units(values: Mapping[str, Any], units: Mapping[str, str]) -> dict[str, Any]:
    """The values under keys that end in their units, where they have one: ``misfit_m``."""
    from ..units.units import column_suffix

    suffixes = {key: column_suffix(unit) for key, unit in units.items() if unit not in ("", "1")}
    return {f"{key}_{suffixes[key]}" if key in suffixes else key: value for key, value in values.items()}


def emit_json(document: Any) -> None:
    """Print one JSON document; a number that is not finite would be a bug and raises."""
    printed.append(document)
    typer.echo(
        json.dumps(
            document,
            indent=1,
            ensure_ascii=False,
            allow_nan=False,
            default=lambda value: str(value) if isinstance(value, Path) else value.tolist(),
        )
    )


def emit_text(text: str, *, indent: str = "") -> None:
    """Print sentences, wrapped between words where a terminal would break them in the middle of one."""
    for line in text.splitlines():
        wrapped = textwrap.fill(
            printable(line), _width(), subsequent_indent=indent, break_on_hyphens=False, break_long_words=False
        )
        typer.echo(wrapped if sys.stdout.isatty() or "COLUMNS" in os.environ else printable(line))


def _width() -> int:
    """Columns of the terminal, or of COLUMNS; a pipe has no width of its own: wide enough that nothing is folded."""
    return shutil.get_terminal_size((_PIPE_COLUMNS, 24)).columns


def emit_table(
    title: str, header: Sequence[str], rows: Iterable[Sequence[str]], *, numeric_from: int | None = 1
) -> None:
    """Print a table; columns from `numeric_from` on, if any, are aligned right.

    Where the terminal is too narrow, sentences are wrapped, and columns of numbers that do not fit follow below with
    the first column beside them; no number is cut or broken.
    """
    from rich.box import SIMPLE_HEAD
    from rich.cells import cell_len
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    class Printer(Console):
        def on_broken_pipe(self) -> None:
            """Raise, where rich would end the process."""
            raise BrokenPipeError(errno.EPIPE, os.strerror(errno.EPIPE))  # for `pipeline.commands.boundary`

    words = len(header) if numeric_from is None else numeric_from
    cells = [[printable(cell) for cell in row] for row in rows]
    widths = [max(cell_len(row[k]) for row in (list(header), *cells)) for k in range(len(header))]
    fitted = [
        width if k and (k >= words or width < _SENTENCE) else min(width, _SENTENCE) for k, width in enumerate(widths)
    ]
    blocks: list[list[int]] = [[0]]
    for k in range(1, len(header)):
        if sum(fitted[i] + _GAP for i in (*blocks[-1], k)) + _GAP > _width() and len(blocks[-1]) > 1:
            blocks.append([0])
        blocks[-1].append(k)
    for block in blocks:
        heading = Text(printable(title)) if title and block is blocks[0] else None
        table = Table(title=heading, title_justify="left", box=SIMPLE_HEAD, padding=(0, 1, 0, 0))
        for k in block:
            table.add_column(
                Text(header[k]),
                justify="right" if k >= words else "left",
                no_wrap=widths[k] == fitted[k],
                overflow="fold",
            )
        for row in cells:
            table.add_row(*(Text(row[k]) for k in block))
        Printer(width=_width(), highlight=False).print(table)


def brief(reasons: Sequence[str]) -> str:
    """The first reason, and how many more there are."""
    more = f" (and {len(reasons) - 1} more)" if len(reasons) > 1 else ""
    return f"{reasons[0]}{more}" if reasons else ""


class StatusLine:
    """A line on stderr that is rewritten while work goes on; shown on a terminal alone, and not with `-q`.

    In a ``with`` statement, a user who stops the command reads what is kept.
    """

    def __init__(self, first: str = "", *, quiet: bool = False) -> None:
        self._quiet = quiet
        self._line: Any = None
        if sys.stderr.isatty() and not quiet:
            from rich.console import Console

            self._line = Console(stderr=True).status("")
        if first:
            self.show(first)

    @property
    def kept(self) -> str:
        """What a stopped command leaves; empty where it leaves nothing."""
        return ""

    def show(self, what: str, share: float | None = None) -> None:
        """Rewrite the line: what is done, and the share that is done."""
        if self._line is not None:
            from rich.text import Text

            self._line.update(Text(printable(what if share is None else f"{what}, {prefixed(share, '%', 0)} %")))
            self._line.start()

    def clear(self) -> None:
        """Take the line away until it is shown again."""
        if self._line is not None:
            self._line.stop()

    def say(self, text: str) -> None:
        """Print a line that stays, in place of the one that is rewritten."""
        self.clear()
        typer.echo(printable(text), err=True)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Restore the terminal; if the user has stopped the command, report what is kept."""
        self.clear()
        if isinstance(error, KeyboardInterrupt):
            error.args = (self.kept,)


class Progress(StatusLine):
    """Progress of a run on stderr; the task and its share where stderr is a terminal, one line per task where not."""

    def __init__(self, *, quiet: bool = False) -> None:
        super().__init__(quiet=quiet)
        self._total = 0
        self._at = 0
        self._made = 0
        self._quarter = 0

    @property
    def kept(self) -> str:
        """The finished steps."""
        if not self._made:
            return "no step was finished yet; the same command starts again"
        steps = f"{self._made} finished step{'s' if self._made > 1 else ''}"
        return f"the results of {steps} are kept; the same command goes on from there"

    @property
    def _place(self) -> str:
        """`` (k of n)``, or nothing where n is not known; n grows if more comes than was planned."""
        return f" ({self._at} of {max(self._total, self._at)})" if self._total else ""

    def planned(self, stages: Sequence[str]) -> None:
        """Count from here on."""
        self._total = len(stages)

    def started(self, task: "Task", reasons: list[str]) -> None:
        """Say what is done and why."""
        self._at += 1
        line = f"{task.stage} {task.title}{self._place}: {brief(reasons)}"
        self.show(line)
        if self._line is None and not self._quiet:
            self.say(line)

    def progressed(self, task: "Task", what: str, share: float) -> None:
        """Show the share; without a terminal, in a line for each quarter of a task of `debist control`, which may take
        minutes.
        """
        self.show(f"{task.stage} {task.title}{self._place}: {what}", share)
        quarter = int(4.0 * share)
        if self._line is None and not self._quiet and task.stage == "control" and quarter > self._quarter:
            self.say(f"{task.stage} {task.title}: {what}, {prefixed(share, '%', 0)} %")
        self._quarter = quarter

    def finished(self, task: "Task", seconds: float) -> None:
        """Print how long it took."""
        self._made += 1
        if not self._quiet:
            self.say(f"{task.stage} {task.title}: done in {seconds:.1f} s")

    def warned(self, what: str, warning: str) -> None:
        """Print a warning, also with `-q`."""
        self.say(f"warning: {what}: {warning}")

    def skipped(self, task: "Task") -> None:
        """Ignore this task; the summary counts it."""
        self._at += 1


def run_of(given: Path) -> Path:
    """The run folder that an argument means: itself, or that of a settings file."""
    if given.suffix.lower() != ".toml" or not given.is_file():
        return given
    from ..workflow.place import run_folder

    return run_folder(given)


def runs_of(given: list[Path]) -> list[Path]:
    """The run folders that some arguments mean."""
    return [run_of(place) for place in given]


Run = Annotated[
    Path, typer.Argument(metavar="RUN", help="Run folder, or the settings file of a run in runs/NAME.", callback=run_of)
]
Runs = Annotated[
    list[Path],
    typer.Argument(metavar="RUN...", help="Run folders, or settings files of runs in runs/NAME.", callback=runs_of),
]
PrototypeFile = Annotated[
    Path, typer.Argument(metavar="PROTOTYPE.toml", help="Settings of one prototype, or the folder of its run.")
]
Json = Annotated[bool, typer.Option("--json", help="Print one JSON document on stdout and nothing else there.")]
Quiet = Annotated[bool, typer.Option("-q", help="No progress on stderr.")]
Force = Annotated[bool, typer.Option("--force", help="Replace files that others wrote or changed; never a log.")]
Parameters = Annotated[
    str, typer.Option("--parameters", metavar="SET", help="table1, nominal, or a TOML file with units.")
]
Output = Annotated[Path | None, typer.Option("-o", metavar="RUN", help="Run folder [default: runs/NAME].")]
NoReport = Annotated[bool, typer.Option("--no-report", help="Make no report.")]
Details = Annotated[bool, typer.Option("--details", help="The whole tables: every log, intervals, horizons.")]
