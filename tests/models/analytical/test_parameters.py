"""Parameter sets: values, names, units, files."""

from pathlib import Path

import pytest

from pipeline.device.parameters import NOMINAL, VECTOR_NAMES, joint_parameters, parameter_file
from pipeline.errors import InputError


def test_names_without_side_mean_both() -> None:
    changed = NOMINAL.with_values({"b": 22e-3, "left.b": 23.5e-3, "E": 1.7e9})
    assert (changed.left.b, changed.right.b, changed.E) == (23.5e-3, 22e-3, 1.7e9)
    assert changed.vector()[VECTOR_NAMES.index("right.b")] == 22e-3


@pytest.mark.parametrize(
    ("name", "value", "allowed"),
    [
        ("E", -1.0, "positive"),
        ("left.Y", float("nan"), "positive"),
        ("eta", -3.64e6, "zero or positive"),
        ("F_c", -5e-3, "zero or positive"),
        ("kappa0", float("inf"), "of either sign"),
    ],
)
def test_impossible_values_are_refused(name: str, value: float, allowed: str) -> None:
    with pytest.raises(InputError, match=f"{name} = .*: must be a finite number, {allowed}$"):
        NOMINAL.with_values({name: value})


def test_overrides_carry_units() -> None:
    joint = joint_parameters("nominal", overrides=["E=1.7 GPa", "left.b = 23.2mm", "rho=1.25 g/cm^3", "eta=4 MPa*s"])
    assert (joint.E, joint.left.b, joint.right.b) == (1.7e9, pytest.approx(23.2e-3), 23e-3)
    assert (joint.rho, joint.eta) == (pytest.approx(1250.0), pytest.approx(4e6))


def test_parameter_files_round_trip(tmp_path: Path) -> None:
    joint = NOMINAL.with_values({"E": 1.7234567e9, "left.Y": 1.234e6, "F_c": 1e-3, "kappa0": -0.01})
    (tmp_path / "joint.toml").write_text(parameter_file(joint, {"E": "± 1e+07"}), encoding="utf-8")
    assert joint_parameters("joint.toml", folder=tmp_path) == joint


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
