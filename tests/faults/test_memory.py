"""No more memory at any request, however small: a line and an exit code, nothing is lost, and a rerun mends it."""

import random
import re
import shutil
import signal
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from pipeline.child_processes import died_of
from tests.faults.no_memory import Ended, Process, compiler, process
from tests.faults.small_run import write_prototype
from tests.faults.test_crash import check_whole
from tests.prototypes import content

WORDS = "debist: not enough memory; "
CRASHES = {128 + number: f"debist: {died_of(number)}" for number in (signal.SIGABRT, signal.SIGSEGV, signal.SIGBUS)}
"""Exit codes and lines of the command where a library aborted or crashed its process; its own words stand above."""
NOT_FREED = re.compile(
    r"Traceback \(most recent call last\):\n  File \"h5py/_objects\.pyx\", .*ObjectID\._dealloc\n"
    r"(  File \"h5py/.*\.pyx\", .*\n)*(RuntimeError|MemoryError).*\n(Exception ignored in: 'h5py.*\.__dealloc__'\n)?"
    r"|Exception ignored on building sys\.unraisablehook arguments: .*\nMemoryError(: )?\n|^MemoryError: \n"
    r"|^object address  : .*\n(object .*\n)+lost sys\.stderr\n<unknown>\n",
    re.MULTILINE,
)
"""What h5py and the interpreter themselves say of an object that they could not take down."""
LOADER = (127, "cannot allocate memory for thread-local data: ABORT")
"""Exit code and line of the system's loader, which ends the process without asking anybody."""
needs_compiler = pytest.mark.skipif(compiler() is None, reason="needs a C compiler and the GNU C library")


@dataclass
class Stages:
    """The commands of all stages; of each the run that it finds, the hashes that it leaves, and what it needs."""

    process: Process
    folder: Path
    run: Path
    commands: dict[str, list[str]]
    expected: dict[str, dict[str, str]]
    needs: dict[str, Ended]

    def start(self, stage: str) -> None:
        """Lay out the run as the stage finds it."""
        shutil.rmtree(self.run, ignore_errors=True)
        if (self.folder / stage).exists():
            shutil.copytree(self.folder / stage, self.run)

    def exhaust(self, stage: str, **limits: int) -> Ended:
        """Run the stage where memory ends, and look at what it says and leaves."""
        self.start(stage)
        ended = self.process.run(self.commands[stage], **limits)
        said = NOT_FREED.sub("", ended.said)
        assert "Traceback" not in said, ended.said
        assert (ended.code, said) == (0, "") or _told(ended), ended.said
        check_whole(self.run) if self.run.exists() else None
        again = ended if ended.code == 0 else self.process.run(self.commands[stage])
        assert again.code == 0, again
        assert content(self.run) == self.expected[stage]
        return ended


def _told(ended: Ended) -> bool:
    """Whether the command ended with a line about memory."""
    last = ended.said.splitlines()[-1]
    return (ended.code == 2 and last.startswith(WORDS)) or (ended.code, last) in (LOADER, *CRASHES.items())


@pytest.fixture(scope="module", params=["objects in pools", "each object a request"])
def stages(request, tmp_path_factory) -> Iterator[Stages]:
    """A small run in all its stages, and the process that is copied for each."""
    folder = tmp_path_factory.mktemp("memory")
    prototype, run = write_prototype(folder), folder / "run"
    prototype.write_text(prototype.read_text().replace("models = []", 'models = ["narx"]'))
    commands = {"ingest": ["ingest", str(prototype), "-o", str(run), "--quiet"]}
    names = ("differentiate", "identify", "validate", "compare", "report")
    commands |= {name: [name, str(run), "--quiet"] for name in names}
    small = request.param == "each object a request"
    with process(folder, list(commands.values()), small) as copied:
        made = Stages(copied, folder, run, commands, {}, {})
        copied.run(["--version"])
        shutil.rmtree(run)
        for stage, arguments in commands.items():
            if run.exists():
                shutil.copytree(run, folder / stage)
            made.needs[stage] = copied.run(arguments)
            assert made.needs[stage].code == 0, made.needs[stage]
            made.expected[stage] = content(run)
        yield made


@pytest.mark.long
@needs_compiler
@pytest.mark.parametrize("stage", ["ingest", "differentiate", "identify", "validate", "compare", "report"])
def test_memory_ends_in_a_stage(stages, stage, count):
    """A request is refused, ten in a row, or all that go beyond some share of what the stage needs.

    `differentiate` is with the check of the settings, `validate` and `compare` with the scores.
    """
    rng, need = random.Random(stage), stages.needs[stage]
    ends = Counter[str]()
    for _ in range(4 if stage == "report" else 8):
        number = rng.randint(1, need.asked)
        for limits in (
            {"first": number, "last": number},
            {"first": number, "last": number + 9},
            {"most": int(need.peak * rng.random())},
        ):
            ended = stages.exhaust(stage, **limits)
            ends[{0: "done", 2: "told"}.get(ended.code, "by a library")] += 1
    count.append(f"{stage}: {ends.total()} of {need.asked} requests, " + ", ".join(f"{v} {k}" for k, v in ends.items()))


@needs_compiler
def test_memory_ends_at_a_request(bench, tmp_path, count):
    """The same, briefly, in a process that has imported nothing yet.

    A library may do without a request; then all is done and said as if it had been granted, and later ones are refused.
    """
    command = ["differentiate", str(bench.run), "--quiet"]
    with process(tmp_path, [], small=False) as copied:
        bench.start("changed")
        need, tried = copied.run(command), 0
        for share in (0.2, 0.9):
            told = False
            for number in range(int(share * need.asked), need.asked, 10):
                bench.start("changed")
                ended = copied.run(command, number, number + 9)
                told, tried = _told(ended), tried + 1
                assert "Traceback" not in ended.said, ended
                assert told or (ended.code, ended.said) == (0, need.said), ended
                check_whole(bench.run)
                bench.check_mended()
                if told:
                    break
            assert told, f"no request from {share} on was missed"
    count.append(f"{tried} of {need.asked} requests and the nine after each, 2 told")
