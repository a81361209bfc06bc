"""Signals that do not fit a model or each other are refused by every model, before compiled code reads them."""

import numpy as np
import pytest

from pipeline.device.parameters import NOMINAL
from pipeline.errors import InputError
from pipeline.fitting.regression import basis_centres
from pipeline.models.analytical.model import AnalyticalModel
from pipeline.models.paper.model import RbfPaperModel

T = 0.01 * np.arange(100)
V = np.zeros((100, 2))


def paper() -> RbfPaperModel:
    centres = basis_centres(-0.02, 0.02, 6)
    weights = np.tile([[8.0], [0.5], [1e-7], [-1e-7]], (1, 6))
    return RbfPaperModel(centres=centres, smoothing=1.0, weights=weights, lag_s=0.03, mass_kg=0.04)


def replaced(values, index, value):
    changed = values.copy()
    changed[index] = value
    return changed


REFUSED = {
    "half the voltages": (T, V[:50], 0.01, 0.0, "v has 50 rows, but t has 100 time stamps"),
    "one column for two inputs": (T, V[:, :1], 0.01, 0.0, r"v has the shape \(100, 1\); this model has 2 input"),
    "inputs in rows": (T, V.T, 0.01, 0.0, r"give \(100, 2\)"),
    "a missing voltage": (T, replaced(V, (7, 1), np.nan), 0.01, 0.0, "v holds samples that are not finite"),
    "text": (T, V.astype(str).astype(object) + "V", 0.01, 0.0, "v does not consist of numbers"),
    "a time stamp that is not finite": (replaced(T, 3, np.inf), V, 0.01, 0.0, "t holds samples that are not finite"),
    "time that jumps": (np.where(T > 0.5, T + 0.1, T), V, 0.01, 0.0, "t is not uniform"),
    "time that runs back": (T[::-1], V, 0.01, 0.0, "t is not uniform and rising"),
    "one sample": (T[:1], V[:1], 0.01, 0.0, "at least 2 time stamps"),
    "a start that is not a number": (T, V, np.nan, 0.0, "q0 holds samples that are not finite"),
    "a path to start from": (T, V, 0.01, np.zeros(100), r"qdot0 has the shape \(100,\); give one number"),
}  # fmt: skip


@pytest.mark.parametrize("model", [paper(), AnalyticalModel(parameters=NOMINAL)], ids=["kernel", "solver"])
@pytest.mark.parametrize("case", REFUSED)
def test_signals_that_do_not_fit_are_refused_in_one_line(model, case):
    t, v, q0, qdot0, text = REFUSED[case]
    with pytest.raises(InputError, match=text) as refusal:
        model.simulate(t, v, q0, qdot0)
    assert "\n" not in str(refusal.value)


def test_times_printed_to_a_tenth_of_a_millisecond_are_uniform():
    assert paper().simulate(np.round(np.arange(100) / 30.0, 5), V, 0.01, 0.0).status == "ok"
