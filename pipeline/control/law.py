"""Parts of a designed controller: its numbers, its tables, and the layout of its state."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from ..errors import CorruptArtifactError
from ..generated.condensed_joint import FIRST_STRAIN, PREPARE, STATES, STOP_ELEMENTS, STOPS
from ..generated.condensed_joint_jacobian import PREPARE as PREPARE_SLOPES
from ..models.hybrid.kernels import CURVES
from ..numerics.arrays import FloatArray

CORRECTED = FIRST_STRAIN
"""Leading states that readings correct: q, q̇, τ, τ̇, β, β̇."""
FILTER = CORRECTED + 1
"""Numbers of the filter: these and the unknown moment."""
FEEDBACK = STATES + 1
"""Numbers of which the regulator makes a moment: the deviation of x, and that of the moment that acts."""

_SIZES = {
    "x": STATES, "z": STOPS, "volts": 2, "moment": 1, "lost": 1, "target": 1, "stood": 1, "near": 1, "level": 1,
    "mean": 1, "strayed": 1, "tried": 1, "refused": 1, "phase": 1, "dwell": 1, "brakes": 1, "commanded": 2,
    "average": 2, "spread": FILTER * (FILTER + 1) // 2,
}  # fmt: skip
_ENDS = np.cumsum(list(_SIZES.values()))
PLACES = {name: slice(int(end) - size, int(end)) for (name, size), end in zip(_SIZES.items(), _ENDS, strict=True)}
"""Slices of the controller's state for the joint's state, stop operators, the converters' voltages, the unknown moment,
periods without a reading, the target, and its time at rest (1: long enough for a well). Then the mode: far (0),
regulated (1) or let go in a well (2). The slow moment that holds a target [N·m], the mean of the damping moment in a
well [N·m], and the periods in which the innovation was too large. The recent share of time in which the joint was far
from its target, and whether that is given up. The pump's phase and its time [of a snap], periods of braking, the last
commands and their means over `estimator.MEMORY` [V], the filter's covariance."""
CONTROLLER_STATE = int(_ENDS[-1])
"""Length of the controller's state."""

SIDES = ("left", "right")
"""Sides of the joint: a membrane with its converter on each."""
NUMBERS = (
    "offset", "wall", "farthest",
    *(f"{name}_{side}" for name in ("kept", "kept_mean") for side in SIDES),
    "reading_variance", "push", "walk",
    *(f"unknown_{i}" for i in range(FILTER)),
    *(f"bound_{i}" for i in range(FILTER)),
    "arm", "length", *(f"travel_{i}" for i in sorted(set(STOP_ELEMENTS))),
    "curve_first", "curve_per_metre", "curve_last", "rest_per_metre",
    "highest", "first", "per_step", "per_reach", "steepness", "saddle", "pumped_right", "pumped_left", "near",
    "slew", "allowed", "band", "lever", "settles", "same", "fade", "slow",
)  # fmt: skip
"""Single numbers of a law, all SI: the laser's offset, the wall no motion passes, the largest displacement
that counts as a reading; the share of each converter's voltage that is left after a period and its mean over it;
variance of a reading; densities of a white force on q and of the unknown moment's random walk; variances where little
is known, magnitudes that no estimate passes; friction's arm, the beam's length, travels of stop operators; grids of the
tables; those of the feedback law (`pipeline.control.feedback`); the largest change of a voltage in a period and its
largest mean [V]; half width of the band in which the joint is settled [m]; the mass centre's distance [m] from the tip
along the beam, the periods after which a brake acts, the rows of the table about a well that mean the well, the part of
a snap's time that passes in a period, and the speed [m/s] below which a joint in a well is let go."""

TARGET_COLUMNS = {"rests": slice(0, STATES), "holding": slice(STATES, STATES + 1),
                  "gains": slice(STATES + 1, STATES + 1 + FEEDBACK),
                  "moments": slice(STATES + 1 + FEEDBACK, STATES + 3 + FEEDBACK),
                  "common": slice(STATES + 3 + FEEDBACK, STATES + 4 + FEEDBACK)}  # fmt: skip
