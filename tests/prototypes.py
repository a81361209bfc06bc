"""Prototypes for tests: settings, logs of the double well, an observer that listens only, logs that are read once."""

import hashlib
import json
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from unittest.mock import patch

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.rig.excitation import command, random_excitation
from pipeline.rig_logs import guarded
from pipeline.store.manifest import load_manifest
from pipeline.workflow.engine import Task
from tests.double_well import DoubleWell

QUICK = """\
[identify]
models = ["rbf-paper"]
[compare]
models = []
"""
"""The fastest model alone, where not the model but what is around it is tested."""


def settings(
    more: str = QUICK,
    *,
    name: str = "P",
    train: str = "log.csv",
    validation: str | None = None,
    q: str = "q",
    inputs: Sequence[str] = ("v1", "v2"),
    volts: str = "kV",
) -> str:
    """A settings file in TOML: channels time [s], q [mm] and the inputs, then what is given of other sections."""
    channels = {"time": ("time", "s"), "q": (q, "mm")} | {f"v{k}": (v, volts) for k, v in enumerate(inputs, start=1)}
    return "\n".join(
        [
            f'name = "{name}"',
            "[logs]",
            f'train = ["{train}"]',
            *([f'validation = ["{validation}"]'] if validation else []),
            "[channels]",
            *(f'{role} = {{ channel = {json.dumps(c)}, unit = "{unit}" }}' for role, (c, unit) in channels.items()),
            more,
        ]
    )


SMALL_CSV = "time;q;u\n" + "".join(f"{i / 100:.2f};{i % 7};{i % 5}\n" for i in range(400))
"""A log of four seconds that can be read, of no motion."""
SMALL = settings("", inputs=["u"], volts="V")
"""Its settings."""


def motion(
    seconds: float,
    rate: float,
    seed: int,
    *,
    device: DoubleWell | None = None,
    excitation: Any = "training",
    gain: float | tuple[float, float] = 1.0,
    noise: float = 0.0,
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Time [s], displacement [m] with white noise [m] on it, and voltages [V] of a double well under random pulses."""
    rng, t = np.random.default_rng(seed), np.arange(round(seconds * rate)) / rate
    v = command(random_excitation(rng, duration=seconds, excitation=excitation), t) * gain
    q = (device or DoubleWell()).simulate(v, 1.0 / rate)
    return t, q + (rng.normal(0.0, noise, t.size) if noise else 0.0), v


def write_csv(path: Path, t: FloatArray, q: FloatArray, v: FloatArray) -> None:
    """A log in s, mm and kV for `settings`, with six decimals."""
    header = ",".join(["time", "q", *(f"v{k}" for k in range(1, v.shape[1] + 1))])
    table = np.column_stack([t, 1e3 * q, 1e-3 * v])
    np.savetxt(path, table, fmt="%.6f", delimiter=",", header=header, comments="")


class Silent:
    """An observer that listens only."""

    def planned(self, stages: Sequence[str]) -> None: ...

    def started(self, task: Task, reasons: list[str]) -> None: ...

    def finished(self, task: Task, seconds: float) -> None: ...

    def skipped(self, task: Task) -> None: ...

    def warned(self, what: str, warning: str) -> None: ...

    def progressed(self, task: Task, what: str, share: float) -> None: ...


def content(run: Path) -> dict[str, str]:
    """Content hash of every artifact."""
    return {name: record.content_hash for name, record in load_manifest(run).artifacts.items()}


_READ = dict[str, tuple[Any, bytes]]()


@contextmanager
def logs_read_once() -> Iterator[None]:
    """Within, equal files are parsed in a process once; later its answer and its samples are given again."""
    first = guarded.read_in_child

    def read_in_child(request: dict[str, Any], *rest: Any) -> Any:
        content, samples = hashlib.sha256(Path(request["path"]).read_bytes()).hexdigest(), Path(request["samples"])
        key = json.dumps([content, request["channels"], request["csv"], request["limits"]])
        if key not in _READ:
            answer = first(request, *rest)
            if "error" in answer:  # which names the file
                return answer
            _READ[key] = answer, samples.read_bytes()
        samples.write_bytes(_READ[key][1])
        return _READ[key][0]

    with patch("pipeline.rig_logs.guarded.read_in_child", read_in_child):
        yield


def motion_prototype(folder: Path, name: str, gain: float = 1.0) -> Path:
    """Ten seconds of a double well under random pulses, times a factor."""
    write_csv(folder / f"{name}.csv", *motion(10.0, 200.0, 1, gain=gain, noise=3e-6))
    path = folder / f"{name}.toml"
    path.write_text(settings(name=name, train=f"{name}.csv"))
    return path
