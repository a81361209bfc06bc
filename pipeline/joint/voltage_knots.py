"""Times between which the voltages of a log are lines: its samples, and finer ones where a voltage switches."""

from typing import NamedTuple

import numpy as np

from pipeline.numerics.arrays import FloatArray, IntArray

BENT = 0.01
"""Deviation from a straight line within a sample interval, relative to the largest voltage, from which it is refined:
above the noise of a measured voltage, and below what a switching leaves to an amplifier's lag."""


class VoltageKnots(NamedTuple):
    """Times t (M,) [s], voltages v (M, K) [V], linear in between, and the `rows` (N,) of them that are samples."""

    t: FloatArray
    v: FloatArray
    rows: IntArray


def voltage_knots(t: FloatArray, v: FloatArray) -> VoltageKnots:
    """Where an integrator that takes straight lines between its times has to be told of the voltages.

    Parameters
    ----------
    t : FloatArray, shape (N,)
        Sample times [s].
    v : FloatArray, shape (N, K) or (N, r, K)
        Voltages [V] at the samples, or at r evenly spaced times of each sample interval, the first of which is the
        sample itself.

    Notes
    -----
    A pulse of 10 ms samples begins up to 10 ms wrong if it is a line from sample to sample, and a passage near the
    saddle is late by several times that. Cost: 50 ns for each voltage, and what the integrator takes for the
    knots: a third more of them on half an hour of pulses, all of them where noise exceeds `BENT`.
    """
    if v.ndim == 2:
        return VoltageKnots(np.ascontiguousarray(t), np.ascontiguousarray(v), np.arange(t.size))
    parts, samples = v.shape[1], v[:, 0]
    share = np.arange(parts)[:, None] / parts
    lines = samples[:-1, None] + np.diff(samples, axis=0)[:, None] * share
    bent = np.abs(v[:-1] - lines).max(axis=(1, 2)) > BENT * np.abs(v).max()
    count = np.where(bent, parts, 1)
    rows = np.concatenate([[0], np.cumsum(count)])
    within = np.arange(rows[-1]) - np.repeat(rows[:-1], count)
    interval = np.repeat(np.arange(t.size - 1), count)
    times = t[interval] + within / parts * np.diff(t)[interval]
    return VoltageKnots(np.append(times, t[-1]), np.vstack([v[interval, within], samples[-1:]]), rows)
