"""Units of characteristic curves: F, d q̇ and g u are forces (or accelerations), and g is half of dC/dq."""

import pint
import pytest

from pipeline.device.device import Device
from pipeline.units.units import INPUT, SiUnit

REGISTRY = pint.UnitRegistry()
SPELT = {"·": "*", "²": "**2"}


def dimension(unit: str) -> object:
    for sign, plain in SPELT.items():
        unit = unit.replace(sign, plain)
    return REGISTRY.parse_expression(unit.replace("rad", "radian")).to_base_units().dimensionality


@pytest.mark.parametrize("mass_known", [True, False])
@pytest.mark.parametrize("squared", [True, False])
@pytest.mark.parametrize("voltage", INPUT)
@pytest.mark.parametrize("displacement", ["m", "rad", "V"])
def test_every_term_of_the_equation_of_motion_has_the_same_dimension(displacement, voltage, squared, mass_known):
    action = "squared" if squared else "linear"
    mass = 1.0 if mass_known else None
    units = Device(None, SiUnit(1.0, displacement), (SiUnit(1.0, voltage),), action, mass).curve_units
    force = dimension(units["F"])
    assert dimension(f"({units['d']})*{displacement}/s") == force
    power = 2 if squared else 1
    assert dimension(f"({units['g']})*({voltage})**{power}") == force
    assert dimension(f"({units['dC']})*({voltage})**{power}") == force
    acceleration = dimension(f"{displacement}/s**2")
    if mass_known and displacement == "m":
        assert force == dimension(f"kg*({displacement}/s**2)")
    elif not mass_known:
        assert force == acceleration
