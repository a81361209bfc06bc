"""Code blocks of the documentation, with the marks that say how they are tested.

A line `<!-- not run: reason -->` right before a block keeps it from being executed; `<!-- file: NAME -->` says that the
block is the content of that file. `<!-- copy: FILE:SECTION -->` says that it repeats a section of a script, which other
tests run.
"""

import re
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
_MARK = re.compile(r"<!-- (?P<kind>not run|file|copy): (?P<text>.+) -->$")
GENERATED = {f"docs/reference/{name}.md" for name in ("columns", "commands", "settings", "mistakes")}
"""Pages that are made while the site is built (docs/hooks.py)."""


@dataclass(frozen=True)
class Block:
    """One fenced block: where it begins, its language, its text, and its marks."""

    page: str
    line: int
    language: str
    text: str
    not_run: str | None
    file: str | None
    copy: str | None

    @property
    def place(self) -> str:
        return f"{self.page}:{self.line}"


def pages() -> list[str]:
    """Every page whose blocks a reader may copy, relative to the repository."""
    found = [path for pattern in ("*.md", "docs/**/*.md", "data/*.md", "workflows/*.md") for path in ROOT.glob(pattern)]
    return sorted({str(path.relative_to(ROOT)) for path in found})


def blocks(page: str) -> list[Block]:
    """The fenced blocks of a page, in order."""
    found: list[Block] = []
    opened: tuple[int, str, dict[str, str]] | None = None
    text: list[str] = []
    marks: dict[str, str] = {}
    for number, line in enumerate((ROOT / page).read_text(encoding="utf-8").splitlines(), start=1):
        if opened is not None:
            if line.strip() == "```":
                start, language, own = opened
                found.append(
                    Block(
                        page,
                        start,
                        language,
                        "\n".join(text) + "\n",
                        own.get("not run"),
                        own.get("file"),
                        own.get("copy"),
                    )
                )
                opened, text = None, []
            else:
                text.append(line)
            continue
        if line.startswith("```"):
            opened, marks = (number, line[3:].strip(), marks), {}
        elif mark := _MARK.match(line.strip()):
            marks = {**marks, mark["kind"]: mark["text"]}
        elif line.strip():
            marks = {}
    return found


def commands(block: Block) -> list[tuple[int, list[str]]]:
    """Arguments of every call of `debist` in a shell block, with its line; pipes and redirections cut off."""
    import shlex

    found = []
    lines = block.text.replace("\\\n", " \n").splitlines()
    for number, line in enumerate(lines, start=block.line + 1):
        for part in re.split(r"\|\||&&|;|\|", line):
            words = shlex.split(part, comments=True)
            while words and (words[0] in ("time", "sudo") or "=" in words[0].split("/")[0]):
                words = words[1:]
            if words and words[0].rpartition("/")[2] == "debist":
                ends = [i for i, word in enumerate(words) if re.match(r"\d?>|<", word)]
                found.append((number, words[1 : min(ends, default=len(words))]))
    return found
