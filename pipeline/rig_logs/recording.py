"""A raw log: its channels, each on its own time base."""

import difflib
from dataclasses import dataclass
from pathlib import Path
from typing import Generic, TypeVar

from pipeline.errors import InputError
from pipeline.numerics.arrays import Samples

_MOST_LISTED = 30

Column = TypeVar("Column", bound=Samples)


@dataclass(frozen=True)
class Channel(Generic[Column]):
    """One channel of a raw log, in the numbers of the log; its columns are arrays, or samples on disk.

    Attributes
    ----------
    name : str
        Name in the log.
    unit : str
        Unit as the log writes it, "" where it says nothing; information only, the settings decide.
    time : FloatArray or Samples, N of them, or None
        The channel's own time base [s]; None where the format has none (a column of a table).
    samples : FloatArray or Samples, N of them
        Samples, converted to float64, read-only.
    dtype : str
        Type of the numbers in the log, such as ``float32``.
    """

    name: str
    unit: str
    time: Column | None
    samples: Column
    dtype: str


@dataclass(frozen=True)
class Recording(Generic[Column]):
    """A raw log, or the part of it that was asked for.

    Attributes
    ----------
    path : Path
        The file.
    format : str
        Its format in words, such as ``MAT v5, ControlDesk``.
    channels : tuple of Channel
        The channels that were asked for, under the names by which they were asked for.
    listed : tuple of str
        Names of all numeric channels of the log.
    notes : tuple of str
        What a reader should know, such as the dialect that was found in a CSV file.
    """

    path: Path
    format: str
    channels: tuple[Channel[Column], ...]
    listed: tuple[str, ...]
    notes: tuple[str, ...] = ()

    def channel(self, name: str) -> Channel[Column]:
        """The channel of that name.

        Raises
        ------
        InputError
            It was not read, or the log has none of that name.
        """
        for channel in self.channels:
            if channel.name == name:
                return channel
        raise InputError(missing_channel(self.path, name, self.listed))


def missing_channel(path: Path, name: str, listed: tuple[str, ...]) -> str:
    """One line that says what is there instead of the channel `name`."""
    if not listed:
        return f"{path}: no channel {name!r}; the log holds no numeric channel at all"
    folded = {entry.casefold(): entry for entry in listed}
    close = [folded[match] for match in difflib.get_close_matches(name.casefold(), list(folded), n=3, cutoff=0.5)]
    hint = f"did you mean {' or '.join(map(repr, close))}? " if close else ""
    shown = ", ".join(map(repr, listed[:_MOST_LISTED])) + (", …" if len(listed) > _MOST_LISTED else "")
    return f"{path}: no channel {name!r}; {hint}it has {shown}"
