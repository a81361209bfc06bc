"""Measured characteristic curves: units, order, holes, refusals in one line, and circles in the figure."""

from pathlib import Path

import numpy as np
import pytest

from pipeline.device.device import Device, device
from pipeline.errors import InputError
from pipeline.loading.prior_knowledge import read_measured_curves
from pipeline.loading.report_data import measured_curves
from pipeline.runs.run_folder import RunFolder
from pipeline.runs.schedule import bring_up_to_date
from pipeline.settings import Prototype, parse_prototype
from pipeline.stages.side_files import tasks
from tests.prototypes import Silent


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


def test_the_mark_that_spreadsheets_begin_a_file_with_is_no_part_of_the_heading(tmp_path: Path, plant: Device) -> None:
    curves = read_measured_curves(written(tmp_path, "\ufeffq [mm],F [mN]\n-3,10\n1.5,-20\n"), plant)
    np.testing.assert_allclose(curves["F"], [0.01, -0.02])


def test_an_angle_takes_torques(tmp_path: Path) -> None:
    turning = device(prototype("deg"))
    curves = read_measured_curves(written(tmp_path, "q [deg],F [N mm]\n-90,2\n90,-2\n"), turning)
    np.testing.assert_allclose(curves["q"], [-np.pi / 2, np.pi / 2])
    np.testing.assert_allclose(curves["F"], [0.002, -0.002])


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


def test_a_file_that_is_not_there_is_named(tmp_path: Path, plant: Device) -> None:
    with pytest.raises(InputError, match=r"curves\.csv: cannot be read"):
        read_measured_curves(tmp_path / "curves.csv", plant)


def test_forces_compare_with_a_known_mass_only() -> None:
    with pytest.raises(InputError, match=r"give plant\.mass"):
        prototype(mass=False)


def test_curves_to_keep_and_curves_to_compare_with_are_both_drawn(tmp_path: Path) -> None:
    """A report is given both files, one below the other; what only one of them holds is unknown in the other."""
    written(tmp_path, "q [mm],F [mN]\n-5,-20\n5,20\n").rename(tmp_path / "kept.csv")
    written(tmp_path, "q [mm],dC1_dq [nF/m]\n0,30\n1,31\n").rename(tmp_path / "compared.csv")
    channels = {name: {"channel": name, "unit": unit} for name, unit in (("q", "mm"), ("v1", "V"), ("v2", "V"))}
    plant = {"mass": {"value": 0.04, "unit": "kg"}, "curves": "kept.csv"}
    document = {"name": "x", "logs": {"train": ["a.csv"]}, "channels": channels, "plant": plant}
    for compare, rows in ((None, 2), ("compared.csv", 4)):
        prototype = parse_prototype(document | {"compare": {"curves": compare}}, "x.toml")
        run = RunFolder.create(tmp_path / f"run-{rows}", prototype.model_dump(mode="json"), tmp_path / "x.toml")
        bring_up_to_date(run, tasks(prototype, tmp_path / "x.toml"), Silent())
        drawn = measured_curves(run, prototype)
        assert {len(column) for column in drawn.values()} == {rows}
        assert sorted(drawn["F"][np.isfinite(drawn["F"])]) == [-0.02, 0.02]
