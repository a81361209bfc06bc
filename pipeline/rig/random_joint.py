"""Random prototypes, new or aged: joints as a workshop makes them, in three families of physics.

``same``    the analytical model's own theory (Ritz beam, neo-Hookean rubber, one Maxwell branch) with left/right
            asymmetries, creep and Maxwell-slip friction, which that model does not have;
``foreign``  another beam (a link chain: geometrically exact), another rubber (Gent, Mooney–Rivlin or Ogden with three
            relaxation times), another capacitance law, an extended frame, and another friction (LuGre, Bouc–Wen or
            Dahl with Coulomb), so that a model judged on it cannot profit from sharing the simulator's equations;
``worn``    a finer foreign joint that remembers: layers of the beam yield, the rubber softens with use and creeps over
            decades of time.
"""

from dataclasses import replace
from typing import Literal

import numpy as np

from ..errors import InputError
from ..numerics.arrays import FloatArray
from ..settings.logs import Number, SettingsTable
from .bench import Bench
from .joint import simulate, wells
from .parameters import (
    BOUC_WEN,
    CHAIN,
    DAHL,
    GENT,
    HENCKY,
    LUGRE,
    MAXWELL_SLIP,
    MOONEY_RIVLIN,
    OGDEN,
    RigParameters,
    nominal,
)

Family = Literal["same", "foreign", "worn"]

_TARGETS = (9.0e-3, 12.3e-3)  # m, range of the mean well displacement
_NEAREST, _SKEW = 5.0e-3, 2.5e-3  # m: least displacement of a well, largest difference of the two
_OVERSHOOT = 24.3e-3  # m, short of the laser's rail
_MAX_DRAWS = 1000  # of 25 drawings 6 switched, and yet 50 in a row have failed in a fleet of 60
_PULSE, _PERIOD, _STEP = 1.5, 4.0, 5e-4  # s
_TRIAL = 2900.0  # V, of the pulses
_SLOW, _RISE, _HOLD, _SLOW_STEP = 2400.0, 3.0, 2.0, 1e-3  # V: Table 1, the stiffest drawing, needs as much; s


def random_joint(rng: np.random.Generator, family: Family) -> RigParameters:
    """Draw a joint of the `family` that rests in two wells and switches between them at 3 kV, both ways.

    The beam's stiffness is set last, so that the wells lie where they were drawn, as the adjustment screws of the
    rig would (§2).

    Raises
    ------
    InputError
        If no draw gives a joint that switches.
    """
    for _ in range(_MAX_DRAWS):
        try:
            p = _tuned(_DRAWN[family](rng), float(rng.uniform(*_TARGETS)))
            if _switches(p):
                return p
        except InputError:
            continue
    raise InputError(f"no switchable joint of the family '{family}' among {_MAX_DRAWS} draws; take another seed")


def _spread(rng: np.random.Generator, value: float, relative: float) -> float:
    """`value` with a uniform relative error."""
    return value * (1.0 + float(rng.uniform(-relative, relative)))


def _asymmetric(rng: np.random.Generator, p: RigParameters) -> RigParameters:
    """`p` with workshop tolerances, left and right each its own: lengths ±0.3 mm, rubber and capacitance ±5 %."""

    def lengths(pair: FloatArray, tolerance: float) -> FloatArray:
        """The lengths [m] of left and right, each moved by up to the tolerance [m]."""
        return np.asarray(pair + rng.uniform(-tolerance, tolerance, 2))

    return p._replace(
        mass=_spread(rng, 40.2e-3, 0.02),
        curvature=float(rng.uniform(-0.05, 0.05)),
        bending_loss=_spread(rng, p.bending_loss, 0.35),
        arm=lengths(p.arm, 0.3e-3),
        drop=lengths(p.drop, 0.3e-3),
        anchor_x=lengths(p.anchor_x, 0.3e-3),
        anchor_y=lengths(p.anchor_y, 0.2e-3),
        free_length=lengths(p.free_length, 0.15e-3),
        modulus=p.modulus * _spread(rng, 1.0, 0.05) * rng.uniform(0.98, 1.02, 2),
        capacitance=p.capacitance * _spread(rng, 1.0, 0.05) * rng.uniform(0.97, 1.03, 2),
    )


