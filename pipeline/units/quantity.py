"""Numbers for readers: SI prefixes on axes and in tables, values to the digits that their uncertainty allows."""

import math
import re

# Angles are read in degrees, and what begins with one; kg and other compound units keep their own.
_ANGLE = re.compile(r"rad(²?)(?=[/·]|$)(?!.*rad)")
_PREFIXES = {-12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
_POWERS = {prefix: power for power, prefix in _PREFIXES.items()} | {"%": -2}
_LONG_AGO = 1e5
"""Seconds of a clock from which on stamps are written to the millisecond: it counts from a day or an epoch long ago."""
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
SHORT = (0.01, 1e5)  # largest numbers along an axis that are written as they are
_PLAIN = (-4, 5)  # powers of ten from and below which a number is written without one
WHOLE = 1e3  # whole numbers below it are written as they are, whatever their uncertainty
LOST = 100.0  # times a value, beyond which the spread about it decides the prefix
MOST_BEFORE_POINT = 4  # digits of a number without uncertainty that are not zero, where it has no decimals
_PREFIXED = re.compile(r"(m|V|N|J|F|s|Hz|A|Pa|W)(?=[/ ·]|$)")


def scale(unit: str, largest: float) -> tuple[str, float]:
    """The unit with a prefix that suits numbers up to `largest`, and the factor from SI to it.

    Parameters
    ----------
    unit : str
        An SI unit, such as ``m/s²`` or ``N s/m``; the prefix goes to its first symbol.
    largest : float
        Largest magnitude to be shown, in SI.
    """
    angle = _ANGLE.match(unit)
    factor = 1.0 if angle is None else (180.0 / math.pi) ** (2 if angle[1] else 1)
    unit = unit if angle is None else f"°{unit.removeprefix('rad')}"  # such as °/(s²·V) or °²/Hz
    magnitude = abs(largest) * factor
    if not _PREFIXED.match(unit) or magnitude == 0.0 or not math.isfinite(magnitude):
        return unit, factor
    # 0.5 rather than 1: 0.8 mm reads better than 800 µm on an axis.
    power = min(9, max(-12, 3 * math.floor(math.log10(magnitude / 0.5) / 3.0)))
    return _PREFIXES[power] + unit, factor * 10.0**-power


def axis_scale(unit: str, largest: float) -> tuple[str, float]:
    """Scale as by `scale`; where no prefix fits, such as to 1/V², a power of ten keeps the labels of an axis short."""
    shown, factor = scale(unit, largest)
    magnitude = abs(largest) * factor
    if SHORT[0] <= magnitude < SHORT[1] or magnitude == 0.0 or not math.isfinite(magnitude):
        return shown, factor
    exponent = 3 * math.floor(math.log10(magnitude) / 3.0)
    ten = f"10{power(exponent)}"
    return (ten if unit in ("", "1") else f"{ten} {shown}"), factor * 10.0**-exponent


def quantity(value: float | None, unit: str, spread: float | None = None, like: float = 0.0) -> str:
    """A value with its unit, and with ± where `spread` is known; a dash for None.

    `like` is a magnitude [SI] with which the value shares prefix and decimals: 20 nm reads 0.00 mm beside 12.3 mm.

    Parameters
    ----------
    value : float or None
        Value in SI.
    unit : str
        Its SI unit.
    spread : float, optional
        Half width of its interval, in SI.
    like : float
        Magnitude [SI] whose prefix and decimals it takes.
    """
    if value is None or not math.isfinite(value):
        return "–"
    size = max(abs(value), abs(like))
    spread = None if spread is None or not math.isfinite(spread) or spread <= 0.0 else spread
    shown, factor = scale(unit, spread if spread is not None and spread > LOST * size else size)
    number = value * factor
    if spread is None and abs(value) < abs(like):  # to three digits of the larger one
        text = rounded(number, 2 - _decade(like * factor), abs(like) * factor)
    elif spread is None:
        text = significant(number)
    else:
        width = spread * factor
        # Two digits of the uncertainty, and the value to the same place, but no more than five digits of the value.
        largest = max(abs(number), width, abs(like) * factor)
        places = min(1 - _decade(width), 4 - _decade(largest))
        text = rounded(number, places, largest)
        text += f" ± {rounded(width, places, largest)}" if round(width, places) > 0.0 else ""
    return f"{text} {shown}".replace("-", "−").strip() if shown != "1" else text.replace("-", "−")


def _decade(number: float) -> int:
    return math.floor(math.log10(abs(number)))


def rounded(number: float, places: int, largest: float) -> str:
    """A number to `places` decimals (negative: before the point), with the power of ten of `largest`.

    That is left out from 1e-4 to 1e5, so that numbers written beside one another have one power: 9.24·10⁵ ± 0.32·10⁵.
    """
    decade = _decade(largest) if largest > 0.0 else 0
    places = max(0, places) if largest < WHOLE else places
    if _PLAIN[0] <= decade < _PLAIN[1]:
        return f"{round(number, places):z.{max(0, places)}f}"
    return f"{number / 10.0**decade:z.{max(0, places + decade)}f}·10{power(decade)}"


def significant(number: float, digits: int = 3) -> str:
    """A number to `digits` significant digits, without an exponent between 1e-4 and 1e5; there a whole one to four."""
    if number == 0.0 or not math.isfinite(number):
        return "0" if number == 0.0 else "–"
    decade = _decade(number)
    if not _PLAIN[0] <= decade < _PLAIN[1]:
        mantissa, _, exponent = f"{number:.{digits - 1}e}".partition("e")
        raised = f"10{power(int(exponent))}"
        return raised if mantissa == "1" else f"{mantissa}·{raised}"
    return rounded(number, max(digits - 1 - decade, min(0, MOST_BEFORE_POINT - 1 - decade)), abs(number))


def short(number: float, digits: int = 3) -> str:
    """A number without the zeros at its end, to `digits` significant digits, as `significant` beyond those."""
    text = f"{number:.{digits}g}"
    return significant(number, digits) if "e" in text else text


def moment(seconds: float) -> str:
    """A time after the start of a record: to 10 ms, earlier ones and later ones to three and four digits."""
    if 0.1 <= seconds < 1000.0:
        return f"{seconds:.2f} s"
    return f"{significant(seconds, 4)} s" if seconds > 1.0 else quantity(seconds, "s")


def power(exponent: int) -> str:
    """A raised exponent."""
    return str(exponent).translate(_RAISED)


def grouped(number: int) -> str:
    """A whole number with narrow spaces between thousands."""
    return f"{number:,}".replace(",", "\u202f")


def interval(value: float | None, low: float, high: float, unit: str) -> tuple[str, str]:
    """A value and the limits of its interval in one unit.

    Two digits of half the interval are shown, but no more than five of the numbers.

    Parameters
    ----------
    value : float or None
        Value in SI.
    low, high : float
        Ends of its interval, in SI.
    unit : str
        Their SI unit.
    """
    largest = max(abs(low), abs(high), abs(value or 0.0))
    shown, factor = scale(unit, largest)
    half = (high - low) / 2.0 * factor
    if not (math.isfinite(half) and half > 0.0):
        return quantity(value, unit), f"{quantity(low, unit)} … {quantity(high, unit)}"
    places = min(1 - _decade(half), 4 - _decade(largest * factor))
    texts = [
        "–" if v is None else rounded(v * factor, places, largest * factor).replace("-", "−")
        for v in (value, low, high)
    ]
    end = "" if shown == "1" else f" {shown}"
    return texts[0] + (end if value is not None else ""), f"{texts[1]} … {texts[2]}{end}"


def percent(fraction: float | None) -> str:
    """A fraction in percent, to three digits but no more than two after the point; a dash where undefined."""
    if fraction is None or not math.isfinite(fraction):
        return "–"
    places = 2 if abs(fraction) < 0.0995 else 1 if fraction != 1.0 else 0
    return f"{100.0 * fraction:.{places}f} %"


def prefixed(value: float | None, prefix: str, digits: int, none: str = "–") -> str:
    """A value in units with an SI prefix, or as a percentage, with so many decimals; what stands for none else.

    Parameters
    ----------
    value : float or None
        In SI.
    prefix : str
        As ``m`` of mm, or ``%``; empty for the unit itself.
    digits : int
        Decimals.
    none : str
        Text where there is no value.
    """
    return none if value is None else f"{value * 10.0 ** -_POWERS[prefix]:z.{digits}f}"


def stamped(stamp: float) -> str:
    """A time stamp [s] without its unit, to the nanosecond; to the millisecond where the clock has run for long."""
    return f"{stamp:.3f}" if abs(stamp) >= _LONG_AGO else f"{round(stamp, 9) + 0.0:.6g}"


def counted(number: int, thing: str) -> str:
    """A number of things."""
    return f"{number} {thing}{'' if number == 1 else 's'}"
