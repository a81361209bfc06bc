"""Corrections of logs as the settings state them, and the raw signals with them."""

from ..device.device import device
from ..errors import InputError
from ..numerics.arrays import FloatArray
from ..settings.logs import Role
from ..settings.prototype import Prototype
from ..signals.columns import scaled
from ..signals.corrections import Corrections
from ..signals.raw_log import RawLog
from ..store import layout
from ..units.units import TIME, parse_quantity


def corrections(prototype: Prototype) -> dict[tuple[Role, str], Corrections]:
    """What [logs] states of each log, by its role and its name in the run.

    Raises
    ------
    InputError
        A zero in another unit than that of q, or a gain of an input that the device has not.
    """
    plant = device(prototype)
    stated = dict[tuple[Role, str], Corrections]()
    for role, log, part in layout.log_parts(prototype):
        where = f"{prototype.name}: logs.{role}: {part.file}"
        if len(plant.inputs) == 1 and part.gain.v2 != 1.0:
            raise InputError(f"{where}: gain.v2 is stated, but [channels] has no v2; leave it out")
        stated[role, log] = Corrections(
            (part.gain.v1, part.gain.v2)[: len(plant.inputs)],
            parse_quantity(part.zero, (plant.displacement.symbol,), f"{where}: zero"),
            part.gain.q,
            parse_quantity(part.delay, TIME, f"{where}: delay"),
            part.clock,
        )
    return stated


def corrected_log(log: RawLog, by: Corrections) -> RawLog:
    """A raw log whose readings are corrected; a measured velocity is left as its own sensor read it."""
    made: dict[tuple[int, float], FloatArray] = {}

    def base(time: FloatArray, delay: float = 0.0) -> FloatArray:
        """A corrected time base, made once, so that signals that shared one do so still."""
        return made.setdefault((id(time), delay), scaled(time, by.clock, delay))

    inputs = [
        (base(time, by.delay), scaled(samples, gain, 0.0))
        for (time, samples), gain in zip(log.inputs, by.gains, strict=True)
    ]
    q = base(log.q[0]), scaled(log.q[1], by.gain_q, by.zero)
    velocity = None if log.velocity is None else (base(log.velocity[0]), log.velocity[1])
    return RawLog(q, tuple(inputs), velocity, log.notes)
