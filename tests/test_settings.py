"""Settings: strict, frozen, and every mistake is one line that names the key and a way out."""

import copy
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from pydantic import BaseModel, ValidationError

from pipeline import settings, settings_logs
from pipeline.errors import InputError, SeveralMistakesError
from pipeline.former_settings import translated
from pipeline.runs import layout
from pipeline.settings import Prototype, load_prototype, parse_prototype

GOOD: dict[str, Any] = {
    "name": "P1",
    "logs": {"train": ["train.mat"]},
    "channels": {"q": {"channel": "Laser_q", "unit": "mm"}, "v1": {"channel": "HV1", "unit": "kV"}},
}


def _changed(change: Callable[[dict[str, Any]], Any]) -> dict[str, Any]:
    document = copy.deepcopy(GOOD)
    change(document)
    return document


def test_only_name_logs_and_channels_are_mandatory() -> None:
    prototype = parse_prototype(GOOD, "P1.toml")
    assert prototype.ingest.sample_interval == 0.01
    assert prototype.channels.inputs == (prototype.channels.v1,)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda d: d.update(identfy={}), ["'identfy'", "did you mean 'identify'"]),
        (lambda d: d.update(identify={"basis_function": 3}), ["'identify.basis_function'", "'basis_functions'"]),
        (lambda d: d.update(ingest={"csv": {"delimeter": ";"}}), ["'ingest.csv.delimeter'", "'delimiter'"]),
        (lambda d: d.update(ingest={"zzz": 1}), ["'ingest.zzz'", "known here", "sample_interval"]),
        (lambda d: d.update(ingest={"record_interval": 0.02}), ["ingest", "record_interval is 0.02 s", "finer"]),
        (lambda d: d.pop("logs"), ["'logs' is missing"]),
        (lambda d: d["channels"]["q"].pop("unit"), ["'channels.q.unit' is missing"]),
        (lambda d: d["logs"].update(train=[]), ["logs.train"]),
        (lambda d: d.update(name="../x"), ["name", "'../x'"]),
        (lambda d: d.update(name=".."), ["'..'"]),
        (lambda d: d.update(name="con"), ["keep it for a device"]),
        (lambda d: d["logs"].update(train=["a/b*c.mat"]), ["'b*c'", "rename"]),
        (lambda d: d["logs"].update(train=["a.mat", "b/a.csv"]), ["logs.train", "'a'"]),
        (lambda d: d.update(differentiate={"alpha": -1.0}), ["differentiate.alpha", "positive"]),
        (
            lambda d: d.update(differentiate={"method": "savitzky-golay", "alpha": 0.1}),
            ["differentiate", "tvregdiff", "'savitzky-golay'"],
        ),
        (
            lambda d: d.update(ingest={"sample_interval": 0}),
            ["sample_interval", "than or equal to 0.00001"],
        ),
        (
            lambda d: d.update(ingest={"sample_interval": 5e-7}),
            [
                "than or equal to 0.00001 (got 5e-07); for a faster log stretch time",
                "scale = 1e4",
                "sample_rate over 1e4",
            ],
        ),
        (lambda d: d.update(ingest={"sample_interval": 100}), ["(got 100); a number in s"]),
        (lambda d: d.update(ingest={"sample_rate": "30 kHz"}), ["(got '30 kHz'); a number in Hz"]),
        (lambda d: d["channels"]["q"].update(average="20 ms"), ["channels.q.average", "; a number in s"]),
        (lambda d: d.update(ingest={"record_interval": 5e-7}), ["record_interval", "scale = 1e4"]),
        (lambda d: d.update(ingest={"sample_rate": 2e7}), ["sample_rate", "sample_rate over 1e4"]),
        (lambda d: d.update(identify={"basis_functions": 2.5}), ["identify.basis_functions", "2.5"]),
        (lambda d: d.update(identify={"models": ["hybird"]}), ["identify.models", "did you mean 'hybrid'?"]),
        (lambda d: d.update(identify={"models": ["hybrid"]}), ["identify.models", "two squared inputs"]),
        (lambda d: d.update(plant={"parameters": "nominal", "inputs": "linear"}), ["plant.parameters", "v1 and v2"]),
        (lambda d: d.update(identify={"models": []}), ["identify.models"]),
        (lambda d: d.update(compare={"models": ["rbf"]}), ["compare.models", "no model 'rbf' here", "sindy"]),
        (
            lambda d: d.update(identify={"models": ["rbf-paper"], "structure": {"drag": "none"}}),
            ["identify.structure.drag", '"rbf"'],
        ),
        (lambda d: d.update(identify={"models": ["rbf-paper"], "time_limit": 5}), ["identify.time_limit", '"rbf"']),
        (
            lambda d: d.update(
                identify={"models": ["rbf-paper"]},
                plant={"mass": {"value": 1, "unit": "g"}, "curves": "c.csv"},
            ),
            ["plant.curves", '"rbf"'],
        ),
        (lambda d: d.update(identify={"friction": "lag"}), ['[identify.structure], and friction = "lag" below it']),
        (lambda d: d.update(identify={"rbf_prior": "smooth"}), ["identify.rbf_prior is gone; leave it out"]),
        (lambda d: d.update(differentiate={"rate": "signals"}), ["rate is gone", "record_interval"]),
        (lambda d: d.update(differentiate={"method": "rts"}), ["method is gone", '"savitzky-golay"']),
        (
            lambda d: (
                d["channels"].update(qdot={"channel": "w", "unit": "m/s"}),
                d.update(differentiate={"alpha": 1.0}),
            ),
            ["differentiate.alpha", "channels.qdot"],
        ),
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


