"""The worked examples of CONTRIBUTING.md: written into a copy of the tree as the page says, and run."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from pipeline.generated.condensed_joint import STATES
from tests.docs.pages import ROOT, blocks
from tests.prototypes import QUICK, motion, settings

_LINE = re.compile(r"<!-- line: (?P<table>\w+) in (?P<file>\S+) -->\n```text\n(?P<line>.*?)\n```", re.S)


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the program with the files and the lines of every example."""
    copy = tmp_path_factory.mktemp("tree")
    shutil.copytree(ROOT / "pipeline", copy / "pipeline", copy_function=shutil.copy2)
    shutil.copy2(ROOT / "cli.py", copy)
    for block in blocks("CONTRIBUTING.md"):
        if block.file is not None:
            assert not (copy / block.file).exists(), f"{block.place}: is no new file"
            (copy / block.file).write_text(block.text, encoding="utf-8")
    for found in _LINE.finditer((ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")):
        file = copy / found["file"]
        text, opening = file.read_text(encoding="utf-8"), f"\n{found['table']} = (\n"
        assert text.count(opening) == 1
        file.write_text(text.replace(opening, f"{opening}{found['line']}\n"), encoding="utf-8")
    return copy


def _debist(tree: Path, *arguments: object) -> str:
    return _outputs(tree, arguments)[0]


def _outputs(tree: Path, *commands: tuple[object, ...]) -> list[str]:
    """What the commands of the copy print, one after the other in one process."""
    program = """if True:
    import json, sys
    from typer.testing import CliRunner
    from cli import app
    done = [CliRunner().invoke(app, command) for command in json.loads(sys.argv[1])]
    print(json.dumps([[each.exit_code, each.stdout, each.stderr] for each in done]))
    """
    arguments = json.dumps([[str(part) for part in command] for command in commands])
    ended = json.loads(_python(tree, "-c", program, arguments))
    assert not any(code for code, *_ in ended), ended
    return [output for _, output, _ in ended]


@pytest.fixture(scope="module")
def run(tree: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, str]]:
    """A run by the new log format with the new baseline, and what commands print of it."""
    folder = tmp_path_factory.mktemp("run")
    t, q, v = motion(8.0, 200.0, 3)
    log = np.rec.fromarrays([t, 1e3 * q, 1e-3 * v[:, 0], 1e-3 * v[:, 1]], names="time,q,v1,v2")
    np.save(folder / "log.npy", np.asarray(log), allow_pickle=False)
    cheap = '[differentiate]\nmethod = "savitzky-golay"\n'  # the copy compiles what it calls
    text = settings(cheap + QUICK.replace("models = []", 'models = ["rest"]'), train="log.npy")
    (folder / "P.toml").write_text(text, encoding="utf-8")
    validate = ("validate", folder / "run")
    _, *printed = _outputs(
        tree,
        ("run", folder / "P.toml", "-o", folder / "run", "-q"),
        ("inspect", folder / "log.npy", "--json"),
        (*validate, "--json"),
        (*validate, "--details"),
    )
    return folder / "run", dict(zip(("inspected", "json", "details"), printed, strict=True))


def test_a_new_log_format_and_a_new_baseline(run: tuple[Path, dict[str, str]]) -> None:
    _, printed = run
    assert json.loads(printed["inspected"])["format"] == "NumPy"
    scores = json.loads(printed["json"])["scores"]
    error = next(row["nrmse"] for row in scores if row["model"] == "rest" and row["signal"] == "q")
    q = motion(8.0, 200.0, 3)[1]
    assert error == pytest.approx(np.sqrt(np.mean((q - q[0]) ** 2)) / np.ptp(q), rel=0.02)


@pytest.mark.parametrize(
    ("mistake", "words"),
    [
        ("    missing_name\n", "NameError: name 'missing_name' is not defined"),
        ("    import no_such_library\n", "ModuleNotFoundError: No module named 'no_such_library'"),
        ("    this is no Python\n", "SyntaxError: invalid syntax"),
    ],
)
def test_a_mistake_in_a_reader_is_not_told_as_damage_of_the_log(
    tree: Path, tmp_path: Path, mistake: str, words: str
) -> None:
    np.save(tmp_path / "log.npy", np.zeros(4, [("time", "f8"), ("q", "f8")]), allow_pickle=False)
    reader = tree / "pipeline" / "rig_logs" / "numpy_log.py"
    right = reader.read_text(encoding="utf-8")
    reader.write_text(right.replace("        super().__init__()\n", f"        super().__init__()\n    {mistake}"))
    try:
        program = "import sys; from typer.testing import CliRunner; from cli import app"
        command = "print(CliRunner().invoke(app, ['inspect', sys.argv[1]]).stderr)"
        told = _python(tree, "-c", f"{program}; {command}", str(tmp_path / "log.npy"))
    finally:
        reader.write_text(right, encoding="utf-8")
    assert words in told and "numpy_log.py" in told and "damaged" not in told and "correct the reader" in told, told


def test_a_new_column_is_in_every_table(run: tuple[Path, dict[str, str]]) -> None:
    import pyarrow.parquet as pq

    root, printed = run
    field = pq.read_schema(root / "scores.parquet").field("stable_rests")
    assert (str(field.type), field.metadata[b"meaning"]) == ("int64", b"stable rests of the model (q only)")
    rows = json.loads(printed["json"])["scores"]
    rests = {row["model"]: row["stable_rests"] for row in rows if row["signal"] == "q"}
    assert rests == {"rbf-paper": 2, "rest": None}
    heading = next(line for line in printed["details"].splitlines() if "outside" in line)
    assert " rests " in heading
    page = (root / "report.html").read_text(encoding="utf-8")
    assert '<th scope="col" title="stable rests of the model (q only)" class="number">rests</th>' in page


@pytest.fixture(scope="module")
def generated(tree: Path) -> Path:
    """The tree after the kernels have been written."""
    pytest.importorskip("casadi")
    _python(tree, "-m", "pipeline.equations.write")
    return tree


def _python(tree: Path, *arguments: str) -> str:
    done = subprocess.run(
        [sys.executable, "-P", *arguments], capture_output=True, text=True, check=False,
        env={**os.environ, "PYTHONPATH": str(tree)},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout


_ELEMENTS = """
import json
import numpy as np
from pipeline.generated.condensed_joint import AT_REST, CORRECTIONS, ELEMENT_STATES, FIRST_ELEMENT, STATES, STOPS
from pipeline.generated.condensed_joint_jacobian import JACOBIAN, PREPARE
from pipeline.models.hybrid import parameters
from pipeline.models.hybrid.kernels import INDEX
from pipeline.models.hybrid.runs import Driving, Followed, JointCoefficients, Stepping, run_joints
from pipeline.device.parameters import NOMINAL

samples, steps = 51, 4
u = np.zeros((1, 2 * steps * (samples - 1) + 1, 2))
common = (Followed(np.zeros(0), np.zeros(samples)), Stepping(0.01, steps, 0.045, 14.0))

def drawn(name):
    deviations = np.full((9, len(parameters.NAMES)), 0.0)
    for other in ("log dry force", "log branch stiffness"):
        deviations[:, parameters.NAMES.index(other)] = -20.0
    deviations[:, parameters.NAMES.index(name)] = np.linspace(-20.0, 2.5, 9)
    return np.array([parameters.constants(NOMINAL, one, 1.26) for one in deviations])

def run(k):
    offset, which = np.zeros(len(k)), np.zeros(len(k), dtype=np.int64)
    coefficients = JointCoefficients(k, np.zeros((len(k), 9, 0)), np.zeros(3))
    driving = Driving(u, which, offset, np.array([-0.011, 0.3, 0.0]))
    return run_joints(coefficients, driving, *common)

found = {"states": STATES, "at_rest": AT_REST}
for name in ("log dry force", "log branch stiffness"):
    k = drawn(name)
    q = run(k)
    path = np.abs(q[:, :, 0] + 0.011).max(axis=1)  # farthest from where it starts
    off = np.abs(q[-1] - run(k[-1:])[0]).max()
    found[name] = {"path": path.tolist(), "off": float(off)}
at = FIRST_ELEMENT + [name for name, _ in ELEMENT_STATES].index("branch_spring")
x, u, z, none = np.zeros(STATES), np.zeros(2), np.zeros(STOPS), np.zeros(len(CORRECTIONS))
slopes = JACOBIAN.evaluate(x=x, u=u, c=none, z=z, c_q=none, p=PREPARE.evaluate(k=k[-1])["p"])["a"]
slopes = slopes.reshape(STATES + STOPS, -1)
found["relaxes"], found["follows"] = float(slopes[at, at]), float(slopes[at, 1])
found["rate"] = float(k[-1, INDEX["branch_relaxation"]])
print(json.dumps(found))
"""


@pytest.mark.long
def test_new_elements_on_the_tip(generated: Path) -> None:
    found = json.loads(_python(generated, "-c", _ELEMENTS))
    assert found["states"] == STATES + 1
    assert found["at_rest"] == [1.0, 1.0, 0.0, 0.0]  # two creep elements, the softening, the new branch
    # The stronger, the less far the tip goes; side by side as alone.
    for name in ("log dry force", "log branch stiffness"):
        path = found[name]["path"]
        assert np.all(np.diff(path) < 1e-9), name
        assert path[-1] < 0.95 * path[0], name
        assert found[name]["off"] < 1e-9, name
    # The exact Jacobian has the new state's law.
    assert found["relaxes"] == pytest.approx(-found["rate"])
    assert found["follows"] == pytest.approx(1.0)
