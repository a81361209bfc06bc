"""MDF logs (ASAM, versions 3 and 4) through asammdf; each channel keeps the time base of its group.

A channel whose conversion is a formula is named and not read: a formula is a text that would have to be run. asammdf
gives raw numbers, without a word, where numexpr refuses one, or has sympy run it as Python where that is installed.
"""

import mmap
import re
import weakref
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..units.units import SECONDS, time_unit
from .source import (
    Entry,
    Source,
    UnreadableChannelError,
    UnreadableLogError,
    left_out,
    ranges,
    unique_names,
)

_FORMULA = "the result of a conversion formula, which is not worked out; export the channel with its physical values"
_MASTERS = {2: "an angle", 3: "a distance", 4: "an index"}
"""Quantities that a group of version 4 may have in place of time."""
_TEXTS = {"4": (7, 8, 9, 10, 11), "3": (11, 12, 132, 133)}
"""Conversions to texts and dates."""
_KINDS = {
    "4": {0: "uint", 1: "uint", 2: "int", 3: "int", 4: "float", 5: "float"},
    "3": {
        **dict.fromkeys((0, 9, 13), "uint"),
        **dict.fromkeys((1, 10, 14), "int"),
        **dict.fromkeys((2, 3, 11, 12, 15, 16), "float"),
    },
}
"""Types of stored numbers by version; others are texts, byte arrays, dates and structures."""


def _has_formula(conversion: Any) -> bool:
    """True if a channel's conversion is a formula, or holds one within a table of conversions."""
    if getattr(conversion, "formula", ""):
        return True
    inner = (getattr(conversion, "referenced_blocks", None) or {}).values()
    return any(_has_formula(block) for block in inner if hasattr(block, "conversion_type"))


