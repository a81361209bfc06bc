"""Files name what there is, and nothing opens a temporary file twice."""

import ast
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]


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


def _programs(tree: ast.AST) -> list[ast.AST]:
    """The programs that a file has as texts, for processes of their own."""
    texts = [each.value for each in ast.walk(tree) if isinstance(each, ast.Constant) and isinstance(each.value, str)]
    return [ast.parse(text) for text in texts if "\nfrom pipeline" in text]


def test_benchmarks_import_what_there_is() -> None:
    """Nothing else runs them between two measurements."""
    for path in sorted((ROOT / "benchmarks").glob("*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        nodes = [each for program in (tree, *_programs(tree)) for each in ast.walk(program)]
        for node in (each for each in nodes if isinstance(each, ast.ImportFrom)):
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


def test_the_package_imports_itself_by_relative_imports_alone() -> None:
    """An absolute import works in a checkout alone: installed, the package is called `debist`."""
    for path in (ROOT / "pipeline").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            modules = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            modules += [node.module or ""] if isinstance(node, ast.ImportFrom) and not node.level else []
            own = {"pipeline", "debist", "cli"} & {module.partition(".")[0] for module in modules}
            assert not own, f"{path.relative_to(ROOT)}:{node.lineno}"


def _functions(body: list[ast.stmt], owner: str = "") -> list[tuple[str, ast.FunctionDef]]:
    """Public functions and methods of public classes, by their names."""
    found: list[tuple[str, ast.FunctionDef]] = []
    for node in body:
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
            found.append((owner + node.name, node))
        elif isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            found += _functions(node.body, f"{node.name}.")
    return found


_IMPORT_WITHOUT_LAPACK = """
import importlib, sys
import numpy.linalg, scipy.linalg

def refused(*arguments, **options):
    raise AssertionError("LAPACK is called by an import")

for library in (numpy.linalg, scipy.linalg):
    for name in ("cholesky", "det", "eig", "eigh", "inv", "lstsq", "pinv", "qr", "solve", "svd"):
        if hasattr(library, name):
            setattr(library, name, refused)
for module in sys.argv[1:]:
    importlib.import_module(module)
"""


def test_no_module_calls_lapack_when_it_is_imported() -> None:
    """Where memory is short, OpenBLAS ends the process at its first call, and nothing catches it."""
    parts = [path.relative_to(ROOT).with_suffix("").parts for path in sorted((ROOT / "pipeline").rglob("*.py"))]
    ends = {
        "__init__",
        "__main__",
        "preloaded",
        "equations",
    }  # preloaded acts when it is imported, equations need CasADi
    modules = [".".join(each) for each in parts if not ends.intersection(each)]
    command = [sys.executable, "-c", _IMPORT_WITHOUT_LAPACK, *modules]
    subprocess.run(command, check=True, cwd=ROOT)


def test_public_functions_of_four_parameters_describe_them() -> None:
    """In a section of their own, or where the function that they are those of is named; options describe themselves."""
    lacking = []
    for path in sorted((ROOT / "pipeline").rglob("*.py")):
        room = path.relative_to(ROOT / "pipeline").parts[0]
        if room in ("commands", "generated"):
            continue
        for name, node in _functions(ast.parse(path.read_text(encoding="utf-8")).body):
            arguments = node.args
            given = [each.arg for each in (*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs)]
            text = ast.get_docstring(node) or ""
            if (
                len(set(given) - {"self", "cls"}) >= 4
                and "Parameters\n-----" not in text
                and "see `pipeline." not in text
            ):
                lacking.append(f"{path.relative_to(ROOT)}: {name}")
    assert not lacking
