"""What users get wrong, and what they are told: the thing, the next step, a few lines, no traceback."""

import os
import re
import shlex
import signal
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import InputError, interrupted, memory_failure
from pipeline.names import shell_word
from tests.prototypes import SMALL, SMALL_CSV

RUNNER = CliRunner()
CSV, TOML = SMALL_CSV, SMALL
ROWS = CSV.partition("\n")[2]
RUN = ["run", "P.toml", "-o", "run", "-q"]


NO_Q = "time;q;u\n" + "".join(f"{i / 100:.2f};;{i % 5}\n" for i in range(400))
COMMAS = "time,q,u\n" + "".join(f"{i // 100},{i % 100:02d},{i % 7},5,{i % 5},0\n" for i in range(400))


def _manifest(text: str):
    def spoil() -> None:
        Path("run").mkdir()
        Path("run/manifest.json").write_text(text)

    return spoil


def _columns_of_two_recordings() -> None:
    from scipy.io import savemat

    savemat("log.csv", {"time": np.arange(400) / 100.0, "q": np.arange(400) % 7, "u": np.arange(395) % 5})


def _foreign_folder() -> None:
    Path("run").mkdir()
    Path("run/thesis.docx").write_text("!")


def _file_in_the_way() -> None:
    Path("run").write_text("a file")


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
    "a word processor's quotes": (RUN, {"P.toml": TOML.replace('"P"', "“P”")}, 2, ['between plain quotes, as "P1"']),
    "a large log for a file": (
        ["run", "log.csv"],
        {"log.csv": CSV * 400},
        2,
        ["log.csv: no settings file", "`debist init"],
    ),
    "a part without a unit": (
        RUN,
        {"P.toml": TOML.replace('"log.csv"', '{ file = "log.csv", stop = 5 }')},
        2,
        ['debist: P.toml: logs.train.0.stop: needs its unit: "5 s"'],
    ),
    "an empty list": (RUN, {"P.toml": TOML.replace('["log.csv"]', "[]")}, 2, ["logs.train: needs at least 1 entry"]),
    "not UTF-8": (RUN, {"P.toml": b'name = "\xff"'}, 2, ["P.toml: not UTF-8; save it as UTF-8"]),
    "unknown key": (RUN, {"P.toml": TOML.replace("train", "trian")}, 2, ["'logs.trian'", "did you mean 'train'?"]),
    "a misspelt channel": (RUN, {"P.toml": TOML.replace("\nq =", "\nqq =")}, 2, ["unknown key 'channels.qq'", "'q'?"]),
    "missing key": (RUN, {"P.toml": TOML.replace('name = "P"', "")}, 2, ["'name' is missing; it is mandatory"]),
    "bad name": (RUN, {"P.toml": TOML.replace('"P"', '"P/1"')}, 2, ["P.toml: name", "P/1"]),
    "out of range": (RUN, {"P.toml": TOML + "[identify]\nsmoothing = -1\n"}, 2, ["identify.smoothing", "(got -1)"]),
    "unknown choice": (RUN, {"P.toml": TOML + '[ingest]\ngaps = "fill"\n'}, 2, ["ingest.gaps", "'split'", "'fill'"]),
    "two logs of one name": (
        RUN,
        {"P.toml": TOML.replace('["log.csv"]', '["log.csv", "b/log.csv"]'), "b/log.csv": CSV},
        2,
        ["logs.train", "two logs are named 'log'"],
    ),
    "no such log": (RUN, {"P.toml": TOML.replace("log.csv", "lag.csv")}, 2, ["lag.csv: no such log", "[logs]"]),
    "a folder as log": (RUN, {"P.toml": TOML.replace("log.csv", "..")}, 2, ["P.toml"]),
    "empty log": (RUN, {"log.csv": ""}, 2, ["log.csv", "the file is empty"]),
    "no log at all": (RUN, {"log.csv": b"\x00\x01\x02" * 500}, 2, ["log.csv", "no text and no format that is known"]),
    "a workbook": (RUN, {"log.csv": b"PK\x03\x04" + b"\0" * 200}, 2, ["log.csv", "truncated or damaged"]),
    "a spoilt row": (RUN, {"log.csv": CSV + "1x;y;z\n"}, 2, ["log.csv", "a row does not fit the table"]),
    "no such channel": (
        RUN,
        {"P.toml": TOML.replace('"q", unit', '"Q", unit')},
        2,
        ["no channel 'Q'", "did you mean 'q'?"],
    ),
    "unknown unit": (RUN, {"P.toml": TOML.replace('"V"', '"Volt!"')}, 2, ["channels.v1.unit", "'Volt!'"]),
    "a unit of something else": (RUN, {"P.toml": TOML.replace('"V"', '"mm"')}, 2, ["channels.v1.unit", "'mm'"]),
    "contradicting units": (
        RUN,
        {"log.csv": CSV.replace("q;", "q [µm];", 1), "P.toml": TOML.replace('"q", unit', '"q [µm]", unit')},
        2,
        ["is in µm by the log, but in mm by the settings", "correct the unit"],
    ),
    "time steps back": (
        RUN,
        {"log.csv": CSV + ROWS},
        3,
        ["log.csv: time steps back at 1 place(s), first after 3.99 s", 'time_reversal = "split"'],
    ),
    "time stands still": (
        RUN,
        {"log.csv": "time;q;u\n" + "".join(f"1;{i % 7};{i % 5}\n" for i in range(99))},
        3,
        ["the time base never advances"],
    ),
    "time only runs back": (
        RUN,
        {"log.csv": "time;q;u\n" + "".join(f"{9 - i / 100:.2f};{i % 7};{i % 5}\n" for i in range(400))},
        3,
        ["log.csv: the time base never advances", "it runs backwards: reverse the rows"],
    ),
    "time in the wrong unit": (
        RUN,
        {"P.toml": TOML.replace('"s"', '"ms"')},
        3,
        ["log.csv: lasts ", " steps of [ingest] sample_interval", "correct the unit of the time"],
    ),
    "a key that a channel does not have": (
        RUN,
        {"P.toml": TOML.replace('unit = "V"', 'unit = "V", gain = 2', 1)},
        2,
        ["unknown key 'channels.v1.gain'; known here: channel, unit, scale, offset"],
    ),
    "a key in another section": (RUN, {"P.toml": TOML + "alpha = 0.01\n"}, 2, ["belongs into [differentiate]"]),
    "a number with its unit": (
        RUN,
        {"P.toml": TOML + '[ingest]\nsample_interval = "10 ms"\n'},
        2,
        ["ingest.sample_interval", "valid number", "'10 ms'"],
    ),
    "no list": (RUN, {"P.toml": TOML.replace('["log.csv"]', '"log.csv"')}, 2, ["logs.train: must be a list"]),
    "a channel without its unit": (
        RUN,
        {"P.toml": TOML.replace('{ channel = "q", unit = "mm" }', '"q"')},
        2,
        ["channels.q: must be a table, as { channel = …, unit = … }"],
    ),
    "a mass without its unit": (
        RUN,
        {"P.toml": TOML + "[plant]\nmass = 0.05\n"},
        2,
        ["plant.mass: must be a table, as { value = …, unit = … }"],
    ),
    "one channel twice": (
        RUN,
        {"P.toml": TOML.replace('"u"', '"q"')},
        2,
        ["channels: v1 and q are the same channel 'q'"],
    ),
    "both inputs from one channel": (
        RUN,
        {
            "P.toml": TOML.replace(
                'v1 = { channel = "u", unit = "V" }',
                'v1 = { channel = "u", unit = "V" }\nv2 = { channel = "u", unit = "V" }',
            )
        },
        2,
        ["channels: v1 and v2 are the same channel 'u'"],
    ),
    "a sample rate that the log's time contradicts": (
        RUN,
        {"P.toml": TOML + "[ingest]\nsample_rate = 123456\n"},
        2,
        ["by its time it has", "sample_rate is 123456 Hz"],
    ),
    "validated on what was trained on": (
        RUN,
        {"P.toml": TOML.replace("[channels]", 'validation = ["log.csv"]\n[channels]')},
        2,
        ["logs.validation: 'log.csv' is a training log too"],
    ),
    "a gate that is none": (
        RUN,
        {"P.toml": TOML + '[quality]\naccept = ["humm"]\n'},
        2,
        ["quality.accept.0: there is no 'humm'; did you mean 'hum'?"],
    ),
    "a gate of the check, misspelt": (
        RUN,
        {"P.toml": TOML + '[quality]\naccept = ["side"]\n'},
        2,
        ["quality.accept.0: there is no 'side'; did you mean 'sides'?"],
    ),
    "a name that turns a line": (RUN, {"P.toml": TOML.replace('"P"', '"P\\n1"')}, 2, ["is no usable name"]),
    "backslashes": (
        RUN,
        {"P.toml": TOML.replace("log.csv", "C:\\data\\log.csv")},
        2,
        ["Unescaped", "write paths with / or between single quotes"],
    ),
    "UTF-16 settings": (RUN, {"P.toml": TOML.encode("utf-16")}, 2, ["P.toml: not UTF-8; save it as UTF-8"]),
    "a log for the settings": (["run", "log.csv"], {}, 2, ["log.csv: no settings file", "`debist init log.csv`"]),
    "a binary log for the settings": (["run", "log.mat"], {"log.mat": b"\xff" * 9}, 2, ["`debist init log.mat`"]),
    "settings for a run": (["status", "P.toml"], {}, 2, ["runs/P: no run here"]),
    "a column without a number": (
        RUN,
        {"log.csv": NO_Q},
        2,
        ["channel 'q' holds no plain numbers, but empty cells only; no sensor"],
    ),
    "thousands": (
        RUN,
        {"log.csv": "time;q;u\n" + "".join(f"{i // 100},{i % 100:02};{i % 7};{1 + i % 3}.000\n" for i in range(400))},
        2,
        ["log.csv: channel 'u' holds no plain numbers, but '1.000'; marks between thousands"],
    ),
    "dates": (
        RUN,
        {"log.csv": "time;q;u\n" + "".join(f"1. Jan 2024 12h{i};{i % 7};1\n" for i in range(400))},
        2,
        ["channel 'time' holds no plain numbers, but '1. Jan 2024 12h0'"],
    ),
    "commas between and within numbers": (RUN, {"log.csv": COMMAS}, 2, ["3 names stand above rows of 6 cells"]),
    "channels of unlike lengths": (
        RUN,
        {"": _columns_of_two_recordings},
        2,
        ["channel 'u' has 395 samples, but its time has 400"],
    ),
    "a web page": (RUN, {"log.csv": "<!DOCTYPE html>\n<html>login</html>\n"}, 2, ["log.csv: this is a web page"]),
    "a pointer": (
        RUN,
        {"log.csv": "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12\n"},
        2,
        ["log.csv: this is a pointer of Git LFS", "`git lfs pull`"],
    ),
    "no such curves": (
        RUN,
        {"P.toml": TOML + '[plant]\nmass = { value = 50, unit = "g" }\ncurves = "F.csv"\n', "f.CSV": ""},
        2,
        ["F.csv: no such log or table; did you mean 'f.CSV'? correct its name"],
    ),
    "no such parameter set": (
        RUN,
        {
            "log.csv": "time;q;u;w\n" + "".join(f"{i / 100:.2f};{i % 7};{i % 5};{i % 3}\n" for i in range(400)),
            "P.toml": TOML + 'v2 = { channel = "w", unit = "V" }\n[plant]\nparameters = "nominel"\n',
        },
        2,
        ["'nominel'", "'nominal'"],
    ),
    "no run there": (["status", "nowhere"], {}, 2, ["nowhere: no run here", "makes one"]),
    "a folder of runs": (
        ["show", "runs"],
        {"runs/P1/manifest.json": "{}"},
        2,
        ["runs: no run here", "such as runs/P1"],
    ),
    "a decimal comma in an option": (
        ["physics", "equilibria", "--set", "E=1,7 GPa"],
        {},
        2,
        ["has a comma; numbers have a decimal point, as '1.7 GPa'"],
    ),
    "a foreign folder": (
        RUN,
        {"": _foreign_folder},
        2,
        ["run: holds files but no run", "choose an empty or a new folder"],
    ),
    "a file in the way": (RUN, {"": _file_in_the_way}, 2, ["run: is no folder", "choose another with -o"]),
    "a damaged manifest": (["verify", "run"], {"": _manifest("{")}, 4, ["manifest.json: damaged", "restore it"]),
    "a foreign manifest": (["verify", "run"], {"": _manifest("{}")}, 4, ["manifest.json: is no debist-run"]),
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