def _same(rng: np.random.Generator) -> RigParameters:
    """The analytical model's theory, plus creep and Maxwell slip."""
    p = _asymmetric(rng, nominal())
    elements = 4
    reach = np.geomspace(0.05e-3, 2.5e-3, elements) * rng.uniform(0.7, 1.4, elements)
    slip = rng.dirichlet(np.full(elements, 4.0)) * rng.uniform(0.8e-3, 2.5e-3)
    return p._replace(
        branch_modulus=np.outer(rng.uniform(0.95, 1.05, 2), [_spread(rng, 0.31e6, 0.3), rng.uniform(0.04e6, 0.12e6)]),
        branch_time=np.array([_spread(rng, 0.27, 0.3), rng.uniform(3.0, 15.0)]),
        friction=MAXWELL_SLIP,
        slip_stiffness=slip / reach,
        slip_force=slip,
    )


def _foreign(rng: np.random.Generator, links: int | None = None) -> RigParameters:
    """Link chain, other rubber with three relaxation times, other friction, extended frame."""
    links = int(rng.integers(3, 6)) if links is None else links
    p = _asymmetric(rng, nominal(links=links))
    rubber = int(rng.choice([GENT, MOONEY_RIVLIN, OGDEN]))
    shape = {
        GENT: np.array([rng.uniform(6.0, 15.0), 0.0]),
        MOONEY_RIVLIN: np.array([rng.uniform(0.1, 0.4), 0.0]),
        OGDEN: np.array([rng.uniform(1.2, 1.8), rng.uniform(2.5, 4.0)]),
    }[rubber]
    print_error = rng.uniform(0.92, 1.08, links)
    p = p._replace(
        beam=CHAIN,
        frame_offset=float(rng.uniform(1e-3, 6e-3)),
        frame_inertia=float(rng.uniform(0.4e-5, 1.6e-5)),
        hinge_stiffness=p.hinge_stiffness * print_error,
        hinge_loss=p.hinge_loss
        * print_error
        * (p.bending_loss / nominal().bending_loss)
        * float(rng.uniform(1.1, 1.8)),
        hinge_cubic=float(rng.uniform(0.2, 1.2)) * links**2,
        rubber=rubber,
        rubber_shape=shape,
        capacitance_exponent=float(rng.uniform(1.0, 1.3)),
        strain=HENCKY,
        branch_modulus=np.outer(rng.uniform(0.95, 1.05, 2), rng.uniform(0.02e6, 0.06e6, 3)),
        branch_time=np.array([rng.uniform(0.03, 0.08), rng.uniform(0.25, 0.7), rng.uniform(4.0, 15.0)]),
        friction_arm=float(rng.uniform(-10e-3, 10e-3)),
    )
    return _other_friction(rng, p)


def _worn(rng: np.random.Generator) -> RigParameters:
    """A foreign joint of six links whose beam yields, and whose rubber softens and creeps over decades of time."""
    return _foreign(rng, links=6)._replace(
        branch_modulus=np.outer(rng.uniform(0.95, 1.05, 2), rng.uniform(0.02e6, 0.08e6, 5)),
        branch_time=np.geomspace(0.03, 300.0, 5) * rng.uniform(0.6, 1.6, 5),
        plastic_share=rng.uniform(0.004, 0.02, 3),
        plastic_yield=np.array([0.6, 2.5, 6.0]) * rng.uniform(0.7, 1.4, 3),
        softening=float(rng.uniform(0.0, 0.06)),
        softening_time=float(rng.uniform(20.0, 100.0)),
    )