"""Columns of the table of targets: the equilibrium there, the moment [N·m] that holds it, and the regulator's gains.
Then the moments of left and right at the largest voltage [N·m], each in its own direction, and the mean share of the
largest squared voltage on both sides."""
TARGETS = 29
"""Rows of that table, from beyond the left well to beyond the right one."""
BEYOND = 2
"""Rows of the table of targets beyond each well; a row lies in each well, where the moment that holds it is zero."""
WELLS = (float(BEYOND), TARGETS - 1.0 - BEYOND)
"""Rows of the wells."""
REACHES = 24
"""Entries of a braking curve."""
RESTS = 65
"""Rows of the table of rests."""


_LARGEST = float(np.finfo(np.float32).max)
"""Single precision holds no larger number."""
_SHAPES = {
    "numbers": (len(NUMBERS),), "prepared": (PREPARE.outputs["p"],), "slopes": (PREPARE_SLOPES.outputs["p"],),
    "rests": (RESTS, 3), "targets": (TARGETS, TARGET_COLUMNS["common"].stop), "braking": (4 * TARGETS, REACHES),
}  # fmt: skip
"""Shapes of the tables that do not depend on the joint."""


class Law(NamedTuple):
    """A controller's constants; displacements are the joint's own, not the laser's.

    Attributes
    ----------
    numbers : FloatArray, shape (len(NUMBERS),)
        See `NUMBERS`.
    prepared, slopes : FloatArray
        Constants of the joint, prepared for its rates and for their derivatives.
    curves : FloatArray, shape (cells, 6, CURVES)
        Corrections of the joint as quintics (`pipeline.models.hybrid.kernels`).
    rests : FloatArray, shape (RESTS, 3)
        Slope, interior shape and stop operators of a joint at rest without voltage, from −`farthest` to `farthest`.
    targets : FloatArray, shape (TARGETS, columns)
        See `TARGET_COLUMNS`.
    braking : FloatArray, shape (4 TARGETS, REACHES)
        Speeds [m/s] at distances from a target, coming from the left (first `TARGETS` rows) and from the right, at
        which a brake begins; then those of a brake that acts.
    """

    numbers: FloatArray
    prepared: FloatArray
    slopes: FloatArray
    curves: FloatArray
    rests: FloatArray
    targets: FloatArray
    braking: FloatArray

    def number(self, name: str) -> float:
        """One of `NUMBERS`."""
        return float(self.numbers[NUMBERS.index(name)])

    @property
    def places(self) -> tuple[float, float]:
        """First and last target [m]."""
        first = self.number("first")
        return first, first + (TARGETS - 1) / self.number("per_step")

    def holding_voltage(self, q: float) -> float:
        """The larger one of both voltages [V] that hold an unstable target at q [m]."""
        grid = np.linspace(*self.places, TARGETS)
        at = {
            name: [np.interp(q, grid, self.targets[:, i]) for i in range(where.start, where.stop)]
            for name, where in TARGET_COLUMNS.items()
        }
        share = at["common"][0] + 0.5 * abs(at["holding"][0]) / np.mean(at["moments"])
        return float(self.number("highest") * np.sqrt(share))

    def to_json(self) -> dict[str, Any]:
        """Every constant, SI."""
        tables = {name: getattr(self, name).tolist() for name in self._fields if name != "numbers"}
        return {"numbers": dict(zip(NUMBERS, self.numbers.tolist(), strict=True)), **tables}

    @classmethod
    def from_json(cls, values: Mapping[str, Any]) -> "Law":
        """The controller back from `to_json`.

        Raises
        ------
        CorruptArtifactError
            Constants are others, as in what another version of the program wrote.
        """
        try:
            if set(values["numbers"]) != set(NUMBERS):
                raise ValueError("constants of another version")
            numbers = np.array([values["numbers"][name] for name in NUMBERS], dtype=np.float64)
            law = cls(numbers, *(np.array(values[name], dtype=np.float64) for name in cls._fields[1:]))
            shapes = {name: getattr(law, name).shape for name in _SHAPES}
            if shapes != _SHAPES or law.curves.shape[1:] != (6, CURVES) or not len(law.curves):
                raise ValueError("a table has another shape")
            if not all(np.all(np.abs(values) <= _LARGEST) for values in law):
                raise ValueError("a number is too large, or none")
            if law.number("curve_last") != len(law.curves) - 1.0:
                raise ValueError("the table of corrections has another length")
        except (KeyError, TypeError, ValueError, IndexError, ArithmeticError) as error:
            raise CorruptArtifactError(
                f"the designed controller cannot be read ({error}); run `debist control design` again"
            ) from None
        return law
