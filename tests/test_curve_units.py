"""Units of characteristic curves: F, d q̇ and g u are forces (or accelerations), and g is half of dC/dq."""

import pint
import pytest

from pipeline.units import INPUT, column_suffix, curve_units

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
    units = curve_units(displacement, voltage, squared=squared, mass_known=mass_known)
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


def test_names_are_those_of_the_field():
    assert curve_units("m", "V", squared=True, mass_known=True) == {
        "F": "N", "d": "N·s/m", "dC": "F/m", "g": "N/V²",
    }  # fmt: skip
    assert curve_units("rad", "1", squared=False, mass_known=True)["g"] == "N·m"


@pytest.mark.parametrize(
    ("symbol", "suffix"), [("N·s/m", "N_s_per_m"), ("m/(s²·V²)", "m_per_s2_V2"), ("1/s", "1_per_s"), ("N·m", "N_m")]
)
def test_a_unit_ends_a_column_name(symbol, suffix):
    assert column_suffix(symbol) == suffix
    assert f"F_{suffix}".isidentifier()
