"""Equations as models state them, set for reading: powers raised, terms apart, so that lines break between terms."""

import re

_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def terms(equation: str) -> list[str]:
    """The parts of an equation between which a line may break."""
    raised = re.sub(r"\^(-?\d+)", lambda m: m[1].translate(_RAISED), equation)
    powers = re.sub(r"(\d)e([+-]\d+)", lambda m: f"{m[1]}·10{str(int(m[2])).translate(_RAISED)}", raised)
    signed = re.split(r" (?=[+-]\d)", powers)
    parts = [re.sub(r"^([+-])(?=\d)", lambda m: "+ " if m[1] == "+" else "− ", part) for part in signed]
    if len(parts) == 1:
        return parts
    # The first term needs no plus, and stands beside the equals sign.
    first = parts[1].removeprefix("+ ").replace("− ", "−", 1)
    return [f"{parts[0]} {first}", *parts[2:]]
