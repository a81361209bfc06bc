"""The program and its command groups: options as dataclasses, and each failure as a line and an exit code."""

import errno
import inspect
import io
import os
import re
import signal
import sys
import traceback
import warnings
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import fields, is_dataclass
from functools import wraps
from pathlib import Path
from types import FrameType
from typing import Any

import typer
from typer.core import TyperGroup

from ..errors import WARNING, DebistError, InputError, SeveralMistakesError, interrupted, memory_failure
from .console import emit_json, printable, printed

_FOLDS = "`debist batch` with a settings file for each fold, whose logs have `start` and `stop`"
COMMANDS = {
    "plot": "`debist report RUN --figures sans` writes every figure; `debist.open_run(RUN).plot(FIGURE)` draws one",
    "repair": "`debist run PROTOTYPE.toml -o RUN` sets aside what is damaged and makes it anew",
    "study folds": _FOLDS,
    "study settings": "`debist batch TABLE.csv -o DIR` runs a row for each combination of settings",
}
_NO_FORCE = "name another place, or remove the file"
_NO_RUN = "leave it out: a sequence is designed for the joint of --parameters"
_IN_PANDAS = "`debist.open_run(RUN).scores()` in Python, then `.to_csv()` or `.to_latex(escape=True)`"
_IN_FILES = {
    "rig": (
        "experiment",
        {
            "faults": 'faults = ["gaps"]',
            "charging-time": "charging_time_s",
            "size": "size",
            "train": "training_logs",
            "validation": "validation_logs",
            "excitation": "excitation",
            "age": "age_days",
            "drift": "the table [drift]",
        },
    ),
    "rig simulate": ("experiment", {"play": "play"}),
    "rig excite": (
        "design",
        {
            "joints": "joints",
            "seed": "seed",
            "max-field": "max_field_V_per_um",
            "rest": "rest_s",
            "rate": "rate_Hz",
            "kinds": 'kinds = ["pulse"]',
            "basis-functions": "basis_functions",
            "candidates": "candidates",
        },
    ),
    "rig closed-loop": (
        "scenario",
        {
            "from": 'start = "left"',
            "format": "format",
            "lag": "lag_s",
            "highest": "highest_V",
            "push": "[[pushes]] start_s, force_N, length_s",
            "hand": "[[hands]] start_s, force_N, length_s",
            "shake": "[[shakes]] start_s, force_N, frequency_Hz, length_s",
            "drag": "drag_N",
            "friction": "friction",
            "lost": "[[lost]] start_s, length_s",
            "frozen": "[[frozen]] start_s, length_s",
            "barrier": "barrier_percent",
            "noise": "noise",
            "seed": "seed",
        },
    ),
}
"""Options that are entries of a TOML file now, by command: the option that names the file, and the entries."""
OPTIONS = {
    **{
        f"{command} --{option}": f"{entry} in the TOML file of --{file}"
        for command, (file, entries) in _IN_FILES.items()
        for option, entry in entries.items()
    },
    "--output": "-o",
    "--file": "-o",
    "--quiet": "-q",
    "-j": "--jobs",
    "-m": "--model",
    "-f": "--figure",
    "-c": "--controller",
    "-p": "--parameters",
    "--report": "leave it out: the report is made unless --no-report is given",
    "--keep-going": "leave it out: the others go on unless --fail-fast is given",
    "--capabilities": "`debist --help`, and the README",
    "batch --set": "a table with a row for each combination of settings, and `debist diff` for its runs",
    "validate --format": _IN_PANDAS,
    "compare --format": _IN_PANDAS,
    "diff --format": "--json",
    "diff --page": '`debist.open_run(RUN).plot("curves")` in Python, whose axes take the curves of another run',
    "series --format": "--json",
    "series -o": "the table, or --json",
    "series --page": "the table, or --json",
    "status --watch": "`watch debist status DIR`",
    "study --folds": _FOLDS,
    "study --by": _FOLDS,
    "study --model": _FOLDS,
    "verify --against": "`debist diff RUN RUN`, whose exit code is 0; its --json has a state for each artifact",
    "verify --all": "a loop of the shell over the runs",
    "verify --subset": "leave it out: all files are checked",
    "physics calibrate --search": "leave it out: a fit has one start; its threads are --jobs",
    "physics calibrate --set": 'a TOML file for --parameters: base = "nominal", then the values',
    "physics calibrate --force": _NO_FORCE,
    "physics calibrate --figure": "the table, or the correlations of --json",
    "rig --force": _NO_FORCE,
    "rig excite --run": _NO_RUN,
    "rig excite --programme": _NO_RUN,
    "rig excite --model": _NO_RUN,
}
"""Advice by the option, alone or after the command or group that had it."""


