"""The population prior of a bistable joint: what others are like, as a normal distribution of θ.

θ counts in units of its joint's own scales. `benchmarks/population_estimate.py` estimates the distribution; what it is
worth stands in docs/explanation/identification.md.
"""

from dataclasses import dataclass

import numpy as np

from pipeline.identification.descent import Prior
from pipeline.identification.joint_structure import JointStructure, Scales
from pipeline.identification.parameter_layout import ParameterLayout, kind_of
from pipeline.numerics.arrays import FloatArray, IntArray


@dataclass(frozen=True)
class Population:
    """A normal distribution of dimensionless θ.

    Attributes
    ----------
    blocks : dict of str to int
        Names and lengths of the blocks of θ, in order.
    smoothing : float
        σ_n of its curves.
    mean : FloatArray, shape (P,)
    root : FloatArray, shape (P, P)
        A of the precision AᵀA.
    """

    blocks: dict[str, int]
    smoothing: float
    mean: FloatArray
    root: FloatArray

    def knows(self, structure: JointStructure) -> bool:
        """Whether it is one of this structure, whose two inputs pull opposite ways by their squares."""
        p = ParameterLayout(structure, Scales(0.0, 1.0, 1.0, 1.0), "squared", (1, -1))
        return blocks_of(p) == self.blocks and structure.smoothing == self.smoothing and not structure.overdamped

    def prior(self, p: ParameterLayout) -> Prior:
        """The prior of a joint of a structure that it knows, whose mirror plane is q = 0."""
        offset, scale = p.dimensionless
        matrix = self.root / scale
        right = self.root @ self.mean + matrix @ offset
        order = np.arange(p.count) if p.signs == (1, -1) else _exchanged(p)
        return Prior(matrix[:, order], right)


def blocks_of(p: ParameterLayout) -> dict[str, int]:
    """Names and lengths of the blocks of θ, in order."""
    return {name: where.stop - where.start for name, where in p.slices.items()}


def _exchanged(p: ParameterLayout) -> IntArray:
    """Where each parameter stands in θ of a joint whose inputs have the numbers of each other, shape (P,)."""
    order, at = np.arange(p.count), p.slices
    for name in at:
        if kind_of(name) in ("pull", "input"):
            order[at[name]] = np.arange(p.count)[at[f"{name[:-1]}{1 - int(name[-1])}"]]
    order[at["input_offset"]] = order[at["input_offset"]][::-1]
    return order
