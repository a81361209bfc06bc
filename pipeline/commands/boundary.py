"""The one place where a failure becomes a line and an exit code; a death of the process as well.

The work goes on in a child process, and a small parent waits. Where memory runs out C and C++ libraries abort or crash
the process, and the kernel kills it; no Python can run there. The parent does nothing but wait, and hands on the
signals that it is sent.
"""

import errno
import io
import os
import signal
import sys
import threading
import time
import traceback
from contextlib import suppress
from functools import cache
from pathlib import Path
from types import FrameType
from typing import Any

import typer
from typer.core import TyperGroup

from pipeline.child_processes import died_of, end_with, exit_code, flush
from pipeline.errors import DebistError, InputError, interrupted, memory_failure

_INTERRUPTED = 130  # as shells say it
_STOPPED = "a file is written whole or not at all; the same command starts again"
_AT_ONCE, _COMPLETION = frozenset(("--help", "--version")), "_DEBIST_COMPLETE"
_NO_MEMORY = b"debist: not enough memory; end other programs, or lower --jobs, and run again\n"
_PLACES = frozenset(
    getattr(errno, name)
    for name in ("EACCES", "EPERM", "EROFS", "ENOSPC", "EDQUOT", "ENOTDIR", "EISDIR", "EEXIST", "ENAMETOOLONG", "ELOOP")
)
"""What is wrong with a place that the user named, and no bug: read-only, full, or not what it should be."""
ORDER = (
    "demo", "init", "inspect", "check", "run",
    "ingest", "differentiate", "identify", "validate", "compare", "report",
    "show", "plot", "status", "verify", "repair", "sign", "diff",
    "batch", "study", "export", "paper", "control", "rig", "physics", "warmup",
)  # fmt: skip


class WholeLines(TyperGroup):
    """A command group whose help cuts no line."""

    def list_commands(self, ctx: Any) -> list[str]:
        """The commands in the order of the work; those that it does not name come last, as they were added."""
        names = super().list_commands(ctx)
        return sorted(names, key=lambda name: ORDER.index(name) if name in ORDER else len(ORDER))

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """Write the name of each command and the first line of its help, wrapped to the terminal."""
        commands = [(name, self.get_command(ctx, name)) for name in self.list_commands(ctx)]
        rows = [(name, _first_line(command.help or "")) for name, command in commands if command and not command.hidden]
        if rows:
            with formatter.section("Commands"):
                formatter.write_dl(rows)


def _first_line(text: str) -> str:
    return " ".join(text.strip().partition("\n\n")[0].split()).removesuffix(".")


class Program(typer.Typer):
    """The commands; where memory ends, be it before one is found or while another failure is told, a line says so."""

    @cache  # noqa: B019  # there is one program
    def make_commands(self) -> Any:
        """All commands with their options; a batch copies the process that has them."""
        return typer.main.get_command(self)

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        """Run the program in a child process, so that its death too is told; what answers at once needs none."""
        computes = sys.argv[1:] and not _AT_ONCE.intersection(sys.argv) and _COMPLETION not in os.environ
        if computes and watch():
            os._exit(exit_code(lambda: self.work(*arguments, **options)))
        return self.work(*arguments, **options)

    def work(self, *arguments: Any, **options: Any) -> Any:
        """Run the program in this process, as a worker does whose parent tells of its death."""
        sys.unraisablehook = _tell_ignored
        try:
            try:
                return self.make_commands()(*arguments, **options)
            except BaseException as error:
                if not memory_failure(error):
                    raise
                error.__traceback__ = error.__context__ = error.__cause__ = None  # with what their frames hold
        except MemoryError:
            pass  # to ask what happened takes memory too
        os.write(2, _NO_MEMORY)
        os._exit(InputError.exit_code)  # for there is no memory either to take the interpreter down


def _tell_ignored(ignored: Any) -> None:
    """Tell of an exception that could go nowhere, but not that memory ended while something was taken down."""
    if not issubclass(ignored.exc_type, MemoryError):
        sys.__unraisablehook__(ignored)


