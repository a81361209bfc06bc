"""Measured characteristic curves: units, order, holes, refusals in one line, and circles in the figure."""

from pathlib import Path

import numpy as np
import pytest

from pipeline.device.device import Device, device
from pipeline.errors import InputError
from pipeline.settings.prototype import Prototype, parse_prototype
from pipeline.workflow.prior_knowledge import read_measured_curves


def prototype(unit: str = "mm", mass: bool = True) -> Prototype:
    channels = {"q": {"channel": "q", "unit": unit}, "v1": {"channel": "v1", "unit": "kV"}}
    kilograms = {"mass": {"value": 40.0, "unit": "g" if unit == "mm" else "g*m**2"}} if mass else {}
    document = {"name": "x", "logs": {"train": ["a.csv"]}, "channels": channels, "plant": kilograms}
    return parse_prototype(document | {"compare": {"curves": "curves.csv"}}, "x.toml")


@pytest.fixture(scope="module")
def plant() -> Device:
    return device(prototype())


def written(folder: Path, text: str) -> Path:
    path = folder / "curves.csv"
    path.write_text(text, encoding="utf-8")
    return path


def test_units_come_to_si_rows_are_put_in_order_and_holes_stay(tmp_path: Path, plant: Device) -> None:
    text = "# load cell, 3 May\nq [mm],F [mN],dC1_dq [nF/m],d [N s/m]\n1.5,-20,2.5,0.1\n-3,10,,0.2\n"
    curves = read_measured_curves(written(tmp_path, text), plant)
    np.testing.assert_allclose(curves["q"], [-3e-3, 1.5e-3])
    np.testing.assert_allclose(curves["F"], [0.01, -0.02])
    np.testing.assert_allclose(curves["dC1_dq"], [np.nan, 2.5e-9])
    np.testing.assert_allclose(curves["d"], [0.2, 0.1])


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("q,F\n1,2\n2,3\n", "column 'q'"),
        ("q [mm],G [N]\n1,2\n2,3\n", "column 'G [N]'"),
        ("q [mm],F [kg]\n1,2\n2,3\n", "does not measure"),
        ("q [mm]\n1\n2\n", "at least one of"),
        ("q [mm],F [N],F [mN]\n1,2,3\n2,3,4\n", "each once"),
        ("q [mm],F [N]\n1,2\n", "1 rows"),
        ("q [mm],F [N]\n1,2\n2\n", "row 3 has 1 cells"),
        ("q [mm],F [N]\n1,2\n2,zwei\n", "no number"),
        ("q [mm],F [N]\n1,2\n2,1e999\n", "infinite"),
        ("q [mm],F [N]\n1,2\n,3\n", "q is empty"),
        ("", "at least one of"),
    ],
)
def test_what_cannot_be_read_is_said_in_a_line(tmp_path: Path, plant: Device, text: str, said: str) -> None:
    with pytest.raises(InputError) as caught:
        read_measured_curves(written(tmp_path, text), plant)
    assert said in str(caught.value) and "curves.csv" in str(caught.value) and "\n" not in str(caught.value)
