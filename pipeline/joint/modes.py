"""Modes of the moving beam: singular value decomposition of its simulated shapes (figure 6a)."""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import FloatArray


@dataclass(frozen=True)
class BeamModes:
    """Modes of w(x, t), most energetic first; three at most, because the Ritz shape has three coordinates.

    Attributes
    ----------
    x : FloatArray, shape (K,)
        Positions along the beam [m].
    shapes : FloatArray, shape (3, K)
        Mode shapes, 1 at their largest deflection.
    amplitudes : FloatArray, shape (N, 3)
        Deflection [m] that each mode contributes where its shape is 1.
    widest : FloatArray, shape (K,)
        The beam's shape at its largest deflection, scaled to 1 there: the model response beside mode 1.
    energy_share : FloatArray, shape (3,)
        Share of Σ w² that each mode carries.
    """

    x: FloatArray
    shapes: FloatArray
    amplitudes: FloatArray
    widest: FloatArray
    energy_share: FloatArray


def beam_shapes(qm: FloatArray, length: float, count: int = 91) -> tuple[FloatArray, FloatArray]:
    """Positions x (K,) [m] and deflections w(x) (N, K) [m] of Ritz coordinates (N, 4) (eq. 13)."""
    x = np.linspace(0.0, length, count)
    return x, qm[:, :3] @ np.stack([x**2, x**3, x**4])


def beam_modes(qm: FloatArray, length: float) -> BeamModes:
    """Decompose the shapes of a motion.

    Parameters
    ----------
    qm : FloatArray, shape (N, 4)
        Ritz coordinates over time.
    length : float
        Length of the beam [m].

    Notes
    -----
    The mean shape is not removed: the modes are those of w itself, as in figure 6a. Cost: an SVD of N × 91.
    """
    x, w = beam_shapes(qm, length)
    left, values, right = np.linalg.svd(w, full_matrices=False)
    peaks = np.take_along_axis(right[:3], np.argmax(np.abs(right[:3]), axis=1)[:, None], axis=1)
    shapes = right[:3] / peaks
    amplitudes = left[:, :3] * values[:3] * peaks[:, 0]
    energy = values**2
    row, column = np.unravel_index(np.argmax(np.abs(w)), w.shape)
    return BeamModes(x, shapes, amplitudes, w[row] / w[row, column], energy[:3] / energy.sum())