def test_three_mistakes_are_three_lines() -> None:
    document = GOOD | {"identfy": {}, "ingest": {"sample_interval": True, "gaps": "fill"}}
    with pytest.raises(SeveralMistakesError) as caught:
        parse_prototype(document, "P1.toml")
    head, *lines = caught.value.lines
    assert head == "P1.toml: 3 mistakes"
    for line, word in zip(lines, ("'identfy'", "ingest.sample_interval", "ingest.gaps"), strict=True):
        assert word in line


NUMBERS = {
    "plant": {"mass": {"value": 1.0, "unit": "kg"}},
    "ingest": {"sample_interval": 0.01, "record_interval": 0.001},
    "differentiate": {"alpha": 0.01, "epsilon": 1e-6},
    "identify": {"basis_functions": 10, "smoothing": 0.5},
    "compare": {"time_limit": 60.0},
}


@pytest.mark.parametrize("value", [float("inf"), float("-inf"), float("nan"), True, "0.01", -1.0, 0.0, 1e30], ids=repr)
@pytest.mark.parametrize("key", [f"{part}.{key}" for part, keys in NUMBERS.items() for key in keys])
def test_no_number_is_out_of_its_bounds(key: str, value: Any) -> None:
    part, name = key.split(".")
    given = {"value": value, "unit": "kg"} if name == "mass" else value
    if name in ("alpha", "mass") and value == 1e30:
        return  # there is no largest mass or regularisation
    document = GOOD | {"plant": {"mass": {"value": 1.0, "unit": "kg"}}} | {part: NUMBERS[part] | {name: given}}
    with pytest.raises(InputError, match=key.replace(".", r"\.")):
        parse_prototype(document, "P1.toml")


def test_a_record_left_out_is_as_fine_as_the_samples() -> None:
    assert parse_prototype(GOOD | {"ingest": {"sample_interval": 1e-4}}, "P1.toml").ingest.sample_interval == 1e-4


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


def test_settings_are_frozen() -> None:
    prototype = parse_prototype(GOOD, "P1.toml")
    with pytest.raises(ValidationError):
        prototype.name = "P2"  # type: ignore[misc]


def test_the_stored_form_reads_back_equal() -> None:
    prototype = parse_prototype(GOOD, "P1.toml")
    assert parse_prototype(prototype.model_dump(mode="json"), "manifest") == prototype


@pytest.mark.parametrize(
    ("content", "words"),
    [(None, "no such file"), (b"name = ", "not valid TOML"), (b"\xff\xfe\x00", "not UTF-8")],
)
def test_an_unreadable_file_is_named(tmp_path: Path, content: bytes | None, words: str) -> None:
    path = tmp_path / "P1.toml"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(InputError, match=words) as caught:
        load_prototype(path)
    assert str(path) in str(caught.value)


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
