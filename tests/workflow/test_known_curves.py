"""Curves from a test stand through the commands: the identified joint keeps them; the settings must make sense."""

import numpy as np
from typer.testing import CliRunner

from cli import app
from pipeline.models.model_type import model_from_tree
from pipeline.store.run_folder import RunFolder
from tests.double_well import DoubleWell
from tests.prototypes import motion, settings, write_csv

_MORE = """\
[plant]
mass = { value = %.9f, unit = "kg" }
curves = "stand.csv"
[identify]
models = ["rbf"]
[identify.structure]
friction = "lag"
"""


def test_the_model_keeps_the_curves_of_the_file(tmp_path):
    truth = DoubleWell()
    write_csv(tmp_path / "log.csv", *motion(8.0, 200.0, 4))
    q = np.linspace(-0.018, 0.018, 37)
    curves = truth.curves(q)
    stand = {"F": curves["c"] * q, "dC1_dq": 2.0 * curves["g1"], "dC2_dq": 2.0 * curves["g2"]}
    heading = "q [mm],F [mN],dC1_dq [nF/m],dC2_dq [nF/m]"
    rows = np.column_stack([1e3 * q, 1e3 * stand["F"], 1e9 * stand["dC1_dq"], 1e9 * stand["dC2_dq"]])
    np.savetxt(tmp_path / "stand.csv", rows, fmt="%.9g", delimiter=",", header=heading, comments="")
    (tmp_path / "p.toml").write_text(settings(_MORE % truth.mass), encoding="utf-8")
    run = str(tmp_path / "run")
    for arguments in (["ingest", str(tmp_path / "p.toml"), "-o", run], ["differentiate", run], ["identify", run]):
        result = CliRunner().invoke(app, arguments)
        assert result.exit_code == 0, result.output
    model = model_from_tree("rbf", RunFolder.open(tmp_path / "run").read_tree("model.h5", "rbf"))
    found = model.curves(q)
    for name, measured in stand.items():
        assert np.abs(found[name] - measured).max() < 0.03 * np.abs(measured).max(), name
