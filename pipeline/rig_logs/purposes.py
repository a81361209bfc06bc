"""What a log is for, by the words of its name."""

import re
from typing import Literal

Purpose = Literal["train", "validation", "test", ""]

_BETWEEN = re.compile(r"[\W\d_]+|(?<=[a-zäöüß])(?=[A-ZÄÖÜ])")
_OF_DATA = "(data|daten|set|log|logs|run|lauf)?"
_WORDS: dict[Purpose, re.Pattern[str]] = {
    "validation": re.compile(rf"val{_OF_DATA}|valid\w*", re.IGNORECASE),
    "test": re.compile(rf"test{_OF_DATA}|tests|testing|prüf\w*|pruef\w*|check|holdout|unseen", re.IGNORECASE),
    "train": re.compile(r"train\w*|ident|identif\w*|fit|lern\w*", re.IGNORECASE),
}


def words(name: str) -> list[str]:
    """The words of a name: what stands between other characters, and between ``trainData``'s small and large letter."""
    return [word for word in _BETWEEN.split(name) if word]


def purpose_of(word: str) -> Purpose:
    """What a word says its data are for, "" for any other word."""
    return next((purpose for purpose, pattern in _WORDS.items() if pattern.fullmatch(word)), "")


def purposes(name: str) -> set[Purpose]:
    """What the words of a name say its data are for."""
    return {purpose_of(word) for word in words(name)} - {""}
