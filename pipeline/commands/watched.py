"""The work in a child process, and a small parent that waits: what ends the child at once is still told in a line.

Where memory runs out C and C++ libraries abort or crash the process, and the kernel kills it; no Python can run there.
The parent has loaded no library, does nothing but wait, and hands on the signals that it is sent.
"""

import os
import signal
import threading
import time
from contextlib import suppress
from types import FrameType

from pipeline.child_processes import died_of, end_with, flush

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
    """Raises `KeyboardInterrupt`, once if the parent hands on what the terminal has sent to both."""

    def __init__(self) -> None:
        self._last = float("-inf")

    def __call__(self, number: int, frame: FrameType | None) -> None:
        last, self._last = self._last, time.monotonic()
        if self._last - last > _SAME_INTERRUPTION:
            signal.default_int_handler(number, frame)


def _hand_on(child: int, number: int) -> None:
    """Send the child a signal; one that stops it stops this process as well, as the shell expects."""
    with suppress(ProcessLookupError):
        os.kill(child, number)
    if number == signal.SIGTSTP:
        handler = signal.signal(number, signal.SIG_DFL)
        os.kill(os.getpid(), number)
        signal.signal(number, handler)
