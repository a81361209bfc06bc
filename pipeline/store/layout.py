"""Paths of the artifacts in a run folder."""

import math
from collections.abc import Mapping
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Any

from ..settings.logs import ROLES, Log, LogPart, Role, log_label
from ..settings.prototype import Prototype
from ..system.names import log_name
from .columns import STUDY_COLUMNS

CHECK = "check.json"
MODELS = "model.h5"
SCORES = "scores.parquet"
INSTRUMENTS = "instruments.parquet"
CURVES = "curves.parquet"
KNOWN_CURVES = "known-curves.parquet"
SIBLINGS = "siblings.h5"
REPORT = "report.html"
PAPER = "paper.html"
DATASHEET = "datasheet.json"
STUDIES = "studies"
EXPORTS = "exports"
"""Folders with files beside the artifacts, each with a list of what was written."""


def inside(name: str) -> bool:
    """True if a path in a run, with slashes, stays in it on any system: no step up, drive or backslash."""
    path = PureWindowsPath(name)
    return not (path.anchor or ".." in path.parts or "\\" in name)


def logs(prototype: Prototype) -> list[tuple[Role, str, str]]:
    """Every log of a prototype: role, name in the run, path as written in the settings or what its part is called."""
    return [(role, log_name(label), label) for role, label, _ in _logs(prototype)]


def raw_logs(prototype: Prototype, prototype_file: Path) -> list[tuple[str, Path, tuple[float, float]]]:
    """Name in messages, path and span [s] of every log, in the order of `logs`."""
    return [
        (label, source(log, prototype_file), log.span if isinstance(log, LogPart) else (-math.inf, math.inf))
        for _, label, log in _logs(prototype)
    ]


def log_parts(prototype: Prototype) -> list[tuple[Role, str, LogPart]]:
    """Every log of a prototype in the order of `logs`: role, name in the run, and what of it is taken and how."""
    return [
        (role, log_name(label), log if isinstance(log, LogPart) else LogPart(file=log))
        for role, label, log in _logs(prototype)
    ]


def _logs(prototype: Prototype) -> list[tuple[Role, str, Log]]:
    return [(role, log_label(log), log) for role in ROLES for log in getattr(prototype.logs, role)]


def source(log: Log | Mapping[str, Any], prototype_file: Path) -> Path:
    """The path of a raw file; relative paths begin at the folder of the settings file."""
    stated = log["file"] if isinstance(log, Mapping) else log
    return prototype_file.parent / (stated if isinstance(stated, str) else stated.file)


def record(role: Role, log: str) -> str:
    """The fine uniform record of a log."""
    return f"{role}/{log}/record.parquet"


def signals(role: Role, log: str) -> str:
    """The decimated signals of a log."""
    return f"{role}/{log}/signals.parquet"


def kinematics(role: Role, log: str) -> str:
    """The signals with their derivatives."""
    return f"{role}/{log}/kinematics.parquet"


def predictions(role: Role, log: str, model: str) -> str:
    """The free run of a model on a log."""
    return f"{role}/{log}/predictions/{model}.parquet"


def study(name: str) -> str:
    """The table of a hyperparameter study."""
    return f"{STUDIES}/{name}.parquet"


def paper_figure(name: str, ending: str) -> str:
    """A figure of `debist paper`; `ending` is svg or pdf."""
    return f"paper/{name}.{ending}"


def figure(name: str, ending: str) -> str:
    """A figure for a paper; `ending` is svg or pdf."""
    return f"figures/{name}.{ending}"


def baseline(model: str) -> str:
    """A baseline as it was fitted."""
    return f"baselines/{model}.h5"


def control(title: str) -> str:
    """Path of the results of `debist control`."""
    return f"control/{title}.json"


def remade(name: str) -> str:
    """Advice on a lost artifact that no stage of `debist run` makes; empty for those of the stages."""
    folder = name.partition("/")[0]
    title = PurePosixPath(name).stem
    if folder == STUDIES and title not in STUDY_COLUMNS:
        return "it is no longer made"
    pulse = f"pulse --to {title.removeprefix('pulse-to-')}"
    control = {"linear": "linearise", "map": "map", "design": "design"}.get(title, pulse)
    commands = {STUDIES: f"study {title}", "control": f"control {control}", "paper": "paper", PAPER: "paper"}
    return f"`debist {commands[folder]}` makes it anew" if folder in commands else ""
