"""Commands end with the exit code that they mean, however loaded the machine: nothing aborts at the end."""

import shutil
import subprocess
import threading
from collections import Counter
from pathlib import Path

import pyarrow as pa
import pytest
from pyarrow import csv, parquet

from pipeline.batch.worker import Workers
from pipeline.child_processes import isolated
from pipeline.rig_logs.csv import CsvSource
from pipeline.rig_logs.source import CsvOptions
from pipeline.runs import tables
from pipeline.stages.run import run_prototype
from tests.prototypes import Silent

_DEBIST = "from cli import app; app()"
_WORKER = "import os; from pipeline.child_processes import end_with; end_with(os.getppid()); " + _DEBIST
_READER = """
from pathlib import Path
from pipeline.rig_logs import guarded
run_child, codes = guarded._run_child, []
def counted(*arguments):
    done = run_child(*arguments)
    codes.append(done.returncode)
    return done
guarded._run_child = counted
guarded.read_recording(Path(sys.argv[1]))
sys.exit(max(map(abs, codes)))
"""
KINDS = {
    "run": (_DEBIST, "run {prototype} -o {run} --quiet --json {report}"),
    "worker": (_WORKER, "run {prototype} -o {run} --quiet --json {report}"),
    "verify": (_DEBIST, "verify {run}"),
    "reader": (_READER, "{log}"),
    "copied": ("", ""),
    "fresh": ("", ""),
}
"""Programs and arguments; `copied` workers of a batch are forked from a process that is warm, `fresh` make a run."""


def ends(bench, folder: Path, wanted: int, at_a_time: int) -> Counter[tuple[str, int | None]]:
    """How often each kind of start ended with which code, with so many under way at a time."""
    bench.start("fresh")
    run_prototype(bench.prototype, bench.run, Silent())  # without figures for a paper, which `bench` draws in part
    waiting = [kind for _ in range(wanted) for kind in KINDS][:wanted]
    report = "--report" if wanted > len(KINDS) else "--no-report"  # the first start in a folder draws its figures
    ended: Counter[tuple[str, int | None]] = Counter()

    def work(run: Path) -> None:
        shutil.copytree(bench.run, run)
        log = bench.prototype.with_name("train.csv")
        while waiting:
            kind = waiting.pop()
            if kind in ("copied", "fresh"):
                name = run.name if kind == "copied" else f"fresh-{len(waiting)}"
                outcome = workers.run(name, bench.prototype, folder, ["--no-report" if kind == "fresh" else report])
                ended[kind, outcome.exit_code if not outcome.reason else -1] += 1
                continue
            program, arguments = KINDS[kind]
            named = {"prototype": bench.prototype, "run": run, "log": log, "report": report}
            told = [part.format(**named) for part in arguments.split()]
            with subprocess.Popen(
                [*isolated(program), *told], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
            ) as child:
                ended[kind, child.wait()] += 1

    threads = [threading.Thread(target=work, args=(folder / f"run-{i}",)) for i in range(at_a_time)]
    with Workers("cli:app", warm=wanted > len(KINDS)) as workers:
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    return ended


@pytest.mark.parametrize("wanted", [len(KINDS), pytest.param(1000, marks=pytest.mark.long)])
def test_every_start_ends_with_zero(bench, tmp_path, wanted, count):
    """Up-to-date runs, workers of a batch, `verify`, readers of logs: four at a time whatever the number of cores."""
    ended = ends(bench, tmp_path, wanted, at_a_time=4)
    assert {code for _, code in ended} == {0}, ended
    assert ended.total() == wanted
    count.append(", ".join(f"{kind} {number}" for (kind, _), number in sorted(ended.items())))


def _is_arrows_own(source: object) -> bool:
    return isinstance(source, pa.NativeFile) and not isinstance(source, pa.PythonFile | pa.lib.TransformInputStream)


def test_arrow_reads_no_table_through_a_file_of_pythons(bench, monkeypatch):
    """Its threads would let go of Python's memory when the interpreter is gone, which aborts the process."""
    bench.start("intact")
    seen, opened = [], parquet.ParquetFile
    monkeypatch.setattr(
        parquet, "ParquetFile", lambda source, **options: seen.append(source) or opened(source, **options)
    )
    tables.read_table(bench.run / "scores.parquet")
    assert seen and all(map(_is_arrows_own, seen)), seen


@pytest.mark.parametrize("encoding", ["utf-8", "latin-1", "utf-16"])
def test_arrow_reads_no_csv_through_a_file_of_pythons(tmp_path, monkeypatch, encoding):
    path = tmp_path / "log.csv"
    rows = "".join(f"{i};{i % 7},25\n" for i in range(2000))
    path.write_text("Zeit;Weg [µm]\n" + rows, encoding=encoding)
    seen, opened = [], csv.open_csv
    options = {}

    def spy(source, **given):
        seen.append(source)
        options.update(given)
        return opened(source, **given)

    monkeypatch.setattr(csv, "open_csv", spy)
    source = CsvSource(path, CsvOptions())
    q = [sample for name, samples in source.parts(["Weg"]) for sample in samples]
    assert q == [i % 7 + 0.25 for i in range(2000)]
    assert seen and all(map(_is_arrows_own, seen)), seen
    assert options["read_options"].encoding == "utf8", "Arrow would have Python's codec called from its threads"