def replacement(error: Any, given: Sequence[str]) -> str | None:
    """The line for a usage error that comes of a command or an option that is gone; None for others.

    Parameters
    ----------
    error : Exception
        As typer raises it.
    given : sequence of str
        The words of the command.
    """
    for command in (" ".join(given[:2]), " ".join(given[:1])):
        if command in COMMANDS:
            return f"`debist {command}` is gone; instead: {COMMANDS[command]}"
    option = getattr(error, "option_name", None)
    context = getattr(error, "ctx", None)
    if option is None or context is None:
        return None
    path = context.command_path.split()[1:]
    for words in (" ".join([*path, option]), " ".join([*path[:1], option]), option):
        if (instead := OPTIONS.get(words)) is not None:
            return f"{option} is gone; instead: {instead}"
    return None


_STOPPED = "a file is written whole or not at all; the same command starts again"
_NO_MEMORY = (
    "debist: not enough memory; end other programs, lower --jobs or raise the limit (`ulimit -v`), and run again"
)
_PLACES = frozenset(
    getattr(errno, name)
    for name in ("EACCES", "EPERM", "EROFS", "ENOSPC", "EDQUOT", "ENOTDIR", "EISDIR", "EEXIST", "ENAMETOOLONG", "ELOOP")
)
"""Errors of a place that the user named, which are no bugs: read-only, full, or not what it should be."""
_FULL = (errno.EMFILE, errno.ENFILE)
ORDER = (
    "demo", "init", "inspect", "check", "run",
    "ingest", "differentiate", "identify", "validate", "compare", "report",
    "show", "status", "verify", "diff", "series",
    "batch", "fleet", "study", "export", "paper", "control", "rig", "physics", "warmup",
)  # fmt: skip


class WholeLines(TyperGroup):
    """A command group whose help cuts no line."""

    def list_commands(self, ctx: Any) -> list[str]:
        """The commands in the order of the work; those that it does not name come last, as they were added."""
        return sorted(super().list_commands(ctx), key=lambda name: (*ORDER, name).index(name))

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """Write the name of each command and the first line of its help, wrapped to the terminal."""
        commands = [(name, self.get_command(ctx, name)) for name in self.list_commands(ctx)]
        rows = [
            (name, " ".join((command.help or "").strip().partition("\n\n")[0].split()).removesuffix("."))
            for name, command in commands
            if command and not command.hidden
        ]
        if rows:
            with formatter.section("Commands"):
                formatter.write_dl(rows)


class Program(typer.Typer):
    """The commands, as a program of the system runs them: with its streams and its signals."""

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        """Run the program."""
        for number, name in enumerate(("stdin", "stdout", "stderr")):
            if getattr(sys, name) is None:  # closed, so that a file would be opened in its place
                setattr(sys, name, os.fdopen(os.open(os.devnull, os.O_RDWR), "r" if number == 0 else "w"))
            elif name == "stdout" and isinstance(sys.stdout, io.TextIOWrapper):
                sys.stdout.reconfigure(encoding="utf-8")
            elif name == "stderr" and not sys.stderr.isatty():
                sys.stderr = io.TextIOWrapper(_Unfailing(2, "w", closefd=False), "utf-8", write_through=True)
        for stop, usual in ((signal.SIGINT, signal.default_int_handler), (signal.SIGTERM, signal.SIG_DFL)):
            if signal.getsignal(stop) is usual:
                signal.signal(stop, _interrupt)
        return super().__call__(*arguments, **options)


class _Unfailing(io.FileIO):
    """A file for messages: a full disk or a closed pipe takes none, and that is no reason to stop."""

    def write(self, text: Any) -> int:
        """Write what can be written."""
        try:
            return super().write(text) or 0
        except OSError:
            return len(text)


