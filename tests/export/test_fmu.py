"""FMI 2.0: valid to fmpy, and both interfaces run like the model."""

import re
import shutil
import subprocess
import zipfile

import numpy as np
import pytest
from fmpy import simulate_fmu
from fmpy.fmi2 import FMU2Slave
from fmpy.validation import validate_fmu
from scipy.interpolate import CubicSpline

from pipeline.export import fmu
from pipeline.export.fmu import write_fmu
from tests.export.fmu_runs import Opened, co_simulated, exchanged
from tests.export.joints import COMPILER, INTERVAL, data_driven, hybrid, paper, sindy, subject

MODELS = {
    "hybrid": hybrid(),
    "data-driven": data_driven(),
    "data-driven, lagged input": data_driven(lag=0.02),
    "paper": paper(),
    "sindy": sindy(),
}
VARIED = [name if name != "data-driven" else pytest.param(name, marks=pytest.mark.long) for name in MODELS]

needs_compiler = pytest.mark.skipif(COMPILER is None, reason="no C compiler here")
_KNOWN = dict[str, dict[str, bytes]]()


@pytest.fixture
def compiled_once(monkeypatch):
    """Within a test that asks for this, equal sources are compiled once in all of them; gives what does compile."""
    compiled = fmu._compiled

    def once(sources, identifier):
        key = repr((sorted(sources.items()), identifier))
        if key not in _KNOWN:
            _KNOWN[key] = compiled(sources, identifier)
        return _KNOWN[key]

    monkeypatch.setattr(fmu, "_compiled", once)
    return compiled


@pytest.mark.usefixtures("compiled_once")
@needs_compiler
@pytest.mark.parametrize("name", MODELS)
def test_co_simulation_is_the_models_own_run(name, tmp_path):
    what = subject(MODELS[name])
    found, run = co_simulated(what, tmp_path), what.model.simulate(what.t, what.v, *what.start)
    assert np.abs(found[:, 0] - run.q).max() < 1e-10 * np.ptp(run.q)
    assert np.abs(found[:, 1] - run.qdot).max() < 1e-10 * np.ptp(run.qdot)
    # debist tells the data-driven joint's acceleration with the friction of half a step later.
    loose = 0.02 if name.startswith("data-driven") else 1e-9
    assert np.abs(found[:, 2] - run.qddot).max() < loose * np.ptp(run.qddot)


@pytest.mark.usefixtures("compiled_once")
@needs_compiler
@pytest.mark.parametrize("name", VARIED)
def test_model_exchange_is_the_models_own_run(name, tmp_path):
    what = subject(MODELS[name], 3.0)
    # Dahl's friction and the charging of membranes are exact in a step of the model, and stiff differential equations.
    parts, tolerance = {"data-driven": (16, 2e-3), "hybrid": (2, 5e-4)}.get(name.split(",")[0], (1, 1e-10))
    run = what.model.simulate(what.t, what.v, *what.start)
    assert np.abs(exchanged(what, tmp_path, parts) - run.q).max() < tolerance * np.ptp(run.q)


@pytest.mark.usefixtures("compiled_once")
@needs_compiler
def test_an_importer_runs_it_both_ways(tmp_path):
    what = subject(hybrid(delay=0.0), 3.0)
    path = write_fmu(what, tmp_path).written[0]
    fine = np.arange(round(3.0 / 1e-3) + 1) * 1e-3
    table = np.zeros(len(fine), dtype=[("time", float), ("v1", float), ("v2", float)])
    table["time"] = fine
    table["v1"], table["v2"] = CubicSpline(what.t, what.v)(fine).T
    run = what.model.simulate(what.t, what.v, *what.start)
    for kind in ("ModelExchange", "CoSimulation"):
        result = simulate_fmu(
            path, fmi_type=kind, input=table, stop_time=3.0, step_size=5e-4, output_interval=1e-3,
            start_values={"q_start": what.start[0]}, output=["q", "check"], solver="Euler",
        )  # fmt: skip
        q = np.interp(what.t, result["time"], result["q"])
        assert np.sqrt(np.mean((q - run.q) ** 2)) < 0.01 * np.ptp(run.q), kind
        assert set(result["check"]) >= {0, 1}, kind  # beyond ±20 mm at times


@pytest.mark.usefixtures("compiled_once")
@needs_compiler
def test_states_are_kept_set_and_written_out(tmp_path):
    opened = Opened(subject(hybrid()), tmp_path, FMU2Slave)
    opened.begin([2500.0, 0.0])
    unit = opened.fmu
    for n in range(20):
        unit.doStep(n * INTERVAL, INTERVAL)
    kept, there = unit.getFMUstate(), opened.outputs()
    written = unit.serializeFMUstate(kept)
    unit.doStep(0.2, INTERVAL)
    assert opened.outputs() != there
    unit.setFMUstate(kept)
    assert opened.outputs() == there
    unit.doStep(0.2, INTERVAL)
    unit.setFMUstate(unit.deSerializeFMUstate(written))
    assert opened.outputs() == there
    unit.freeFMUstate(kept)
    opened.close()


@pytest.mark.parametrize("name", VARIED)
def test_fmpy_finds_nothing_wrong_and_equal_models_give_equal_bytes(name, tmp_path, compiled_once, monkeypatch):
    what = subject(MODELS[name])
    path = write_fmu(what, tmp_path).written[0]
    assert validate_fmu(str(path)) == []
    monkeypatch.setattr(fmu, "_compiled", compiled_once)  # a second time
    assert write_fmu(what, tmp_path / "again").written[0].read_bytes() == path.read_bytes()


@pytest.mark.usefixtures("compiled_once")
@pytest.mark.skipif(shutil.which("x86_64-w64-mingw32-gcc") is None, reason="no cross compiler for Windows here")
@needs_compiler
def test_the_binary_for_windows_has_the_functions_of_that_for_linux(tmp_path):
    """Its tables are read; nothing here runs it."""
    made, names = write_fmu(subject(hybrid()), tmp_path), []
    for binary, tool in (("win64", "x86_64-w64-mingw32-objdump -p"), ("linux64", "nm -D --defined-only")):
        with zipfile.ZipFile(made.written[0]) as archive:
            (place,) = (name for name in archive.namelist() if name.startswith(f"binaries/{binary}/"))
            library = archive.extract(place, tmp_path)
        listed = subprocess.run([*tool.split(), library], capture_output=True, text=True, check=True).stdout
        names.append(set(re.findall(r"\bfmi2\w+", listed)))
        if binary == "win64":
            assert set(re.findall(r"DLL Name: (\S+)", listed)) <= {"KERNEL32.dll", "msvcrt.dll"}  # on every Windows
    assert names[0] == names[1] and "fmi2DoStep" in names[0]
