"""Facts of the device and of its models as tables for readers: units from the keys, values with deviations."""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..diagnostics.calibrated import Calibrated
from ..diagnostics.datasheet import Datasheet, DatasheetFact, is_refused
from ..diagnostics.run_data import RunData
from ..store.columns import FACT_COLUMNS, STABLE, FactColumn
from ..units.quantity import interval, percent, power, quantity, scale, significant

NOT_USED = " (a model not to be used)"
"""Remark beside facts of a model that the assessment rejects."""
WIDE = 2.0
"""Ratio of the ends of an interval beyond which it is written by its ends."""
_WHAT = {
    ("hybrid", True): "hybrid is the analytical joint with {physical} fitted physical parameters (the calibrated "
    "quantities below) and RBF corrections of {count} basis functions each.",
    ("hybrid", False): "hybrid is the analytical joint with {physical} fitted physical parameters (the calibrated "
    "quantities below); 0 basis functions act.",
    ("rbf", True): "rbf is identified from data alone, with {count} basis functions in each curve.",
    ("rbf-paper", True): "rbf-paper is the published recipe, with {count} basis functions in each curve.",
}
_PARTS = {
    "equations_alone": "equations alone",
    "equations_with_rbf": "with basis functions",
    "rbf_alone": "rbf from data alone",
}
"""Parts that an ablation leaves out (`pipeline.models.choose.Choice.to_json`), in words."""


Rows = list[tuple[str, ...]]
LONGEST_LIST = 12  # numbers that one cell shows
_UNIT_AT_END = re.compile(r"^(?P<name>.*?)(?: \[(?P<unit>[^\[\]]+)\]|_(?P<suffix>1_per_s|1_per_m|m|s|kg|V|Hz|N))$")


@dataclass(frozen=True)
class SheetCell:
    """Texts of a cell: the model's value, and those of the data alone and of the free run (or empty)."""

    value: str
    seen: str


@dataclass(frozen=True)
class SheetRow:
    """A quantity: cells of the left and the right well, or one cell for the whole device."""

    title: str
    help: str
    cells: tuple[SheetCell, ...]


def sheet_rows(known: Sequence[DatasheetFact]) -> list[SheetRow]:
    """The rows that have at least one value."""
    facts = {fact.key: fact for fact in known}
    stroke = max((abs(f.value or f.measured or 0.0) for f in known if f.key.startswith("well")), default=0.0)
    grouped: dict[tuple[str, bool], dict[str, list[str]]] = {}
    helps: dict[tuple[str, bool], FactColumn] = {}
    for column in FACT_COLUMNS:
        row = column.row, bool(column.side)
        helps.setdefault(row, column)
        keys = [key for key in facts if key.startswith(STABLE)] if column.key == STABLE else [column.key]
        grouped.setdefault(row, {}).setdefault(column.side, []).extend(keys)
    rows = []
    for row, sides in grouped.items():
        keys = [key for side in sides.values() for key in side if key in facts]
        if keys:
            largest = max(abs(_shown(facts[key], facts[key].value) or 0.0) for key in keys)  # both wells have one unit
            like = stroke if keys == ["saddle"] else largest
            rows.append(SheetRow(row[0], helps[row].help, tuple(_cell(facts, side, like) for side in sides.values())))
    return rows


def _cell(facts: Mapping[str, DatasheetFact], keys: Sequence[str], like: float) -> SheetCell:
    values = []
    measured = ""
    for fact in (facts[key] for key in keys if key in facts):
        text = quantity(_shown(fact, fact.value), fact.unit, _shown(fact, fact.half_width), like).replace(" ", "\u00a0")
        if fact.key.startswith("switch"):
            text = f"{fact.key.split('_')[1]}\u00a0{text}"
        values.append(f"{text} ({fact.doubt})" if fact.doubt else text)
        if fact.measured is not None:
            spread = _shown(fact, fact.measured_spread)
            measured = f"{quantity(_shown(fact, fact.measured), fact.unit, spread, like)} · {fact.events}×"
            if fact.free_run is not None:
                measured += f"\nfree run {quantity(_shown(fact, fact.free_run), fact.unit, like=like)}"
    return SheetCell(", ".join(values) or "–", measured)


def _shown(fact: DatasheetFact, value: float | None) -> float | None:
    return 100.0 * value if fact.unit == "%" and value is not None else value


@dataclass(frozen=True)
class CalibratedRow:
    """Texts of one quantity; `moved` if its nominal value lies outside its interval."""

    name: str
    nominal: str
    value: str
    moved: bool


