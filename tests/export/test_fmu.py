"""FMI 2.0: valid to fmpy, and both interfaces run like the model."""

import ctypes
import zipfile

import numpy as np
import pytest
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi2 import FMU2Model, FMU2Slave
from fmpy.validation import validate_fmu
from joints import COMPILER, INTERVAL, data_driven, half_steps, hybrid, paper, sindy, subject
from scipy.interpolate import CubicSpline

from pipeline.export.fmu import write_fmu
from pipeline.export.realise import realise

POINTER = ctypes.POINTER(ctypes.c_double)
MODELS = {"hybrid": hybrid(), "data-driven": data_driven(), "paper": paper(), "sindy": sindy()}

needs_compiler = pytest.mark.skipif(COMPILER is None, reason="no C compiler here")


class Opened:
    """An exported FMU, instantiated through fmpy."""

    def __init__(self, what, folder, kind):
        self.subject, self.realisation = what, realise(what.model, INTERVAL)
        path = write_fmu(what, folder).written[0]
        described = read_model_description(path)
        self.places = {v.name: v.valueReference for v in described.modelVariables}
        self.fmu = kind(
            guid=described.guid,
            unzipDirectory=extract(path, folder / "unzipped"),
            modelIdentifier=described.coSimulation.modelIdentifier,
            instanceName="joint",
        )
        self.fmu.instantiate()
        self.fmu.setupExperiment(startTime=0.0)

    def begin(self, v):
        names = ["q_start", "qdot_start", *self.inputs]
        self.fmu.enterInitializationMode()
        self.fmu.setReal([self.places[name] for name in names], [*self.subject.start, *v])
        self.fmu.exitInitializationMode()

    @property
    def inputs(self):
        return [f"v{i + 1}" for i in range(self.realisation.inputs)]

    def outputs(self):
        return self.fmu.getReal([self.places[name] for name in ("q", "qdot", "qddot")])

    def close(self):
        self.fmu.terminate()
        self.fmu.freeInstance()


@needs_compiler
@pytest.mark.parametrize("name", MODELS)
def test_co_simulation_with_derivatives_of_the_inputs_is_the_models_own_run(name, tmp_path):
    # A delay would move the knots of the spline into the steps.
    what = subject(hybrid(delay=0.0) if name == "hybrid" else MODELS[name])
    opened = Opened(what, tmp_path, FMU2Slave)
    t, references = what.t - what.t[0], [0, 1] * 3
    orders = [1, 1, 2, 2, 3, 3]
    if name == "hybrid":
        pieces = [CubicSpline(t, what.v)(t, order) for order in range(4)]
    else:
        slopes = np.diff(what.v, axis=0, append=what.v[-1:]) / INTERVAL
        pieces = [what.v, slopes, 0.0 * slopes, 0.0 * slopes]
    run = what.model.simulate(what.t, what.v, *what.start)
    opened.begin(pieces[0][0])
    found = np.empty((len(t), 3))
    for n in range(len(t)):
        opened.fmu.setReal([0, 1], list(pieces[0][n]))
        opened.fmu.setRealInputDerivatives(references, orders, [x for piece in pieces[1:] for x in piece[n]])
        found[n] = opened.outputs()
        opened.fmu.doStep(t[n], INTERVAL)
    opened.close()
    assert np.abs(found[:, 0] - run.q).max() < 1e-10 * np.ptp(run.q)
    assert np.abs(found[:, 1] - run.qdot).max() < 1e-10 * np.ptp(run.qdot)
    # debist tells the data-driven joint's acceleration with the friction of half a step later.
    assert np.abs(found[:, 2] - run.qddot).max() < (0.02 if name == "data-driven" else 1e-10) * np.ptp(run.qddot)


@needs_compiler
@pytest.mark.parametrize("name", MODELS)
def test_model_exchange_is_the_models_own_run(name, tmp_path):
    what = subject(MODELS[name], 3.0)
    opened = Opened(what, tmp_path, FMU2Model)
    # Dahl's friction is exact in each step of the model; as a differential equation it is stiff.
    parts, tolerance = (16, 2e-3) if name == "data-driven" else (1, 1e-10)
    fmu, r, v = opened.fmu, opened.realisation, half_steps(what, parts)
    h, steps = r.step / parts, parts * round(INTERVAL / r.step)
    size = len(r.states)
    opened.begin(v[0])
    fmu.enterContinuousTimeMode()
    x, dx = np.empty(size), np.empty(size)
    fmu.getContinuousStates(x.ctypes.data_as(POINTER), size)
    found = []
    for n in range(len(v) // 2 + 1):
        if n % steps == 0:
            found.append(opened.outputs()[0])
        if n == len(v) // 2:
            break
        total, y = np.zeros(size), x.copy()
        for stage, (at, ahead, share) in enumerate(((0, 0.5, 1.0), (1, 0.5, 2.0), (1, 1.0, 2.0), (2, 0.0, 1.0))):
            fmu.setTime((n + at / 2) * h)
            fmu.setReal([0, 1], list(v[2 * n + at]))
            if stage:
                fmu.setContinuousStates(y.ctypes.data_as(POINTER), size)
            fmu.getDerivatives(dx.ctypes.data_as(POINTER), size)
            total += share * dx
            y = x + ahead * h * dx
        x = x + h / 6.0 * total
        fmu.setContinuousStates(x.ctypes.data_as(POINTER), size)
        fmu.completedIntegratorStep()
    opened.close()
    run = what.model.simulate(what.t, what.v, *what.start)
    assert np.abs(np.array(found) - run.q).max() < tolerance * np.ptp(run.q)


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


@needs_compiler
def test_states_are_kept_set_and_written_out(tmp_path):
    opened = Opened(subject(hybrid()), tmp_path, FMU2Slave)
    opened.begin([2500.0, 0.0])
    fmu = opened.fmu
    for n in range(20):
        fmu.doStep(n * INTERVAL, INTERVAL)
    kept, there = fmu.getFMUstate(), opened.outputs()
    written = fmu.serializeFMUstate(kept)
    fmu.doStep(0.2, INTERVAL)
    assert opened.outputs() != there
    fmu.setFMUstate(kept)
    assert opened.outputs() == there
    fmu.doStep(0.2, INTERVAL)
    fmu.setFMUstate(fmu.deSerializeFMUstate(written))
    assert opened.outputs() == there
    fmu.freeFMUstate(kept)
    opened.close()


@pytest.mark.parametrize("name", MODELS)
def test_fmpy_finds_nothing_wrong_and_equal_models_give_equal_bytes(name, tmp_path):
    what = subject(MODELS[name])
    path = write_fmu(what, tmp_path).written[0]
    assert validate_fmu(str(path)) == []
    assert write_fmu(what, tmp_path / "again").written[0].read_bytes() == path.read_bytes()


def test_without_a_compiler_the_source_is_exported_and_said_so(tmp_path, monkeypatch):
    monkeypatch.setattr("shutil.which", lambda name: None)
    made = write_fmu(subject(hybrid()), tmp_path)
    assert "source only" in made.notes[0]
    names = zipfile.ZipFile(made.written[0]).namelist()
    assert {"modelDescription.xml", "sources/fmu.c"} <= set(names)
    assert not [name for name in names if name.startswith("binaries")]
    assert validate_fmu(str(made.written[0])) == []
