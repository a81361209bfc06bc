"""The reference pages are written from the code: `python -m tests.test_reference` renews them."""

import json
import types
import typing
from pathlib import Path

import pytest
from pydantic import BaseModel
from pydantic_core import PydanticUndefined
from typer.main import get_command
from typer.testing import CliRunner

from cli import app
from pipeline.settings import Prototype, Quantity
from pipeline.settings_logs import Channel, Channels

DOCS = Path(__file__).resolve().parents[1] / "docs" / "reference"


def _settings_page() -> str:
    lines = [
        "# Settings",
        "",
        "One TOML file per prototype; a key with the default – may be left out and is then not set. Written from",
        "`pipeline/settings.py` by `python -m tests.test_reference`.",
    ]
    for heading, model in _sections(Prototype, ""):
        lines += ["", f"## {heading or 'Top level'}", "", (model.__doc__ or "").strip(), ""]
        lines += _table(model)
        if model is Channels:
            lines += ["", f"What stands in {_type(Channel)}; a time takes the first five keys:", "", *_table(Channel)]
    return "\n".join(lines) + "\n"


def _table(model: type[BaseModel]) -> list[str]:
    lines = ["| key | type | default | meaning |", "|---|---|---|---|"]
    for name, field in model.model_fields.items():
        if not _is_section(field.annotation):
            default = "mandatory" if field.default is PydanticUndefined else _toml(field.default)
            meaning = " ".join((field.description or "").split())
            lines.append(f"| `{name}` | {_type(field.annotation)} | {default} | {meaning} |")
    return lines


def _toml(default: typing.Any) -> str:
    """A value as a settings file says it; JSON and TOML write those that there are alike."""
    if isinstance(default, Quantity):
        return f'`{{ value = {default.value:g}, unit = "{default.unit}" }}`'
    return "–" if default is None else f"`{json.dumps(default)}`"


def _sections(model: type[BaseModel], path: str) -> list[tuple[str, type[BaseModel]]]:
    found = [(f"[{path}]" if path else "", model)]
    for name, field in model.model_fields.items():
        if _is_section(field.annotation):
            found += _sections(field.annotation, f"{path}.{name}" if path else name)
    return found


def _is_section(annotation: typing.Any) -> bool:
    inline = {"Channel", "LogColumn", "LogPart", "Gains", "Quantity"}
    return isinstance(annotation, type) and issubclass(annotation, BaseModel) and annotation.__name__ not in inline


def _type(annotation: typing.Any) -> str:
    origin = typing.get_origin(annotation)
    if origin in (typing.Union, types.UnionType):
        return " or ".join(_type(a) for a in typing.get_args(annotation) if a is not type(None))
    if origin is typing.Literal:
        return ", ".join(map(_toml, typing.get_args(annotation)))
    if origin is tuple:
        return f"list of {_type(typing.get_args(annotation)[0])}"
    if origin is typing.Annotated:
        return _type(typing.get_args(annotation)[0])
    inline = {**dict.fromkeys(("Channel", "LogColumn"), "`{ channel, unit }`"), "Quantity": "`{ value, unit }`"}
    inline["LogPart"] = "`{ file, start, stop, gain, zero, delay, clock }`"
    return (inline | {"str": "text", "float": "number", "int": "integer", "bool": "boolean"})[annotation.__name__]


_SIGNALS = """
Ctrl-C and SIGTERM end a command with one line; what is written is whole."""


def _commands_page() -> str:
    lines = ["# Commands", "", "What `--help` says; written by `python -m tests.test_reference`.", "", app.info.epilog]
    lines.append(_SIGNALS)
    for path in _walk(get_command(app), []):
        shown = CliRunner().invoke(app, [*path, "--help"], env={"COLUMNS": "100", "TERMINAL_WIDTH": "100"}).output
        lines += ["", f"## debist {' '.join(path)}", "", "```text", shown.strip(), "```"]
    return "\n".join(lines) + "\n"


def _walk(group: typing.Any, path: list[str]) -> list[list[str]]:
    found = []
    for name, command in getattr(group, "commands", {}).items():
        found += _walk(command, [*path, name]) if hasattr(command, "commands") else [[*path, name]]
    return found


PAGES = {"settings.md": _settings_page, "commands.md": _commands_page}


@pytest.mark.parametrize("name", PAGES)
def test_the_page_is_what_the_code_says(name: str) -> None:
    assert (DOCS / name).read_text(encoding="utf-8") == PAGES[name](), "renew it: python -m tests.test_reference"


if __name__ == "__main__":
    for page, write in PAGES.items():
        (DOCS / page).write_text(write(), encoding="utf-8")
