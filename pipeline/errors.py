"""What can go wrong, as one line for the user; the only mapping from failure to exit code."""

from typing import ClassVar


class DebistError(Exception):
    """A failure that the user can act on; its text names the file, the channel or the key, and the next step."""

    exit_code: ClassVar[int] = 2


class InputError(DebistError):
    """Bad usage or bad input: settings, raw logs, units, options."""

    exit_code = 2


class DataRefusedError(DebistError):
    """The data are readable, but a quality gate refuses to build a model on them."""

    exit_code = 3


class CorruptArtifactError(DebistError):
    """An artifact of a run is damaged, edited or incomplete."""

    exit_code = 4


class RunLockedError(DebistError):
    """Another process works on the run."""

    exit_code = 5


class BatchFailedError(DebistError):
    """Some prototypes of a batch failed; the others are complete."""

    exit_code = 6
