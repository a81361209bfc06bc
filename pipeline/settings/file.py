"""A settings file as a document, read and written; its mistakes as one line each; keys of earlier releases."""

import difflib
import errno
import json
import re
import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, TypeVar, get_args

from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo

from ..errors import InputError, SeveralMistakesError
from ..system.names import shell_word
from ..system.plain_files import read_plain, read_toml

STRUCTURE = ("friction", "force", "damping", "drag", "stops", "gain", "drive", "effect", "hold")
"""Keys of `[identify]` that became the table `[identify.structure]`."""

GATES = ("delay", "time-base", "device")
"""Gates of `[quality] accept` that refuse nothing any more."""

_DEFAULTS: dict[str, dict[str, Any]] = {
    "differentiate": {"reweighted": True, "rate": "record"},
    "identify": {"basis": "gaussian", "rbf_basis_functions": "auto", "rbf_smoothing": "auto", "rbf_prior": "auto"},
}
"""Keys that are gone, and the value that the program has now in any case."""


def replacement(key: str, value: Any, gone: Mapping[str, str]) -> str | None:
    """The line for a key, or value, that an earlier release had; None where none had it.

    Parameters
    ----------
    key : str
        Dotted.
    value : object
        Its value.
    gone : mapping of str to str
        Advice by keys that went.
    """
    table, _, name = key.partition(".")
    if table == "identify" and name in STRUCTURE:
        return f"{key} is gone; write [identify.structure], and {name} = {value!r:.60} below it".replace("'", '"')
    if key == "differentiate.method" and value != "rts":
        return None
    return f"{key} is gone; {gone[key]}" if key in gone else None


def translated(stored: Mapping[str, Any], *, used: bool = False) -> dict[str, Any]:
    """Settings that an earlier release stored, by today's keys; those of today as they are.

    Parameters
    ----------
    stored : mapping
        Tables of settings, as JSON values; some may be absent.
    used : bool
        True if an artifact was made with them. Then a value that no setting has any more stays, so that it counts as a
        change.
    """
    tables = {name: dict(table) for name, table in stored.items() if isinstance(table, Mapping)}
    for name, defaults in _DEFAULTS.items():
        for key in defaults.keys() & tables.get(name, {}).keys():
            if not used or tables[name][key] == defaults[key]:
                del tables[name][key]
    if "prototype" in tables:
        tables["prototype"] = translated(tables["prototype"], used=used)
    if not used and isinstance(accepted := tables.get("quality", {}).get("accept"), list | tuple):
        tables["quality"]["accept"] = [gate for gate in accepted if gate not in GATES]
    if not used and tables.get("differentiate", {}).get("method") == "rts":
        del tables["differentiate"]["method"]
    identify = tables.get("identify", {})
    if moved := {key: identify.pop(key) for key in STRUCTURE if key in identify}:
        identify["structure"] = moved
    return {**stored, **tables}


Settings = TypeVar("Settings", bound=BaseModel)

_SLIPS = (
    (re.compile(r"=\s*[-+]?\d+,\d"), "numbers have a decimal point, as 40.5"),
    (re.compile("[“”„‘’]"), 'text stands between plain quotes, as "P1"'),
    (re.compile(r"(?:^|[{,])\s*[\w.]+\s*=\s*(?!(true|false|inf|nan)\b)[^\W\d]"), 'text stands between quotes, as "P1"'),
)
"""Common slips in a line that is no TOML, and the correct form."""

_BRANCH = re.compile(r"int|float|str|LogPart|literal\[.*\]|constrained-.*|tuple\[.*\]", re.DOTALL)
"""Parts of pydantic's locations that name a branch of a union and no key."""

_TOO_FAST = {
    ("sample_interval", "greater_than_equal"),
    ("record_interval", "greater_than_equal"),
    ("sample_rate", "less_than_equal"),
}
"""Keys that a log which is too fast needs, and the bound that they pass."""
_STRETCHED = (
    "; for a faster log stretch time, as by 1e4: time = { …, scale = 1e4 } in [channels], or sample_rate over 1e4, and "
    "intervals times 1e4; a second of the results is then 1e-4 s"
)


