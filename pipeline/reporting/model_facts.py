"""What a model says of itself, for people: units from the keys, fitted values with their standard deviations."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from pipeline.si_prefix import power, quantity, scale, significant

LONGEST_LIST = 12
_FITTED = ("deviations",)  # parts whose pairs are a value and its standard deviation
_ENDS = ("end_stops",)  # pairs that are the ends of a range; other pairs are lists
_UNIT_AT_END = re.compile(r"^(?P<name>.*?)(?: \[(?P<unit>[^\[\]]+)\]|_(?P<suffix>1_per_s|1_per_m|m|s|kg|V|Hz|N))$")

Rows = list[tuple[str, str]]


@dataclass(frozen=True)
class Described:
    """A model: equations as terms between which a line may break, one table of facts, and long tables by title."""

    name: str
    equations: list[list[str]]
    rows: Rows
    tables: list[tuple[str, Rows]]


def described(
    name: str, description: Mapping[str, Any], displacement: str = "m", *, mass_known: bool = True
) -> Described:
    """The description of a model; `DynamicModel.describe` tells what it may hold.

    A model calls its displacement a length, and its mass 1 kg if it has none: `displacement` is the true unit.
    """
    facts = {key: value for key, value in description.items() if mass_known or key != "mass_kg"}
    stated = facts.pop("equations", ())
    equations = [terms(equation) for equation in ([stated] if isinstance(stated, str) else stated)]
    tables: list[tuple[str, Rows]] = []
    fitted = [facts.pop(key, ()) for key in ("fitted", "values", "standard_errors")]
    if fitted[0]:
        pairs = zip(*fitted, strict=False)
        tables.append(("fitted", [_quantity_row(key, pair, displacement, fitted=True) for key, *pair in pairs]))
    rows: Rows = []
    for key, value in facts.items():
        if isinstance(value, Mapping) and len(value) > LONGEST_LIST:
            fitted_part = key in _FITTED
            tables.append(
                (_words(key), [_quantity_row(k, v, displacement, fitted=fitted_part) for k, v in value.items()])
            )
        elif isinstance(value, Mapping):
            fitted_part = key in _FITTED
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
        if name.endswith(_ENDS):
            return _words(name), _list(value, unit, " … ")
    return _words(name), _text(value, unit)


def _text(value: Any, unit: str) -> str:
    if isinstance(value, bool) or value is None:
        return {True: "yes", False: "no", None: "–"}[value]
    if isinstance(value, int):
        return quantity(float(value), unit) if unit != "1" else str(value).replace("-", "−")
    if isinstance(value, float):
        return quantity(value, unit)
    if isinstance(value, list | tuple):
        return _list(value, unit)
    return str(value)


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
    signed = re.split(r" (?=[+-]\d)", powers)
    parts = [re.sub(r"^([+-])(?=\d)", lambda m: "+ " if m[1] == "+" else "− ", part) for part in signed]
    if len(parts) == 1:
        return parts
    # The first term needs no plus, and stands beside the equals sign.
    first = parts[1].removeprefix("+ ").replace("− ", "−", 1)
    return [f"{parts[0]} {first}", *parts[2:]]
