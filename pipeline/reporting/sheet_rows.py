"""The datasheet as a table for people: one row per quantity, the left well beside the right one."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from pipeline.device_facts.datasheet import Datasheet
from pipeline.device_facts.fact import Fact
from pipeline.si_prefix import quantity

# Row title, facts of the left well, facts of the right well. Single facts have no second list.
_ROWS: tuple[tuple[str, tuple[str, ...], tuple[str, ...]], ...] = (
    ("rest position", ("well_left",), ("well_right",)),
    ("energy barrier out of it", ("barrier_left",), ("barrier_right",)),
    (
        "lowest steady input that switches out of it",
        ("switch_v1_to_right", "switch_v2_to_right"),
        ("switch_v1_to_left", "switch_v2_to_left"),
    ),
    ("stiffness", ("stiffness_left",), ("stiffness_right",)),
    ("ring-down frequency", ("frequency_left",), ("frequency_right",)),
    ("damping ratio", ("damping_left",), ("damping_right",)),
    ("rest position", ("rest",), ()),
    ("stiffness at rest", ("stiffness",), ()),
    ("ring-down frequency", ("frequency",), ()),
    ("damping ratio", ("damping",), ()),
    ("unstable equilibrium", ("saddle",), ()),
    ("asymmetry of rests (q₊\u00a0+\u00a0q₋)/(q₊\u00a0−\u00a0q₋)", ("asymmetry_wells",), ()),
    ("asymmetry of depths, ΔU over mean barrier", ("asymmetry_barriers",), ()),
)


@dataclass(frozen=True)
class SheetCell:
    """Texts of a cell: the model's value, and what the data show without a model and the free run there (or empty)."""

    value: str
    seen: str


@dataclass(frozen=True)
class SheetRow:
    """A quantity: cells of the left and the right well, or one cell for the whole device."""

    title: str
    cells: tuple[SheetCell, ...]


def sheet_rows(sheet: Datasheet) -> list[SheetRow]:
    """The rows that have at least one value."""
    facts = {fact.key: fact for fact in sheet.facts}
    stroke = max((abs(f.value or f.measured or 0.0) for f in sheet.facts if f.key.startswith("well")), default=0.0)
    rows = []
    for title, left, right in _ROWS:
        groups = [keys for keys in (left, right) if keys]
        if any(key in facts for keys in groups for key in keys):
            like = stroke if left == ("saddle",) else _largest(facts, (*left, *right))
            rows.append(SheetRow(title, tuple(_cell(facts, keys, like) for keys in groups)))
    return rows


def _largest(facts: Mapping[str, Fact], keys: Sequence[str]) -> float:
    """Both wells of a row have one unit."""
    return max((abs(_shown(facts[key], facts[key].value) or 0.0) for key in keys if key in facts), default=0.0)


def _cell(facts: Mapping[str, Fact], keys: Sequence[str], like: float) -> SheetCell:
    known = [facts[key] for key in keys if key in facts]
    values, seen = [], ""
    for fact in known:
        text = quantity(_shown(fact, fact.value), fact.unit, _shown(fact, _half_width(fact)), like)
        if fact.key.startswith("switch"):
            text = f"{fact.key.split('_')[1]} {text}"
        values.append(text)
        if fact.measured is not None:
            spread = _shown(fact, fact.measured_spread)
            seen = f"{quantity(_shown(fact, fact.measured), fact.unit, spread, like)} · {fact.events}×"
            if fact.free_run is not None:
                seen += f", free run {quantity(_shown(fact, fact.free_run), fact.unit, like=like)}"
    return SheetCell(", ".join(values) or "–", seen)


def _half_width(fact: Fact) -> float | None:
    return None if fact.low is None or fact.high is None else (fact.high - fact.low) / 2.0


def _shown(fact: Fact, value: float | None) -> float | None:
    return 100.0 * value if fact.unit == "%" and value is not None else value