def structure_summary(data: RunData, sheet: Datasheet) -> str:
    """Sentences on the main model: its type, the reason, the count of its basis functions and their effect."""
    description = data.descriptions.get(sheet.main_model, {})
    if (count := description.get("basis_functions")) is None:
        return ""
    sentences = [
        _WHAT.get((sheet.main_model, bool(count)), "").format(
            count=count, physical=description.get("physical_parameters", 0)
        )
    ]
    choice = data.choice or {}
    if choice.get("chosen") == sheet.main_model and data.why_chosen:
        sentences.append(f"Why this model: {data.why_chosen}.")
    ablation = [
        f"{_PARTS[name]} {percent(error)}"
        for name, error in choice.get("ablation", {}).items()
        if error is not None and name in _PARTS
    ]
    if ablation:
        sentences.append(
            f"Errors over the last quarters of the training logs, of the operating range: {', '.join(ablation)}."
        )
    return " ".join(sentence for sentence in sentences if sentence)


def calibrated_row(fitted: Calibrated) -> CalibratedRow:
    """The row of a quantity that the hybrid model's fit moves."""
    half = (fitted.high - fitted.low) / 2.0
    nominal = "–" if fitted.nominal is None else quantity(fitted.nominal, fitted.unit, like=fitted.value)
    moved = fitted.nominal is not None and not fitted.low <= fitted.nominal <= fitted.high
    if fitted.low > 0.0 and fitted.high > WIDE * fitted.low:  # the interval of a logarithm, far from even
        value, ends = interval(fitted.value, fitted.low, fitted.high, fitted.unit)
        return CalibratedRow(fitted.name, nominal, f"{value} ({ends})", moved)
    return CalibratedRow(fitted.name, nominal, quantity(fitted.value, fitted.unit, half), moved)


def datasheet_tables(document: dict[str, Any]) -> list[tuple[str, tuple[str, ...], Rows]]:
    """The datasheet for the terminal, as tables with title, heading and rows.

    The facts of the page, the evidence of the logs for them, the acting elements, and last the checks of the
    assessment.
    """
    sheet = sheet_rows([DatasheetFact(**fact) for fact in document["facts"]])

    def texts(row: SheetRow, of: Callable[[SheetCell], str]) -> tuple[str, ...]:
        """Title and cells of a row, in one line each."""
        cells = (row.title, *(of(cell) for cell in row.cells), "")[:3]
        return tuple(cell.replace("\u00a0", " ").replace("\n", "; ") for cell in cells)

    assessment = document["verdict"]
    checks: Rows = [
        (check["about"], check["grade"], check["statement"], "" if check["grade"] == "good" else check["advice"])
        for check in assessment["checks"]
    ]
    source = f"facts from {document['facts_from']}" if document["facts_from"] else "no model has curves"
    refused = document["facts_from"] == document["judged_model"] and is_refused(assessment["checks"])
    wells = ("quantity", "left well, or the device", "right well")
    return [
        (
            f"{document['name']}: {source}{NOT_USED if refused else ''}; ± half of the central 90 %, "
            "ring-downs of small motion",
            wells,
            [texts(row, lambda cell: cell.value) for row in sheet],
        ),
        (
            "measured in the logs, and in the model's free runs",
            wells,
            [texts(row, lambda cell: cell.seen) for row in sheet if any(cell.seen for cell in row.cells)],
        ),
        (
            "what acts along the training logs",
            ("element", "RMS force", "of the restoring force"),
            element_rows(document.get("elements", ())),
        ),
        (
            f"assessment: data {assessment['data']}, model {document['judged_model']} {assessment['model']}",
            ("about", "grade", "finding", "what to do"),
            checks,
        ),
    ]


def element_rows(elements: Sequence[Mapping[str, Any]]) -> Rows:
    """Element, RMS force and share of the restoring force; "absent" for an element that does not act."""
    return [
        (
            element["name"],
            quantity(element["force_rms"], element["unit"]) if element["force_rms"] else "absent",
            "–" if element["share"] is None or not element["force_rms"] else percent(element["share"]),
        )
        for element in elements
    ]


FactRows = list[tuple[str, str]]


@dataclass(frozen=True)
class Described:
    """A model: equations as terms between which a line may break, one table of facts, and long tables by title."""

    name: str
    equations: list[list[str]]
    rows: FactRows
    tables: list[tuple[str, FactRows]]


