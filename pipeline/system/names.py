"""Names that a user writes: of prototypes and logs, with their safe forms for folders and files, and of choices."""

import hashlib
import os
import re
import shlex
import unicodedata
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, Literal

ROLE_WORDS = {"train": "training", "validation": "validation"}
SAFE = re.compile(r"[A-Za-z0-9._-]{1,64}")
_NOT_WRITABLE = frozenset('<>:"|?*\\/`')
_LONGEST = 64
_LONGEST_LOG = 250
_RESERVED = frozenset({"con", "prn", "aux", "nul", *(f"{d}{i}" for d in ("com", "lpt") for i in range(1, 10))})
_SPELT = {"ä": "ae", "ö": "oe", "ü": "ue", "Ä": "Ae", "Ö": "Oe", "Ü": "Ue", "ß": "ss", "æ": "ae", "ø": "o", "µ": "u"}


def check_name(name: str, longest: int = _LONGEST) -> str:
    """Return `name` if users and systems can work with it: letters of any script, digits, blanks, signs and such.

    Raises
    ------
    ValueError
        It is empty or longer than `longest`, holds what leaves a folder, a line, a table or a shell, or is reserved.
    """
    if not name.isprintable():
        raise ValueError(
            f"{name!r} is no usable name: a character of it cannot be printed; write paths with / or in single quotes"
        )
    # Windows leaves a dot at the end out
    if _NOT_WRITABLE & {*name} or not 0 < len(name) <= longest or name[0] in " =+@" or name[-1] in " .":
        raise ValueError(
            f"{name!r} is no usable name: 1 to {longest} visible characters without {' '.join(sorted(_NOT_WRITABLE))}, "
            "no blank at its ends, no =, + or @ before it, no dot behind it; rename it"
        )
    if name.split(".")[0].strip().lower() in _RESERVED:
        raise ValueError(f"{name!r} is no usable name: some systems keep it for a device; rename it")
    return name


def slug(name: str) -> str:
    """The name of its folder: itself where it is safe, else spelt in ASCII (``Prüfling 1`` → ``Pruefling-1``).

    A name without a spelling (another script) becomes one from its hash, always the same. A name of more than 64
    letters keeps its first ones, with a hash that separates it from others that begin alike.
    """
    if SAFE.fullmatch(name) and name.split(".")[0].strip().lower() not in _RESERVED and not name.endswith("."):
        return name
    short = re.sub(r"-{2,}", "-", "".join(map(_spelt, unicodedata.normalize("NFC", name)))).strip("-.")
    digest = hashlib.sha256(name.encode()).hexdigest()[:8]
    if not re.search(r"[A-Za-z0-9]", short) or short.split(".")[0].lower() in _RESERVED:
        return f"name-{digest}"
    return short if len(short) <= _LONGEST else f"{short[: _LONGEST - 9]}-{digest}"


def _spelt(letter: str) -> str:
    if SAFE.fullmatch(letter):
        return letter
    if letter in _SPELT:
        return _SPELT[letter]
    words = unicodedata.name(letter, "").split()
    if words[:1] == ["GREEK"] and "LETTER" in words:
        greek = words[words.index("LETTER") + 1].lower()
        return greek.capitalize() if "CAPITAL" in words else greek
    plain = unicodedata.normalize("NFKD", letter).encode("ascii", "ignore").decode()
    return plain if SAFE.fullmatch(plain) else "-"


def true_name(log: str) -> str:
    """Name of a log for readers: the file's name without its ending."""
    return Path(log.replace("\\", "/")).stem


def check_log_name(log: str) -> str:
    """Return a log's true name if it is one that `check_name` takes; it may be as long as a file's name may be."""
    return check_name(true_name(log), _LONGEST_LOG)


def log_title(role: str, name: str) -> str:
    """``training log``, and the log's true name where that differs."""
    words = f"{ROLE_WORDS[role]} log"
    return words if name.lower() in (role, ROLE_WORDS[role]) else f"{words} {name}"


def log_name(log: str) -> str:
    """The name under which a run files a raw log."""
    return slug(true_name(log))


def with_true_names(rows: Iterable[Mapping[str, Any]], sources: Iterable[tuple[str, str]]) -> list[dict[str, Any]]:
    """Rows with the keys ``role`` and ``log``, with the true names of the logs in place of those in a run.

    `sources` has role and raw log of every log.
    """
    called = {(role, log_name(log)): true_name(log) for role, log in sources}
    return [{**row, "log": called.get((row["role"], row["log"]), row["log"])} for row in rows]


def shell_word(path: object) -> str:
    """A path as it is typed in a command: in quotes where a shell needs them."""
    text = f"{path}"
    if os.name != "nt":
        return shlex.quote(text)
    return text if re.fullmatch(r"[\w\\/:.+-]+", text) else f'"{text}"'  # no name has these quotes there


Target = Literal["c", "controller", "crate", "fmu", "json", "matlab"]
"""Form of an export."""
Typeface = Literal["sans", "serif"]
"""Of a figure."""
Well = Literal["left", "right"]
"""Well in which a joint rests."""
Goal = Literal["time", "energy", "voltage"]
"""Quantity that a pulse minimises."""
