"""Parameter sets: values, names, units, files."""

from pathlib import Path

import pytest

from pipeline.device.parameter_sets import joint_parameters, parameter_file
from pipeline.device.parameters import NOMINAL, PARAMETER_SETS, QUANTITIES, TABLE1, VECTOR_NAMES
from pipeline.errors import InputError
from pipeline.units import parse_quantity


def test_sets_differ_in_the_beams_modulus_only() -> None:
    assert NOMINAL.with_values({"E": TABLE1.E}) == TABLE1 and set(PARAMETER_SETS) == {"table1", "nominal"}
    assert len(NOMINAL.vector()) == len(VECTOR_NAMES) == 41


def test_names_without_side_mean_both() -> None:
    changed = NOMINAL.with_values({"b": 22e-3, "left.b": 23.5e-3, "E": 1.7e9})
    assert (changed.left.b, changed.right.b, changed.E) == (23.5e-3, 22e-3, 1.7e9)
    assert changed.vector()[VECTOR_NAMES.index("right.b")] == 22e-3


@pytest.mark.parametrize(
    ("name", "value", "allowed"),
    [
        ("E", -1.0, "positive"),
        ("left.Y", float("nan"), "positive"),
        ("b", 0.0, "positive"),
        ("eta", -3.64e6, "zero or positive"),
        ("rho", -1200.0, "zero or positive"),
        ("right.eta_v", -20e3, "zero or positive"),
        ("F_c", -5e-3, "zero or positive"),
        ("kappa0", float("inf"), "of either sign"),
    ],
)
def test_impossible_values_are_refused(name: str, value: float, allowed: str) -> None:
    with pytest.raises(InputError, match=f"{name} = .*: must be a finite number, {allowed}$"):
        NOMINAL.with_values({name: value})


def test_what_may_vanish_or_point_either_way_is_taken() -> None:
    given = {"eta": 0.0, "rho": 0.0, "F_c": 0.0, "kappa0": -0.05, "e_x": -7e-3, "g": -9.81}
    changed = NOMINAL.with_values(given)
    assert {name: changed.value(name if name != "e_x" else "left.e_x") for name in given} == given


def test_every_unit_can_be_given() -> None:
    for name, quantity in QUANTITIES.items():
        assert parse_quantity(f"2.5 {quantity.unit}", (quantity.unit,), name) == 2.5


def test_overrides_carry_units() -> None:
    joint = joint_parameters("nominal", overrides=["E=1.7 GPa", "left.b = 23.2mm", "rho=1.25 g/cm^3", "eta=4 MPa*s"])
    assert (joint.E, joint.left.b, joint.right.b) == (1.7e9, pytest.approx(23.2e-3), 23e-3)
    assert (joint.rho, joint.eta) == (pytest.approx(1250.0), pytest.approx(4e6))


@pytest.mark.parametrize(
    ("override", "says"),
    [("E", "name=value"), ("E=1.7", "has no unit"), ("E=1.7 mm", "does not measure"), ("Q=1 m", "did you mean")],
)
def test_bad_overrides_say_what_to_write(override: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        joint_parameters("nominal", overrides=[override])


def test_parameter_files_round_trip(tmp_path: Path) -> None:
    joint = NOMINAL.with_values({"E": 1.7234567e9, "left.Y": 1.234e6, "F_c": 1e-3, "kappa0": -0.01})
    (tmp_path / "joint.toml").write_text(parameter_file(joint, {"E": "± 1e+07"}), encoding="utf-8")
    assert joint_parameters("joint.toml", folder=tmp_path) == joint


def test_sides_win_over_both_wherever_they_stand(tmp_path: Path) -> None:
    text = 'base = "table1"\nY = "1.3 MPa"\n[left]\nY = "1.1 MPa"\n'
    (tmp_path / "joint.toml").write_text(text, encoding="utf-8")
    joint = joint_parameters("joint.toml", folder=tmp_path)
    assert (pytest.approx(1.1e6), pytest.approx(1.3e6), TABLE1.E) == (joint.left.Y, joint.right.Y, joint.E)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("E = 1.7", "has no unit"),
        ('base = "mine"', "no parameter set"),
        ("E = [", "cannot be read"),
        ("Eh='1 Pa'", "did"),
    ],
)
def test_bad_files_are_one_line(tmp_path: Path, text: str, says: str) -> None:
    (tmp_path / "joint.toml").write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=says):
        joint_parameters("joint.toml", folder=tmp_path)


def test_unknown_sets_and_missing_files_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="did you mean 'nominal'"):
        joint_parameters("nominale")
    with pytest.raises(InputError, match="cannot be read"):
        joint_parameters("gone.toml", folder=tmp_path)
