"""How the code is written: short functions, and every one that another reads says what it gives."""

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
MODULES = sorted(path for path in (ROOT / "pipeline").rglob("*.py") if path.parent.name != "generated")
LONGEST, SELF_EVIDENT = 40, 4
"""Lines of a function without its docstring; lines of an inner function that needs none."""


def _functions(path: Path) -> list[ast.FunctionDef]:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]


def _length(function: ast.FunctionDef) -> int:
    documented = ast.get_docstring(function) is not None and len(function.body) > 1
    begin = function.body[1].lineno if documented else function.lineno
    return (function.end_lineno or begin) - begin + 1


@pytest.mark.parametrize("room", sorted({path.relative_to(ROOT).parent.as_posix() for path in MODULES}))
def test_functions_are_short_and_inner_ones_documented(room: str) -> None:
    for path in (path for path in MODULES if path.parent == ROOT / room):
        for function in _functions(path):
            place = f"{path.relative_to(ROOT)}:{function.lineno} {function.name}"
            assert _length(function) <= LONGEST, f"{place}: {_length(function)} lines"
            inner = (node for node in ast.walk(function) if isinstance(node, ast.FunctionDef) and node is not function)
            for each in inner:
                said = ast.get_docstring(each) or _length(each) <= SELF_EVIDENT
                assert said, f"{path.relative_to(ROOT)}:{each.lineno} {each.name} has no docstring"
