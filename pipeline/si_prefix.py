"""Numbers for people: SI prefixes on axes and in tables, values to the digits that their uncertainty allows."""

import math

# Angles are read in degrees; kg and compound units keep their own.
_TO_SHOWN = {"rad": ("°", 180.0 / math.pi), "rad/s": ("°/s", 180.0 / math.pi), "rad/s²": ("°/s²", 180.0 / math.pi)}
_PREFIXES = {-12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
SHORT = (0.01, 1e5)  # largest numbers along an axis that are written as they are
_PREFIXED = ("m", "V", "N", "J", "F", "s", "Hz", "A", "Pa", "W")


def scale(unit: str, largest: float) -> tuple[str, float]:
    """The unit with a prefix that suits numbers up to `largest`, and the factor from SI to it.

    Parameters
    ----------
    unit : str
        An SI unit, such as ``m/s²`` or ``N s/m``; the prefix goes to its first symbol.
    largest : float
        Largest magnitude to be shown, in SI.
    """
    unit, factor = _TO_SHOWN.get(unit, (unit, 1.0))
    head = next((p for p in sorted(_PREFIXED, key=len, reverse=True) if _starts(unit, p)), None)
    magnitude = abs(largest) * factor
    if head is None or magnitude == 0.0 or not math.isfinite(magnitude):
        return unit, factor
    # 0.5 rather than 1: 0.8 mm reads better than 800 µm on an axis.
    power = 3 * math.floor(math.log10(magnitude / 0.5) / 3.0)
    power = min(9, max(-12, power))
    return _PREFIXES[power] + unit, factor * 10.0**-power


def axis_scale(unit: str, largest: float) -> tuple[str, float]:
    """As `scale`; where no prefix fits, such as to 1/V², a power of ten keeps the labels of an axis short."""
    shown, factor = scale(unit, largest)
    magnitude = abs(largest) * factor
    if SHORT[0] <= magnitude < SHORT[1] or magnitude == 0.0 or not math.isfinite(magnitude):
        return shown, factor
    exponent = 3 * math.floor(math.log10(magnitude) / 3.0)
    ten = f"10{power(exponent)}"
    return (ten if unit in ("", "1") else f"{ten} {shown}"), factor * 10.0**-exponent


def _starts(unit: str, symbol: str) -> bool:
    rest = unit[len(symbol) :]
    return unit.startswith(symbol) and (not rest or rest[0] in "/ ·")


def quantity(value: float | None, unit: str, spread: float | None = None, like: float = 0.0) -> str:
    """A value with its unit, and with ± where `spread` is known; a dash for None.

    `like` is a magnitude [SI] with which the value shares prefix and decimals: 20 nm reads 0.00 mm beside 12.3 mm.
    """
    if value is None or not math.isfinite(value):
        return "–"
    shown, factor = scale(unit, max(abs(value), abs(like)))
    number = value * factor
    if spread is None or not math.isfinite(spread) or spread <= 0.0:
        places = max(0, 2 - math.floor(math.log10(abs(like) * factor))) if like else 0
        text = f"{number:z.{places}f}" if abs(value) < abs(like) else significant(number)
    else:
        width = spread * factor
        # Two digits of the uncertainty, and the value to the same place, but no more than five digits of the value.
        places = max(0, 1 - math.floor(math.log10(width)))
        largest = max(abs(number), width, abs(like) * factor)
        places = min(places, max(0, 4 - math.floor(math.log10(largest))))
        text = f"{number:z.{places}f}"
        text += f" ± {width:.{places}f}" if round(width, places) > 0.0 else ""
    return f"{text} {shown}".replace("-", "−").strip() if shown != "1" else text.replace("-", "−")


def significant(number: float, digits: int = 3) -> str:
    """A number to `digits` significant digits, without an exponent between 1e-4 and 1e6."""
    if number == 0.0 or not math.isfinite(number):
        return "0" if number == 0.0 else "–"
    power = math.floor(math.log10(abs(number)))
    if not -4 <= power < 6:
        mantissa, _, exponent = f"{number:.{digits - 1}e}".partition("e")
        raised = f"10{str(int(exponent)).translate(_RAISED)}"
        return raised if mantissa == "1" else f"{mantissa}·{raised}"
    return f"{number:.{max(0, digits - 1 - power)}f}"


def power(exponent: int) -> str:
    """A raised exponent."""
    return str(exponent).translate(_RAISED)


def grouped(number: int) -> str:
    """A whole number with narrow spaces between thousands."""
    return f"{number:,}".replace(",", "\u202f")


def interval(value: float | None, low: float, high: float, unit: str, like: float = 0.0) -> tuple[str, str]:
    """A value and the limits of its interval in one unit, that of `like` if it is larger.

    Two digits of half the interval are shown, but no more than five of the numbers.
    """
    largest = max(abs(low), abs(high), abs(value or 0.0), abs(like))
    shown, factor = scale(unit, largest)
    half = (high - low) / 2.0 * factor
    if not (math.isfinite(half) and half > 0.0):
        return quantity(value, unit), f"{quantity(low, unit)} … {quantity(high, unit)}"
    places = max(0, min(1 - math.floor(math.log10(half)), 4 - math.floor(math.log10(largest * factor))))
    texts = ["–" if v is None else f"{v * factor:z.{places}f}".replace("-", "−") for v in (value, low, high)]
    end = "" if shown == "1" else f" {shown}"
    return texts[0] + (end if value is not None else ""), f"{texts[1]} … {texts[2]}{end}"


def percent(fraction: float | None) -> str:
    """A fraction in percent, to three digits but no more than two after the point; a dash where undefined."""
    if fraction is None or not math.isfinite(fraction):
        return "–"
    places = 2 if abs(fraction) < 0.0995 else 1 if fraction != 1.0 else 0
    return f"{100.0 * fraction:.{places}f} %"