def read_document(path: Path) -> dict[str, Any]:
    """The document of a prototype's TOML file, unchecked.

    Raises
    ------
    InputError
        The file is missing, or is no TOML.
    """
    try:
        return read_toml(path)
    except FileNotFoundError:
        raise InputError(f"{path}: no such file; `debist init LOG` writes one for a log") from None
    except IsADirectoryError:
        raise InputError(f"{path}: is a folder; name a settings file (*.toml)") from None
    except OSError as error:
        if error.errno == errno.EFBIG:
            raise InputError(f"{path}: {_no_toml(path, error)}") from error
        raise InputError(f"{path}: cannot be read: {error.strerror}; see to disk and permission") from error
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise InputError(f"{path}: {_no_toml(path, error)}") from error


def read_options(path: Path | None, schema: type[Settings]) -> Settings:
    """The rare options of a command, from a TOML file of its own; the defaults where there is no file.

    Raises
    ------
    InputError
        The file is missing or no TOML, or a key or a value is none of the schema's.
    """
    if path is None:
        return schema()
    if not path.exists():
        raise InputError(f"{path}: no such file")
    return checked(read_document(path), schema, str(path))


def checked(document: dict[str, Any], schema: type[Settings], where: str) -> Settings:
    """Settings that were read from `where`.

    Raises
    ------
    InputError
        Everything that is wrong, each with the key and a suggestion.
    """
    try:
        return schema.model_validate(document)
    except ValidationError as error:
        raise SeveralMistakesError.of(where, mistakes(error.errors(include_url=False), schema)) from None


def _no_toml(path: Path, error: Exception) -> str:
    if path.suffix.lower() != ".toml":
        return f"no settings file; if it is a log, `debist init {shell_word(path)}` writes settings for it"
    if isinstance(error, UnicodeDecodeError):
        return "not UTF-8; save it as UTF-8 in your editor"
    if isinstance(error, OSError):
        return f"no settings file: it {error.strerror}"
    return f"not valid TOML: {error}{_advice(path, str(error))}"


def _advice(path: Path, error: str) -> str:
    """Advice where the line that is no TOML shows a common slip; else empty."""
    if "Unescaped" in error:
        return "; write paths with / or between single quotes"
    if (place := re.search(r"at line (\d+)", error)) is None:
        return ""
    line = read_plain(path).decode("utf-8-sig").split("\n")[int(place[1]) - 1]
    return next((f"; {advice}" for slip, advice in _SLIPS if slip.search(line)), "")


def toml_text(document: Mapping[str, Any]) -> str:
    """Settings as TOML; keys without a value (None) are left out.

    Parameters
    ----------
    document : mapping
        JSON values. Sub-mappings become tables, mappings within those inline tables.
    """
    lines = [f"{key} = {_toml(value)}" for key, value in document.items() if not isinstance(value, Mapping | None)]
    for key, value in document.items():
        if isinstance(value, Mapping) and any(entry is not None for entry in value.values()):
            lines += ["", f"[{key}]"]
            lines += [f"{name} = {_toml(entry)}" for name, entry in value.items() if entry is not None]
    return "\n".join(lines) + "\n"


def _toml(value: Any) -> str:
    if isinstance(value, Mapping):
        inside = ", ".join(f"{key} = {_toml(entry)}" for key, entry in value.items() if entry is not None)
        return f"{{ {inside} }}" if inside else "{}"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_toml, value))}]"
    # Texts, numbers and truth values are equal in JSON and TOML, except one control character.
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def mistakes(errors: Sequence[Any], settings: type[BaseModel]) -> list[str]:
    """Every mistake once: of the branches of a union the first, of a mistyped mandatory key that it is unknown.

    Parameters
    ----------
    errors : sequence of dict
        As pydantic lists them.
    settings : type
        The settings that they are about.
    """
    unknown = [error for error in errors if error["type"] == "extra_forbidden"]
    # Only a mistyped key is close to a missing one: the message on the unknown key is enough.
    typed = {(error["loc"][:-1], close) for error in unknown for close in _close(str(error["loc"][-1]), errors, error)}
    texts: dict[str, str] = {}
    for error in (*unknown, *(error for error in errors if error["type"] != "extra_forbidden")):
        if error["type"] == "missing" and (error["loc"][:-1], error["loc"][-1]) in typed:
            continue
        if error["type"] == "too_short" and error["input"]:  # its entries have mistakes of their own
            continue
        texts.setdefault(".".join(_location(error)) or str(error["msg"]), explain(error, settings))
    return list(texts.values())


