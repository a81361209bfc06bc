"""One self-contained page: templates, style and scripts put together under a strict content-security policy.

Everything that comes from logs and settings is data: Jinja2 escapes it in the markup, and `json_for_script` in the one
data block, which no browser executes. Scripts and styles are allowed by their hashes alone; the page can load nothing.
"""

import base64
import hashlib
import json
import zlib
from collections.abc import Callable, Collection, Mapping, Sequence
from importlib.resources import files
from typing import Any

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from ..numerics.arrays import FloatArray
from ..system.package import full_name
from ..units.quantity import axis_scale
from .figure import MARKS, Figure, Line, Panel, axis_label, extreme_places, slot, slot_dashes

_ASSETS = files(full_name("reporting")) / "assets"
_DASHES = {"mark": [], "snap": [4, 3]}  # of upright lines, by their kind
LEVELS = 65534  # codes 0 … 65534; 65535 stands for no sample
MISSING = LEVELS + 1
DEFLATION = 6  # of deflate; 9 takes ten times as long and saves 0.5 %
LONGEST = 60_000  # samples a series may have before it is stored by the extremes of its buckets


def packed(y: FloatArray, longest: int = LONGEST) -> dict[str, Any]:
    """A series as JSON values.

    Parameters
    ----------
    y : FloatArray, shape (N,)
        Samples at equal steps; NaN where there is none.
    longest : int
        Number of samples beyond which the least and the largest of every bucket are kept instead.

    Returns
    -------
    dict
        ``n`` samples, ``low`` and ``step`` of the quantisation, and ``data``.
    """
    y = y if y.size <= longest else y[extreme_places(y, -(-2 * y.size // longest))]
    finite = np.isfinite(y)
    low, high = (float(y[finite].min()), float(y[finite].max())) if finite.any() else (0.0, 0.0)
    step = (high - low) / LEVELS or 1.0
    codes = np.full(y.size, MISSING, dtype=np.int64)
    codes[finite] = np.rint((y[finite] - low) / step)
    change = np.diff(codes, prepend=0) % 65536
    planes = np.concatenate((change & 255, change >> 8)).astype(np.uint8)
    # For repetitions or for noise, whichever is shorter.
    packers = [
        zlib.compressobj(level=DEFLATION, strategy=strategy) for strategy in (zlib.Z_DEFAULT_STRATEGY, zlib.Z_FILTERED)
    ]
    deflated = min((packer.compress(planes.tobytes()) + packer.flush() for packer in packers), key=len)
    return {"n": int(y.size), "low": low, "step": step, "data": base64.b64encode(deflated).decode("ascii")}


def render(template: str, scripts: Sequence[str], context: Mapping[str, Any]) -> str:
    """Fill a template of the assets folder.

    Parameters
    ----------
    template : str
        Its file name.
    scripts : sequence of str
        Script files to put in, in this order.
    context : mapping
        Names for the template; text is escaped, `Markup` is not.
    """
    environment = Environment(
        loader=PackageLoader(full_name("reporting"), "assets"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters |= {"limit": lambda number: f"{number:g}", "commands": _commands}
    plotted = "uplot.min.js" in scripts
    style = (asset("uplot.min.css") if plotted else "") + asset("style.css")
    licence = f"/*! {asset('uplot.LICENSE.txt')} */\n" if plotted else ""
    script = licence + "\n".join(asset(name) for name in scripts)
    policy = (
        f"default-src 'none'; script-src '{csp_hash(script)}'; style-src '{csp_hash(style)}'; img-src data:; "
        "base-uri 'none'; form-action 'none'"
    )
    return (
        environment.get_template(template).render(
            context,
            policy=policy,
            style=Markup(style),  # noqa: S704 - files of this package, no input
            script=Markup(script),  # noqa: S704 - likewise
        )
        + "\n"
    )


def _commands(text: str) -> Markup:
    """Text whose parts between backticks are code."""
    code = Markup("<code>{}</code>")
    return Markup("").join(code.format(part) if i % 2 else part for i, part in enumerate(text.split("`")))


def asset(name: str) -> str:
    """The text of an asset."""
    return (_ASSETS / name).read_text(encoding="utf-8")


def csp_hash(text: str) -> str:
    """The source expression that allows exactly this inline text (CSP level 3, § 6.7.2)."""
    return f"sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}"


def json_for_script(document: Any) -> Markup:
    """JSON for a script element that is not executed: no character of it can end the element or open a comment."""
    text = json.dumps(document, ensure_ascii=True, allow_nan=False, separators=(",", ":"))
    # Nothing in it can be markup any more.
    return Markup(text.replace("&", "\\u0026").replace("<", "\\u003c").replace(">", "\\u003e"))  # noqa: S704


def viewer_data(figures: Sequence[Figure], models: Sequence[str]) -> dict[str, Any]:
    """Data of the viewer's script: figures, and every distinct series once, in SI."""
    series: dict[str, Any] = {}
    names: dict[bytes, str] = {}

    def store(values: FloatArray) -> str:
        """The name under which a series is stored."""
        if (content := hashlib.blake2b(values.tobytes()).digest()) not in names:
            names[content] = f"s{len(names)}"
            series[names[content]] = packed(values)
        return names[content]

    return {"figures": {f.name: _viewer_figure(f, models, store) for f in figures}, "packed": series}


def _viewer_figure(figure: Figure, models: Sequence[str], store: Callable[[FloatArray], str]) -> dict[str, Any]:
    first = figure.panels[0].lines[0].x
    return {
        "axis": f"{figure.x_name} in {figure.x_unit}",
        "unit": figure.x_unit,
        "start": float(first[0]),
        "stop": float(first[-1]),
        "panels": [_viewer_panel(panel, figure.hidden, models, store) for panel in figure.panels],
        "marks": [
            {"name": name, "at": [round(float(t), 6) for t in at], "colour": kind, "dash": _DASHES[kind]}
            for name, at in figure.marks.items()
            if (kind := MARKS[name].kind)
        ],
        "gaps": [list(gap) for gap in figure.gaps],
    }


def _viewer_panel(
    panel: Panel, hidden: Collection[str], models: Sequence[str], store: Callable[[FloatArray], str]
) -> dict[str, Any]:
    """A panel whose lines share one time grid."""
    visible = [line for line in panel.lines if line.label not in hidden]
    largest = max((abs(float(v)) for line in visible for v in _ends(line.y)), default=0.0)
    unit, factor = axis_scale(panel.unit, largest)
    lines = [
        {
            "label": line.label,
            "slot": slot(line.role, models),
            "dash": list(slot_dashes(slot(line.role, models))),
            "wide": line.wide,
            "factor": factor,
            **_stored(line, store),
        }
        for line in panel.lines
    ]
    bands = [
        {
            "label": band.label,
            "slot": slot(band.role, models),
            "factor": factor,
            "low": store(band.low),
            "high": store(band.high),
        }
        for band in panel.bands
    ]
    x = panel.lines[0].x
    return {
        "label": axis_label(panel.name, unit),
        "start": float(x[0]),
        "stop": float(x[-1]),
        "low": panel.low,
        "limits": None if panel.y_limits is None else [end * factor for end in panel.y_limits],
        "series": lines,
        "bands": bands,
    }


def _stored(line: Line, store: Callable[[FloatArray], str]) -> dict[str, str]:
    # The extremes of a difference do not follow from those of its parts.
    if line.parts is None or line.y.size > LONGEST:
        return {"data": store(line.y)}
    return {"data": store(line.parts[0]), "minus": store(line.parts[1])}


def _ends(values: Any) -> list[float]:
    finite = values[values == values]  # without NaN
    return [float(finite.min()), float(finite.max())] if finite.size else []
