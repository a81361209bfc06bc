"""Pages that are made from the code while the site is built, and stand nowhere else: `mkdocs.yml` names this file."""

import dataclasses
import json
import sys
import types
import typing
from pathlib import Path

from mkdocs.structure.files import File
from pydantic import BaseModel
from pydantic_core import PydanticUndefined
from typer.main import get_command
from typer.testing import CliRunner

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from cli import app
from pipeline.device.device import JOINT
from pipeline.settings.logs import Channel, Channels
from pipeline.settings.prototype import Prototype, Quantity
from pipeline.store import schemas
from pipeline.store.columns import FACT_COLUMNS, SCHEMA_VERSION
from pipeline.units.units import SiUnit


def on_files(files: typing.Any, config: typing.Any) -> typing.Any:
    """Add the pages to those of the site."""
    for name, write in PAGES.items():
        files.append(File.generated(config, f"reference/{name}", content=write()))
    return files


def settings_page() -> str:
    """Every key of the settings, table by table."""
    lines = [
        "# Settings",
        "",
        "One TOML file per prototype; a key with the default – may be left out and is then not set.",
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


def commands_page() -> str:
    """The help of every command."""
    lines = ["# Commands", "", "What `--help` prints.", "", app.info.epilog]
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


def mistakes_page() -> str:
    """The table of mistakes, each of which is made and answered for it."""
    from tests.mistakes.table import page

    return page()


def tables() -> list[schemas.Schema]:
    """The columns of every Parquet file, for a joint in m with two voltages."""
    every = [value for value in vars(schemas).values() if isinstance(value, schemas.Schema)]
    measured = dataclasses.replace(JOINT, velocity=SiUnit(1.0, "m/s"))
    return [schemas.schema_of(schema, measured, phi=True, tubes=True) for schema in (*every, *schemas.STUDIES.values())]


def columns_page() -> str:
    """Columns of every Parquet file, and the facts of `datasheet.json`."""
    lines = [
        f"# Columns (schema version {SCHEMA_VERSION})",
        "",
        "Types and units of the Parquet files; each file carries unit and meaning as metadata of its columns. For a "
        "device that turns, `q` is in rad. A device with one input has no `v2`. `phi` needs a parameter set, "
        "`velocity` a channel `qdot`.",
    ]
    for schema in tables():
        lines += ["", f"## {schema.kind}", "", "| column | type | unit | meaning |", "|---|---|---|---|"]
        lines += [f"| `{column.key}` | {column.dtype} | {column.unit} | {column.help} |" for column in schema.columns]
    lines += ["", "## Facts of `datasheet.json`", "", "| key | title | unit | meaning |", "|---|---|---|---|"]
    lines += [f"| `{fact.key}` | {fact.title} | {fact.unit} | {fact.help} |" for fact in FACT_COLUMNS]
    return "\n".join(lines) + "\n"


PAGES = {
    "columns.md": columns_page,
    "commands.md": commands_page,
    "settings.md": settings_page,
    "mistakes.md": mistakes_page,
}
