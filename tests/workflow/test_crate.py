"""A crate holds all that another machine needs: it checks there, and repeats to the same content hashes."""

import json
import tomllib
import zipfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, strategies as st
from typer.testing import CliRunner

from cli import app
from pipeline.device.parameters import joint_parameters
from pipeline.errors import InputError
from pipeline.settings.file import toml_text
from pipeline.settings.prototype import load_prototype
from pipeline.store.hashing import file_sha256
from pipeline.store.manifest import load_manifest
from pipeline.store.run_folder import RunFolder
from pipeline.workflow.export import export_crate
from tests.prototypes import motion_prototype

RUNNER = CliRunner()


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """A prototype's settings file in a folder of its own, with curves from a test stand, and its run."""
    folder = tmp_path_factory.mktemp("made")
    (folder / "rig/logs").mkdir(parents=True)
    (folder / "rig/stand.csv").write_text("q [mm],F [mN]\n-10,5\n10,-5\n", encoding="utf-8")
    prototype = motion_prototype(folder / "rig/logs", "a", 1).rename(folder / "rig/a.toml")
    settings = prototype.read_text().replace('["a.csv"]', '["logs/a.csv"]')
    settings = settings.replace(
        "[compare]", '[plant]\nmass = { value = 40, unit = "g" }\n[compare]\ncurves = "stand.csv"'
    )
    prototype.write_text(settings)
    _invoke("run", str(prototype), "-o", str(folder / "run"), "--no-report")
    return prototype, folder / "run"


@pytest.fixture(scope="module")
def crate(made: tuple[Path, Path], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The unpacked crate, at another place."""
    (written,) = json.loads(_invoke("export", str(made[1]), "--to", "crate", "--json"))["written"]
    place = tmp_path_factory.mktemp("elsewhere") / "crate"
    with zipfile.ZipFile(written) as archive:
        archive.extractall(place)
    return place


def _invoke(*arguments: str, code: int = 0) -> str:
    result = RUNNER.invoke(app, list(arguments))
    assert result.exit_code == code, result.output
    return result.stdout if code == 0 else result.stderr


def _entities(crate: Path) -> dict[str, dict]:
    return {e["@id"]: e for e in json.loads((crate / "ro-crate-metadata.json").read_text("utf-8"))["@graph"]}


def test_the_crate_describes_the_run_by_the_profile(crate: Path, made: tuple[Path, Path]) -> None:
    entities = _entities(crate)
    root, action = entities["./"], entities["#run"]
    assert root["conformsTo"] == [{"@id": "https://w3id.org/ro/wfrun/process/0.5"}]
    assert root["mentions"] == [{"@id": "#run"}] and action["@type"] == "CreateAction"
    assert action["instrument"] == {"@id": "#debist"} and "endTime" in action
    assert {"@id": "inputs/train/a.csv"} in action["object"] and {"@id": "a.toml"} in action["object"]
    assert {"@id": "run/scores.parquet"} in action["result"]
    versions = load_manifest(made[1]).versions
    assert {
        e["name"]: e["softwareVersion"] for e in entities.values() if e["@type"] == "SoftwareApplication"
    } == versions
    files = {name: entity for name, entity in entities.items() if entity["@type"] == "File"}
    on_disk = {str(p.relative_to(crate)) for p in crate.rglob("*") if p.is_file()} - {"ro-crate-metadata.json"}
    assert set(files) == on_disk
    for name, entity in files.items():
        assert entity["sha256"] == file_sha256(crate / name)
        assert int(entity["contentSize"]) == (crate / name).stat().st_size
    assert files["run/model.h5"]["contentHash"] == load_manifest(made[1]).artifacts["model.h5"].content_hash
    assert f"numpy=={np.__version__}" in (crate / "environment.txt").read_text().splitlines()


def test_the_crate_is_read_by_its_library(crate: Path) -> None:
    from rocrate.rocrate import ROCrate

    read = ROCrate(crate)
    assert read.name == "Run of a"
    assert len(read.get_by_type("CreateAction")) == 1


def test_another_place_checks_it_and_repeats_it_to_the_same_hashes(crate: Path, tmp_path: Path) -> None:
    assert "all intact" in _invoke("verify", str(crate / "run"))
    _invoke("run", str(crate / "a.toml"), "-o", str(tmp_path / "again"), "--no-report")
    (artifacts,) = json.loads(_invoke("diff", str(crate / "run"), str(tmp_path / "again"), "--json"))["artifacts"]
    assert len(artifacts) > 4 and {entry["state"] for entry in artifacts} == {"equal"}


@pytest.mark.parametrize("name", ["logs/a.csv", "stand.csv"])
def test_a_crate_is_of_the_files_that_the_run_was_made_from(made: tuple[Path, Path], name: str) -> None:
    log = made[0].parent / name
    whole = log.read_bytes()
    try:
        log.write_bytes(whole + b"9,9,9,9\n")
        assert "changed since the run was made" in _invoke("export", str(made[1]), "--to", "crate", code=2)
        log.unlink()
        assert "is gone" in _invoke("export", str(made[1]), "--to", "crate", code=2)
    finally:
        log.write_bytes(whole)


_TEXTS = st.text(st.sampled_from("aß𝛼 \"'\\#=[]{}\n\t\r\x00\x1f\x7f"))


@given(
    st.dictionaries(
        st.sampled_from("abc"), _TEXTS | st.booleans() | st.integers(-(2**63), 2**63 - 1) | st.floats(-1e9, 1e9)
    )
)
def test_every_text_and_number_survives_as_toml(values: dict) -> None:
    assert tomllib.loads(toml_text({"table": values, "other": 1})).get("table", {}) == values


def test_a_crate_holds_the_parameter_set_that_the_run_was_made_with_and_no_other_file(tmp_path: Path) -> None:
    """Neither one that was edited since, nor a file of this machine that a received manifest names."""
    prototype = motion_prototype(tmp_path, "a")
    settings = prototype.read_text().replace("[compare]", '[plant]\nparameters = "mine.toml"\n[compare]')
    prototype.write_text(settings)
    (tmp_path / "mine.toml").write_text('base = "nominal"\nE = "1.8 GPa"\n')
    _invoke("run", str(prototype), "-o", str(tmp_path / "run"), "--no-report", "-q")
    (tmp_path / "mine.toml").write_text('secret = "hush-hush"\n')
    (written,) = json.loads(_invoke("export", str(tmp_path / "run"), "--to", "crate", "--json"))["written"]
    with zipfile.ZipFile(written) as archive:
        archive.extractall(tmp_path / "crate")
    assert not [
        path for path in (tmp_path / "crate").rglob("*") if path.is_file() and b"hush-hush" in path.read_bytes()
    ]
    named = load_prototype(tmp_path / "crate/a.toml").plant.parameters
    assert joint_parameters(str(named), folder=tmp_path / "crate").E == 1.8e9


def test_a_prior_without_its_hash_is_not_packed(made: tuple[Path, Path], tmp_path: Path) -> None:
    run = RunFolder.open(made[1])
    (tmp_path / "prior.h5").write_bytes(b"secret")
    plant = run.prototype.plant.model_copy(update={"siblings": str(tmp_path / "prior.h5")})
    with pytest.raises(InputError, match="has no"):
        export_crate(run, run.prototype.model_copy(update={"plant": plant}), tmp_path)
