"""The next log: a sequence that makes an identified joint surest of its free run in a stated programme.

It is built burst by burst as in `excitation_design`, but starts from the posterior that the run has: the criterion
is the expected standard deviation of the free run (`pipeline.models.hybrid.next_log`).
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

from ...errors import InputError
from ...models.hybrid.model import HybridModel
from ...models.hybrid.next_log import Uncertainty, slopes, uncertainty
from ...numerics.arrays import FloatArray
from ...rig.excitation import EXCITATIONS, Burst, command, load_sequence, random_excitation
from .excitation_design import Requirements, behind_converters, greedy_bursts

INTERVAL = 0.01  # s, of the simulated samples
DRAWS = 3
"""Training excitations that a designed log is compared with."""


@dataclass(frozen=True)
class NextLog:
    """A designed log and what it is expected to bring.

    Attributes
    ----------
    wanted : Requirements
    bursts : list of Burst
    programme : str
        The programme whose free run is to become surer: an excitation, or a file.
    now, designed, usual : float
        Standard deviation [m] of that free run, RMS: with the logs at hand, with the designed log as well, and with one
        of the usual excitation instead (mean of `DRAWS`).
    stroke : float
        Range [m] of the free run.
    """

    wanted: Requirements
    bursts: list[Burst]
    programme: str
    now: float
    designed: float
    usual: float
    stroke: float


def design_next_log(
    model: HybridModel,
    start: float,
    interval: float,
    programme: str,
    rng: np.random.Generator,
    wanted: Requirements,
    *,
    report: Callable[[float], None] | None = None,
) -> NextLog:
    """Design the log after those that a joint was identified from.

    Parameters
    ----------
    model : HybridModel
        Identified.
    start : float
        Where it rests before a log [m].
    interval : float
        Sample interval [s] of its logs.
    programme : str
        A name in `pipeline.rig.excitation.EXCITATIONS`, from which one is drawn, or a file with voltages.
    rng : Generator
        Draws the programme, the candidates and the usual logs.
    wanted : Requirements
        Length, limits, shapes, effort.
    report : callable, optional
        Receives the share that is designed.

    Raises
    ------
    InputError
        A programme that cannot be read, or one that the model cannot follow.

    Notes
    -----
    Cost: about 20 places × candidates × 0.1 s.
    """
    t, v = _voltages(programme, wanted, rng)
    unsure = uncertainty(model, t, v, start, interval)
    if unsure is None:
        raise InputError(f"--programme {programme}: the free run of the model diverges; take another programme")
    expected = partial(_expected, unsure, start)
    bursts = greedy_bursts(lambda bursts, end: -2.0 * np.log(expected(bursts, end)), rng, wanted, report=report)
    usual = [
        expected(random_excitation(rng, duration=wanted.duration, top=wanted.voltage), wanted.duration)
        for _ in range(DRAWS)
    ]
    designed = expected(bursts, wanted.duration)
    mean = float(np.mean(usual))
    return NextLog(wanted, bursts, programme, unsure.error(), designed, mean, 1e-3 * unsure.stroke)


def _expected(unsure: Uncertainty, start: float, bursts: list[Burst], duration: float) -> float:
    """Standard deviation [m] after a log of these bursts; infinite where the model cannot follow them."""
    t = _clock(duration)
    by_theta = slopes(unsure.model, t, behind_converters(command(bursts, t), INTERVAL), start)
    return np.inf if by_theta is None else unsure.error(unsure.shown(by_theta, INTERVAL))


def _voltages(programme: str, wanted: Requirements, rng: np.random.Generator) -> tuple[FloatArray, FloatArray]:
    """Times [s] and voltages [V] of the programme."""
    if programme in EXCITATIONS:
        t = _clock(wanted.duration)
        drawn = random_excitation(rng, duration=wanted.duration, excitation=programme, top=wanted.voltage)
        return t, behind_converters(command(drawn, t), INTERVAL)
    if not Path(programme).is_file():
        raise InputError(f"--programme {programme}: no such file; name one, or one of {', '.join(EXCITATIONS)}")
    sequence = load_sequence(Path(programme))
    t = _clock(sequence.duration)
    return t, behind_converters(sequence.at(t), INTERVAL)


def _clock(duration: float) -> FloatArray:
    return INTERVAL * np.arange(round(duration / INTERVAL), dtype=np.float64)
