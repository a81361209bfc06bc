"""Numbers in prose and tables that quote a page of docs/measured stand on that page.

A line `<!-- quotes: measured/hybrid.md -->` right before a paragraph or table binds it: every number with a decimal
point must stand on one of the named pages, rounded as in the quotation.
"""

import re
from decimal import ROUND_HALF_DOWN, ROUND_HALF_UP, Decimal
from pathlib import Path

import pytest

from tests.docs.pages import ROOT, pages

_MARK = re.compile(r"<!-- quotes: (?P<sources>[^>]+?) -->\n(?P<block>.+?)(?=\n\s*\n|\Z)", re.S)
_NUMBER = re.compile(r"(?<![\w.])\d+\.\d+(?![\w.]*\d)")


def missing(block: str, sources: str) -> list[str]:
    """Numbers of a block that no number of the sources rounds to."""
    measured = [Decimal(number) for number in _NUMBER.findall(sources)]

    def stands(text: str) -> bool:
        quoted = Decimal(text)
        rounded = (n.quantize(quoted, way) for n in measured for way in (ROUND_HALF_UP, ROUND_HALF_DOWN))
        return any(quoted == value for value in rounded)

    return [number for number in _NUMBER.findall(block) if not stands(number)]


def quotations(page: str) -> list[tuple[str, list[Path]]]:
    """Each bound block of a page with the pages that it quotes."""
    text = (ROOT / page).read_text(encoding="utf-8")
    return [
        (m["block"], [ROOT / "docs" / name.strip() for name in m["sources"].split(",")]) for m in _MARK.finditer(text)
    ]


QUOTING = [page for page in pages() if quotations(page)]


@pytest.mark.parametrize("page", QUOTING)
def test_quoted_numbers_are_the_measured_ones(page: str) -> None:
    for block, sources in quotations(page):
        lost = missing(block, "\n".join(source.read_text(encoding="utf-8") for source in sources))
        assert not lost, f"{page} quotes {', '.join(lost)}, which no source has: {block[:80]}…"
