"""Values in generated files: each goes through the writer of its language.

A template's own text and `Code` stand as they are. Any other text may come from a file that somebody else wrote. It
reads as words wherever it lands: it can end no comment and no string, begin no line and no tag.
"""

import re
import textwrap
import unicodedata
from collections.abc import Callable, Iterable, Mapping
from functools import cache, partial
from importlib.resources import files
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined, Undefined

from ..codegen.text_writer import Code, number
from ..store.atomic import write_text
from ..system.package import full_name

_SPELT = str.maketrans({"²": "^2", "³": "^3", "·": ".", "−": "-", "µ": "u", '"': "'", "\\": "/", "`": "'"})
_DOT = re.compile("(?P<letter>[qz])(?P<dots>[\u0307\u0308])")
_ENDS = re.compile(r"(?<=\*)(?=/)|(?<=/)(?=[*/])|(?<=\?)(?=\?)")
"""Places in ASCII where two characters together end or begin a comment of C, or belong to a trigraph."""
_AT_START = re.compile(r"^[*/?]")
_AT_END = re.compile(r"[*/?]$")
_NOT_IN_XML = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def words(text: str) -> str:
    r"""Text for a comment or a string of C and MATLAB: one line of printable ASCII without ``"`` and ``\``.

    Derivatives keep their names: ``q̈`` becomes qddot. What ASCII cannot spell becomes ``?``.
    """
    apart = unicodedata.normalize("NFD", text.translate(_SPELT))
    named = _DOT.sub(lambda match: match["letter"] + ("dot" if match["dots"] == "\u0307" else "ddot"), apart)
    plain = unicodedata.normalize("NFKD", named).translate(_SPELT)
    spelt = "".join(c for c in plain if not unicodedata.combining(c))
    one_line = "".join(c if " " <= c <= "~" else " " if c.isspace() or not c.isprintable() else "?" for c in spelt)
    return _ENDS.sub(" ", _AT_END.sub(r"\g<0> ", _AT_START.sub(r" \g<0>", one_line)))


def in_xml(text: str) -> str:
    """Text without the characters that XML forbids; `jinja2` escapes the rest."""
    return _NOT_IN_XML.sub("\ufffd", text)


def constant(value: float) -> Code:
    """A real number as text that is safe in any expression."""
    return Code(f"({number(value)})") if value < 0.0 else number(value)


def numbers(values: Iterable[float], end: str = "") -> Code:
    """Numbers to the last bit, apart by commas, in lines that end with `end`."""
    lines = textwrap.wrap(
        ", ".join(number(value) for value in values), 110, initial_indent="    ", subsequent_indent="    "
    )
    return Code(f"{end}\n".join(lines))


def reals(values: Iterable[float]) -> Code:
    """The same in C, in the precision that the file is compiled for."""
    return Code(
        "\n".join(
            textwrap.wrap(
                ", ".join(f"R({number(value)})" for value in values),
                114,
                initial_indent="    ",
                subsequent_indent="    ",
            )
        )
    )


def render(name: str, fields: dict[str, Any]) -> str:
    """The file that the template `name` makes of `fields`; its ending, as ``.c.j2``, decides the language."""
    return _environment(_LANGUAGES[name.split(".")[-2]]).get_template(name).render(fields)


def write_texts(folder: Path, texts: Mapping[str, str]) -> list[Path]:
    """Write files into a folder, by name; their paths."""
    for name, text in texts.items():
        write_text(folder / name, text)
    return [folder / name for name in texts]


def asset(name: str) -> str:
    """The text of a file that is copied unchanged."""
    return files(full_name("export")).joinpath("assets", name).read_text(encoding="utf-8")


def _value(value: Any, text: Callable[[str], str]) -> Any:
    """A value as it gets into the file."""
    if isinstance(value, Code | Undefined):
        return value
    if isinstance(value, float):
        return number(value)
    return str(value) if isinstance(value, int) else text(str(value))


_LANGUAGES = {"c": words, "h": words, "m": words, "xml": in_xml}


@cache
def _environment(text: Callable[[str], str]) -> Environment:
    environment = Environment(
        loader=PackageLoader(full_name("export"), "assets"),
        undefined=StrictUndefined,
        keep_trailing_newline=True,
        autoescape=text is in_xml,  # noqa: S701 - markup is escaped so, the other languages by `finalize`
        finalize=partial(_value, text=text),
    )
    environment.filters |= {"numbers": numbers, "reals": reals}
    return environment