def _other_friction(rng: np.random.Generator, p: RigParameters) -> RigParameters:
    """`p` with LuGre, Bouc–Wen or Dahl friction of 0.6 to 2 mN."""
    kind = int(rng.choice([LUGRE, BOUC_WEN, DAHL]))
    force = float(rng.uniform(0.6e-3, 2.0e-3))
    reach = float(rng.uniform(0.1e-3, 1.2e-3))
    shape = {
        LUGRE: np.array([rng.uniform(0.1, 0.5), rng.uniform(2e-3, 10e-3), 0.02, rng.uniform(0.0, 0.01)]),
        BOUC_WEN: np.array([rng.uniform(0.0, 0.5), 1.0, 0.0, 0.0]),
        DAHL: np.array([rng.uniform(0.1e-3, 0.4e-3), rng.uniform(3e-3, 10e-3), 0.0, 0.0]),
    }[kind]
    return p._replace(
        friction=kind, slip_stiffness=np.array([force / reach]), slip_force=np.array([force]), friction_shape=shape
    )


_DRAWN = {"same": _same, "foreign": _foreign, "worn": _worn}


def _stiffened(p: RigParameters, factor: float) -> RigParameters:
    """`p` with `factor` on the beam's bending stiffness."""
    return p._replace(bending=p.bending * factor, hinge_stiffness=p.hinge_stiffness * factor)


def _tuned(p: RigParameters, target: float) -> RigParameters:
    """`p` with the bending stiffness at which the wells lie `target` [m] from the middle, on average."""
    low = 0.55
    high = 1.6
    for _ in range(9):
        factor = 0.5 * (low + high)
        left, right = wells(_stiffened(p, factor))
        low, high = (factor, high) if 0.5 * (right - left) > target else (low, factor)
    return _stiffened(p, 0.5 * (low + high))


def _switches(p: RigParameters) -> bool:
    """True if the wells lie apart and each voltage switches the joint to the well of its side.

    By pulses, and with a reserve by a voltage that rises slowly: an operator turns the screws until it does (§2).
    """
    left, right = wells(p)
    if not (left < -_NEAREST and right > _NEAREST and abs(left + right) < _SKEW):
        return False
    period = round(_PERIOD / _STEP)
    pulse = round(_PULSE / _STEP)
    v = np.zeros((2 * period, 2))
    v[:pulse, 0] = v[period : period + pulse, 1] = _TRIAL
    q = simulate(p, v, _STEP, stride=1).q
    if not (q[period - 1] > 0.5 * right and q[-1] < 0.5 * left and np.abs(q).max() < _OVERSHOOT):
        return False
    slow = np.minimum(_SLOW / _RISE * np.arange(0.0, _RISE + _HOLD, _SLOW_STEP), _SLOW)
    none = np.zeros_like(slow)
    q = simulate(p, np.column_stack([np.r_[slow, none], np.r_[none, slow]]), _SLOW_STEP, stride=1).q
    return bool(q[slow.size - 1] > 0.0 and q[-1] < 0.0)


class Drift(SettingsTable):
    """Changes in a day, proportional to the age."""

    capacitance_percent: Number = 0.0
    """Drift of both membranes."""
    stiffness_percent: Number = 0.0
    """Drift of the beam in bending."""
    charging_s: Number = 0.0
    """Drift of the time constant with which the membranes charge."""
    laser_m: Number = 0.0
    """Drift of the laser's reading at q = 0."""


def aged(joint: RigParameters, bench: Bench, age: float, drift: Drift) -> tuple[RigParameters, Bench]:
    """Joint and bench at an age [days].

    Parameters
    ----------
    joint : RigParameters
        When it was new.
    bench : Bench
        When it was new.
    age : float
        [days].
    drift : Drift
        Changes per day.

    Raises
    ------
    InputError
        Nothing of a capacitance, a stiffness or a charging time is left at that age.
    """
    more_charge = 1.0 + 0.01 * age * drift.capacitance_percent
    stiffer = 1.0 + 0.01 * age * drift.stiffness_percent
    charging = bench.charging + age * drift.charging_s
    if min(more_charge, stiffer) <= 0.5 or charging < 0.0:
        raise InputError(
            f"age_days = {age:g}: more than half of a capacitance or a stiffness is gone, or a time is negative"
        )
    laser = replace(bench.laser, zero=bench.laser.zero + age * drift.laser_m)
    joint = _stiffened(joint, stiffer)._replace(capacitance=joint.capacitance * more_charge)
    return joint, replace(bench, charging=charging, laser=laser)
