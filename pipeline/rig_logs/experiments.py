"""Channels of one file that are not of one record: far shorter ones, and those of a second experiment.

A model is identified on channels of one length and of one experiment. Names tell the experiments of a file apart where
they differ only by what the data are for (`U` and `U_val`, `uEst` and `uVal`), or where groups hold the same channels
(`run1.u` and `run1.y`, `run2.u` and `run2.y`).
"""

import re
from collections.abc import Callable, Mapping, Sequence
from typing import Literal

Purpose = Literal["train", "validation", "test", ""]

_BETWEEN = re.compile(r"[\W\d_]+|(?<=[a-zäöüß])(?=[A-ZÄÖÜ])")
_OF_DATA = "(data|daten|set|log|logs|run|lauf)?"
_WORDS: dict[Purpose, re.Pattern[str]] = {
    "validation": re.compile(rf"val{_OF_DATA}|valid\w*", re.IGNORECASE),
    "test": re.compile(rf"test{_OF_DATA}|tests|testing|prüf\w*|pruef\w*|check|holdout|unseen", re.IGNORECASE),
    "train": re.compile(r"train\w*|ident|identif\w*|fit|lern\w*", re.IGNORECASE),
}
_FAR_SHORTER = 10
_FEWEST = 2
"""Channels of an experiment: an input and an output."""
_MOST_NAMED = 4
_PARTS = re.compile(r"([\W\d_]+|(?<=[a-z])(?=[A-Z]))")
_JOINTS = re.compile(r"[_\-./ ]+")
_FOR_TRAINING = re.compile(r"id|est|estim\w*", re.IGNORECASE)
_JOINED = re.compile(r"(?P<signal>[a-z]{1,2})(?P<purpose>train|test|valid|val|est|id)", re.IGNORECASE)
_GROUP = re.compile(r"(?P<group>.*[./])(?P<leaf>[^./]*)")


def far_shorter(counts: Mapping[str, int]) -> set[str]:
    """Channels of less than a tenth of the samples of the longest one: parameters, not records."""
    longest = max(counts.values(), default=0)
    return {name for name, count in counts.items() if _FAR_SHORTER * count < longest}


def second_experiments(names: Sequence[str], is_record: Callable[[Sequence[str]], bool]) -> dict[str, str]:
    """Channels of a further experiment, each with that of the first one to which it corresponds.

    Parameters
    ----------
    names : sequence of str
        All channels of a log.
    is_record : callable
        Whether channels of these names could be a record, with an output and an input.
    """
    return _held_out(names) or _repeated(names, is_record)


def note_on(apart: Mapping[str, str]) -> list[str]:
    """What to do with the channels of a further experiment; nothing where there are none."""
    if not apart:
        return []
    further, first = (_named(list(dict.fromkeys(some))) for some in (apart, apart.values()))
    return [f"{further} look like a second experiment beside {first}: save it as a file of its own, for validation"]


def _named(names: Sequence[str]) -> str:
    return ", ".join(map(repr, names[:_MOST_NAMED])) + (", …" if len(names) > _MOST_NAMED else "")


def _held_out(names: Sequence[str]) -> dict[str, str]:
    """Channels for validation or tests beside those of the same names for training."""
    first: dict[str, str] = {}
    further: dict[str, str] = {}
    for name in names:
        signal, purpose = _signal_and_purpose(name)
        if purpose in ("validation", "test"):
            further[name] = signal
        elif purpose == "train" or signal not in first:
            first[signal] = name
    twins = {name: first[signal] for name, signal in further.items() if signal in first}
    return twins if len(set(twins.values())) >= _FEWEST else {}


def _signal_and_purpose(name: str) -> tuple[str, Purpose]:
    """A name without the words that say what it is for, and what the last of them says."""
    left = list[str]()
    last = purpose_of("")
    for part in _PARTS.split(name):
        purpose = _word_purpose(part)
        signal = ""
        if not purpose and (joined := _JOINED.fullmatch(part)):
            purpose = _word_purpose(joined["purpose"])
            signal = joined["signal"]
        left.append(signal if purpose else part)
        last = purpose or last
    return _JOINTS.sub("", "".join(left)).casefold(), last


def _word_purpose(word: str) -> Purpose:
    return "train" if _FOR_TRAINING.fullmatch(word) else purpose_of(word)


def _repeated(names: Sequence[str], is_record: Callable[[Sequence[str]], bool]) -> dict[str, str]:
    """Channels of groups that hold the same as an earlier one, which could be a record."""
    groups: dict[str, list[str]] = {}
    for match in filter(None, map(_GROUP.fullmatch, names)):
        groups.setdefault(match["group"], []).append(match["leaf"])
    twins: dict[str, str] = {}
    first: dict[frozenset[str], str] = {}
    for group, leaves in groups.items():
        earlier = first.setdefault(frozenset(leaves), group)
        if earlier != group and is_record(leaves):
            twins.update({group + leaf: earlier + leaf for leaf in leaves})
    return twins


def words(name: str) -> list[str]:
    """The words of a name: what stands between other characters, and between ``trainData``'s small and large letter."""
    return [word for word in _BETWEEN.split(name) if word]


def purpose_of(word: str) -> Purpose:
    """What a word says its data are for, "" for any other word."""
    return next((purpose for purpose, pattern in _WORDS.items() if pattern.fullmatch(word)), "")


def purposes(name: str) -> set[Purpose]:
    """What the words of a name say its data are for."""
    return {purpose_of(word) for word in words(name)} - {""}
