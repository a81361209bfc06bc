"""Prototypes as folders: every format is read back, faults are where they are said to be, seeds decide everything."""

import json
import tomllib
from pathlib import Path
from typing import get_args

import numpy as np
import pytest
from typer.testing import CliRunner

from pipeline.commands.rig import app
from pipeline.errors import InputError
from pipeline.rig.bench import Readings
from pipeline.rig.excitation import EXCITATIONS, MAX_VOLTAGE, command, random_excitation
from pipeline.rig.fleet import Experiment, draw, simulate_prototype
from pipeline.rig.joint import simulate
from pipeline.rig.log import LAYOUTS, FaultKind, inject_faults
from pipeline.rig.parameters import CHAIN, RigParameters, as_json, nominal, sized
from pipeline.rig_logs import read_recording

SHORT = Experiment(kind="nominal", rate=2000.0, duration=4.0, format="parquet")
SI = {"mm": 1e-3, "µm": 1e-6, "kV": 1e3, "V": 1.0}


def truth_of(toml: Path) -> dict[str, object]:
    return json.loads((toml.parent / "truth" / "truth.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("form", LAYOUTS)
def test_every_format_is_read_back_as_its_toml_says(form: str, tmp_path: Path) -> None:
    from pyarrow import parquet

    toml = simulate_prototype(tmp_path, "X", SHORT.model_copy(update={"format": form}), seed=2)
    prototype = tomllib.loads(toml.read_text(encoding="utf-8"))
    truth = parquet.read_table(tmp_path / "truth" / "train.parquet").to_pydict()
    entries = prototype["channels"]
    log = read_recording(tmp_path / prototype["logs"]["train"][0], channels=[e["channel"] for e in entries.values()])
    named = dict(zip(entries, log.channels, strict=True))
    if "time" in named:
        t = named["time"].samples
    else:
        assert named["q"].time is not None
        t = named["q"].time
    np.testing.assert_allclose(np.diff(t), 1 / 2000, rtol=1e-3)
    for key, tolerance in (("q", 12e-6), ("v1", 60.0), ("v2", 60.0)):
        measured = named[key].samples * SI[entries[key]["unit"]]
        assert measured.size == 8000
        np.testing.assert_allclose(measured[::2], truth[key], atol=tolerance)
        assert named[key].unit in ("", entries[key]["unit"], f"[{entries[key]['unit']}]")


@pytest.mark.parametrize("kind", [nominal(), nominal(links=3)._replace(beam=CHAIN, hinge_cubic=4.0)])
@pytest.mark.parametrize("size", [0.4, 2.5])
def test_a_joint_of_another_size_moves_alike_and_slower(kind: RigParameters, size: float) -> None:
    kind = kind._replace(slip_stiffness=np.array([8.0]), slip_force=np.array([2e-3]), curvature=0.03)
    v = np.zeros((800, 2))
    v[:400, 0] = 2900.0
    drawn = simulate(kind, v, 5e-4, stride=1).q
    other = simulate(sized(kind, size), v, 5e-4 * size**0.5, stride=1).q
    assert np.ptp(drawn) > 5e-3
    np.testing.assert_allclose(other / size, drawn, atol=1e-4 * np.ptp(drawn))


def test_a_joint_and_its_records_come_back_from_the_seed(tmp_path: Path) -> None:
    from pyarrow import parquet

    experiment = SHORT.model_copy(update={"kind": "foreign"})
    truth = truth_of(simulate_prototype(tmp_path, "X", experiment, seed=7))
    joint, _, logs = draw(Experiment(**truth["experiment"]), np.random.default_rng(truth["seed"]))
    records = {log.stem: log.record for log in logs}
    assert truth["joint"] == as_json(joint)
    assert set(records) == {"train", "validation"}
    for stem, found in records.items():
        written = parquet.read_table(tmp_path / "truth" / f"{stem}.parquet").to_pydict()
        np.testing.assert_array_equal(found.true_q[::2], written["q"])


@pytest.mark.parametrize("excitation", EXCITATIONS)
def test_excitations_keep_the_voltage_limit_and_use_both_sides(excitation: str) -> None:
    t = np.arange(0, 37.5, 1e-3)
    one, other = (command(random_excitation(np.random.default_rng(s), excitation=excitation), t) for s in (1, 2))
    for v in (one, other):
        assert v.min() >= 0.0 and v.max() <= MAX_VOLTAGE
        assert (v[t < 1.0] == 0).all()
        assert (v > 0.4 * MAX_VOLTAGE).mean(axis=0).min() > 0.05
    assert np.abs(one - other).max() > 1000


def test_faults_are_put_where_they_are_said_to_be() -> None:
    t = np.arange(20_000) * 1e-3
    clean = Readings(t, 0.02 * np.sin(t), np.zeros(t.size), np.zeros(t.size))
    kinds = get_args(FaultKind)
    log, faults = inject_faults(clean, kinds, np.random.default_rng(4))
    found = {kind: [fault for fault in faults if fault.kind == kind] for kind in kinds}
    assert {kind: len(found[kind]) for kind in kinds} == {k: 1 if k == "saturation" else 3 for k in kinds}
    steps = np.diff(log.t)
    assert np.count_nonzero(steps == 0) == 3
    np.testing.assert_allclose(log.t[:-1][steps > 2e-3], sorted(f.start for f in found["gaps"]))
    np.testing.assert_allclose(np.sort(steps[steps > 2e-3]), sorted(f.end - f.start for f in found["gaps"]), rtol=1e-9)
    for fault in found["dropouts"]:
        inside = (log.t >= fault.start) & (log.t <= fault.end)
        assert np.nanmin(log.q[inside]) == pytest.approx(0.97 * 0.02, rel=1e-6)
    assert 1 <= np.count_nonzero(np.isnan(log.q)) <= 6
    assert np.nanmax(np.abs(log.q)) == pytest.approx(0.97 * 0.02, rel=1e-6)
    lost, _ = inject_faults(clean, ("dropouts",), np.random.default_rng(4))
    assert lost.q.max() == 0.025
    same, none = inject_faults(clean, (), np.random.default_rng(4))
    assert none == [] and (same.q == clean.q).all()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('fault = ["gaps"]', "did you mean 'faults'"),
        ('faults = ["gap"]', "did you mean 'gaps'"),
        ("size = 9.0", "size: input should be less than or equal to 5"),
        ("[drift]\ncolour = 1.0", "known here: capacitance_percent"),
    ],
)
def test_a_mistake_in_the_file_of_an_experiment_is_one_line(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "e.toml").write_text(text)
    done = CliRunner().invoke(app, ["simulate", "-o", str(tmp_path), "--experiment", str(tmp_path / "e.toml")])
    assert isinstance(done.exception, InputError) and said in str(done.exception)


def test_commands_write_and_say_where(tmp_path: Path) -> None:
    options = ["--rate", "2000", "--duration", "4", "--kind", "nominal", "--json"]
    (tmp_path / "e.toml").write_text('faults = ["gaps", "nan"]')
    given = ["--experiment", str(tmp_path / "e.toml")]
    one = CliRunner().invoke(app, ["simulate", "-o", str(tmp_path / "one"), *given, *options])
    assert one.exit_code == 0, one.output
    document = json.loads(one.stdout)
    assert Path(document["prototype"]).is_file() and Path(document["truth"]).is_file()
    many = CliRunner().invoke(app, ["fleet", "2", "-o", str(tmp_path / "many"), *options])
    assert [Path(path).is_file() for path in json.loads(many.stdout)["prototypes"]] == [True, True]
    assert len(many.stderr.splitlines()) == 2
    quiet = CliRunner().invoke(app, ["fleet", "2", "-o", str(tmp_path / "more"), "-q", *options])
    assert (quiet.exit_code, quiet.stderr) == (0, "")
