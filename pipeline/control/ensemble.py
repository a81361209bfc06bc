"""Many runs of an identified joint, its estimate and draws from its posterior, under commanded voltages."""

from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np
from scipy.special import ndtri

from ..models.hybrid.model import HybridModel
from ..models.hybrid.runs import Driving, Followed, JointCoefficients, Stepping, run_joints
from ..numerics.arrays import FloatArray
from .estimator import PERIOD

INTERVAL = 4e-3
"""Sample interval of the runs [s]."""
PROBE = 0.003
"""Standard deviation of a probe's voltage, relative, as data sheets state it."""
SEED = 1911
_FINE = 4  # voltages behind the lag in an interval of the commands


@dataclass(frozen=True)
class Converters:
    """Knowledge of the converters between commands and membranes.

    Attributes
    ----------
    lags : tuple of float
        Time constants of left and right [s].
    spread : float
        Standard deviation of their logarithms.
    probe : float
        Standard deviation of the voltages that act over those commanded, relative.
    highest : float
        Largest voltage [V] that they may give.
    """

    lags: tuple[float, float]
    spread: float
    probe: float = PROBE
    highest: float = np.inf


@dataclass(frozen=True)
class Ensemble:
    """One joint as B parameter vectors; the first is the estimate.

    Attributes
    ----------
    coefficients : JointCoefficients
        Constants and corrections of the joints.
    offsets : FloatArray, shape (B,)
        Of each laser [m].
    delays, charging : FloatArray, shape (B,)
        By which voltages act later, and time constants of the membranes behind their electrodes [s].
    lags : FloatArray, shape (B, 2)
        Time constants of the left and the right converter [s].
    gains : FloatArray, shape (B,)
        Voltages that act over those commanded.
    highest : float
        Largest voltage [V]: trained, and what the converters may give.
    stepping : Stepping
        Steps in `INTERVAL`, and what all joints share.
    """

    coefficients: JointCoefficients
    offsets: FloatArray
    delays: FloatArray
    charging: FloatArray
    lags: FloatArray
    gains: FloatArray
    highest: float
    stepping: Stepping

    def subset(self, which: slice) -> "Ensemble":
        """Some of the vectors."""
        constants, weights, basis = self.coefficients
        own = {name: getattr(self, name)[which] for name in ("offsets", "delays", "charging", "lags", "gains")}
        return replace(self, coefficients=JointCoefficients(constants[which], weights[which], basis), **own)

    def run(self, commands: FloatArray, start: float) -> FloatArray:
        """Readings of the laser [m] every `INTERVAL`, shape (P, B, N), from rest at the reading `start` [m].

        Parameters
        ----------
        commands : FloatArray, shape (P, M, 2)
            Commanded voltages [V] of P runs, one every `PERIOD` of the controller, held in between.
        start : float
            Displacement at the start [m].

        Notes
        -----
        Cost: 60 µs for a run of 2 s.
        """
        return self.simulate(self.squares(commands), start)

    def squares(self, commands: FloatArray) -> FloatArray:
        """Squared voltages [V²] that act on the joints, on the half steps, shape (P, B, H, 2); as `run` takes them.

        Commands that are twice as high give four times as much.
        """
        # An interval without voltage first: a run begins at rest under its first voltages.
        commands = np.pad(commands, ((0, 0), (round(INTERVAL / PERIOD), 0), (0, 0)))
        half = 2 * self.stepping.substeps * round(commands.shape[1] * PERIOD / INTERVAL) + 1
        width = INTERVAL / (2 * self.stepping.substeps)
        squares = []
        for gain, lags, charging, delay in zip(self.gains, self.lags, self.charging, self.delays, strict=True):
            membranes = _behind(_behind(np.repeat(commands, _FINE, axis=1), lags), [charging] * 2)
            squares.append(gain**2 * _mean_squares(membranes, half, width, delay))
        return np.stack(squares, axis=1)

    def simulate(self, squares: FloatArray, start: float) -> FloatArray:
        """Readings [m] as of `run` under squared voltages [V²], shape (P, B, H, 2), as of `squares`."""
        pulses, count, half, _ = squares.shape
        samples = (half - 1) // (2 * self.stepping.substeps) + 1
        constants, weights, basis = self.coefficients
        runs = run_joints(
            JointCoefficients(np.tile(constants, (pulses, 1)), np.tile(weights, (pulses, 1, 1)), basis),
            Driving(
                squares.reshape(pulses * count, half, 2),
                np.arange(pulses * count),
                np.tile(self.offsets, pulses),
                np.array([start, 0.0, 0.0]),
            ),
            Followed(np.zeros(0), np.zeros(samples)),
            self.stepping,
        )
        return np.ascontiguousarray(runs[:, 1:, 0].reshape(pulses, count, samples - 1))

    def with_gain_error(self, deviation: float) -> "Ensemble":
        """The ensemble with draws whose voltages differ from the commands, by this relative standard deviation.

        The logarithms are quantiles of the normal distribution in a drawn order, so that few draws have its width too.
        """
        draws = len(self.gains) - 1
        quantiles = np.random.default_rng(SEED).permutation(ndtri((np.arange(draws) + 0.5) / max(draws, 1)))
        return replace(self, gains=np.exp(np.concatenate([[0.0], deviation * quantiles])))


