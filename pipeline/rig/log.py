"""A raw log before it becomes a file: one time base, three channels, and the names and units each format uses."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from pipeline.numerics.arrays import BoolArray, FloatArray

# Displacement and voltages per SI unit
_SCALES = {"mm": 1e3, "µm": 1e6, "kV": 1e-3, "V": 1.0}


@dataclass(frozen=True)
class RawLog:
    """Readings of one experiment, each of shape (N,): t [s], q [m], v1 (left) and v2 (right) [V]."""

    t: FloatArray
    q: FloatArray
    v1: FloatArray
    v2: FloatArray

    def kept(self, keep: BoolArray) -> "RawLog":
        """The samples where `keep`, shape (N,), is true."""
        return RawLog(self.t[keep], self.q[keep], self.v1[keep], self.v2[keep])

    def repeated(self, at: int) -> "RawLog":
        """The log with sample `at` standing twice, as a logger that writes a row again."""
        order = np.insert(np.arange(self.t.size), at, at)
        return RawLog(self.t[order], self.q[order], self.v1[order], self.v2[order])

    def with_q(self, q: FloatArray) -> "RawLog":
        """The log with other displacement readings."""
        return replace(self, q=q)


@dataclass(frozen=True)
class Layout:
    """How a rig of one make names its channels.

    Attributes
    ----------
    suffix : str
        Ending of the file's name.
    time : tuple of (str, str) or None
        Name and unit of the time channel; None where the format carries its own time base.
    q, v1, v2 : tuple of (str, str)
        Name and unit.
    write : callable
        Writes (path, t, channels: name → samples and unit).
    """

    suffix: str
    time: tuple[str, str] | None
    q: tuple[str, str]
    v1: tuple[str, str]
    v2: tuple[str, str]
    write: Callable[[Path, FloatArray, dict[str, tuple[FloatArray, str]]], None]

    def save(self, log: RawLog, path: Path) -> None:
        """Write `log` in this layout, its samples in the layout's units."""
        samples = {self.q: log.q, self.v1: log.v1, self.v2: log.v2}
        channels = {name: (values * _SCALES[unit], unit) for (name, unit), values in samples.items()}
        self.write(path, log.t, channels)

    def toml(self) -> str:
        """The ``[channels]`` table of a prototype with logs of this layout."""
        entries = {"time": self.time, "q": self.q, "v1": self.v1, "v2": self.v2}
        lines = [
            f'{key} = {{ channel = "{entry[0]}", unit = "{entry[1]}" }}' for key, entry in entries.items() if entry
        ]
        return "\n".join(["[channels]", *lines]) + "\n"