@pytest.mark.parametrize(
    "command", [["rnu"], ["run"], ["run", "--jobs", "x"], ["batch", "a", "-o", "b", "--jobs", "0"]]
)
def test_a_mistake_on_the_command_line_is_told_by_the_parser(command):
    result = RUNNER.invoke(app, command)
    assert result.exit_code == 2
    assert "Traceback" not in result.output and len(result.stderr.splitlines()) < 8


def test_a_bug_of_ours_is_a_traceback_and_exit_code_1(tmp_path, monkeypatch):
    def fail(*_: object, **__: object) -> None:
        raise ZeroDivisionError("planted")

    monkeypatch.setattr("pipeline.stages.run.run_status", fail)
    result = RUNNER.invoke(app, ["status", str(tmp_path)])
    assert result.exit_code == 1
    lines = result.stderr.splitlines()
    assert any("ZeroDivisionError: planted" in line for line in lines)
    assert lines[-1] == "debist: this is a bug in debist; please report the lines above"


def test_where_no_kernel_can_be_kept_it_says_what_to_set(tmp_path, monkeypatch):
    """Numba itself raises it, left without any place such as its cache takes."""

    def fail(*_: object, **__: object) -> None:
        import numba

        monkeypatch.setattr("numba.core.caching.CacheImpl._locator_classes", [])
        numba.njit(cache=True)(lambda x: x)

    monkeypatch.setattr("pipeline.stages.run.run_status", fail)
    result = RUNNER.invoke(app, ["status", str(tmp_path)])
    assert result.exit_code == 2
    assert "set NUMBA_CACHE_DIR to one that can be written" in result.stderr and "Traceback" not in result.stderr


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_a_log_without_permission(tmp_path):
    (tmp_path / "log.csv").write_text(CSV)
    (tmp_path / "log.csv").chmod(0)
    result = RUNNER.invoke(app, ["inspect", str(tmp_path / "log.csv")])
    assert (result.exit_code, "no permission" in result.stderr) == (2, True)


