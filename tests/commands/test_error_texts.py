"""What users get wrong, and what they are told: the thing, the next step, a few lines, no traceback."""

import os
import re
import shlex
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import interrupted, memory_failure
from pipeline.system.names import shell_word
from tests.prototypes import SMALL, SMALL_CSV

RUNNER = CliRunner()
CSV, TOML = SMALL_CSV, SMALL
ROWS = CSV.partition("\n")[2]
RUN = ["run", "P.toml", "-o", "run", "-q"]


def _manifest(text: str):
    def spoil() -> None:
        Path("run").mkdir()
        Path("run/manifest.json").write_text(text)

    return spoil


def _foreign_folder() -> None:
    Path("run").mkdir()
    Path("run/thesis.docx").write_text("!")


MISTAKES = {
    "no settings file": (["run", "Q.toml"], {}, 2, ["Q.toml: no such file", "`debist init LOG` writes one"]),
    "a folder for a file": (["run", "."], {}, 2, [".: is a folder; name a settings file"]),
    "no TOML": (RUN, {"P.toml": "name = = 1"}, 2, ["P.toml: not valid TOML", "line 1"]),
    "a decimal comma": (
        RUN,
        {"P.toml": TOML + "[plant]\nmass = { value = 40,5, unit = 'g' }\n"},
        2,
        ["P.toml: not valid TOML", "a decimal point, as 40.5"],
    ),
    "no quotes": (RUN, {"P.toml": TOML.replace('"P"', "P")}, 2, ['text stands between quotes, as "P1"']),
    "not UTF-8": (RUN, {"P.toml": b'name = "\xff"'}, 2, ["P.toml: not UTF-8; save it as UTF-8"]),
    "unknown key": (RUN, {"P.toml": TOML.replace("train", "trian")}, 2, ["'logs.trian'", "did you mean 'train'?"]),
    "no such log": (RUN, {"P.toml": TOML.replace("log.csv", "lag.csv")}, 2, ["lag.csv: no such log", "[logs]"]),
    "empty log": (RUN, {"log.csv": ""}, 2, ["log.csv", "the file is empty"]),
    "no log at all": (RUN, {"log.csv": b"\x00\x01\x02" * 500}, 2, ["log.csv", "no text and no format that is known"]),
    "a spoilt row": (RUN, {"log.csv": CSV + "1x;y;z\n"}, 2, ["log.csv", "a row does not fit the table"]),
    "no such channel": (
        RUN,
        {"P.toml": TOML.replace('"q", unit', '"Q", unit')},
        2,
        ["no channel 'Q'", "did you mean 'q'?"],
    ),
    "time steps back": (
        RUN,
        {"log.csv": CSV + ROWS},
        3,
        ["log.csv: time steps back at 1 place(s), first after 3.99 s", 'time_reversal = "split"'],
    ),
    "time in the wrong unit": (
        RUN,
        {"P.toml": TOML.replace('"s"', '"ms"')},
        3,
        ["log.csv: lasts ", " steps of [ingest] sample_interval", "correct the unit of the time"],
    ),
    "one channel twice": (
        RUN,
        {"P.toml": TOML.replace('"u"', '"q"')},
        2,
        ["channels: v1 and q are the same channel 'q'"],
    ),
    "validated on what was trained on": (
        RUN,
        {"P.toml": TOML.replace("[channels]", 'validation = ["log.csv"]\n[channels]')},
        2,
        ["logs.validation: 'log.csv' is a training log too"],
    ),
    "backslashes": (
        RUN,
        {"P.toml": TOML.replace("log.csv", "C:\\data\\log.csv")},
        2,
        ["Unescaped", "write paths with / or between single quotes"],
    ),
    "a log for the settings": (["run", "log.csv"], {}, 2, ["log.csv: no settings file", "`debist init log.csv`"]),
    "settings for a run": (["status", "P.toml"], {}, 2, ["runs/P: no run here"]),
    "no run there": (["status", "nowhere"], {}, 2, ["nowhere: no run here", "makes one"]),
    "a foreign folder": (
        RUN,
        {"": _foreign_folder},
        2,
        ["run: holds files but no run", "choose an empty or a new folder"],
    ),
    "a damaged manifest": (["verify", "run"], {"": _manifest("{")}, 4, ["manifest.json: damaged", "restore it"]),
    "inspect what is not there": (["inspect", "gone.mat"], {}, 2, ["gone.mat: cannot be read (No such file"]),
    "an empty fleet": (["batch", "b", "-o", "out"], {"b/readme.txt": "x"}, 2, ["b: holds no settings file (*.toml)"]),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_told_in_a_line_with_the_next_step(tmp_path, monkeypatch, mistake):
    command, files, code, words = MISTAKES[mistake]
    monkeypatch.chdir(tmp_path)
    for name, content in ({"P.toml": TOML, "log.csv": CSV} | files).items():
        if callable(content):
            content()
            continue
        Path(name).parent.mkdir(parents=True, exist_ok=True)
        Path(name).write_bytes(content if isinstance(content, bytes) else content.encode())
    result = RUNNER.invoke(app, command)
    assert result.exit_code == code, result.output
    assert "Traceback" not in result.output
    told = [line for line in result.stderr.splitlines() if not line.startswith("warning: ")]
    assert len(told) == 1 and told[0].startswith("debist: ") and len(told[0]) < 600
    for word in words:
        assert word in told[0]


def test_a_folder_of_others_stays_as_it_is(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("P.toml").write_text(TOML)
    Path("log.csv").write_text(CSV)
    assert RUNNER.invoke(app, ["run", "P.toml", "-o", "."]).exit_code == 2
    assert sorted(path.name for path in Path().iterdir()) == ["P.toml", "log.csv"]


def test_a_bug_of_ours_is_a_traceback_and_exit_code_1(tmp_path, monkeypatch):
    def fail(*_: object, **__: object) -> None:
        raise ZeroDivisionError("planted")

    monkeypatch.setattr("pipeline.workflow.run.run_status", fail)
    result = RUNNER.invoke(app, ["status", str(tmp_path)])
    assert result.exit_code == 1
    lines = result.stderr.splitlines()
    assert any("ZeroDivisionError: planted" in line for line in lines)
    assert lines[-1] == "debist: this is a bug in debist; please report the lines above"


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_a_log_without_permission(tmp_path):
    (tmp_path / "log.csv").write_text(CSV)
    (tmp_path / "log.csv").chmod(0)
    result = RUNNER.invoke(app, ["inspect", str(tmp_path / "log.csv")])
    assert (result.exit_code, "no permission" in result.stderr) == (2, True)


def _raised(first: BaseException, then: BaseException) -> BaseException:
    """The second error, raised while the first was handled."""
    try:
        try:
            raise first
        except BaseException:
            raise then  # noqa: B904
    except BaseException as last:
        return last


def test_an_interrupt_that_compiled_code_turned_into_another_error_is_no_lack_of_memory() -> None:
    said = SystemError("<built-in function march> returned a result with an exception set")
    assert memory_failure(said)
    assert not memory_failure(_raised(KeyboardInterrupt(), said))
    assert interrupted(_raised(KeyboardInterrupt(), said))
    assert memory_failure(_raised(MemoryError(), ValueError("x")))


def test_a_library_that_does_not_fit_into_memory_is_a_lack_of_memory() -> None:
    assert memory_failure(ImportError("x.so: failed to map segment from shared object"))
    assert not memory_failure(ImportError("No module named 'x'"))


def test_commands_in_messages_can_be_typed_whatever_the_path_is_called(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "run of Ann's joint"
    folder.mkdir()
    (folder / "log.toml").write_text(TOML)
    for arguments in (["show", folder], ["inspect", folder / "log.toml"], ["verify", folder]):
        result = RUNNER.invoke(app, [*map(str, arguments)])
        words = [shlex.split(typed) for typed in re.findall(r"`(debist [^`]*)`", result.stderr)]
        assert any(f"{folder}" in word for typed in words for word in typed), result.stderr
    assert shell_word("runs/P1") == "runs/P1"
    monkeypatch.setattr("os.name", "nt")
    assert [shell_word(r"C:\runs\P1"), shell_word(r"C:\my runs")] == [r"C:\runs\P1", r'"C:\my runs"']
