"""Units: converted by their definition, refused by their dimension."""

import math

import pint
import pytest

from pipeline.errors import InputError
from pipeline.units import units
from pipeline.units.units import DISPLACEMENT, INPUT, MASS, PLAIN, POWERS, TIME, parse_quantity, to_si


@pytest.mark.parametrize(
    ("unit", "allowed", "factor", "symbol"),
    [
        ("mm", DISPLACEMENT, 1e-3, "m"),
        ("µm", DISPLACEMENT, 1e-6, "m"),
        ("deg", DISPLACEMENT, math.pi / 180, "rad"),
        ("kV", INPUT, 1e3, "V"),
        ("%", INPUT, 1e-2, "1"),
        ("ms", TIME, 1e-3, "s"),
        ("g", tuple(MASS.values()), 1e-3, "kg"),
    ],
)
def test_known_units(unit: str, allowed: tuple[str, ...], factor: float, symbol: str) -> None:
    resolved = to_si(unit, allowed, "here")
    assert resolved.symbol == symbol
    assert resolved.factor == pytest.approx(factor, rel=1e-12)


@pytest.mark.parametrize("unit", ["kg", "mmm", "degC", "", "m/", "%", "10 mm", "__import__('os')"])
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
    monkeypatch.setattr("pipeline.units.units.PLAIN", {})
    for unit, (factor, symbol) in known.items():
        found = to_si(unit, (*DISPLACEMENT, *INPUT, *TIME, *MASS.values(), "V/m"), "here")
        assert (found.factor, found.symbol) == (factor, symbol)


HOSTILE = [
    "m*9**9**9**9",
    "m**9**9",
    "m**99",
    "m**0.5",
    "9**9*m",
    "((((m))))",
    "m*" * 40 + "m",
    "m" * 61,
    "m.__class__",
    "__import__('os').system('true')",
    "[m for m in m]",
    "m;s",
    "m\0",
]


@pytest.mark.parametrize("unit", HOSTILE, ids=ascii)
def test_what_is_no_product_of_names_and_small_powers_is_refused(unit):
    """Pint multiplies out whatever it is given: `9**9**9**9` without end."""
    with pytest.raises(InputError, match=r"^P.toml: unknown unit .*; write names and whole powers as in"):
        units.to_si(unit, units.DISPLACEMENT, "P.toml")


@pytest.mark.parametrize(
    ("unit", "factor", "symbol"),
    [
        ("N*s/m", 1.0, "N·s/m"),
        ("kg·m²", 1.0, "kg·m²"),
        ("g * cm^2", 1e-7, "kg·m²"),
        ("m**-1", 1.0, "1/m"),
        ("1/mm", 1e3, "1/m"),
        ("mm⁻¹", 1e3, "1/m"),
        ("°", 0.017453292519943295, "rad"),
        ("%", 0.01, "1"),
        ("h", 3600.0, "s"),
    ],
)
def test_products_quotients_and_powers_of_units_are_known(unit, factor, symbol):
    assert units.to_si(unit, (symbol,), "x").factor == pytest.approx(factor, rel=1e-12)


@pytest.mark.parametrize("form", ["csv", "hdf5", "parquet", "mf4"])
def test_a_hostile_unit_in_a_log_does_not_hang_the_run(tmp_path, form):
    import h5py
    import numpy as np
    import pyarrow as pa
    import pyarrow.parquet as pq

    from pipeline.settings.prototype import parse_prototype
    from pipeline.workflow.si_log import read_si

    hostile, columns = "m*9**9**9**9", {name: np.arange(50.0) for name in ("t", "q", "u")}
    path = tmp_path / f"log.{form}"
    if form == "csv":
        path.write_text(f"t,q [{hostile}],u\n" + "".join(f"{i},{i},{i}\n" for i in range(50)))
    elif form == "hdf5":
        with h5py.File(path, "w") as file:
            for name, values in columns.items():
                file.create_dataset(name, data=values).attrs["unit"] = hostile
    elif form == "mf4":
        from asammdf import MDF, Signal

        with MDF(version="4.10") as log:
            t = columns["t"]
            log.append([Signal(values, t, unit=hostile, name=name) for name, values in columns.items() if name != "t"])
            log.save(path)
    else:
        fields = [pa.field(name, pa.float64(), metadata={"unit": hostile}) for name in columns]
        pq.write_table(pa.table(list(columns.values()), schema=pa.schema(fields)), path)
    time = "time" if form == "mf4" else "t"
    channels = {"time": {"channel": time, "unit": "s"}, "q": {"channel": "q", "unit": "mm"}}
    channels["v1"] = {"channel": "u", "unit": "V"}
    prototype = parse_prototype({"name": "P", "logs": {"train": [path.name]}, "channels": channels}, "P.toml")
    assert read_si(path, prototype).q[1].size == 50


@pytest.mark.parametrize("unit", POWERS)
def test_powers_of_kg_m_s_and_v_are_those_of_pint(unit: str) -> None:
    registry = pint.UnitRegistry()
    spelled = unit.replace("·", "*").replace("²", "**2")
    base = registry.Quantity(1.0, spelled if unit != "1" else "").to_base_units()
    # V = kg m² s⁻³ A⁻¹
    si = dict(base.dimensionality)
    current = -int(si.pop("[current]", 0))
    mass, length, time = (int(si.pop(name, 0)) for name in ("[mass]", "[length]", "[time]"))
    assert not si
    assert POWERS[unit] == (mass - current, length - 2 * current, time + 3 * current, current)


@pytest.mark.parametrize(
    ("unit", "allowed", "said"),
    [
        ("grad", DISPLACEMENT, "write 'deg' for degrees"),
        ("px", DISPLACEMENT, "a pixel has no length of its own"),  # pint: a 96th of an inch
        ("Volt", INPUT, "did you mean 'volt'"),
        ("KV", INPUT, "did you mean 'kV'"),
        ("[mm]", DISPLACEMENT, "did you mean 'mm'"),
        ("counts", DISPLACEMENT, "give `scale` too"),
        ("mm/s", DISPLACEMENT, "integrate it, or give it as `qdot` beside a measured q"),
        ("rpm", INPUT, "write '1' for the numbers of any other input"),
    ],
)
def test_units_that_mislead_say_what_to_write(unit, allowed, said):
    with pytest.raises(InputError) as error:
        to_si(unit, allowed, "P.toml")
    assert said in str(error.value)