def test_settings_may_begin_with_a_byte_order_mark(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("P.toml").write_bytes(b"\xef\xbb\xbf" + TOML.encode())
    result = RUNNER.invoke(app, RUN)
    assert result.exit_code == 2 and "log.csv: no such log" in result.stderr


def test_a_digest_that_openssl_has_no_memory_for_is_told_as_such():
    assert memory_failure(ValueError("[digital envelope routines] initialization error"))
    assert not memory_failure(ValueError("[digital envelope routines] unsupported"))


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


@pytest.mark.parametrize(
    "error",
    [
        RuntimeError("no compiled object yet for <Library>"),
        SystemError("returned a result with an exception set"),
        InputError("log: cannot be read"),
    ],
)
def test_what_fails_after_an_interrupt_is_told_as_one(error: Exception, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr("pipeline.tools.inspection.inspect", fail)
    before = RUNNER.invoke(app, ["inspect", __file__])
    monkeypatch.setattr("pipeline.commands.boundary._signals", [signal.SIGINT])
    after = RUNNER.invoke(app, ["inspect", __file__])
    assert before.exit_code != 130 and "interrupted" not in before.stderr
    assert after.exit_code == 130 and "debist: interrupted" in after.stderr


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


def test_paths_in_commands_of_messages_are_quoted_everywhere() -> None:
    """A name of a command, study or stage needs no quotes."""
    bare = re.compile(r"debist [^`\"\n]*?\{(?!shell_word\()[\w.]*\b(?:root|path|folder|log|output|run|prototype)\}")
    sources = Path(__file__).parents[1].joinpath("pipeline").rglob("*.py")
    assert not [
        f"{path}: {line}" for path in sources for line in path.read_text("utf-8").split("\n") if bare.search(line)
    ]
