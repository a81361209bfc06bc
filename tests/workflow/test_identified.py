"""Which models a run has beside its main model: the network is a row of its own, and nothing is fitted twice."""

from collections import Counter
from types import SimpleNamespace
from typing import Any

import pytest

from pipeline.device.device import JOINT
from pipeline.models.choose import Choice
from pipeline.models.model_type import Training
from pipeline.settings.prototype import Identify, parse_prototype
from pipeline.workflow.steps import identify

CHANNELS = {key: {"channel": key, "unit": unit} for key, unit in (("q", "mm"), ("v1", "kV"), ("v2", "kV"))}
PROTOTYPE = parse_prototype({"name": "P", "logs": {"train": ["a.csv"]}, "channels": CHANNELS}, "P.toml")
WHOLE = Training((), (), JOINT, None, None, Identify())


class Named:
    """A model of which the name counts."""

    def __init__(self, name: str) -> None:
        self.name = name

    def describe(self) -> dict[str, Any]:
        return {}


@pytest.fixture
def fitted(monkeypatch: pytest.MonkeyPatch) -> Counter[str]:
    """How often each model was fitted; "auto" chooses `hybrid`."""
    count = Counter[str]()

    def model_type(name: str) -> Any:
        def fit(_: Training) -> Named:
            count[name] += 1
            return Named(name)

        return SimpleNamespace(fit=fit)

    monkeypatch.setattr(identify, "_findings", lambda *_: [])
    monkeypatch.setattr(identify, "training", lambda *_: WHOLE)
    monkeypatch.setattr(identify, "model_type", model_type)
    return count


def chosen(monkeypatch: pytest.MonkeyPatch, model: str, other: str | None) -> tuple[list[str], dict[str, Any]]:
    """Names of the models of a run where "auto" chose `model` and had fitted `other` to all logs; and the notes."""
    beside = None if other is None else Named(other)
    monkeypatch.setattr(identify, "_choose", lambda *_: Choice(Named(model), "", {}, None, None, beside))  # type: ignore[arg-type]
    models, notes = identify.identified([], PROTOTYPE, None)
    return list(models), notes


@pytest.mark.parametrize(
    ("model", "other", "models", "networks"),
    [
        ("hybrid", None, ["hybrid", "rbf", "rbf-paper"], 1),
        ("hybrid", "rbf", ["hybrid", "rbf", "rbf-paper"], 0),
        ("rbf", "hybrid", ["rbf", "rbf-paper", "hybrid"], 0),
        ("rbf", None, ["rbf", "rbf-paper"], 0),
    ],
)
def test_the_network_has_a_row_and_is_fitted_once(
    fitted: Counter[str], monkeypatch: pytest.MonkeyPatch, model: str, other: str | None, models: list[str],
    networks: int,
) -> None:  # fmt: skip
    held, notes = chosen(monkeypatch, model, other)
    assert held == models
    assert fitted == Counter({"rbf": networks, "rbf-paper": 1})
    assert notes["identified"] == [name for name in models if (name, model) != ("hybrid", "rbf")]
    assert notes.get("equations") == (other if other == "hybrid" else None)