class ErrorBoundary(WholeLines):
    """A command group that prints a known failure as one line and an unknown one as a traceback."""

    def main(self, *arguments: Any, **options: Any) -> Any:
        """Run the program; also help and version meet a standard output that takes nothing."""
        try:
            return super().main(*arguments, **options)
        except OSError as error:
            if memory_failure(error) or not _stdout_fails():
                raise
            typer.echo(f"debist: the output cannot be written: {error.strerror}; give it another place", err=True)
            os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # for what is held back
            sys.exit(InputError.exit_code)

    def invoke(self, ctx: Any) -> Any:
        """Run the command; exit codes are those of `pipeline.errors`."""
        for stream in (sys.stdout, sys.stderr):
            if isinstance(stream, io.TextIOWrapper):  # a name that is not UTF-8 is shown with its bytes written out
                stream.reconfigure(errors="backslashreplace")
        try:
            done = super().invoke(ctx)
            if sys.stdout:  # None where it was closed
                sys.stdout.flush()
            return done
        except DebistError as error:
            if interrupted(error) or _Interruption.came:
                raise _interruption() from error
            if memory_failure(error):
                raise  # what it says is only what came of it
            from pipeline.commands.console import printable

            first, *more = getattr(error, "lines", (str(error),))
            typer.echo(f"debist: {printable(first)}", err=True)
            for line in more:
                typer.echo(f"  {printable(line)}", err=True)
            raise typer.Exit(error.exit_code) from error
        except KeyboardInterrupt as stopped:
            raise _interruption(str(stopped)) from stopped
        except (typer.Exit, typer.Abort, BrokenPipeError):
            raise
        except Exception as error:
            if isinstance(error, OSError) and _stdout_fails():
                raise
            if type(error).__module__.startswith(("typer", "click")):
                raise  # a usage error, which typer prints itself
            if interrupted(error) or _Interruption.came:
                raise _interruption() from error
            if memory_failure(error):
                raise
            told = _told(error)
            if told is None:
                traceback.print_exc(file=sys.stderr)
            typer.echo(f"debist: {told or 'this is a bug in debist; please report the lines above'}", err=True)
            raise typer.Exit(1 if told is None else InputError.exit_code) from error


def _interruption(said: str = "") -> typer.Exit:
    """How a command ends that Ctrl-C stopped, which is told."""
    typer.echo(f"debist: interrupted; {said or _STOPPED}", err=True)
    return typer.Exit(_INTERRUPTED)


def _told(error: Exception) -> str | None:
    """What a user can do about an exception that is none of debist's, and no bug; None for a bug."""
    if isinstance(error, RuntimeError) and "no locator available" in str(error):  # numba's words
        return "no folder for the compiled kernels; set NUMBA_CACHE_DIR to one that can be written"
    if isinstance(error, OSError) and error.filename and error.errno in _PLACES:
        from pipeline.commands.console import printable

        place, why = printable(os.fsdecode(error.filename)), os.strerror(error.errno or 0)
        denied = error.errno in (errno.EACCES, errno.EPERM)
        unreadable = denied and Path(place).exists() and not os.access(error.filename, os.R_OK)
        return f"{place}: cannot be {'read' if unreadable else 'written'}: {why}; choose another place, or see to it"
    return None


def _stdout_fails() -> bool:
    """Whether standard output takes nothing more, as on a full disk."""
    try:
        os.write(1, b"\n")
    except OSError:
        return True
    return False


def group(text: str) -> typer.Typer:
    """A group of commands with its help."""
    return typer.Typer(cls=WholeLines, no_args_is_help=True, rich_markup_mode=None, help=text)


_SAME_INTERRUPTION = 1.0
"""Seconds within which a terminal's Ctrl-C, which both processes get, may come again from the parent."""


def watch() -> bool:
    """Go on in a child, whose end this process waits for; it ends with the child's exit code.

    Where processes cannot be copied, or there are threads, all goes on in this one, and the answer is False. A death by
    a signal that this process was not sent is told on standard error, and has the exit code 128 + its number.
    """
    if not hasattr(os, "fork") or threading.active_count() > 1:
        return False
    ended_by = (signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT)
    handed_on = (*ended_by, signal.SIGINT, signal.SIGTSTP, signal.SIGCONT)
    flush()
    signal.pthread_sigmask(signal.SIG_BLOCK, handed_on)
    try:
        parent, child = os.getpid(), os.fork()
    except OSError:  # no more processes
        signal.pthread_sigmask(signal.SIG_UNBLOCK, handed_on)
        return False
    if child == 0:
        end_with(parent)
        if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
            signal.signal(signal.SIGINT, _Interruption())
        signal.pthread_sigmask(signal.SIG_UNBLOCK, handed_on)
        return True
    for number in handed_on:
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, lambda sent, _: _hand_on(child, sent))
    signal.pthread_sigmask(signal.SIG_UNBLOCK, handed_on)
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    if -code in ended_by:
        signal.signal(-code, signal.SIG_DFL)
        os.kill(os.getpid(), -code)
    elif code < 0 and -code != signal.SIGINT:  # which may come once more after the child has told of it
        with suppress(OSError):
            os.write(2, f"debist: {died_of(-code)}\n".encode())
    os._exit(code if code >= 0 else 128 - code)


class _Interruption:
    """Raises `KeyboardInterrupt`, once if the parent hands on what the terminal has sent to both.

    `came`: whether it has; what compiles kernels loses the exception and fails for the lack of what it was making.
    """

    came = False

    def __init__(self) -> None:
        self._last = float("-inf")

    def __call__(self, number: int, frame: FrameType | None) -> None:
        last, self._last = self._last, time.monotonic()
        if self._last - last > _SAME_INTERRUPTION:
            _Interruption.came = True
            signal.default_int_handler(number, frame)


def _hand_on(child: int, number: int) -> None:
    """Send the child a signal; one that stops it stops this process as well, as the shell expects."""
    with suppress(ProcessLookupError):
        os.kill(child, number)
    if number == signal.SIGTSTP:
        handler = signal.signal(number, signal.SIG_DFL)
        os.kill(os.getpid(), number)
        signal.signal(number, handler)
