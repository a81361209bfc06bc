"""A batch by a table: a settings file for each row, with logs where the table lies."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import InputError
from pipeline.settings.prototype import load_prototype
from pipeline.workflow.members import members, prototype_files
from tests.prototypes import SMALL
from tests.rig_logs.small_logs import workbook

RUNNER = CliRunner()

ROWS = [
    ["name", "train", "logs.validation", "differentiate.alpha", "channels.q.scale", "note"],
    ["A", "a.csv", "", "", "", ""],
    ["Prüfling 2", "b 1.csv; b 2.csv", "sub/v.csv", "0.01", "1000", ""],
]


def _table(folder: Path, rows: list[list[str]], name: str = "fleet.csv", separator: str = ",") -> Path:
    path = folder / name
    if path.suffix == ".xlsx":
        pytest.importorskip("python_calamine")
        workbook(path, [[float(cell) if cell[:1].isdigit() else cell for cell in row] for row in rows])
    else:
        path.write_text("\n".join(separator.join(row) for row in rows), encoding="utf-8-sig")
    return path


@pytest.mark.parametrize(("name", "separator"), [("fleet.csv", ","), ("fleet.tsv", "\t"), ("fleet.xlsx", "")])
def test_each_row_is_a_prototype_that_differs_from_the_base(tmp_path: Path, name: str, separator: str) -> None:
    (tmp_path / "fleet.toml").write_text(SMALL)
    table = _table(tmp_path, ROWS, name, separator)
    first, second = members(prototype_files([table], tmp_path / "runs"))
    assert (first.name, second.name) == ("A", "Pruefling-2")
    assert first.logs == (tmp_path / "a.csv",)
    assert second.logs == (tmp_path / "b 1.csv", tmp_path / "b 2.csv", tmp_path / "sub/v.csv")
    base = load_prototype(tmp_path / "fleet.toml")
    read = load_prototype(second.settings)
    assert (read.differentiate.alpha, read.channels.q.scale) == (0.01, 1000.0)
    assert read.channels.v1 == base.channels.v1
    assert load_prototype(first.settings).differentiate.alpha == base.differentiate.alpha


def test_parts_of_logs_and_semicolons_between_columns_are_read(tmp_path: Path) -> None:
    (tmp_path / "base.toml").write_text(SMALL)
    part = '"{ file = ""long.csv"", start = ""1 s"", stop = ""2 s"" }"'
    table = _table(tmp_path, [["name", "logs.train"], ["A", part], ["B", '"a.csv; b.csv"']], separator=";")
    one, two = members(prototype_files([table], tmp_path / "runs"))
    assert one.logs == (tmp_path / "long.csv",) and load_prototype(one.settings).logs.train[0].start == "1 s"
    assert two.logs == (tmp_path / "a.csv", tmp_path / "b.csv")


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ([["name", "train"], ["A", "a.csv"], ["a", "b.csv"]], "row 3: is named 'a' as row 2"),
        ([["name", "train"], ["", "a.csv"]], "row 2: has no name"),
        ([["prototype", "train"], ["A", "a.csv"]], "no heading 'name'"),
        ([["name", "train", "logs.train"], ["A", "a", "b"]], "'logs.train' twice"),
        ([["name", "train"]], "no rows"),
        ([["name", "name.x"], ["A", "1"]], "'name' is no section"),
    ],
)
def test_a_mistake_of_the_table_is_named_with_its_row(tmp_path: Path, rows: list[list[str]], said: str) -> None:
    (tmp_path / "fleet.toml").write_text(SMALL)
    with pytest.raises(InputError, match=said):
        prototype_files([_table(tmp_path, rows)], tmp_path / "runs")


def test_a_table_without_a_base_names_where_one_goes(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"fleet\.toml beside it, or name it with --base"):
        prototype_files([_table(tmp_path, ROWS)], tmp_path / "runs")


def test_a_row_with_another_mistake_is_listed_and_fails_alone(tmp_path: Path) -> None:
    (tmp_path / "fleet.toml").write_text(SMALL)
    rows = [["name", "train", "identify.model"], ["A", "a.csv", ""], ["B", "b.csv", "rbf"]]
    table = _table(tmp_path, rows)
    arguments = ["batch", str(table), "-o", str(tmp_path / "runs"), "--list"]
    listed = json.loads(RUNNER.invoke(app, [*arguments, "--json"]).stdout)["prototypes"]
    assert [(each["name"], "did you mean 'models'" in each["error"]) for each in listed] == [("A", False), ("B", True)]
    assert listed[0]["logs"] == [str(tmp_path / "a.csv")]
    assert "did you mean" in RUNNER.invoke(app, arguments).stdout
