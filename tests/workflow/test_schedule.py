"""Tasks side by side in processes give the results, the events and the error of tasks done one after the other."""

import time
from collections.abc import Mapping
from functools import partial
from pathlib import Path

import pytest

from pipeline.errors import InputError, SeveralMistakesError
from pipeline.store.run_folder import RunFolder, Written
from pipeline.workflow.engine import After, Task, bring_up_to_date
from tests.prototypes import Silent


class Events(Silent):
    """Keeps every event but progress, which only a task that is waited for shows."""

    def __init__(self) -> None:
        self.seen: list[tuple[str, str]] = []

    def started(self, task, reasons):
        self.seen.append(("started", task.title))

    def finished(self, task, seconds):
        self.seen.append(("finished", task.title))

    def skipped(self, task):
        self.seen.append(("skipped", task.title))

    def warned(self, what, warning):
        self.seen.append((warning, what))


def _write(run: RunFolder, name: str, inputs: tuple[str, ...], seconds: float) -> Mapping[str, Written]:
    """The texts of the inputs and a name, after a while."""
    time.sleep(seconds)
    text = "".join(run.checked(given).read_text() for given in inputs) + name
    return {name: run.write_text(name, text, {"warnings": [f"about {name}"]})}


def _fail(run: RunFolder, seconds: float, text: str) -> Mapping[str, Written]:
    time.sleep(seconds)
    raise SeveralMistakesError(text, ["one", "two"])


def _task(name: str, *inputs: str, seconds: float = 0.0) -> Task:
    return Task("stage", name, "1", {}, inputs, (name,), partial(_write, name=name, inputs=inputs, seconds=seconds))


def _folder(root: Path) -> RunFolder:
    return RunFolder.create(root, {}, root / "P.toml")


def _decided(run: RunFolder):
    """A plan whose end is known after its third task; the first tasks take longer than those behind them."""
    yield _task("a", seconds=0.2)
    yield _task("b")
    yield _task("c", "a", seconds=0.1)
    yield _task("d", "b")
    yield After("c")
    yield _task(run.checked("c").read_text(), "c", "d")


def test_results_and_events_are_those_of_one_process(tmp_path):
    seen, made = [], []
    for jobs in (1, 3):
        run, events = _folder(tmp_path / str(jobs)), Events()
        statuses = bring_up_to_date(run, _decided(run), events, jobs=jobs)
        again = Events()
        bring_up_to_date(run, _decided(run), again, jobs=jobs)
        assert {what for what, _ in again.seen} == {"skipped"}
        seen.append((events.seen, again.seen, statuses))
        made.append({name: run.checked(name).read_text() for name in ("a", "b", "c", "d", "ac")})
    assert seen[0] == seen[1]
    assert made[0] == made[1] == {"a": "a", "b": "b", "c": "ac", "d": "bd", "ac": "acbdac"}


def test_the_first_error_of_the_plan_is_raised_and_earlier_tasks_are_kept(tmp_path):
    for jobs in (1, 3):
        run = _folder(tmp_path / str(jobs))
        slow = Task("stage", "slow", "1", {}, (), ("x",), partial(_fail, seconds=0.3, text="first"))
        fast = Task("stage", "fast", "1", {}, (), ("y",), partial(_fail, seconds=0.0, text="second"))
        with pytest.raises(InputError, match=r"first: 2 mistakes: \(1\) one") as raised:
            bring_up_to_date(run, [_task("a"), slow, fast, _task("b", "a")], Silent(), jobs=jobs)
        assert raised.value.lines == ("first: 2 mistakes", "one", "two")
        assert "a" in run.manifest.artifacts
        assert not {"x", "y"} & run.manifest.artifacts.keys()
        assert not list(run.root.glob(".*staged*"))
