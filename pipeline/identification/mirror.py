"""The mirror image of a data-driven joint: its left side is the other's right one."""

import numpy as np

from pipeline.identification import viscoelastic_joint as joint
from pipeline.identification.parameter_layout import ParameterLayout, kind_of
from pipeline.numerics.arrays import FloatArray


def mirror_image(p: ParameterLayout) -> FloatArray:
    """Matrix (P, P) that takes dimensionless θ to that of the joint mirrored at q = 0, its two inputs exchanged.

    A hidden shape changes its sign in the mirror, so that couplings are even and pulls change sides and sign. What
    belongs to one of one or three inputs has no image: zeros.
    """
    image, at = np.zeros((p.count, p.count)), {name: np.arange(p.count)[where] for name, where in p.slices.items()}

    def put(name: str, other: str, factor: float, *, turned: bool) -> None:
        """Make a block of the image from another, end for end if it is a curve along the centres."""
        image[at[name], at[other][::-1] if turned else at[other]] = factor

    for name, index in at.items():
        kind = kind_of(name)
        if kind == "force":
            powers = index[: joint.POLYNOMIALS]
            image[powers, powers] = (-1.0, 1.0, -1.0, 1.0)[: len(powers)]  # the last is the confining cubic's logarithm
            image[index[joint.POLYNOMIALS :], index[joint.POLYNOMIALS :][::-1]] = -1.0
        elif kind in ("input", "pull"):
            if len(p.signs) == 2:
                put(name, f"{name[:-1]}{1 - int(name[-1])}", 1.0 if kind == "input" else -1.0, turned=True)
        elif name == "input_offset":
            put(name, name, 1.0, turned=True)
        else:
            curve = kind in ("damping", "coupling", "relaxation")
            put(name, name, -1.0 if name == "inertia_centre" else 1.0, turned=curve)
    return image
