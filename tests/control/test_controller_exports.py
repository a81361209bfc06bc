"""The exported controller is the one that runs in Python: FMU by fmpy, MATLAB function under GNU Octave."""

import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from control_joints import Running, designed
from scipy.io import loadmat, savemat

from pipeline.control.controller import PERIOD, closed_on_model, estimate, observe
from pipeline.control.law import Law
from pipeline.control.plant import wells_and_saddle
from pipeline.export.controller import ESTIMATES, write_controller
from pipeline.numerics.arrays import FloatArray

OCTAVE = shutil.which("octave-cli")


@pytest.fixture(scope="module")
def exported(tmp_path_factory: pytest.TempPathFactory) -> Path:
    plant, law = designed()
    left, saddle, right = (each.q for each in wells_and_saddle(plant))
    folder = tmp_path_factory.mktemp("controller")
    names = {"prototype": "P1", "model": "hybrid", "origin": "0" * 64}
    write_controller(folder, law, (3e-3, 3e-3), (left, saddle, right), **names)
    return folder


def told(count: int) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Readings with gaps, targets, and what the controller answers."""
    plant, law = designed()
    left, _, right = (each.q for each in wells_and_saddle(plant))
    target = np.where(np.arange(count) < 20, left, right)
    q, _ = closed_on_model(law, law, left, target)
    q = q + 2e-6 * np.random.default_rng(1).standard_normal(count)
    q[60:64] = np.nan
    running = Running(law, q[0])
    return q, target, np.array([running.step(*each) for each in zip(q, target, strict=True)])


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
def test_the_fmu_is_valid_and_answers_in_the_same_period(exported: Path) -> None:
    from fmpy import extract, read_model_description
    from fmpy.fmi2 import FMU2Slave
    from fmpy.validation import validate_fmu

    path = str(exported / "controller.fmu")
    assert validate_fmu(path) == []
    about = read_model_description(path)
    estimates = [one.name for one in ESTIMATES]
    assert [each.name for each in about.modelVariables] == ["q", "target", "v1", "v2", *estimates]
    fmu = FMU2Slave(guid=about.guid, unzipDirectory=extract(path), modelIdentifier=about.coSimulation.modelIdentifier)
    fmu.instantiate()
    fmu.setupExperiment()
    fmu.enterInitializationMode()
    fmu.exitInitializationMode()
    q, target, volts = told(400)
    found, running = [], Running(designed()[1], q[0])
    for i, each in enumerate(zip(q, target, strict=True)):
        fmu.setReal([0, 1], each)
        found.append(fmu.getReal([2, 3]))
        running.step(*each)
        estimated = fmu.getReal(range(4, 4 + len(estimates)))
        np.testing.assert_allclose(estimated, estimate(running.state, running.law), rtol=1e-6, atol=1e-9)
        fmu.doStep(i * PERIOD, PERIOD)
    np.testing.assert_allclose(found, volts, rtol=0.0, atol=1e-9 * volts.max())
    with pytest.raises(Exception, match="fmi2DoStep"):
        fmu.doStep(1.0, 0.4 * PERIOD)
    fmu.terminate()
    fmu.freeInstance()


@pytest.mark.skipif(OCTAVE is None, reason="no GNU Octave here")
def test_the_matlab_function_is_the_controller(exported: Path) -> None:
    q, target, volts = told(150)
    savemat(exported / "told.mat", {"q": q, "target": target})
    script = (
        "load told.mat; s = []; v = zeros(2, numel(q)); "
        "for i = 1:numel(q), [v(:, i), s, x] = controller(s, q(i), target(i)); end; "
        "[w, s, y] = controller(s, q(end), NaN, [1500; 0]); save -v6 found.mat v x y"
    )
    done = subprocess.run(
        [str(OCTAVE), "--norc", "--quiet", "--eval", script], cwd=exported, capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, done.stderr
    found, law = loadmat(exported / "found.mat"), designed()[1]
    np.testing.assert_allclose(found["v"].T, volts, rtol=0.0, atol=1e-9 * volts.max())
    running = Running(law, q[0])
    for each in zip(q, target, strict=True):
        running.step(*each)
    np.testing.assert_allclose(found["x"].ravel(), estimate(running.state, law), rtol=1e-6, atol=1e-9)
    observe(running.state, q[-1], np.array([1500.0, 0.0]), law)
    np.testing.assert_allclose(found["y"].ravel(), estimate(running.state, law), rtol=1e-6, atol=1e-9)


@pytest.mark.parametrize(
    "text",
    [
        "*/ INJECTED /*\r\nINJECTED = 1;\n%{\n",
        *(pytest.param(text, marks=pytest.mark.long) for text in ("*\\\\/ ??/\n INJECTED", "\u2028INJECTED")),
    ],
)
@pytest.mark.usefixtures("without_binaries")
def test_no_name_leaves_the_comments(text: str, tmp_path: Path) -> None:
    plant, law = designed()
    left, saddle, right = (each.q for each in wells_and_saddle(plant))
    names = {"prototype": text, "model": text, "origin": text}
    write_controller(tmp_path, law, (3e-3, 3e-3), (left, saddle, right), **names)
    for ending in ("h", "c"):
        source = (tmp_path / f"controller.{ending}").read_text(encoding="ascii")
        assert "INJECTED" not in re.sub(r"/\*.*?\*/", " ", source, flags=re.DOTALL) and "??" not in source
    script = (tmp_path / "controller.m").read_text(encoding="ascii")
    assert not [line for line in script.splitlines() if "INJECTED" in line and not line.startswith("%")]


HARNESS = """
#include <math.h>
#include "controller.h"
int main(void)
{
    static const double odd[] = {0.0, -0.01, NAN, 1e300, -INFINITY, 0.01, 5.0, -1e-300};
    static double state[8192], v[2], out[%d];
    if (debist_controller_size() > sizeof state) return 2;
    for (int first = 0; first < 8; first++) {
        debist_controller_init(state, odd[first]);
        for (int i = 0; i < 200; i++) {
            debist_controller_step(state, i %% 3 ? 0.01 : odd[i %% 8], odd[(i / 7) %% 8], v);
            if (!(v[0] >= 0.0 && v[1] >= 0.0 && v[0] <= %.17g && v[1] <= %.17g)) return 3;
            debist_controller_observe(state, odd[(i / 5) %% 8], odd + i %% 7);
            debist_controller_estimate(state, out);
        }
    }
    return 0;
}
"""


@pytest.mark.long
@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
@pytest.mark.parametrize("seed", range(4))
def test_an_absurd_controller_does_nothing_undefined_and_keeps_its_limits(seed: int, tmp_path: Path) -> None:
    """One whose numbers are far from what they were, but pass the check of a received design."""
    plant, law = designed()
    left, saddle, right = (each.q for each in wells_and_saddle(plant))
    document, random = law.to_json(), np.random.default_rng(seed)
    fixed = {"curve_last", "highest"}
    for name, value in document["numbers"].items():
        if name not in fixed and random.random() < 0.2:
            document["numbers"][name] = value * 10.0 ** int(random.integers(-6, 7))
    absurd = Law.from_json(document)
    names = {"prototype": "P1", "model": "hybrid", "origin": "0" * 64}
    write_controller(tmp_path, absurd, (3e-3, 3e-3), (left, saddle, right), **names)
    highest = absurd.number("highest")
    (tmp_path / "main.c").write_text(HARNESS % (len(ESTIMATES), highest, highest), encoding="utf-8")
    sanitised = ("-g", "-O1", "-std=c99", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
    subprocess.run(["gcc", *sanitised, "main.c", "controller.c", "-o", "run", "-lm"], cwd=tmp_path, check=True)
    done = subprocess.run([tmp_path / "run"], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, (done.returncode, done.stderr)
