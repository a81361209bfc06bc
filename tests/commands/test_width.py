"""On a terminal of 80 columns every table fits: no line is longer, no number is cut or broken."""

import io
import sys
import time
import warnings
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import given, settings, strategies as st
from rich.cells import cell_len
from typer.testing import CliRunner

from cli import app
from pipeline.commands import boundary
from pipeline.commands.console import StatusLine, emit_table
from pipeline.errors import warn_user
from tests.diagnostics.first_hour import RUN, write_logs

RUNNER = CliRunner()
pytestmark = pytest.mark.usefixtures("read_once")
_NUMBERS = st.sampled_from(["–", "0.07", "15.02 [2.49, 22.38] ≈", "diverged at t = 5.49 s", "−11.387 mm"])
_WORDS = st.lists(st.sampled_from(["the", "damping", "ratio", "in", "left", "well"]), max_size=12).map(" ".join)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Two logs and a finished run with its report."""
    folder = tmp_path_factory.mktemp("width")
    write_logs(folder)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        patch.setenv("COLUMNS", "80")
        assert RUNNER.invoke(app, [part for part in RUN if part != "--no-report"]).exit_code == 0
        yield folder


_COMMANDS = (
    ("run", "P.toml", "-o", "run", "-q"),
    ("check", "P.toml", "-q", "--details"),
    ("validate", "run", "-q", "--details"),
    ("compare", "run", "-q", "--details"),
    ("show", "run"),
    ("status", "run"),
    ("inspect", "train.csv"),
    ("diff", "run", "run"),
)


@pytest.mark.parametrize("command", _COMMANDS, ids=" ".join)
def test_a_command_fits(command: tuple[str, ...], folder: Path) -> None:
    result = RUNNER.invoke(app, command)
    assert result.exit_code in (0, 6), result.output
    assert max(map(cell_len, result.stdout.splitlines())) <= 80
    assert "…" not in result.stdout.replace(" … ", "")


@settings(max_examples=60, deadline=None)
@given(
    data=st.data(),
    columns=st.integers(2, 9),
    texts=st.integers(1, 3),
    rows=st.integers(1, 3),
)
def test_any_table_fits_and_holds_all_its_numbers(data: st.DataObject, columns: int, texts: int, rows: int) -> None:
    kinds = [_WORDS if k < texts else _NUMBERS for k in range(columns)]
    table = [[data.draw(kind) for kind in kinds] for _ in range(rows)]
    header = ["about" if k < texts else "NRMSE [%]" for k in range(columns)]
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("COLUMNS", "80")
        printed = _printed(header, table, texts)
    assert max(map(cell_len, printed)) <= 80
    for row in table:
        for cell in row[texts:]:
            assert any(cell in line for line in printed)


def _printed(header: list[str], table: list[list[str]], numeric_from: int) -> list[str]:
    import io
    from contextlib import redirect_stdout

    with redirect_stdout(io.StringIO()) as out:
        emit_table("a title", header, table, numeric_from=numeric_from)
    return out.getvalue().splitlines()


class _Terminal(io.TextIOWrapper):
    def isatty(self) -> bool:
        """Appear as a terminal."""
        return True


def test_a_warning_stands_on_a_line_of_its_own_above_the_progress(monkeypatch: pytest.MonkeyPatch) -> None:
    written = io.BytesIO()
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr(sys, "stderr", _Terminal(written, encoding="utf-8", write_through=True))
    monkeypatch.setattr(warnings, "showwarning", boundary._show_warning)
    with warnings.catch_warnings(), StatusLine("ingest a log") as line:
        warnings.simplefilter("always")
        line.show("ingest a log", 0.3)
        time.sleep(0.2)
        warn_user("an artifact was set aside")
    before, warning, behind = written.getvalue().decode().partition("warning: an artifact was set aside")
    assert warning and before.endswith("\x1b[2K") and behind.startswith("\n"), (before[-80:], behind[:40])
