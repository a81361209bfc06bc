"""The double well: its own equation, its energy; and the files of the demo."""

import json
import tomllib
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.io import loadmat

from pipeline.rig.bench import Converter
from pipeline.rig.fleet import write_demo_logs
from tests.double_well import DoubleWell


def test_simulation_agrees_with_an_independent_solver() -> None:
    truth, dt = DoubleWell(), 1e-4
    t = np.arange(20_000) * dt
    v = np.stack([3000.0 * np.exp(-(((t - 0.5) / 0.2) ** 2)), 2500.0 * np.exp(-(((t - 1.3) / 0.2) ** 2))], axis=1)

    def rhs(time: float, x: np.ndarray) -> list[float]:
        c, d, g1, g2 = (float(curve[0]) for curve in truth.curves(x[:1]).values())
        e1 = (3000.0 * np.exp(-(((time - 0.5) / 0.2) ** 2))) ** 2
        e2 = (2500.0 * np.exp(-(((time - 1.3) / 0.2) ** 2))) ** 2
        force = -c * x[0] - d * x[2] + g1 * e1 + g2 * e2
        return [x[1], force / truth.mass, (x[1] - x[2]) / truth.lag]

    exact = solve_ivp(rhs, (0, t[-1]), [-truth.left_well, 0, 0], t_eval=t, rtol=1e-9, atol=1e-12)
    q = truth.simulate(v, dt)
    assert np.abs(q - exact.y[0]).max() < 1e-6
    assert q.max() > 0.01  # it did snap over


def test_converter_keeps_its_limits_and_reaches_its_command() -> None:
    converter, dt = Converter(), 1e-5
    u = np.where(np.arange(6000) < 4000, 3000.0, 0.0)
    v = converter.drive(u, dt)
    slope = np.diff(v) / dt
    assert np.abs(slope).max() <= converter.rate_limit * (1 + 1e-9)
    charging = (slope > 0) & (v[:-1] > 200)
    power = converter.capacitance * v[:-1][charging] * slope[charging]
    assert power.max() <= converter.power_limit * (1 + 1e-9)
    assert v[3999] == pytest.approx(3000.0, rel=1e-5)
    linear = Converter(rate_limit=np.inf, power_limit=np.inf)
    t = np.arange(500) * dt
    np.testing.assert_allclose(linear.drive(np.ones(500), dt), 1 - np.exp(-t / linear.lag), atol=1e-12)


def test_demo_writes_a_prototype_as_a_rig_would(tmp_path: Path) -> None:
    path = write_demo_logs(tmp_path / "demo")
    prototype = tomllib.loads(path.read_text(encoding="utf-8"))
    planted = json.loads((path.parent / "truth.json").read_text(encoding="utf-8"))
    assert prototype["plant"]["mass"]["value"] == pytest.approx(planted["moving_mass"], abs=1e-4)
    readings = []
    for log in prototype["logs"]["train"] + prototype["logs"]["validation"]:
        record = loadmat(path.parent / log, squeeze_me=True, struct_as_record=False)["rec"]
        channels = {channel.Name: channel for channel in record.Y}
        for entry in prototype["channels"].values():
            assert channels[entry["channel"]].Unit == entry["unit"]
        q = channels["Laser_q"].Data
        assert record.X.Data.size == q.size == 37_500
        crossings = np.count_nonzero(np.diff(np.sign(q[::10])))
        assert crossings >= 8, "both wells must be visited"
        assert np.abs(q).max() < 25.0, "no saturation was asked for"
        readings.append(q)
    assert np.abs(readings[0] - readings[1]).max() > 1.0, "validation is another experiment"