class MdfSource(Source):
    """An MDF log. No channel is brought onto another one's raster, so no sample is invented."""

    def __init__(self, path: Path, *_: object) -> None:
        from asammdf import MDF
        from asammdf.blocks import mdf_v4, v2_v3_blocks, v4_blocks

        for blocks in (v2_v3_blocks, v4_blocks):
            vars(blocks)["lambdify"] = None  # sympy's: it would run a formula in the log as Python
        # From 200 MiB on, asammdf 8.8 takes a path that reads whole channels for any slice, and fails for slices.
        vars(mdf_v4)["validate_blocks"] = lambda *_: False
        try:
            self._mdf = MDF(path)
        except Exception as error:  # asammdf lets errors of many kinds through on damaged files
            raise UnreadableLogError(f"truncated or damaged (asammdf: {type(error).__name__}: {error})") from error
        weakref.finalize(self, self._mdf.close).atexit = False  # its objects refer to each other, and would wait
        super().__init__()
        self.format = f"MDF {self._mdf.version}"
        self._places: dict[str, tuple[int, int]] = {}
        self._entries: list[Entry] = []
        self._timeless: set[int] = set()
        self._factors: dict[int, float] = {}
        self._list()

    def entries(self) -> list[Entry]:
        """Every channel whose samples are real numbers."""
        return self._entries

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """The samples of some channels in their physical units, NaN where the log marks them invalid."""
        for name in names:
            group, index = self._places[name]
            expected = int(self._mdf.groups[group].channel_group.cycles_nr)
            held = 0
            for first, last in ranges(expected):
                samples = self._samples(name, group, index, first, last - first)
                held += len(samples)
                yield name, self.counted(name, samples)
                self._let_go()
            if held != expected:
                raise UnreadableLogError(f"channel {name!r} has {held} of {expected} samples: truncated")

    def _let_go(self) -> None:
        """Give back the pages of the log that were read; asammdf maps all of it."""
        mapped = getattr(self._mdf._mdf, "_file", None)
        if isinstance(mapped, mmap.mmap) and hasattr(mmap, "MADV_DONTNEED"):  # Windows has no such advice
            with suppress(OSError):
                mapped.madvise(mmap.MADV_DONTNEED)

    def _samples(self, name: str, group: int, index: int, first: int, count: int) -> NDArray[Any]:
        try:
            if index == self._mdf.masters_db.get(group):
                samples: NDArray[Any] = self._mdf.get_master(group, record_offset=first, record_count=count)
                samples = samples * self._factors[group] if group in self._factors else samples
                invalid: NDArray[Any] | None = None
            else:
                samples, invalid = self._mdf.get(
                    group=group,
                    index=index,
                    samples_only=True,
                    ignore_invalidation_bits=True,
                    record_offset=first,
                    record_count=count,
                )
        except Exception as error:
            raise UnreadableLogError(f"channel {name!r}: {type(error).__name__}: {error}") from error
        if samples.dtype.kind in "SUO" and _is_partly_text(self._mdf.groups[group].channels[index].conversion):
            samples = np.full(len(samples), np.nan)  # no number among these
        if samples.ndim != 1 or samples.dtype.kind not in "fiub":
            raise UnreadableChannelError(f"channel {name!r} holds no plain numbers ({samples.dtype})")
        if invalid is not None and np.any(invalid):
            samples = np.where(np.asarray(invalid, dtype=np.bool_), np.nan, samples)
        return np.asarray(samples)

    def _list(self) -> None:
        groups: list[Any] = self._mdf.groups
        masters_of: dict[int, int] = self._mdf.masters_db
        version = "4" if self._mdf.version >= "4" else "3"
        places = [(group, index) for group, content in enumerate(groups) for index in range(len(content.channels))]
        names = unique_names([groups[group].channels[index].name for group, index in places])
        masters = {
            group: name for name, (group, index) in zip(names, places, strict=True) if index == masters_of.get(group)
        }
        clocks = {
            name: self._clock(name, group, groups[group].channels[masters_of[group]]) for group, name in masters.items()
        }
        for name, (group, index) in zip(names, places, strict=True):
            channel = groups[group].channels[index]
            if why := _why_unread(channel, groups[group].channels[masters_of.get(group, index)], version):
                self.texts[name] = why
                continue
            self._places[name] = (group, index)
            if text := _words(channel):
                self.descriptions[name] = text
            self._entries.append(
                Entry(
                    name,
                    unit=clocks.get(name, _unit(channel)),
                    dtype=f"{_KINDS[version][channel.data_type]}{channel.bit_count}",
                    count=int(groups[group].channel_group.cycles_nr),
                    time=None if group in self._timeless or name in clocks else masters.get(group),
                )
            )
        self.heading = _words(self._mdf.header)
        self.notes += left_out(self.texts)

    def _clock(self, name: str, group: int, master: Any) -> str:
        """Note what a group's master is if it does not count seconds; the unit in which it is read."""
        unit = _unit(master)
        factor = SECONDS.get(time_unit(unit)) if unit.strip() else 1.0
        kind = _MASTERS.get(getattr(master, "sync_type", 0)) or ("" if factor else f"in {unit}")
        if kind:
            self._timeless.add(group)
            self.notes.append(f"{name!r} is {kind} and no time: its channels need a [channels] time")
        elif factor is not None and factor != 1.0:
            self._factors[group] = factor
            self.notes.append(f"{name!r} counts in {unit} and is read in s")
        return unit if kind else "s"


def _why_unread(channel: Any, clock: Any, version: str) -> str:
    """Reason why a channel over this clock has no numeric physical value; "" where it has."""
    if channel.data_type not in _KINDS[version]:
        return "no plain numbers"
    conversion = channel.conversion
    stands_for_texts = conversion is not None and conversion.conversion_type in _TEXTS[version]
    if stands_for_texts and not _is_partly_text(conversion):
        return "its numbers stand for texts: export it as numbers"
    return _FORMULA if _has_formula(conversion) or _has_formula(clock.conversion) else ""


def _is_partly_text(conversion: Any) -> bool:
    """True if some numbers stand for texts, such as "invalid", and the others have a conversion to numbers."""
    default = (getattr(conversion, "referenced_blocks", None) or {}).get("default_addr")
    return getattr(default, "conversion_type", _TEXTS["4"][0]) not in _TEXTS["4"]


def _unit(channel: Any) -> str:
    return channel.unit or (getattr(channel.conversion, "unit", "") if channel.conversion else "") or ""


def _words(block: Any) -> str:
    """The comment of a channel or a file without its XML, on one line; that of version 3 is a description."""
    text = getattr(block, "comment", "") or getattr(block, "description", "") or ""
    if isinstance(text, bytes):
        text = text.decode("latin-1")
    return " ".join(re.sub(r"<[^>]*>", " ", str(text)).strip("\0").split())


open_log = MdfSource