def ensemble_of(model: HybridModel, draws: int, converters: Converters) -> Ensemble:
    """The estimate of an identified joint, and draws from its posterior with possible lags of its converters."""
    rng = np.random.default_rng(SEED)
    thetas = np.concatenate([model.theta[None], model.draws(draws)]) if draws else model.theta[None]
    lags = np.array(converters.lags) * np.exp(converters.spread * _spread(rng, draws, 2))
    return ensemble_at(model, thetas, lags, 1.0 + converters.probe * _spread(rng, draws, 1)[:, 0], converters.highest)


def ensemble_at(
    model: HybridModel, thetas: FloatArray, lags: FloatArray, gains: FloatArray, highest: float = np.inf
) -> Ensemble:
    """An identified joint with the parameters `thetas` (B, P), and its converters' lags (B, 2) [s] and gains (B,).

    The converters give `highest` [V] at most.

    Parameters
    ----------
    model : HybridModel
        The identified joint.
    thetas : FloatArray, shape (B, P)
        Parameters.
    lags : FloatArray, shape (B, 2)
        Time constants of the converters [s].
    gains : FloatArray, shape (B,)
        Voltages that act over those commanded.
    highest : float
        Largest voltage of the converters [V].
    """
    condensed = model.joint
    instruments = [condensed.instruments(theta) for theta in thetas]
    return Ensemble(
        coefficients=JointCoefficients(condensed.in_use(thetas), condensed.weights(thetas), condensed.basis),
        offsets=np.array([instrument.offset for instrument in instruments]),
        delays=np.array([instrument.delay for instrument in instruments]),
        charging=np.array([instrument.charging for instrument in instruments]),
        lags=lags,
        gains=gains,
        highest=min(condensed.largest_voltage, highest),
        stepping=Stepping(INTERVAL, condensed.substeps(model.theta, INTERVAL), condensed.q_stop, condensed.lead),
    )


def _spread(rng: np.random.Generator, draws: int, count: int) -> FloatArray:
    """Standard normal numbers of the draws, shape (1 + draws, count), zero for the estimate."""
    return np.concatenate([np.zeros((1, count)), rng.standard_normal((draws, count))])


def _behind(fine: FloatArray, lags: Iterable[float]) -> FloatArray:
    """Voltages, `_FINE` in each interval of the commands, behind a lag [s] of each side, in place."""
    from scipy.signal import lfilter

    for side, lag in enumerate(lags):
        if lag > 0.0:
            decay = float(np.exp(-PERIOD / _FINE / lag))
            fine[..., side] = lfilter([1.0 - decay], [1.0, -decay], fine[..., side], axis=1)
    return fine


def _mean_squares(fine: FloatArray, count: int, width: float, delay: float) -> FloatArray:
    """Means of v² [V²] in windows of `width` [s] about the half steps, `delay` [s] earlier, shape (P, count, 2)."""
    total = np.concatenate([np.zeros((len(fine), 1, 2)), np.cumsum(fine**2, axis=1)], axis=1)
    edges = np.clip(((np.arange(count + 1) - 0.5) * width - delay) / (PERIOD / _FINE), 0.0, fine.shape[1])
    lower = np.minimum(edges.astype(np.int64), fine.shape[1] - 1)
    share = (edges - lower)[None, :, None]
    at = (1.0 - share) * total[:, lower] + share * total[:, lower + 1]
    length = np.diff(edges)[None, :, None]
    return np.asarray(np.where(length > 1e-9, np.diff(at, axis=1) / np.maximum(length, 1e-9), 0.0))
