"""Damage as data: a list of edits that Hypothesis draws, and shrinks to the smallest one that hurts."""

from collections.abc import Sequence
from dataclasses import dataclass

from hypothesis import strategies as st

# Counts and offsets at which parsers break: zero, signs, powers of two and their neighbours.
_INTERESTING = (0, 1, 7, 8, 127, 128, 255, 256, 0x7FFF, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, (1 << 63) - 1)
_EDGE = 640


@dataclass(frozen=True)
class Edit:
    """One change of a file: what, where, and a number or two."""

    what: str
    place: int
    length: int = 1
    value: int = 0

    def within(self, ranges: Sequence[tuple[int, int]]) -> bool:
        """Whether it sets a single byte, and that in one of the ranges."""
        return self.what == "set" and any(low <= self.place < high for low, high in ranges)


def apply(data: bytes, edits: Sequence[Edit]) -> bytes:
    """The damaged file."""
    damaged = bytearray(data)
    for edit in edits:
        place, end = min(edit.place, len(damaged)), min(edit.place + edit.length, len(damaged))
        if edit.what == "cut":
            del damaged[place:]
        elif edit.what == "delete":
            del damaged[place:end]
        elif edit.what == "repeat":
            damaged[place:place] = damaged[place:end]
        elif edit.what == "copy":
            source = edit.value % max(len(damaged), 1)
            block = damaged[source : source + end - place]
            damaged[place : place + len(block)] = block
            del damaged[max(len(data), len(damaged)) :]
        elif place < len(damaged):
            if edit.what == "flip":
                damaged[place] ^= 1 << (edit.value % 8)
            elif edit.what == "set":
                damaged[place] = edit.value % 256
            else:
                written = (edit.value % (1 << 8 * edit.length)).to_bytes(edit.length, "little")
                damaged[place:end] = written[: end - place]
    return bytes(damaged)


LETTERS = b"bcghjklmopqrstvwxyz#!?$%&/_~@"
"""Bytes that stand in no number; those of nan, na and inf are left out."""


def damage(size: int) -> st.SearchStrategy[list[Edit]]:
    """One to five edits of a file of `size` bytes, heads and tails favoured, or a cut."""
    last = size - 1
    place = st.integers(0, last) | st.integers(0, min(last, _EDGE)) | st.integers(max(0, last - _EDGE), last)
    single = st.builds(Edit, st.sampled_from(("flip", "set")), place, st.just(1), st.integers(0, 255))
    number = st.builds(Edit, st.just("number"), place, st.sampled_from((1, 2, 4, 8)), st.sampled_from(_INTERESTING))
    what = st.sampled_from(("delete", "repeat", "copy"))
    block = st.builds(Edit, what, place, st.integers(1, 64), st.integers(0, last))
    cut = st.builds(Edit, st.just("cut"), place)
    few = st.lists(single | number, min_size=1, max_size=2)
    return few | st.lists(single | number | block, min_size=1, max_size=5) | st.lists(cut, min_size=1, max_size=1)


def noticeable(ranges: Sequence[tuple[int, int]], values: Sequence[int]) -> st.SearchStrategy[list[Edit]]:
    """One or two bytes set to some of `values` within the ranges."""
    place = st.sampled_from(list(ranges)).flatmap(lambda bounds: st.integers(bounds[0], bounds[1] - 1))
    edit = st.builds(Edit, st.just("set"), place, st.just(1), st.sampled_from(list(values)))
    return st.lists(edit, min_size=1, max_size=2)
