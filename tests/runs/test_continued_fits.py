"""An identification or calibration that is killed goes on from what it had finished, to the same result."""

import json
import os
import signal

import pytest

from pipeline.runs.checkpoints import FOLDER, Checkpoints
from pipeline.stages.run import run_prototype
from tests.faults.small_run import write_prototype
from tests.prototypes import Silent, content

SETTINGS = {
    "rbf": ({"models": ["rbf"], "time_limit": 3.0}, [], 'inputs = "squared"'),
    "hybrid": ({"models": ["auto"], "time_limit": 1.0}, [], 'inputs = "squared"'),
    "calibration": ({"models": ["rbf-paper"]}, ["analytical-calibrated"], 'parameters = "nominal"'),
}
FEWEST = {"rbf": 6, "hybrid": 8, "calibration": 4}


def prototype_of(folder, kind):
    """The small prototype, with these models."""
    prototype, (identify, baselines, plant) = write_prototype(folder), SETTINGS[kind]
    head = prototype.read_text().partition("[identify]")[0]
    lines = [f"{key} = {json.dumps(value)}" for key, value in identify.items()]
    text = [head, "[plant]", plant, "[identify]", *lines, "[compare]", f"models = {json.dumps(baselines)}"]
    prototype.write_text("\n".join(text))
    return prototype


def make(prototype, run) -> None:
    run_prototype(prototype, run, Silent(), with_report=False)


def killed_after(prototype, run, monkeypatch, parts: int) -> list[str] | None:
    """Run until so many parts were made, and then no further; the names of those, None if the run ended before."""
    names, put, pipe = list[str](), Checkpoints.put, os.pipe()

    def counted(self, name, value):
        put(self, name, value)
        names.append(name)
        os.write(pipe[1], f"{name}\n".encode())
        if len(names) == parts:
            os.kill(os.getpid(), signal.SIGKILL)

    pid = os.fork()
    if pid == 0:
        try:
            monkeypatch.setattr(Checkpoints, "put", counted)
            make(prototype, run)
        finally:
            os._exit(0)
    killed = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) == -signal.SIGKILL
    os.close(pipe[1])
    with os.fdopen(pipe[0]) as said:
        made = said.read().splitlines()
    return made if killed else None


@pytest.mark.long
@pytest.mark.parametrize("kind", SETTINGS)
def test_a_killed_fit_goes_on_to_the_same_result(tmp_path, monkeypatch, kind):
    """Killed after every second part, again and again; what was made once is not made again."""
    prototype, run = prototype_of(tmp_path, kind), tmp_path / "run"
    make(prototype, tmp_path / "whole")
    made = list[str]()
    while parts := killed_after(prototype, run, monkeypatch, 2):
        made += parts
        assert (run / FOLDER).is_dir()
    assert len(made) == len(set(made)) >= FEWEST[kind], made
    assert content(run) == content(tmp_path / "whole")
    assert not (run / FOLDER).exists()