def described(
    name: str, description: Mapping[str, Any], displacement: str = "m", *, mass_known: bool = True
) -> Described:
    """The description of a model, as `DynamicModel.describe` returns it.

    A model calls its displacement a length, and its mass 1 kg if it has none: `displacement` is the true unit.

    Parameters
    ----------
    name : str
        Name of the model.
    description : mapping
        Its facts, with units in the keys.
    displacement : str
        SI unit of q.
    mass_known : bool
        True if the mass is more than 1 by convention.
    """
    facts = {key: value for key, value in description.items() if mass_known or key != "mass_kg"}
    stated = facts.pop("equations", ())
    equations = [terms(equation) for equation in ([stated] if isinstance(stated, str) else stated)]
    tables: list[tuple[str, FactRows]] = []
    fitted = [facts.pop(key, ()) for key in ("fitted", "values", "standard_errors")]
    if fitted[0]:
        tables.append(
            (
                "fitted",
                [_quantity_row(key, pair, displacement, fitted=True) for key, *pair in zip(*fitted, strict=False)],
            )
        )
    rows: FactRows = []
    for key, value in facts.items():
        fitted_part = key == "deviations"  # whose pairs are a value and its standard deviation
        if isinstance(value, Mapping) and len(value) > LONGEST_LIST:
            tables.append(
                (_words(key), [_quantity_row(k, v, displacement, fitted=fitted_part) for k, v in value.items()])
            )
        elif isinstance(value, Mapping):
            rows += [_quantity_row(f"{key}: {k}", v, displacement, fitted=fitted_part) for k, v in value.items()]
        else:
            rows.append(_quantity_row(key, value, displacement))
    return Described(name, equations, rows, tables)


def _words(key: str) -> str:
    return key.replace("_", " ")


def _quantity_row(key: str, value: Any, displacement: str, *, fitted: bool = False) -> tuple[str, str]:
    match = _UNIT_AT_END.match(key)
    name, unit = (match["name"], match["unit"] or match["suffix"].replace("_per_", "/")) if match else (key, "1")
    unit = {"m": displacement, "1/m": f"1/{displacement}"}.get(unit, unit)
    if isinstance(value, list | tuple) and len(value) == 2 and all(isinstance(number, float) for number in value):
        if fitted:
            return _words(name), quantity(value[0], unit, value[1])
        if name.endswith("end_stops"):  # the ends of a range; other pairs are lists
            return _words(name), _list(value, unit, " … ")
    return _words(name), _text(value, unit)


def _text(value: Any, unit: str) -> str:
    if isinstance(value, bool) or value is None:
        return {True: "yes", False: "no", None: "–"}[value]
    if isinstance(value, int):
        return quantity(float(value), unit) if unit != "1" else str(value).replace("-", "−")
    if isinstance(value, float):
        return quantity(value, unit)
    return _list(value, unit) if isinstance(value, list | tuple) else str(value)


def _list(values: Sequence[Any], unit: str, between: str = ", ") -> str:
    if not values:
        return "none"
    if any(isinstance(value, list | tuple) for value in values):
        if len(values) > 2:
            return f"{len(values)} × {len(values[0])} numbers, in the model's file"
        return "; ".join(_list(value, unit) for value in values)
    if len(values) > LONGEST_LIST:
        return f"{len(values)} numbers, in the model's file"
    if any(isinstance(value, str | bool) for value in values):
        return "; ".join(_text(value, "1") for value in values)
    shown, factor = scale(unit, max(abs(float(value)) for value in values))
    whole = all(isinstance(value, int) for value in values)
    texts = [str(value) if whole else significant(factor * float(value)) for value in values]
    return between.join(texts).replace("-", "−") + (f" {shown}" if shown != "1" else "")


def terms(equation: str) -> list[str]:
    """The parts of an equation between which a line may break."""
    raised = re.sub(r"\^(-?\d+)", lambda m: power(int(m[1])), equation)
    powers = re.sub(r"(\d)e([+-]\d+)", lambda m: f"{m[1]}·10{power(int(m[2]))}", raised)
    parts = [
        re.sub(r"^([+-])(?=\d)", lambda m: "+ " if m[1] == "+" else "− ", part)
        for part in re.split(r" (?=[+-]\d)", powers)
    ]
    if len(parts) == 1:
        return parts
    # The first term needs no plus, and stands beside the equals sign.
    first = parts[1].removeprefix("+ ").replace("− ", "−", 1)
    return [f"{parts[0]} {first}", *parts[2:]]