_warned: set[str] = set()
"""Warnings that the command has printed."""
_signals: list[int] = []
"""Signals received to end the command; the compiler of kernels loses the exception, and fails in another way."""


def _interrupt(number: int, frame: FrameType | None) -> None:
    _signals.append(number)
    raise KeyboardInterrupt


class ErrorBoundary(WholeLines):
    """A command group that prints a known failure as one line and an unknown one as a traceback."""

    _given: Sequence[str] = ()

    def main(self, *arguments: Any, **options: Any) -> Any:
        """Run the program; also help and version meet a standard output that takes nothing."""
        given = arguments[0] if arguments else options.get("args")
        self._given = sys.argv[1:] if given is None else given
        printed.clear()
        _warned.clear()
        for stream in (sys.stdout, sys.stderr):
            if isinstance(stream, io.TextIOWrapper):
                stream.reconfigure(errors="backslashreplace")  # the bytes of a name that is not UTF-8
        try:
            with warnings.catch_warnings():
                warnings.filterwarnings("always", re.escape(WARNING))  # whatever PYTHONWARNINGS asks for
                warnings.showwarning = _show_warning  # type: ignore[assignment]
                return super().main(*arguments, **options)
        except Exception as error:
            if not memory_failure(error):
                if not isinstance(error, OSError) or not _stdout_fails():
                    raise
                typer.echo(f"debist: the output cannot be written: {error.strerror}; give it another place", err=True)
                os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # for what is held back
                sys.exit(InputError.exit_code)
        typer.echo(_NO_MEMORY, err=True)  # here, where what the command held is free again
        sys.exit(InputError.exit_code)

    def make_context(self, *arguments: Any, **options: Any) -> Any:
        """Read the options; help, too, may have a reader that goes."""
        try:
            return super().make_context(*arguments, **options)
        except BrokenPipeError as error:
            raise _unread() from error
        except Exception as error:
            self._name_replacement(error)
            raise

    def _name_replacement(self, error: Exception) -> None:
        """End with one line, if the error comes of a command or an option that is gone."""
        if _of_typer(error) and (text := replacement(error, self._given)):
            typer.echo(f"debist: {printable(text)}", err=True)
            self._emit_error(text, InputError.exit_code)
            raise typer.Exit(InputError.exit_code) from error

    def invoke(self, ctx: Any) -> Any:
        """Run the command; exit codes are those of `pipeline.errors`."""
        try:
            done = super().invoke(ctx)
            sys.stdout.flush()
            return done
        except KeyboardInterrupt as stopped:
            raise _interruption(str(stopped)) from stopped
        except (typer.Exit, typer.Abort):
            raise
        except Exception as error:
            if isinstance(error, OSError) and _stdout_fails():
                # Nobody reads standard output any more, which Windows calls an invalid argument.
                if isinstance(error, BrokenPipeError) or (os.name == "nt" and error.errno == errno.EINVAL):
                    raise _unread() from error
                raise
            if _of_typer(error):
                self._name_replacement(error)
                self._emit_error(getattr(error, "message", str(error)), InputError.exit_code)
                raise  # a usage error, which typer prints itself
            if interrupted(error) or _signals:
                raise _interruption() from error
            if memory_failure(error):
                raise MemoryError from error  # what the error says is only what came of it
            code = error.exit_code if isinstance(error, DebistError) else InputError.exit_code
            text = str(error) if isinstance(error, DebistError) else _remedy(error)
            if text is None:
                traceback.print_exc(file=sys.stderr)
                code = 1
                text = "this is a bug in debist; please report the lines above"
            first, *more = error.lines if isinstance(error, SeveralMistakesError) else (text,)
            typer.echo(f"debist: {printable(first)}", err=True)
            for line in more:
                typer.echo(f"  {printable(line)}", err=True)
            self._emit_error(text, code)
            raise typer.Exit(code) from error

    def _emit_error(self, message: str, exit_code: int) -> None:
        """Print a failure as the JSON document of a command with --json, unless it has printed its own before."""
        if "--json" in self._given and not printed:
            with suppress(OSError):  # the exit code says the same
                emit_json({"error": {"message": message, "exit_code": exit_code}})


