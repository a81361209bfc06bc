"""What is believed of any device before its log: smooth curves, small hidden states, sides that are alike.

The prior that simulated joints give a bistable one is in `population`.
"""

from collections.abc import Sequence

import numpy as np

from pipeline.identification import viscoelastic_joint as joint
from pipeline.identification.descent import Prior
from pipeline.identification.mirror import mirror_image
from pipeline.identification.parameter_layout import ParameterLayout
from pipeline.numerics.arrays import FloatArray

GAIN_SPREAD = 0.7  # of the logarithm of a gain about its typical size
SLOW_DAMPING = 0.05  # mean of the damping, in units of the frequency scale
ARM_BUMP = 0.2  # how much less than another joint a turning arm is expected to deviate from its sine
CUBIC_SPREAD = 1.0  # of the logarithm of the confining cubic about the stiffness scale
STOP_SPREADS = 0.1, 0.1, 1.5, 1.5  # of both places [half ranges], and of the logarithms of stiffness and resistance
SPREADS = {
    "rate": 0.5, "slip_force": 1.0, "slip_length": 1.0, "inertia": 1.0, "inertia_centre": 0.3, "drag": 1.5,
    "input_offset": 0.01, "input_lag": 1.0, "input_delay": 1.0, "input_bend": 0.7,
    "input_zone": 1.0,
}  # fmt: skip
"""Prior standard deviations of single numbers about where they start."""

UNLIKENESS = {"force": 2.5, "damping": 2.0}
"""How far these may be from their mirror images, over what other curves may."""


def joint_prior(p: ParameterLayout, start: FloatArray, symmetry: float | None) -> Prior:
    """Gaussian prior of the parameters: smooth curves, small hidden states, and mirror symmetry if asked for.

    Parameters
    ----------
    p : ParameterLayout
        Names and scales.
    start : FloatArray, shape (P,)
        The mean of gains, rates, friction and inertia.
    symmetry : float, optional
        Relative standard deviation of left/right differences about q = 0: F odd, d even, g_2(x) = −g_1(−x).
        None for a device without a mirror plane.
    """
    rows = _PriorRows(p.count)
    at, s = p.slices, p.units
    size = 2.5 * s.stiffness
    force = np.arange(at["force"].start, at["force"].stop)
    for i in force[: joint.POLYNOMIALS - 1]:
        rows.add([i], [1.0], 0.0, 3.0 * size)
    for i in force[joint.POLYNOMIALS - 1 : joint.POLYNOMIALS]:
        rows.add([i], [1.0], np.log(s.stiffness), CUBIC_SPREAD)
    bells = force[joint.POLYNOMIALS :]
    bump = size * (ARM_BUMP if p.structure.turning_arm else 1.0)
    rows.each(bells, np.zeros(len(bells)), 0.5 * bump)
    rows.smooth(bells, 0.3 * bump)
    damping = np.arange(at["damping"].start, at["damping"].stop)
    rows.smooth(damping, 0.7)
    usual = start[damping] if p.structure.overdamped else np.full(len(damping), np.log(SLOW_DAMPING * s.frequency))
    rows.each(damping, usual, 2.0)
    for k, sign in enumerate(p.signs):
        gain = np.arange(at[f"input{k}"].start, at[f"input{k}"].stop)
        unit = 1.0 if sign else float(np.abs(start[gain]).max())
        rows.smooth(gain, 0.3 * unit)
        rows.each(gain, start[gain], GAIN_SPREAD * unit)
    for i in range(len(p.structure.rates)):
        coupling = np.arange(at[f"coupling{i}"].start, at[f"coupling{i}"].stop)
        spread = 0.5 if i < p.structure.shape_elements else 0.3
        rows.smooth(coupling, 0.1 * np.sqrt(s.stiffness))
        rows.each(coupling, np.zeros(len(coupling)), spread * np.sqrt(s.stiffness))
    _shapes(rows, p, start)
    for i, spread in zip(range(at["stops"].start, at["stops"].stop), STOP_SPREADS, strict=False):
        rows.add([i], [1.0], float(start[i]), spread)
    for name, spread in SPREADS.items():
        index = np.arange(at[name].start, at[name].stop)
        rows.each(index, start[index], spread)
    if symmetry is not None and s.middle == 0.0:
        _mirror(rows, p, symmetry)
    return rows.prior()


def _mirror(rows: "_PriorRows", p: ParameterLayout, symmetry: float) -> None:
    """The joint is about its own mirror image; plain relaxing elements may be as they are."""
    image, (_, scale) = mirror_image(p), p.dimensionless
    blocks = ["force", "damping", "inertia_centre"]
    blocks += [f"{name}{i}" for i in range(p.structure.shape_elements) for name in ("relaxation", "coupling")]
    if p.signs in ((1, -1), (-1, 1)):
        blocks += ["input0", *(f"pull{i}_0" for i in range(p.structure.shape_elements))]
    for name in blocks:
        spread = symmetry * UNLIKENESS.get(name, 1.0)
        for i in range(p.slices[name].start, p.slices[name].stop):
            j = int(np.argmax(np.abs(image[i])))
            if i < j:
                rows.add([i, j], [1.0, -image[i, j]], 0.0, spread * scale[i])
            elif i == j and image[i, i] < 0.0:
                rows.add([i], [1.0], 0.0, spread * scale[i])


def _shapes(rows: "_PriorRows", p: ParameterLayout, start: FloatArray) -> None:
    """Shape elements relax about as fast as they start, and inputs pull little at them."""
    at, unit = p.slices, np.sqrt(p.units.stiffness)
    for i in range(p.structure.shape_elements):
        relaxation = np.arange(at[f"relaxation{i}"].start, at[f"relaxation{i}"].stop)
        rows.smooth(relaxation, 0.3)
        rows.each(relaxation, start[relaxation], 1.0)
        for k in range(len(p.signs)):
            pull = np.arange(at[f"pull{i}_{k}"].start, at[f"pull{i}_{k}"].stop)
            rows.smooth(pull, 0.1 * unit)
            rows.each(pull, np.zeros(len(pull)), 0.5 * unit)


class _PriorRows:
    """Rows of a Gaussian prior, collected one by one; each is divided by its standard deviation."""

    def __init__(self, parameters: int) -> None:
        self.parameters = parameters
        self.rows: list[FloatArray] = []
        self.right: list[float] = []

    def add(self, index: Sequence[int], factors: Sequence[float], mean: float, spread: float) -> None:
        row = np.zeros(self.parameters)
        row[list(index)] += np.array(factors)
        self.rows.append(row / spread)
        self.right.append(mean / spread)

    def each(self, index: FloatArray, means: FloatArray, spread: float) -> None:
        for i, mean in zip(index, means, strict=True):
            self.add([int(i)], [1.0], float(mean), spread)

    def smooth(self, index: FloatArray, spread: float) -> None:
        """Second differences along the centres are small."""
        for a, b, c in zip(index, index[1:], index[2:], strict=False):
            self.add([int(a), int(b), int(c)], [-1.0, 2.0, -1.0], 0.0, spread)

    def prior(self) -> Prior:
        return Prior(np.array(self.rows), np.array(self.right))
