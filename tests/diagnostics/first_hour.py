"""Mistakes of a first hour: how each is made, and what debist must say to it."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tests.prototypes import QUICK, motion, settings, write_csv

TOML = settings('[plant]\nmass = { value = 41, unit = "g" }\n' + QUICK, train="train.csv", validation="validation.csv")
RUN = ("run", "P.toml", "-o", "run", "--no-report", "-q")


@dataclass(frozen=True)
class Mistake:
    """One mistake.

    Attributes
    ----------
    done : str
        What the user did.
    said : str
        What debist says, a part of it.
    make : callable
        Makes the mistake in a folder that holds the logs, their settings and a finished run.
    arguments : tuple of str
        The command.
    code : int
        Its exit code.
    """

    done: str
    said: str
    make: Callable[[Path], None]
    arguments: tuple[str, ...] = ("run", "P.toml", "-o", "new", "--no-report", "-q")
    code: int = 3


def write_logs(folder: Path) -> None:
    """Two logs of 20 s of a double well, and the settings."""
    for name, seed in (("train", 1), ("validation", 3)):
        write_csv(folder / f"{name}.csv", *motion(20.0, 500.0, seed, noise=3e-6))
    (folder / "P.toml").write_text(TOML)


def _edit(*changes: tuple[str, str]) -> Callable[[Path], None]:
    def make(folder: Path) -> None:
        path = folder / "P.toml"
        text = path.read_text()
        for old, new in changes:
            assert old in text, old
            text = text.replace(old, new)
        path.write_text(text)

    return make


def _logs(change: Callable[[np.ndarray], np.ndarray]) -> Callable[[Path], None]:
    def make(folder: Path) -> None:
        for path in (folder / "train.csv", folder / "validation.csv"):
            table = change(np.loadtxt(path, delimiter=",", skiprows=1))
            np.savetxt(path, table, fmt="%.6f", delimiter=",", header="time,q,v1,v2", comments="")

    return make


def _damage(folder: Path) -> None:
    model = folder / "run" / "model.h5"
    model.write_bytes(model.read_bytes()[:-8] + b"damaged!")


def _nothing(folder: Path) -> None:
    """The command itself is the mistake."""


_SWAPPED = (('channel = "v1"', 'channel = "_"'), ('channel = "v2"', 'channel = "v1"'), ('"_"', '"v2"'))
MISTAKES = (
    Mistake("v1 and v2 swapped", "v1 is the left membrane and pushes q to the right", _edit(*_SWAPPED)),
    Mistake(
        "q counted to the other side",
        "give q scale = -1",
        _logs(lambda table: table * [1.0, -1.0, 1.0, 1.0]),
    ),
    Mistake("the mass in g given as kg", "of q and of plant.mass (", _edit(('"g"', '"kg"'))),
    Mistake(
        "time in ms read as s",
        "correct the unit of time in [channels] (ms is not s) or the sample_rate (in Hz)",
        _logs(lambda table: table * [1e3, 1.0, 1.0, 1.0]),
    ),
    Mistake(
        "kV read as V",
        "the coupling of the joint as drawn: check the units of v1 and v2 (",
        _edit(('unit = "kV"', 'unit = "V"')),
    ),
    Mistake("mm read as m", "check the unit of q in [channels]", _edit(('unit = "mm"', 'unit = "m"'))),
    Mistake(
        "the folder of another prototype's run",
        "holds the run of the prototype 'P', not of 'Q'",
        _edit(('name = "P"', 'name = "Q"')),
        RUN,
        2,
    ),
    Mistake("a validation log that is not there", "no such log", _edit(("validation.csv", "validaton.csv")), code=2),
    Mistake(
        "the training log as validation log under another name",
        "has the content of the training log",
        lambda folder: (folder / "validation.csv").write_bytes((folder / "train.csv").read_bytes()) and None,
        code=2,
    ),
    Mistake(
        "three mistakes in the settings",
        "P.toml: 3 mistakes",
        _edit(("models = []", 'modles = []\n[ingest]\nsample_interval = 1e-9\ngaps = "fill"')),
        code=2,
    ),
    Mistake(
        "an edit of the settings that was forgotten",
        "setting differentiate.order changed from 3 to 2",
        _edit(("[identify]", "[differentiate]\norder = 2\n[identify]")),
        ("status", "run"),
        0,
    ),
    Mistake(
        "a report of a damaged model",
        "model.h5: does not have the bytes that were written",
        _damage,
        ("report", "run"),
        4,
    ),
    Mistake(
        "a settings file for a log",
        "is a settings file; `debist check P.toml` looks at the logs",
        _nothing,
        ("inspect", "P.toml"),
        2,
    ),
)