def _of_typer(error: Exception) -> bool:
    """True if typer raised the error for the user's arguments."""
    return type(error).__module__.startswith(("typer", "click"))


def _show_warning(message: Warning | str, *_: Any) -> None:
    """Print a warning of debist as one line, once; those of libraries are for developers.

    While a `StatusLine` is shown, `sys.stderr` prints above it; the stream that `typer.echo` takes by itself, onto it.
    """
    if str(message).startswith(WARNING) and str(message) not in _warned:
        _warned.add(str(message))
        typer.echo(f"warning: {printable(str(message).removeprefix(WARNING))}", file=sys.stderr, err=True)


def _unread() -> typer.Exit:
    """Exit of a command whose reader has gone (`debist show RUN | head -1`), as SIGPIPE ends other programs."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # for what is held back
    return typer.Exit(128 + _SIGPIPE)


_SIGPIPE = 13  # which Windows lacks


def _interruption(goes_on: str = "") -> typer.Exit:
    """Exit of a command that Ctrl-C or SIGTERM has stopped, after a line on stderr."""
    number = _signals[0] if _signals else signal.SIGINT
    what = "interrupted" if number == signal.SIGINT else f"ended by {signal.Signals(number).name}"
    typer.echo(f"debist: {what}; {goes_on or _STOPPED}", err=True)
    return typer.Exit(128 + number)


def _remedy(error: Exception) -> str | None:
    """The remedy for an exception from outside debist that is not a bug; None for a bug."""
    if isinstance(error, RuntimeError) and "no locator available" in str(error):  # numba's words
        return "no folder for the compiled kernels; set NUMBA_CACHE_DIR to one that can be written"
    if isinstance(error, OSError) and error.errno in _FULL:
        return f"{os.strerror(error.errno)}; raise the limit (`ulimit -n`), or end other programs"
    if isinstance(error, OSError) and error.errno in (errno.ENOSPC, errno.EDQUOT) and not error.filename:
        return f"{os.strerror(error.errno)}; make room where results, compiled kernels and temporary files (TMPDIR) lie"
    if isinstance(error, FileNotFoundError) and not error.filename:
        return "the current folder was deleted; change into another one"
    if isinstance(error, OSError) and error.filename and error.errno in _PLACES:
        place = printable(os.fsdecode(error.filename))
        why = os.strerror(error.errno or 0)
        denied = error.errno in (errno.EACCES, errno.EPERM)
        unreadable = denied and Path(place).exists() and not os.access(error.filename, os.R_OK)
        return f"{place}: cannot be {'read' if unreadable else 'written'}: {why}; choose another place, or see to it"
    return None


def _stdout_fails() -> bool:
    """True if standard output takes nothing more, as on a full disk."""
    try:
        os.write(1, b"\n")
    except OSError:
        return True
    return False


def group(text: str) -> typer.Typer:
    """A group of commands with its help."""
    return typer.Typer(cls=WholeLines, no_args_is_help=True, rich_markup_mode=None, help=text)


def with_options(command: Callable[..., None]) -> Callable[..., None]:
    """A command that typer gives the fields of its dataclass parameters, each as an option of its own.

    The fields carry `typer.Option` in their annotations, as parameters of a command do.
    """
    signature = inspect.signature(command, eval_str=True)
    groups: dict[str, Any] = {
        name: parameter.annotation
        for name, parameter in signature.parameters.items()
        if is_dataclass(parameter.annotation)
    }
    parameters = [
        each.replace(kind=inspect.Parameter.KEYWORD_ONLY)
        for name, parameter in signature.parameters.items()
        for each in (
            inspect.signature(groups[name], eval_str=True).parameters.values() if name in groups else [parameter]
        )
    ]

    @wraps(command)
    def from_options(**values: Any) -> None:
        """Run the command with its options gathered in their dataclasses."""
        for name, group in groups.items():
            values[name] = group(**{field.name: values.pop(field.name) for field in fields(group)})
        command(**values)

    from_options.__signature__ = signature.replace(parameters=parameters)  # type: ignore[attr-defined]
    from_options.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    return from_options
