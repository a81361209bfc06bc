"""JSON: a reader without debist finds units, range, every constant, and a run to check against."""

import json

import numpy as np
import pytest

from pipeline.export.sources import write_json
from tests.export.joints import data_driven, hybrid, paper, sindy, subject


@pytest.mark.parametrize("model", [hybrid(), data_driven(), paper(), sindy()], ids=lambda model: type(model).__name__)
def test_the_document_is_strict_json_with_units_range_and_a_run(model, tmp_path):
    what = subject(model)
    held = json.loads(write_json(what, tmp_path).written[0].read_text(encoding="utf-8"), parse_constant=pytest.fail)
    assert (held["prototype"], held["validity"]["q"]) == ("demo-1", [-0.02, 0.02])
    made = what.realisation()
    assert [each["name"] for each in held["equations"]["states"]] == [each.name for each in made.states]
    assert all(each["unit"] and each["meaning"] for each in held["equations"]["states"])
    check = held["check"]
    run = model.simulate(np.array(check["t_s"]), np.array(check["v"]), check["q0"], check["qdot0"])
    np.testing.assert_array_equal(run.q, check["q"])


def test_the_paper_model_can_be_run_from_the_document_alone(tmp_path):
    held = json.loads(write_json(subject(paper()), tmp_path).written[0].read_text(encoding="utf-8"))
    c, check = held["equations"]["constants_si"], held["check"]
    t, v = np.array(check["t_s"]), np.array(check["v"])
    parts = round((t[1] - t[0]) / held["equations"]["integration"]["step_s"])

    def slope(x, u):
        bells = np.exp(-c["bend"] * (x[0] - np.array(c["centres"])) ** 2) @ np.array(c["weights"])
        return np.array([x[1], -bells[0] * x[0] - bells[1] * x[2] + bells[2:] @ u, (x[1] - x[2]) / c["lag"]])

    x, h, q = np.array([check["q0"], check["qdot0"], check["qdot0"]]), (t[1] - t[0]) / parts, []
    for n in range(len(t) - 1):
        q.append(x[0])
        for part in range(parts):
            u = [(v[n] + (part + s) / parts * (v[n + 1] - v[n])) ** 2 for s in (0.0, 0.5, 1.0)]
            d1 = slope(x, u[0])
            d2 = slope(x + 0.5 * h * d1, u[1])
            d3 = slope(x + 0.5 * h * d2, u[1])
            d4 = slope(x + h * d3, u[2])
            x = x + h / 6.0 * (d1 + 2.0 * d2 + 2.0 * d3 + d4)
    assert np.abs(np.array(q) - check["q"][:-1]).max() < 1e-9 * np.ptp(q)
