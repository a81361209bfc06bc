"""A killed task goes on from its finished parts, and only from those that were made for the same recipe."""

import os
import signal

import numpy as np
import pytest

from pipeline.runs.checkpoints import FOLDER, Checkpoints
from pipeline.runs.engine import Task, bring_up_to_date
from pipeline.runs.manifest import Recipe
from pipeline.runs.run_folder import RunFolder
from pipeline.tools.verify import verify_everything
from tests.prototypes import Silent

PARTS = [f"part {i}" for i in range(6)]
LOG = "made"


def _task(folder, *, killed_after: int | None = None, setting: int = 1) -> Task:
    """Makes six parts, each of which leaves a line in a file; perhaps it is killed after some of them."""

    def make(names):
        for done, name in enumerate(names):
            if done == killed_after:
                os.kill(os.getpid(), signal.SIGKILL)
            with (folder / LOG).open("a") as log:
                log.write(f"{name}\n")
            yield [name, setting, (1.0 / 3.0).hex()]

    def work(run):
        values = run.checkpoints().each(PARTS, make)
        assert values == [[name, setting, (1.0 / 3.0).hex()] for name in PARTS]
        return {"one.json": run.write_text("one.json", str(values), {})}

    return Task("study", "parts", "1", {"setting": setting}, (), ("one.json",), work)


def _killed(run: RunFolder, task: Task) -> None:
    pid = os.fork()
    if pid == 0:
        try:
            bring_up_to_date(run, [task], Silent())
        finally:
            os._exit(0)
    assert os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) == -signal.SIGKILL


@pytest.fixture
def run(tmp_path) -> RunFolder:
    return RunFolder.create(tmp_path / "run", {}, tmp_path / "P.toml")


def made(tmp_path) -> list[str]:
    return (tmp_path / LOG).read_text().splitlines()


def test_a_killed_task_goes_on(run, tmp_path):
    _killed(run, _task(tmp_path, killed_after=2))
    _killed(run, _task(tmp_path, killed_after=3))
    assert made(tmp_path) == PARTS[:5]
    assert len(verify_everything(run.root).leftover) == 5, "an interrupted run is named as one"
    bring_up_to_date(run, [_task(tmp_path)], Silent())
    assert made(tmp_path) == PARTS
    assert not (run.root / FOLDER).exists(), "what is committed needs no parts"
    assert verify_everything(run.root).intact


def test_parts_of_another_recipe_or_damaged_ones_do_not_count(run, tmp_path):
    _killed(run, _task(tmp_path, killed_after=2))
    for path, content in zip((run.root / FOLDER).rglob("*.json"), ("{", '{"value": [1], "sha256": "0"}'), strict=True):
        path.write_text(content)
    bring_up_to_date(run, [_task(tmp_path)], Silent())
    assert made(tmp_path) == [*PARTS[:2], *PARTS]
    _killed(run, _task(tmp_path, killed_after=4, setting=2))
    bring_up_to_date(run, [_task(tmp_path, setting=3)], Silent())
    assert made(tmp_path) == [*PARTS[:2], *PARTS, *PARTS[:4], *PARTS]
    assert not (run.root / FOLDER).exists()


def test_a_part_counts_for_its_recipe_and_its_name_alone(run):
    """Copied from another run or renamed, it is dropped."""
    one, other = (Checkpoints(run.root, Recipe("s", "1", {"setting": n}, {})) for n in range(2))
    one.put("a", 1)
    for checkpoints, name in ((other, "a"), (one, "b")):
        place = checkpoints._place(name)
        place.parent.mkdir(exist_ok=True)
        place.write_bytes(one._place("a").read_bytes())
        assert checkpoints.get(name) is None
    assert one.get("a") == 1


def test_parts_come_back_to_the_last_bit(run):
    checkpoints = Checkpoints(run.root, Recipe("s", "1", {}, {}))
    array = np.array([[1.0 / 3.0, -0.0, np.nan], [np.inf, 5e-324, 1.7e308]])
    parts = {"arrays": [array, array[0]], "empty": np.zeros((0, 3)), "levels": [(0.3, 4, True)], "spent": 1.0 / 7.0}
    assert checkpoints.keep("a", lambda: parts) is parts
    kept = checkpoints.keep("a", lambda: pytest.fail("made again"))
    assert [found.tobytes() for found in kept["arrays"]] == [array.tobytes(), array[0].tobytes()]
    assert (kept["arrays"][0].shape, kept["empty"].shape) == ((2, 3), (0, 3))
    assert (kept["levels"], kept["spent"]) == ([[0.3, 4, True]], 1.0 / 7.0)


def test_no_link_leads_a_part_or_its_removal_out(run, tmp_path):
    (tmp_path / "victim").mkdir()
    (tmp_path / "victim" / "mine.json").write_text("mine")
    (run.root / FOLDER).symlink_to(tmp_path / "victim")
    from pipeline.errors import InputError

    with pytest.raises(InputError, match="is a symbolic link"):
        Checkpoints(run.root, Recipe("s", "1", {}, {})).put("a", [1])
    run.commit(Recipe("s", "1", {}, {}), {"one.json": run.write_text("one.json", "1", {})})
    assert [path.read_text() for path in (tmp_path / "victim").iterdir()] == ["mine"]
