"""Names that would leave the folder, fool a terminal, a page or a table, or reach a shell."""

import ast
from pathlib import Path

import pytest
from typer.testing import CliRunner

import pipeline
from cli import app
from pipeline.errors import InputError
from pipeline.settings.prototype import parse_prototype
from pipeline.store.run_folder import RunFolder

RUNNER = CliRunner()
HOSTILE = [
    "",
    ".",
    "..",
    "../up",
    "/etc/passwd",
    "a/b",
    "a\\b",
    "a\0b",
    "CON",
    "nul.txt",
    "com1",
    "\u202egpj.exe",
    "x" * 65,
    "x" * 300,
    "\x1b[31mred",
    "line\nbreak",
    "<script>alert(1)</script>",
    "=cmd()",
    "+1",
    "@sum",
    " blank",
]
ROWS = "\n".join(f"{i / 100:.2f},{i % 7},{i % 5}" for i in range(400)) + "\n"


def _document(**changes):
    channel = {"channel": "q", "unit": "mm"}
    document = {
        "name": "P",
        "logs": {"train": ["log.csv"]},
        "channels": {"time": {"channel": "t", "unit": "s"}, "q": channel, "v1": {"channel": "u", "unit": "V"}},
    }
    return document | changes


@pytest.mark.parametrize("name", HOSTILE, ids=ascii)
def test_a_prototype_is_not_named_so(name):
    with pytest.raises(InputError, match=r"^P\.toml: .*name"):
        parse_prototype(_document(name=name), "P.toml")


@pytest.mark.parametrize(
    "name", [name for name in HOSTILE if name and len(name) != 65 and not {*"/\\"} & {*name}], ids=ascii
)
def test_a_log_is_not_named_so(name):
    """A folder in front of the log's name is allowed; the run files it by the name alone."""
    with pytest.raises(InputError, match="is no usable name"):
        parse_prototype(_document(logs={"train": [f"{name}.csv"]}), "P.toml")


@pytest.mark.parametrize("name", ["../out.parquet", "a/../../out", "/etc/passwd"])
def test_no_artifact_leaves_the_run(tmp_path, name):
    run = RunFolder.create(tmp_path / "run", {}, tmp_path / "P.toml")
    with pytest.raises(InputError, match="leaves the run folder"):
        run.write_text(name, "x", {})
    assert [path.name for path in tmp_path.iterdir()] == ["run"]


def test_no_shell_no_eval_no_pickle_in_the_sources():
    """What the linter forbids, seen without it: no call that takes a command line, evaluates text or unpickles."""
    forbidden = {"eval", "exec", "system", "popen", "compile"}
    for path in [Path(pipeline.__file__).parent.parent / "cli.py", *Path(pipeline.__file__).parent.rglob("*.py")]:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import | ast.ImportFrom):
                modules = {alias.name for alias in node.names} | {getattr(node, "module", "") or ""}
                assert not modules & {"pickle", "marshal", "shelve", "dill", "joblib", "yaml"}, path
            elif isinstance(node, ast.Call):
                name = getattr(node.func, "id", None) or getattr(node.func, "attr", "")
                owner = getattr(getattr(node.func, "value", None), "id", "")
                harmless = owner in ("re", "platform", "compiler", "kernel", "self")
                assert name not in forbidden or harmless, f"{path}:{node.lineno}"
                assert not any(keyword.arg == "shell" for keyword in node.keywords), f"{path}:{node.lineno}"


@pytest.mark.parametrize("channel", ["<script>alert(1)</script>", "=cmd()", "\x1b[31mred", "$\\frac{1}{$", "\u202eq"])
def test_a_channel_may_be_named_so_and_is_shown_harmlessly(tmp_path, channel):
    (tmp_path / "log.csv").write_text(f"t,{channel},u\n" + ROWS, encoding="utf-8")
    shown = RUNNER.invoke(app, ["inspect", str(tmp_path / "log.csv")])
    assert shown.exit_code == 0, shown.output
    assert "\x1b" not in shown.output and "\u202e" not in shown.output
