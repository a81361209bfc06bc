"""Text of received files in exported ones: it ends no comment, no string, no line and no tag, whatever it is."""

import re
import subprocess
import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path

import pytest

from pipeline.export import fmu, sources as texts
from pipeline.export.crate import environment_text
from pipeline.export.subject import Subject, Variable
from pipeline.reporting.tables import disarmed
from tests.export.joints import COMPILER, STRICT, sindy, subject

HOSTILE = (
    "*/ int INJECTED(void); /*",
    "*\\/ \\\n#include <INJECTED>",
    "??/\n*??/\n/ INJECTED",
    "\r\nsystem('INJECTED')\n%",
    "%{\n%}\nINJECTED = 1;",
    "' ; INJECTED ; '",
    '" INJECTED="1"><INJECTED/>',
    "]]>--><INJECTED/>\x00\x0b\ufffe",
    "\u2028INJECTED\u0085INJECTED",
    "∗/ ⁎⁄ INJECTED ＊／",
)
ALLOWED = re.compile(r"[\n\t -~]*")


def hostile(text: str) -> Subject:
    """A model whose every text is this one."""
    told = {"structure": text, "equations": text}
    what = subject(sindy().model_copy(update={"diagnostics": told, "units": (text, text)}), 1.0)
    return replace(what, prototype=text, origin=text, validity=replace(what.validity, q_unit=text, v_units=(text,) * 2))


def without_comments(source: str) -> str:
    return re.sub(r"/\*.*?\*/", " ", source, flags=re.DOTALL)


def realised(what: Subject, text: str):
    made = what.realisation()
    states = tuple(replace(state, unit=text, meaning=text) for state in made.states)
    return replace(made, structure=text, states=states, hysteresis_states=(Variable("h_0", text, text),))


@pytest.mark.parametrize("text", HOSTILE)
def test_no_text_leaves_its_comment_or_attribute(text: str, tmp_path: Path) -> None:
    what = hostile(text)
    made = realised(what, text)
    sources = fmu.fmu_sources(what, made)
    assert re.fullmatch(r"[A-Za-z]\w*", what.identifier, re.ASCII)
    own = re.compile(what.identifier, re.IGNORECASE)
    for name, source in sources.items():
        assert ALLOWED.fullmatch(source) and "??" not in source, name
        assert "INJECTED" not in own.sub("", without_comments(source)), name
    script = texts.function_source(what)
    assert ALLOWED.fullmatch(script)
    lines = own.sub("", script).splitlines()
    assert not [line for line in lines if "INJECTED" in line and not line.lstrip().startswith("%")]
    root = ET.fromstring(fmu.description(what, made, fmu.guid(what)))  # noqa: S314 - our own
    assert not [tag for tag in root.iter() if "INJECTED" in tag.tag or "INJECTED" in tag.attrib]
    if COMPILER is not None:
        for name, source in texts.c_sources(what, made).items():
            (tmp_path / name).write_text(source, encoding="ascii")
        subprocess.run(
            [COMPILER, *STRICT, "-trigraphs", "-fsyntax-only", f"{what.identifier}.c"], cwd=tmp_path, check=True
        )


def test_an_environment_holds_no_option_of_pip() -> None:
    packages = {"numpy": "2.0", "--index-url http://INJECTED #": "1", "scipy": "1.0\n-r INJECTED", "a b": "1"}
    text = environment_text({"debist": "1.0", "python": "3.11\n-r INJECTED", **packages})
    assert [line for line in text.splitlines() if not line.startswith("#")] == ["numpy==2.0"]


def test_a_name_is_no_formula_in_a_table() -> None:
    assert disarmed("\t =cmd()") == "'\t =cmd()" and disarmed("\n@x").startswith("'")
