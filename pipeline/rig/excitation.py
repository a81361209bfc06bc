"""Voltage commands of an experiment: rest, then bursts of pulses, chirps, steps and multisines (§5.1); as files too."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from operator import methodcaller
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np

from ..errors import InputError
from ..numerics.arrays import FloatArray
from .log import LAYOUTS

Shape = Literal["pulse", "chirp", "steps", "multisine"]

DURATION = 37.5  # s, of a log
MAX_VOLTAGE = 3000.0  # V: 60 V/µm across 50 µm of film (§2)
STEP_HOLD = 0.12  # s, shortest hold of a random step: the converter settles, the joint does not
MULTISINE_LINES = 8
REST, PULSE, PAUSE = 1.0, 1.0, 1.0  # s: before the first burst; of alternating pulses

BurstKind = Literal["pulse", "both", "chirp", "steps", "multisine"]
BURSTS: tuple[BurstKind, ...] = get_args(BurstKind)
"""Kinds of bursts: one side on, both sides on, and three that swing between the sides."""
SHARES: dict[str, dict[BurstKind, float]] = {
    "mixed": dict.fromkeys(BURSTS, 1.0 / len(BURSTS)),
    "training": {"pulse": 0.86, "both": 0.1, "chirp": 0.04},
    "validation": {"pulse": 0.72, "both": 0.16, "chirp": 0.12},
}
"""Share of each type of burst; "training" and "validation" as in the logs of three prototypes (6 logs of 20 to 27
bursts), and so the shares below."""
EXCITATIONS = ("pulses", "chirps", "both", "steps", "multisine", *SHARES, "alternating")
"""Excitations of a log: half of its bursts pulses and half of one kind, all kinds alike, or as in the logs of
prototypes; "alternating" is `switching_pulses`."""
SHORT_PULSES = 0.45
SHORT_PAUSES = 0.6
TIME = "time"
INPUTS = ("v1", "v2")
"""Names of the channels in the files: time [s], and the commands to the left and right converter [V]."""
ENDINGS = (".csv", ".mat")


@dataclass(frozen=True)
class Burst:
    """One piece of the experiment; zero volts between bursts.

    Attributes
    ----------
    shape : Shape
        ``pulse`` holds both sides; the others swing between the sides. Positive values go left and negative ones right,
        since the electrostatic force does not depend on the sign of the voltage.
    start, duration : float
        [s].
    left, right : float
        Amplitudes [V].
    frequencies : FloatArray
        Chirp: first and last; multisine: its lines [Hz].
    levels : FloatArray
        Steps: signed levels in units of the amplitudes, equally long; multisine: phases [rad].
    """

    shape: Shape
    start: float
    duration: float
    left: float
    right: float
    frequencies: FloatArray = field(default_factory=lambda: np.empty(0))
    levels: FloatArray = field(default_factory=lambda: np.empty(0))


def command(bursts: list[Burst], t: FloatArray) -> FloatArray:
    """Voltages commanded to the left and right converter at sorted times `t` [s], shape (N, 2) [V]."""
    v = np.zeros((t.size, 2))
    for burst in bursts:
        first, last = np.searchsorted(t, [burst.start, burst.start + burst.duration])
        if burst.shape == "pulse":
            v[first:last] = burst.left, burst.right
        else:
            swing = _swing(burst, t[first:last] - burst.start)
            sides = (burst.left * np.maximum(swing, 0.0), burst.right * np.maximum(-swing, 0.0))
            v[first:last] = np.column_stack(sides)
    return v


def _swing(burst: Burst, t: FloatArray) -> FloatArray:
    """The signed waveform within ±1 at times `t` [s] after the start of the burst."""
    if burst.shape == "chirp":
        f0, f1 = burst.frequencies
        return np.asarray(np.sin(2 * np.pi * (f0 * t + 0.5 * (f1 - f0) / burst.duration * t**2)))
    if burst.shape == "steps":
        index = np.minimum((t / burst.duration * burst.levels.size).astype(np.int64), burst.levels.size - 1)
        return burst.levels[index]
    waves = np.sin(2 * np.pi * np.outer(t, burst.frequencies) + burst.levels).sum(axis=1)
    return np.asarray(np.clip(waves / np.sqrt(burst.frequencies.size), -1.0, 1.0))


def alternating_pulses(*, duration: float = DURATION, rest: float = REST, voltage: float = MAX_VOLTAGE) -> list[Burst]:
    """Equal pulses, left and right in turn, with equal pauses: the plain sequence that designs are compared with."""
    starts = np.arange(rest, duration - PULSE, PULSE + PAUSE)
    sides = [(voltage, 0.0), (0.0, voltage)]
    return [Burst("pulse", float(start), PULSE, *sides[i % 2]) for i, start in enumerate(starts)]


def switching_pulses(rng: np.random.Generator, *, duration: float = DURATION, top: float = MAX_VOLTAGE) -> list[Burst]:
    """Full pulses, left and right in turn, of random lengths: the paper's experiment (figures 11 and 15).

    Pulses and pauses last 1 to 2 s, in which the joint nearly comes to rest.
    """
    bursts: list[Burst] = []
    start = REST
    while start < duration - 0.5:
        length, pause = rng.uniform(1.0, 2.0, 2)
        sides = (top, 0.0) if len(bursts) % 2 == 0 else (0.0, top)
        bursts.append(Burst("pulse", start, float(length), *sides))
        start += float(length + pause)
    return bursts


def random_excitation(
    rng: np.random.Generator, *, duration: float = DURATION, excitation: str = "training", top: float = MAX_VOLTAGE
) -> list[Burst]:
    """Draw an experiment up to `top` [V]: a rest, then bursts and pauses until `duration` [s].

    The first burst is a full pulse on the left, which sends a joint resting on the left over to the right. Later pulses
    mostly change sides, so that the joint is sent from well to well. About half of them use the full voltage. The
    others stay between a half and the full one, where switching is not certain.

    Parameters
    ----------
    rng : np.random.Generator
        Draws the bursts.
    duration : float
        Length [s].
    excitation : str
        A name in `EXCITATIONS`.
    top : float
        Largest voltage [V].
    """
    if excitation == "alternating":
        return switching_pulses(rng, duration=duration, top=top)
    bursts = [Burst(shape="pulse", start=REST, duration=float(rng.uniform(1.0, 2.0)), left=top, right=0.0)]
    shares = _shares(excitation)
    start = REST + bursts[0].duration + float(rng.uniform(0.05, 0.6))
    side = 1
    while start < duration - 0.2:
        kind = BURSTS[int(rng.choice(len(BURSTS), p=shares))]
        burst = draw_burst(rng, kind, start, side, top, SHORT_PULSES)
        bursts.append(burst)
        start += burst.duration + draw_pause(rng, SHORT_PAUSES)
        side = 1 - side if kind == "pulse" and rng.random() < 0.8 else side
    return bursts


def _shares(excitation: str) -> list[float]:
    """Probability of each of `BURSTS`."""
    kind = excitation if excitation in BURSTS else excitation.removesuffix("s")
    halves = {name: 0.5 * (name == "pulse") + 0.5 * (name == kind) for name in BURSTS}
    return [SHARES.get(excitation, halves).get(name, 0.0) for name in BURSTS]


def draw_pause(rng: np.random.Generator, short: float = 0.4) -> float:
    """Length [s] of a pause: a short one, in which the joint does not come to rest, or a long one, in which it does."""
    return float(rng.choice([rng.uniform(0.05, 0.3), rng.uniform(0.3, 1.6)], p=[short, 1.0 - short]))


def draw_burst(
    rng: np.random.Generator, kind: BurstKind, start: float, side: int, top: float, short: float = 0.35
) -> Burst:
    """One burst.

    Parameters
    ----------
    rng : Generator
        Draws it.
    kind : BurstKind
        Type of the burst.
    start : float
        Start [s].
    side : int
        Of a pulse: 0 is left.
    top : float
        Largest voltage [V].
    short : float
        Share of the pulses in which the joint does not come to rest.
    """
    amplitude = top if rng.random() < 0.55 else float(rng.uniform(0.5, 1.0)) * top
    match kind:
        case "pulse":
            length = float(rng.uniform(0.1, 0.6) if rng.random() < short else rng.uniform(1.0, 2.4))
            return Burst("pulse", start, length, *((amplitude, 0.0) if side == 0 else (0.0, amplitude)))
        case "both":
            left, right = (rng.uniform(0.5, 0.95, 2) * top).tolist()
            return Burst("pulse", start, float(rng.uniform(0.8, 2.2)), left, right)
        case "chirp":
            return Burst(
                shape="chirp",
                start=start,
                frequencies=np.array([rng.uniform(0.5, 2.0), rng.uniform(4.0, 10.0)]),
                duration=float(rng.uniform(1.0, 2.4)),
                left=amplitude,
                right=amplitude,
            )
        case "steps":
            levels = rng.uniform(-1.0, 1.0, int(rng.integers(6, 16)))
            length = STEP_HOLD * levels.size * float(rng.uniform(1.0, 4.0))
            return Burst("steps", start, length, left=top, right=top, levels=levels)
        case "multisine":
            return Burst(
                shape="multisine",
                start=start,
                frequencies=rng.uniform(0.3, 8.0, MULTISINE_LINES),
                levels=rng.uniform(0.0, 2 * np.pi, MULTISINE_LINES),
                duration=float(rng.uniform(2.0, 5.0)),
                left=amplitude,
                right=amplitude,
            )


@dataclass(frozen=True)
class Sequence:
    """Commands to the two converters: times (N,) [s] from 0 on, uniform, and voltages (N, 2) [V]."""

    t: FloatArray
    u: FloatArray

    @property
    def duration(self) -> float:
        """Length [s], the last sample held as long as the others."""
        return float(self.t[-1] - self.t[0]) * self.t.size / (self.t.size - 1)

    def at(self, t: FloatArray) -> FloatArray:
        """Commands at sorted times `t` (M,) [s], each held until the next: shape (M, 2) [V]."""
        rows = np.searchsorted(self.t, t + 1e-9 * self.duration, side="right") - 1
        return np.asarray(self.u[np.clip(rows, 0, self.t.size - 1)])


def save_sequence(path: Path, sequence: Sequence, about: Mapping[str, Any]) -> tuple[Path, ...]:
    """Write a sequence as `path` (.csv or .mat), and its description `about` as JSON beside it.

    A MAT file (v5) holds ``time``, ``v1``, ``v2`` as columns, ``excitation`` as the structure with time that
    Simulink's *From Workspace* block plays, and `about` as JSON text.

    Raises
    ------
    InputError
        Another ending.
    """
    document = json.dumps(about, indent=1, default=methodcaller("tolist")) + "\n"
    if path.suffix.lower() == ".csv":
        LAYOUTS["csv"].write(path, sequence.t, {name: (sequence.u[:, i], "V") for i, name in enumerate(INPUTS)})
    elif path.suffix.lower() == ".mat":
        from scipy.io import savemat

        columns = {TIME: sequence.t[:, None], **{name: sequence.u[:, [i]] for i, name in enumerate(INPUTS)}}
        signals = {"values": sequence.u, "dimensions": 2.0, "label": "v1, v2 [V]"}
        played = {"time": sequence.t[:, None], "signals": signals}
        savemat(path, {**columns, "excitation": played, "about": document})
    else:
        raise InputError(f"{path}: a sequence is written as {' or '.join(ENDINGS)}; name the file so")
    beside = path.with_suffix(".json")
    beside.write_text(document, encoding="utf-8", newline="\n")
    return path, beside


def load_sequence(path: Path) -> Sequence:
    """Read a sequence back, as the virtual rig's player does.

    Raises
    ------
    InputError
        The file cannot be read, lacks a channel, or its times do not advance.
    """
    from ..rig_logs import read_recording

    recording = read_recording(path, channels=[TIME, *INPUTS])
    t, *inputs = (recording.channel(name).samples for name in (TIME, *INPUTS))
    if t.size < 2 or not np.all(np.diff(t) > 0.0) or not all(np.isfinite(column).all() for column in inputs):
        raise InputError(f"{path}: a sequence needs times that advance and voltages that are finite")
    return Sequence(t - t[0], np.column_stack(inputs))
