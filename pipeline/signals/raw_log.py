"""A raw log in SI units: displacement and inputs, each with its time base."""

from dataclasses import dataclass

from .columns import Signal


@dataclass(frozen=True)
class RawLog:
    """A log in SI units before it has a uniform time base; signals with one time base hold the same object.

    Attributes
    ----------
    q : Signal
        Displacement [m or rad].
    inputs : tuple of Signal
        Voltages [V], or what the inputs measure.
    velocity : Signal or None
        Measured velocity [m/s or rad/s].
    notes : tuple of str
        What was masked or interpolated, by the names in a record.
    """

    q: Signal
    inputs: tuple[Signal, ...]
    velocity: Signal | None = None
    notes: tuple[str, ...] = ()

    @property
    def beside(self) -> dict[str, Signal]:
        """All but q, by their names in a record."""
        named = {f"v{i}": signal for i, signal in enumerate(self.inputs, start=1)}
        return named if self.velocity is None else {**named, "velocity": self.velocity}
