"""An input whose probe is at the end of its range: what was applied there is not known."""

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.signals.signal_quality import examine_signal

_SHARE = 0.005
"""Share of the samples that stay at an end."""
_RAGGED = 0.5
"""Share of the samples elsewhere that differ from the one before, where a probe has noise or the input moves."""


def saturation(time: FloatArray, samples: FloatArray, step: float, unit: str) -> list[str]:
    """What to say of an input that stays at its largest or smallest value to the last digit, though it has noise.

    A command holds its levels exactly, everywhere; a probe does so nowhere but at its rail. An input that rests at
    zero, as the part of a signed monitor does, is not at a rail there.
    """
    seen = examine_signal(time, samples, step)
    if seen.constant or seen.stepped or seen.levels:
        return []
    said = []
    for share, rail in ((seen.low_rail, seen.usual[0]), (seen.high_rail, seen.usual[1])):
        if share < _SHARE or abs(rail) <= 1e-3 * max(abs(seen.smallest), abs(seen.largest)):
            continue
        elsewhere = samples[np.isfinite(samples) & (samples != rail)]
        if np.mean(np.diff(elsewhere) != 0.0) < _RAGGED:
            continue
        first = time[np.argmax(samples == rail)]
        said.append(
            f"{100.0 * share:.2g} % of the samples stay at {rail:.6g} {unit}, the first at {first:.6g} s, elsewhere "
            "no two are equal: a saturated probe? What was applied there is not known: widen the probe's range, unless "
            "this is a command that is limited there"
        )
    return said
