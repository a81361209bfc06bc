"""Settings: strict, frozen, and every mistake is one line that names the key and a way out."""

import copy
from collections.abc import Callable
from typing import Any

import pytest
from pydantic import BaseModel

from pipeline.errors import InputError
from pipeline.settings import logs as settings_logs, prototype as settings
from pipeline.settings.file import translated
from pipeline.settings.prototype import Prototype, parse_prototype
from pipeline.store import layout

GOOD: dict[str, Any] = {
    "name": "P1",
    "logs": {"train": ["train.mat"]},
    "channels": {"q": {"channel": "Laser_q", "unit": "mm"}, "v1": {"channel": "HV1", "unit": "kV"}},
}


def _changed(change: Callable[[dict[str, Any]], Any]) -> dict[str, Any]:
    document = copy.deepcopy(GOOD)
    change(document)
    return document


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda d: d.update(identfy={}), ["'identfy'", "did you mean 'identify'"]),
        (lambda d: d.update(ingest={"zzz": 1}), ["'ingest.zzz'", "known here", "sample_interval"]),
        (lambda d: d.update(ingest={"record_interval": 0.02}), ["record_interval is 0.02 s"]),
        (lambda d: d["channels"]["q"].pop("unit"), ["'channels.q.unit' is missing"]),
        (lambda d: d["logs"].update(train=[]), ["logs.train"]),
        (lambda d: d["logs"].update(train=["a.mat", "b/a.csv"]), ["logs.train", "'a'"]),
        (lambda d: d["logs"].update(train=[{"file": "a.mat", "stop": 5}]), ["logs.train.0.stop", "needs its unit"]),
        (lambda d: d["channels"].update(v1=d["channels"]["q"]), ["v1 and q are the same channel"]),
        (lambda d: d.update(name="../x"), ["name", "'../x'"]),
        (lambda d: d.update(ingest={"sample_interval": 5e-7}), ["(got 5e-07)", "scale = 1e4"]),
        (lambda d: d.update(ingest={"sample_rate": "30 kHz"}), ["(got '30 kHz')", "a number in Hz"]),
        (lambda d: d.update(identify={"basis_functions": 2.5}), ["identify.basis_functions", "2.5"]),
        (lambda d: d.update(identify={"models": ["hybrid"]}), ["identify.models", "two squared inputs"]),
        (lambda d: d.update(compare={"models": ["rbf"]}), ["compare.models", "no model 'rbf' here", "sindy"]),
        (lambda d: d.update(identify={"models": ["rbf-paper"], "time_limit": 5}), ["identify.time_limit", '"rbf"']),
        (lambda d: d.update(identify={"friction": "lag"}), ["[identify.structure]"]),
        (lambda d: d.update(identify={"rbf_prior": "smooth"}), ["identify.rbf_prior is gone"]),
    ],
)
def test_a_mistake_is_one_line_that_names_the_key(change: Callable[[dict[str, Any]], Any], words: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        parse_prototype(_changed(change), "P1.toml")
    message = str(caught.value)
    assert message.startswith("P1.toml: ")
    assert "\n" not in message
    for word in words:
        assert word in message


NUMBERS = {
    "plant": {"mass": {"value": 1.0, "unit": "kg"}},
    "ingest": {"sample_interval": 0.01, "record_interval": 0.001},
    "differentiate": {"alpha": 0.01, "epsilon": 1e-6},
    "identify": {"basis_functions": 10, "smoothing": 0.5},
    "compare": {"time_limit": 60.0},
}


@pytest.mark.parametrize("value", [float("inf"), float("nan"), True, "0.01", -1.0, 0.0, 1e30], ids=repr)
@pytest.mark.parametrize("key", [f"{part}.{key}" for part, keys in NUMBERS.items() for key in keys])
def test_no_number_is_out_of_its_bounds(key: str, value: Any) -> None:
    part, name = key.split(".")
    given = {"value": value, "unit": "kg"} if name == "mass" else value
    if name in ("alpha", "mass") and value == 1e30:
        return  # there is no largest mass or regularisation
    document = GOOD | {"plant": {"mass": {"value": 1.0, "unit": "kg"}}} | {part: NUMBERS[part] | {name: given}}
    with pytest.raises(InputError, match=key.replace(".", r"\.")):
        parse_prototype(document, "P1.toml")


@pytest.mark.parametrize(
    ("name", "folder"),
    [
        ("P1", "P1"),
        ("Prüfling 1", "Pruefling-1"),
        ("Training α (1)", "Training-alpha-1"),
        ("Versuch [neu]", "Versuch-neu"),
        ("试验", "name-c72763fe"),
    ],
)
def test_a_name_of_any_script_has_a_safe_folder(name: str, folder: str) -> None:
    document = GOOD | {"name": name, "logs": {"train": [f"{name}.mat"]}}
    prototype = parse_prototype(document, "P1.toml")
    assert (prototype.name, prototype.folder) == (name, folder)
    assert layout.logs(prototype) == [("train", folder, f"{name}.mat")]


def test_the_stored_form_reads_back_equal() -> None:
    prototype = parse_prototype(GOOD, "P1.toml")
    assert parse_prototype(prototype.model_dump(mode="json"), "manifest") == prototype


def test_every_setting_says_what_it_is() -> None:
    def undocumented(model: type[BaseModel]) -> list[str]:
        return [f"{model.__name__}.{name}" for name, field in model.model_fields.items() if not field.description]

    classes = {**vars(settings), **vars(settings_logs)}.values()
    models = [m for m in classes if isinstance(m, type) and issubclass(m, BaseModel)]
    missing = [name for model in models for name in undocumented(model)]
    assert [m for m in missing if m.split(".")[0] != Prototype.__name__] == []


def test_stored_settings_of_an_earlier_release_are_translated() -> None:
    stored = GOOD | {
        "identify": {"friction": "lag", "rbf_prior": "smooth", "basis": "gaussian"},
        "differentiate": {"method": "rts", "rate": "signals", "reweighted": True},
    }
    prototype = parse_prototype(translated(stored), "P1.toml")
    assert prototype.identify.structure.friction == "lag"
    assert prototype.differentiate.method == "tvregdiff"
    assert translated(prototype.model_dump(mode="json")) == prototype.model_dump(mode="json")
    # What an artifact was made with, and cannot be made with any more, stays a difference.
    used = translated({name: stored[name] for name in ("identify", "differentiate")}, used=True)
    assert used["identify"] == {"structure": {"friction": "lag"}, "rbf_prior": "smooth"}
    assert used["differentiate"] == {"method": "rts", "rate": "signals"}
