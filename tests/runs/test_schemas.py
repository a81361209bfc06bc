"""`data/README.md` publishes the schemas as the code defines them."""

from pathlib import Path

from pipeline.runs import schemas
from pipeline.runs.schemas import Schema, resolve

PAGE = Path(__file__).resolve().parents[2] / "data" / "README.md"
START, END = "<!-- schemas: written by `python -m tests.runs.test_schemas` -->", "<!-- end of schemas -->"


def _published() -> str:
    kinds = [value for value in vars(schemas).values() if isinstance(value, Schema)] + list(schemas.STUDIES.values())
    parts = []
    for schema in (resolve(kind, displacement="m", inputs=("V", "V"), phi=True, velocity=True) for kind in kinds):
        rows = [f"| `{c.name}` | {c.dtype} | {c.unit} | {c.meaning} |" for c in schema.columns]
        parts.append(
            "\n".join([f"### {schema.kind}", "", "| column | type | unit | meaning |", "|---|---|---|---|", *rows])
        )
    return "\n\n".join(parts)


def _page() -> tuple[str, str, str]:
    text = PAGE.read_text(encoding="utf-8")
    head, rest = text.split(START)
    body, tail = rest.split(END)
    return head, body.strip(), tail


def test_the_page_shows_todays_schemas() -> None:
    assert _page()[1] == _published()


if __name__ == "__main__":
    head, _, tail = _page()
    PAGE.write_text(f"{head}{START}\n\n{_published()}\n\n{END}{tail}", encoding="utf-8")
