"""A run that is stopped after each of its steps ends in the same artifacts as one that is not, its report included."""

import pytest

from pipeline.workflow.engine import Task
from pipeline.workflow.run import run_prototype
from tests.faults.small_run import write_prototype
from tests.prototypes import Silent, content


class StoppedAfter(Silent):
    """Interrupts the run when so many steps are done."""

    def __init__(self, steps: int) -> None:
        self.left, self.done = steps, list[str]()

    def finished(self, task: Task, seconds: float) -> None:
        self.done.append(f"{task.stage} {task.title}")
        self.left -= 1
        if not self.left:
            raise KeyboardInterrupt


@pytest.mark.parametrize(
    ("steps", "models"), [(8, '["narx"]'), pytest.param(1, '["sindy", "narx"]', marks=pytest.mark.long)]
)
def test_an_interrupted_run_has_the_report_of_one_that_was_not(tmp_path, steps, models):
    """Each time it goes on it knows the steps before from the disk alone, and must read them as it made them."""
    prototype = write_prototype(tmp_path)
    prototype.write_text(prototype.read_text().replace("models = []", f"models = {models}"))
    whole = StoppedAfter(0)
    run_prototype(prototype, tmp_path / "whole", whole)
    done = list[str]()
    while True:
        part = StoppedAfter(steps)
        try:
            run_prototype(prototype, tmp_path / "run", part)
            break
        except KeyboardInterrupt:
            done += part.done
    assert done + part.done == whole.done
    assert content(tmp_path / "run") == content(tmp_path / "whole")
    page, expected = ((tmp_path / name / "report.html").read_text() for name in ("run", "whole"))
    assert page == expected
