"""Every command in README and docs: its options exist, and it runs where it can."""

import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import pytest
from typer.main import get_command

from cli import app
from pipeline.settings.prototype import Prototype, parse_prototype
from tests.docs.pages import ROOT, Block, blocks, commands, pages

BIN = Path(sys.executable).parent
SHELL = [block for page in pages() for block in blocks(page) if block.language == "sh"]
COPIES = [block for page in pages() for block in blocks(page) if block.copy is not None]
TOML = [block for page in pages() for block in blocks(page) if block.language == "toml"]
OF_PROGRAM = "CONTRIBUTING.md"
"""Its blocks change the program itself: `test_contributing` runs them."""
RUN = [
    page
    for page in pages()
    if page != OF_PROGRAM
    and any(b.language in ("sh", "python") and b.not_run is None and b.copy is None for b in blocks(page))
]
MAKES_ITS_OWN = re.compile(
    r"debist (?:run|ingest) (?P<name>\S+)\.toml -o (runs/(?P=name))(?!\S)|debist init .*-o (\S+)"
)
"""A page that makes a run or settings of its own, before anything else names them, begins without them."""


@pytest.mark.parametrize("block", SHELL, ids=lambda block: block.place)
def test_commands_and_options_exist(block: Block) -> None:
    for line, arguments in commands(block):
        try:
            parse(arguments)
        except Exception as error:
            pytest.fail(f"{block.page}:{line}: debist {' '.join(arguments)}: {error}")


def parse(arguments: list[str]) -> None:
    """Parse a call down to its last option, without doing anything."""
    command: Any = get_command(app)
    if arguments[0].startswith("--"):  # acts while it is parsed, such as --install-completion
        assert any(arguments[0] in option.opts for option in command.params), f"no such option: {arguments[0]}"
        return
    context = command.make_context("debist", list(arguments))
    rest = list(arguments)
    while hasattr(command, "commands"):
        if not rest:
            return
        name, command, rest = command.resolve_command(context, rest)
        context = command.make_context(name, list(rest), parent=context)


@pytest.mark.parametrize("page", pages())
def test_no_command_hides_in_another_kind_of_block(page: str) -> None:
    for block in blocks(page):
        if block.language not in ("sh", "python"):
            first = block.text.lstrip().removeprefix("$ ").split(maxsplit=1)[:1]
            assert first != ["debist"], f"{block.place}: write it as a sh block, so that it is tested"


@pytest.mark.parametrize("block", TOML, ids=lambda block: block.place)
def test_settings_are_such_as_the_program_takes(block: Block) -> None:
    document = tomllib.loads(block.text)
    if not set(document) <= set(Prototype.model_fields):
        pytest.skip("no settings of a prototype")
    known = {key: {"channel": key, "unit": "mm"} for key in ("q", "v1", "v2")}
    whole = {"name": "X", "logs": {"train": ["x.mat"]}, "channels": known} | document
    parse_prototype(whole, block.place)


@pytest.mark.parametrize("block", COPIES, ids=lambda block: block.place)
def test_code_in_a_page_is_that_of_its_script(block: Block) -> None:
    name, _, section = str(block.copy).partition(":")
    text = (ROOT / name).read_text(encoding="utf-8")
    if section:
        text = text.partition(f"# --8<-- [start:{section}]\n")[2].partition(f"# --8<-- [end:{section}]")[0]
    assert text.strip() and block.text.strip() == text.strip()


SIMULATED = """echo 'excitation = "mixed"' > mixed.toml
debist rig simulate -o {} --rate 2000 --kind nominal --experiment mixed.toml --seed 4
rm mixed.toml"""
BEFORE = {"docs/how-to/control.md": SIMULATED.format("rig")}
"""What a page takes from the tutorial, beside the workshop."""


@pytest.fixture(scope="session")
def workshop(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder as a user has it: raw logs, settings of P1 and P2, finished runs of both, a folder of prototypes."""
    folder = tmp_path_factory.mktemp("docs") / "workshop"
    folder.mkdir()
    (folder / ".venv").symlink_to(BIN.parent)
    shell(folder, SIMULATED.format("."))
    draft = (folder / "nominal-4.toml").read_text(encoding="utf-8").replace('"nominal-4"', '"{name}"', 1)
    quick = '\n[identify]\nmodels = ["auto", "rbf-paper"]\n[compare]\nmodels = ["sindy"]\n'
    (folder / "nominal-4.toml").unlink()
    (folder / "prototypes").mkdir()
    for name in ("P1", "P2"):
        text = draft.replace("{name}", name) + quick
        (folder / f"{name}.toml").write_text(text, encoding="utf-8")
        (folder / "prototypes" / f"{name}.toml").write_text(
            text.replace('["train', '["../train').replace('["valid', '["../valid'), encoding="utf-8"
        )
    shutil.copytree(ROOT / "examples", folder / "examples")
    shell(folder, "debist run -q P1.toml -o runs/P1")
    shell(folder, "debist run -q P2.toml -o runs/P2")
    return folder


def shell(folder: Path, script: str) -> str:
    """Run a script of a page; its output, or a failure that shows it."""
    environment = os.environ | {"PATH": f"{BIN}{os.pathsep}{os.environ['PATH']}", "OMP_NUM_THREADS": "1"}
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", script], cwd=folder, env=environment, capture_output=True, text=True
    )
    assert done.returncode == 0, f"{script}\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}"
    return done.stdout


@pytest.mark.long
@pytest.mark.parametrize("page", RUN)
def test_the_blocks_of_a_page_run_in_order(page: str, workshop: Path, tmp_path: Path) -> None:
    folder = tmp_path / "page"
    shutil.copytree(workshop, folder, symlinks=True)
    text = "".join(block.text for block in blocks(page) if block.language == "sh")
    for made in MAKES_ITS_OWN.finditer(text):
        place = folder / (made[2] or made[3])
        if (made[2] or made[3]) not in text[: made.start()] and place.exists():
            shutil.rmtree(place) if made[2] else place.unlink()
    shell(folder, BEFORE.get(page, "true"))
    for block in blocks(page):
        if block.file is not None:
            (folder / block.file).write_text(block.text, encoding="utf-8")
        elif block.not_run is None and block.language == "sh":
            shell(folder, block.text)
        elif block.not_run is None and block.copy is None and block.language == "python":
            (folder / "block.py").write_text(block.text, encoding="utf-8")
            shell(folder, "python block.py")
