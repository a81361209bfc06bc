"""An exported FMU, driven through fmpy step by step as an importer drives it."""

import ctypes

import numpy as np
from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Model, FMU2Slave

from pipeline.export.fmu import write_fmu
from tests.export.joints import half_steps

POINTER = ctypes.POINTER(ctypes.c_double)
ORDERS = [1, 2, 3]


class Opened:
    """An exported FMU, instantiated through fmpy."""

    def __init__(self, what, folder, kind):
        self.subject, self.realisation = what, what.realisation()
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


def co_simulated(what, folder, pieces=None):
    """q, q̇, q̈ at the samples, in the model's own steps, shape (N, 3).

    `pieces` are the inputs at each step and their three derivatives; if none are given, the parabolas through the
    three values in a step that the model itself uses.
    """
    opened = Opened(what, folder, FMU2Slave)
    t, r = what.t - what.t[0], opened.realisation
    steps = round(what.validity.sample_interval / r.step)
    nodes = np.linspace(0.0, t[-1], steps * (len(t) - 1) + 1)
    if pieces is None:
        v, h = half_steps(what), nodes[1] - nodes[0]
        begin, middle, end = v[::2], np.vstack([v[1::2], v[-1:]]), np.vstack([v[2::2], v[-1:]])
        pieces = [begin, (4.0 * middle - 3.0 * begin - end) / h, 4.0 * (begin - 2.0 * middle + end) / h**2, 0.0 * begin]
        if r.between == "zero":
            pieces = [begin, *[0.0 * begin] * 3]
    places = list(range(r.inputs))
    opened.begin(pieces[0][0])
    found = []
    for n, now in enumerate(nodes):
        opened.fmu.setReal(places, list(pieces[0][n]))
        for order in ORDERS:
            opened.fmu.setRealInputDerivatives(places, [order] * r.inputs, list(pieces[order][n]))
        if n % steps == 0:
            found.append(opened.outputs())
        if n < len(nodes) - 1:
            opened.fmu.doStep(now, nodes[1] - nodes[0])
    opened.close()
    return np.array(found)


def exchanged(what, folder, parts=1):
    """Q at the samples, by Runge-Kutta outside of the FMU, in `parts` of the model's own steps."""
    opened = Opened(what, folder, FMU2Model)
    fmu, r, v = opened.fmu, opened.realisation, half_steps(what, parts)
    h, steps = r.step / parts, parts * round(what.validity.sample_interval / r.step)
    size, places = len(r.states), list(range(r.inputs))
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
        for at, ahead, share in ((0, 0.5, 1.0), (1, 0.5, 2.0), (1, 1.0, 2.0), (2, 0.0, 1.0)):
            fmu.setTime((n + at / 2) * h)
            fmu.setReal(places, list(v[2 * n + (0 if r.between == "zero" else at)]))
            fmu.setContinuousStates(y.ctypes.data_as(POINTER), size)
            fmu.getDerivatives(dx.ctypes.data_as(POINTER), size)
            total += share * dx
            y = x + ahead * h * dx
        x = x + h / 6.0 * total
        fmu.setContinuousStates(x.ctypes.data_as(POINTER), size)
        fmu.completedIntegratorStep()
    opened.close()
    return np.array(found)