def _close(key: str, errors: Sequence[Any], unknown: Any) -> list[str]:
    beside = [str(e["loc"][-1]) for e in errors if e["type"] == "missing" and e["loc"][:-1] == unknown["loc"][:-1]]
    return difflib.get_close_matches(key, beside, n=1, cutoff=0.5)


def _location(error: Any) -> list[str]:
    return [str(part) for part in error["loc"] if not _BRANCH.fullmatch(str(part))]


_UNIT = re.compile(r"\[([^]]+)\]")


def explain(error: Any, settings: type[BaseModel]) -> str:
    """One error of pydantic's, for the settings that `settings` describes."""
    location = _location(error)
    key = ".".join(location)
    gone = getattr(settings, "gone", {})
    if error["type"] in ("extra_forbidden", "literal_error") and (instead := replacement(key, error["input"], gone)):
        return instead
    if error["type"] == "extra_forbidden":
        return f"unknown key {key!r}; {_hint(location, settings)}"
    if error["type"] == "missing":
        return f"{key!r} is missing; it is mandatory"
    given = repr(error["input"])
    if error["type"] in ("tuple_type", "list_type"):
        return f"{key}: must be a list, with its entries in brackets (got {given:.60}, not [{given:.60}])"
    if error["type"] == "too_short":
        return f"{key}: needs at least {error['ctx']['min_length']} entry (got {given:.60})"
    if error["type"] == "literal_error":
        choices = re.findall(r"'([^']*)'", error["ctx"]["expected"])
        if close := difflib.get_close_matches(str(error["input"]), choices, n=1):
            return f"{key}: there is no {given:.60}; did you mean {close[0]!r}?"
    if error["type"] in ("model_type", "model_attributes_type", "dict_type"):
        fields = _fields_at(location, settings)
        mandatory = [name for name, field in fields.items() if field.is_required()]
        wanted = ", ".join(f"{name} = …" for name in mandatory or fields)
        return f"{key}: must be a table, as {{ {wanted} }} (got {given:.60})"
    message = str(error["msg"]).removeprefix("Value error, ")
    if not key:  # a check of the whole names its keys itself
        return message
    got = "" if error["type"] == "value_error" else f" (got {given:.60})"
    fast = (location[-1], error["type"]) in _TOO_FAST and error["input"] > 0.0
    unit = _unit_at(location, settings) if got and not fast else ""
    return f"{key}: {message[:1].lower()}{message[1:]}{got}{_STRETCHED if fast else unit}"


def _unit_at(location: list[str], settings: type[BaseModel]) -> str:
    """The unit of a number, as the meaning of its key states it in brackets."""
    field = _fields_at(location[:-1], settings).get(location[-1])
    unit = _UNIT.search((field and field.description) or "")
    return f"; a number in {unit[1]}" if unit else ""


def _hint(location: list[str], settings: type[BaseModel]) -> str:
    *section, key = location
    keys = list(_fields_at(section, settings))
    if close := difflib.get_close_matches(key, keys, n=1, cutoff=0.5):
        return f"did you mean {close[0]!r}?"
    elsewhere = [name for name in settings.model_fields if key in _fields_at([name], settings) and len(section) < 2]
    return f"it belongs into [{elsewhere[0]}]" if elsewhere else f"known here: {', '.join(keys)}"


def _fields_at(location: list[str], settings: type[BaseModel]) -> dict[str, FieldInfo]:
    """The fields of the table at a place by their keys; none where there is no table."""
    model = settings
    for part in (part for part in location if not part.isdigit()):
        annotation = model.model_fields[part].annotation
        tables = [c for c in _within(annotation) if isinstance(c, type) and issubclass(c, BaseModel)]
        if not tables:
            return {}
        model = tables[0]
    return model.model_fields


def _within(annotation: Any) -> list[Any]:
    """A type, and those that it is made of."""
    return [annotation, *(part for inner in get_args(annotation) for part in _within(inner))]
