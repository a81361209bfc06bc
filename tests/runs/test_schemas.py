"""`data/README.md` publishes the columns as the code defines them, and their version changes when they do."""

import hashlib
from collections.abc import Iterator
from pathlib import Path

from pipeline.runs import schemas
from pipeline.runs.columns import FACT_COLUMNS, SCHEMA_VERSION
from pipeline.runs.schemas import Schema, resolve

PAGE = Path(__file__).resolve().parents[2] / "data" / "README.md"
START, END = "<!-- schemas: written by `python -m tests.runs.test_schemas` -->", "<!-- end of schemas -->"
VERSIONS = {"1": "6759345cecf59ad9", "2": "0ca3f9e57b9bf8ea"}
"""Digests of the columns by schema version: a change of columns needs a new version, a new table a new digest."""


def _schemas() -> list[Schema]:
    kinds = [value for value in vars(schemas).values() if isinstance(value, Schema)] + list(schemas.STUDIES.values())
    return [resolve(kind, displacement="m", inputs=("V", "V"), phi=True, velocity=True, tubes=True) for kind in kinds]


def _digest() -> str:
    files = [(schema.kind, [(c.key, c.dtype, c.unit) for c in schema.columns]) for schema in _schemas()]
    facts = [(fact.key, fact.unit) for fact in FACT_COLUMNS]
    return hashlib.sha256(repr((files, facts)).encode()).hexdigest()[:16]


def _published() -> Iterator[str]:
    for schema in _schemas():
        rows = [f"| `{c.key}` | {c.dtype} | {c.unit} | {c.help} |" for c in schema.columns]
        yield "\n".join([f"### {schema.kind}", "", "| column | type | unit | meaning |", "|---|---|---|---|", *rows])
    rows = [f"| `{fact.key}` | {fact.title} | {fact.unit} | {fact.help} |" for fact in FACT_COLUMNS]
    yield "\n".join(
        ["### facts of `datasheet.json`", "", "| key | title | unit | meaning |", "|---|---|---|---|", *rows]
    )


def _page() -> tuple[str, str, str]:
    text = PAGE.read_text(encoding="utf-8")
    head, rest = text.split(START)
    body, tail = rest.split(END)
    return head, body.strip(), tail


def test_the_page_shows_todays_columns() -> None:
    head, body, _ = _page()
    assert body == "\n\n".join(_published())
    assert f"(schema version {SCHEMA_VERSION})" in head


def test_columns_that_changed_have_a_new_version() -> None:
    assert VERSIONS.get(SCHEMA_VERSION) == _digest(), "raise SCHEMA_VERSION and add its digest to VERSIONS"


if __name__ == "__main__":
    head, _, tail = _page()
    published = "\n\n".join(_published())
    PAGE.write_text(f"{head}{START}\n\n{published}\n\n{END}{tail}", encoding="utf-8")
