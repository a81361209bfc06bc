"""Settings, logs, manifests that never end or that no parser survives: each prototype fails alone, in a line."""

import os
import signal
import time
from pathlib import Path

import pytest

from cli import debist
from pipeline.device.parameters import joint_parameters
from pipeline.errors import CorruptArtifactError, InputError
from pipeline.settings.prototype import load_prototype
from pipeline.store.manifest import MANIFEST, load_manifest
from pipeline.system.plain_files import read_plain
from pipeline.workflow.batch import Execution, Outcome, Worker, run_batch, write_fleet_tables
from pipeline.workflow.members import FLEET_CSV, members, prototype_files
from pipeline.workflow.progress import fleet_progress, is_fleet
from pipeline.workflow.run import run_prototype
from tests.prototypes import Silent

CHANNELS = """
[channels]
time = { channel = "t", unit = "s" }
q = { channel = "q", unit = "mm" }
v1 = { channel = "u", unit = "V" }
"""


class Quiet:
    def started(self, name): ...

    def finished(self, outcome): ...


@pytest.fixture(autouse=True)
def within_a_minute():
    """Whatever hangs is interrupted."""

    def hung(*_):
        raise TimeoutError("it hangs")

    before = signal.signal(signal.SIGALRM, hung)
    signal.alarm(60)
    yield
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


def _spoilt_settings(folder: Path) -> dict[str, str]:
    """Settings files that nobody can read, and what is said of each."""
    (folder / "digits.toml").write_text(f'name = "digits"\nx = {"9" * 5000}\n')
    (folder / "brackets.toml").write_text(f'name = "brackets"\nx = {"[" * 20_000}\n')
    (folder / "large.toml").write_text("#" * (1 << 21))
    os.mkfifo(folder / "fifo.toml")
    (folder / "zero.toml").symlink_to("/dev/zero")
    return {
        "digits": "Exceeds the limit",
        "brackets": "nested too deeply",
        "large": "is larger than",
        "fifo": "is no regular file",
        "zero": "is no regular file",
    }


def test_settings_that_no_parser_survives_fail_alone(tmp_path):
    """In the batch's own process, which asks each for its name; one worker stands for all."""
    said = _spoilt_settings(tmp_path)
    for name, text in said.items():
        with pytest.raises(InputError, match=text) as caught:
            load_prototype(tmp_path / f"{name}.toml")
        assert "\n" not in str(caught.value)
    files = [tmp_path, *(tmp_path / f"{name}.toml" for name in said)]
    named = members(prototype_files(files, tmp_path / "runs"))
    assert {member.name for member in named} >= set(said) - {"zero"}  # a link is resolved
    assert all(member.error for member in named)
    one = [member for member in named if member.name == "brackets"]
    outcomes = run_batch(one, tmp_path / "runs", Quiet(), debist, Execution(1))
    assert [(o.exit_code, "nested too deeply" in o.reason) for o in outcomes] == [(2, True)]
    assert "nested too deeply" in (tmp_path / "runs/fleet.csv").read_text()


@pytest.mark.parametrize("kind", ["fifo", "zero", "folder"])
def test_a_log_that_is_no_file_is_refused_before_it_is_hashed(tmp_path, kind):
    log = tmp_path / "log.csv"
    {"fifo": os.mkfifo, "zero": lambda at: at.symlink_to("/dev/zero"), "folder": Path.mkdir}[kind](log)
    (tmp_path / "P.toml").write_text(f'name = "P"\n[logs]\ntrain = ["log.csv"]\n{CHANNELS}')
    with pytest.raises(InputError, match=r"log\.csv: cannot be read: (is no regular file|Is a directory)"):
        run_prototype(tmp_path / "P.toml", tmp_path / "run", Silent())


@pytest.mark.parametrize("kind", ["fifo", "zero", "nested"])
def test_a_manifest_that_no_parser_survives_is_refused(tmp_path, kind):
    manifest = tmp_path / MANIFEST
    nested = '{"format": ' + "[" * 100_000
    make = {
        "fifo": os.mkfifo,
        "zero": lambda at: at.symlink_to("/dev/zero"),
        "nested": lambda at: at.write_text(nested),
    }
    make[kind](manifest)
    with pytest.raises(CorruptArtifactError if kind == "nested" else InputError, match=MANIFEST):
        load_manifest(tmp_path)


def test_a_parameter_set_that_is_no_file_is_refused(tmp_path):
    os.mkfifo(tmp_path / "set.toml")
    with pytest.raises(InputError, match="is no regular file"):
        joint_parameters("set.toml", folder=tmp_path)


def test_what_is_larger_than_it_may_be_is_not_read_on(tmp_path):
    with pytest.raises(OSError, match="is larger than"):
        read_plain(Path("/proc/self/maps"), 10)
    (tmp_path / "some").write_bytes(b"x" * 10)
    assert read_plain(tmp_path / "some", 10) == b"x" * 10


def _sleeping(arguments):
    time.sleep(100)


def test_a_worker_is_stopped_after_its_time_limit_and_says_so(tmp_path):
    with Worker(_sleeping, "P", Path("P.toml"), tmp_path, time_limit=0.3) as worker:
        outcome = worker.outcome()
    assert outcome.exit_code == -signal.SIGKILL and outcome.seconds < 50.0
    assert outcome.reason == "stopped after the time limit of 0.3 s; raise --time-limit, the same command goes on"


@pytest.mark.parametrize(
    ("names", "said"),
    [
        (("Arm", "arm"), "which some disks take for the same"),
        (("Fleet.csv",), "a file of the fleet"),
        (("Failed",), "a file of the fleet"),
    ],
)
def test_names_that_collide_on_some_disks_are_refused(tmp_path, names, said):
    for number, name in enumerate(names):
        (tmp_path / f"{number}.toml").write_text(f'name = "{name}"\n[logs]\ntrain = ["log.csv"]\n{CHANNELS}')
    with pytest.raises(InputError, match=said):
        members(prototype_files([tmp_path], tmp_path))


def test_a_run_that_is_spoilt_after_it_ended_well_is_a_row_of_the_table(tmp_path):
    write_fleet_tables(tmp_path, [Outcome("gone", tmp_path / "gone.toml", 0, "")])
    assert "gone,2," in (tmp_path / FLEET_CSV).read_text()


def test_the_status_of_a_folder_with_links_and_fifos_ends(tmp_path):
    (tmp_path / "loop").symlink_to(tmp_path)
    for name, file in (("a", MANIFEST), ("b", ".lock-holder.json"), ("c", ".lock"), ("failed", "x.txt")):
        (tmp_path / name).mkdir()
        os.mkfifo(tmp_path / name / file)
    (tmp_path / "d").mkdir()
    (tmp_path / "d" / MANIFEST).symlink_to("/dev/zero")
    (tmp_path / "e").mkdir()
    (tmp_path / "e" / MANIFEST).write_text("{}")
    assert is_fleet(tmp_path)
    assert [(member.name, member.state) for member in fleet_progress(tmp_path)] == [
        ("e", "failed"), ("x", "stopped"),
    ]  # fmt: skip
