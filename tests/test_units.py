"""Units: converted by their definition, refused by their dimension."""

import math

import pytest

from pipeline.errors import InputError
from pipeline.units import DISPLACEMENT, INPUT, MASS, PLAIN, TIME, parse_quantity, to_si


@pytest.mark.parametrize(
    ("unit", "allowed", "factor", "symbol"),
    [
        ("mm", DISPLACEMENT, 1e-3, "m"),
        ("µm", DISPLACEMENT, 1e-6, "m"),
        ("deg", DISPLACEMENT, math.pi / 180, "rad"),
        ("kV", INPUT, 1e3, "V"),
        ("%", INPUT, 1e-2, "1"),
        ("ms", TIME, 1e-3, "s"),
        ("g", MASS, 1e-3, "kg"),
    ],
)
def test_known_units(unit: str, allowed: tuple[str, ...], factor: float, symbol: str) -> None:
    resolved = to_si(unit, allowed, "here")
    assert resolved.symbol == symbol
    assert resolved.factor == pytest.approx(factor, rel=1e-12)


@pytest.mark.parametrize("unit", ["kV", "mmm", "degC", "", "m/", "%", "10 mm", "__import__('os')"])
def test_what_is_no_displacement_is_refused_by_name(unit: str) -> None:
    with pytest.raises(InputError, match="channels q") as caught:
        to_si(unit, DISPLACEMENT, "P1.toml: channels q")
    assert repr(unit) in str(caught.value)


@pytest.mark.parametrize(("text", "value"), [("23mm", 0.023), ("-2.5e1 mm", -0.025), ("0", 0.0)])
def test_quantities(text: str, value: float) -> None:
    assert parse_quantity(text, ("m",), "--b") == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize("text", ["23", "mm", "3 kV", "", "nan mm", "inf mm"])
def test_bad_quantities_are_refused(text: str) -> None:
    with pytest.raises(InputError, match="--b"):
        parse_quantity(text, ("m",), "--b")


def test_plain_units_are_what_pint_makes_of_them(monkeypatch: pytest.MonkeyPatch) -> None:
    known = dict(PLAIN)
    monkeypatch.setattr("pipeline.units.PLAIN", {})
    for unit, (factor, symbol) in known.items():
        found = to_si(unit, DISPLACEMENT + INPUT + TIME + MASS, "here")
        assert (found.factor, found.symbol) == (factor, symbol)
