"""Whether jumps of a signal answer changes of the inputs: a sensor that fails does not know them, a device does."""

from collections.abc import Sequence

import numpy as np

from pipeline.numerics.arrays import BoolArray, FloatArray
from pipeline.signals.columns import Signal
from pipeline.signals.signal_quality import span

_OF_INPUT, _ANSWER = 0.05, 0.03
"""Share of the range of an input that its change exceeds, and time [s] that a device which jumps takes to answer."""
_TOGETHER, _BY_CHANCE, _PLACES = 0.75, 0.01, 2000
"""Share of the jumps that answer an input where the device makes them, the probability below which that is no chance,
and at how many places it is seen how often an input changes."""


def answer_inputs(times: FloatArray, inputs: Sequence[Signal], stamps: FloatArray, step: float) -> bool:
    """Whether an input has changed just before most of these times [s], more of them than by chance.

    Parameters
    ----------
    times : FloatArray
        When the signal jumps [s].
    inputs : sequence of (FloatArray, FloatArray)
        Time stamps [s] and samples of what drives the device.
    stamps : FloatArray
        Those of the signal [s], by which chance is judged.
    step : float
        Nominal sampling step of the signal [s].
    """
    from scipy.special import bdtrc

    anywhere = stamps[:: max(1, stamps.size // _PLACES)]
    answers, chance = np.zeros(times.size, dtype=np.bool_), np.zeros(anywhere.size, dtype=np.bool_)
    for signal in inputs:
        answers |= _changed(signal, times, step)
        chance |= _changed(signal, anywhere, step)
    count = int(np.count_nonzero(answers))
    likely = count > 0 and count >= _TOGETHER * times.size
    return likely and bool(bdtrc(count - 1, times.size, float(np.mean(chance))) < _BY_CHANCE)


def _changed(signal: Signal, times: FloatArray, step: float) -> BoolArray:
    """Whether an input differs at these times [s] from what it was shortly before."""
    smallest, largest = span(signal[1])
    before = np.searchsorted(signal[0], times - max(5.0 * step, _ANSWER))
    now = np.searchsorted(signal[0], times + step)
    last = signal[1].size - 1
    change = np.abs(signal[1][np.minimum(now, last)] - signal[1][np.minimum(before, last)])
    changed: BoolArray = change > _OF_INPUT * (largest - smallest)
    return changed
