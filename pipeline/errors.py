"""Failures and warnings, each as one line for the user; the only mapping from failure to exit code."""

import errno
import os
import re
import sys
import warnings
from collections.abc import Sequence
from traceback import walk_stack
from typing import ClassVar

_DISK = (errno.EIO, errno.ESTALE, errno.ENXIO, errno.ENODEV, errno.ETIMEDOUT, errno.EACCES, errno.EMFILE, errno.ENFILE)
_NO_MEMORY = re.compile(
    "annot allocate memory|[Aa]llocation (failed|error)|(can't|nable to|ailed to) alloc|malloc of size|bad_alloc|"
    "[Oo]ut of memory|failed to map segment|"
    "envelope routines\\] initialization error|"  # OpenSSL of a digest
    "without exception set|without setting an exception|with an exception set"  # CPython of C code that failed wrongly
)
WARNING = "debist: "
"""Beginning of each warning."""
_IN_HDF5 = re.compile(r"errno = (\d+), error message = ")


class DebistError(Exception):
    """A failure that the user can act on; its text names the file, the channel or the key, and the next step."""

    exit_code: ClassVar[int] = 2


class InputError(DebistError):
    """Bad usage or bad input: settings, raw logs, units, options."""


class SeveralMistakesError(InputError):
    """Several things are wrong at once; each has a line of its own where there is room for lines.

    Attributes
    ----------
    lines : tuple of str
        The file with the number of mistakes, then the mistakes.
    """

    def __init__(self, where: str, mistakes: Sequence[str]) -> None:
        super().__init__(where, mistakes)  # by which it is pickled
        self.lines = (f"{where}: {len(mistakes)} mistakes", *mistakes)

    def __str__(self) -> str:
        """All mistakes in one line."""
        return f"{self.lines[0]}: {'; '.join(f'({i}) {text}' for i, text in enumerate(self.lines[1:], 1))}"

    @classmethod
    def of(cls, where: str, mistakes: Sequence[str]) -> InputError:
        """The error for these mistakes; a single one is a plain line."""
        return cls(where, mistakes) if len(mistakes) > 1 else InputError(f"{where}: {mistakes[0]}")


class DataRefusedError(DebistError):
    """The data are readable, but a quality gate refuses to build a model on them."""

    exit_code = 3


class CorruptArtifactError(DebistError):
    """An artifact of a run is damaged, edited or incomplete."""

    exit_code = 4


class SupersededError(CorruptArtifactError):
    """Artifact that another process replaced while it was read; to read it again is the remedy."""


class RunLockedError(DebistError):
    """Another process works on the run."""

    exit_code = 5


class BatchFailedError(DebistError):
    """Some prototypes of a batch failed; the others are complete."""

    exit_code = 6


def warn_user(text: str) -> None:
    """Give a `UserWarning` at the line that called debist; the program prints it on stderr."""
    packages = [str(frame.f_globals.get("__name__")).partition(".")[0] for frame, _ in walk_stack(sys._getframe())]
    own = [level for level, package in enumerate(packages, start=1) if package in ("pipeline", "debist")]
    warnings.warn(f"{WARNING}{text}", stacklevel=max(own) + 1)


def disk_failure(error: Exception) -> str | None:
    """The system's reason for a refused read; None if `error` may also mean damage."""
    stated = _IN_HDF5.search(str(error))
    number = int(stated[1]) if stated else getattr(error, "errno", None)
    return os.strerror(number) if number in _DISK else None


def interrupted(error: BaseException | None) -> bool:
    """True if this error came of Ctrl-C."""
    if error is None or isinstance(error, KeyboardInterrupt):
        return error is not None
    cause = error.__cause__
    return interrupted(cause) or (error.__context__ is not cause and interrupted(error.__context__))


def memory_failure(error: BaseException | None) -> bool:
    """True if memory ended, by the text of this error or of one that caused it."""
    if interrupted(error):
        return False  # compiled code that a signal stops says what it also says where memory ends
    while error is not None:
        may_state_it = isinstance(error, ImportError | OSError | SystemError | RuntimeError | ValueError)
        if isinstance(error, MemoryError) or (may_state_it and _NO_MEMORY.search(str(error))):
            return True
        error = error.__cause__ or error.__context__
    return False
