"""How the code is written: short functions, and every one that another reads says what it gives."""

import ast
import re
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


def _defined(module: str) -> set[str] | None:
    """Names that a module of the repository defines or imports, and the modules in a package; None for no module."""
    place = ROOT / Path(*module.split("."))
    path = place / "__init__.py" if place.is_dir() else place.with_suffix(".py")
    if not path.is_file():
        return None
    found = {each.stem for each in place.glob("*")}
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            found.add(node.name)
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            found.add(node.id)
        elif isinstance(node, ast.ImportFrom | ast.Import):
            found |= {alias.asname or alias.name for alias in node.names}
    return found


def test_benchmarks_import_what_there_is() -> None:
    """Nothing else runs them between two measurements."""
    for path in sorted((ROOT / "benchmarks").glob("*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        for node in (each for each in ast.walk(tree) if isinstance(each, ast.ImportFrom)):
            if node.module and node.module.partition(".")[0] in ("pipeline", "tests"):
                known = _defined(node.module)
                assert known is not None, f"{path.name}: {node.module}"
                assert {alias.name for alias in node.names} <= known, f"{path.name}: {node.module}"
        for folder in re.findall(r'ROOT / "tests" / "(\w+)"', path.read_text(encoding="utf-8")):
            beside = {module.stem for module in (ROOT / "tests" / folder).glob("*.py")}
            names = {alias.name for node in tree.body if isinstance(node, ast.Import) for alias in node.names}
            names |= {node.module or "" for node in tree.body if isinstance(node, ast.ImportFrom)}
            assert names & beside, f"{path.name} finds nothing in tests/{folder}"


def test_no_temporary_file_is_opened_by_its_name_while_it_is_open() -> None:
    """Windows refuses that, and every reader of an unpacked or rewritten log opens it by name."""
    texts = {path: path.read_text(encoding="utf-8") for path in (ROOT / "pipeline").rglob("*.py")}
    assert len(texts) > 100
    assert not [path for path, text in texts.items() if "NamedTemporaryFile" in text]


def test_the_makefile_names_files_that_are_there() -> None:
    named = re.findall(r"\b(?:tests|benchmarks)/[\w/]+(?:\.py)?", (ROOT / "Makefile").read_text(encoding="utf-8"))
    files = [name for name in named if not name.endswith("_")]  # but patterns such as bench_*.py
    assert files and not [name for name in files if not (ROOT / name).exists()]
