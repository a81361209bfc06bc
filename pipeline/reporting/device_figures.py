"""The figures of the device: curves with bands (fig. 14), energy landscape, phase portrait with basins, studies."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from ..diagnostics.characteristics import COVERAGE, CurveEquilibrium, Curves, equilibria, outer_wells
from ..diagnostics.data_quality import centre_visits
from ..diagnostics.datasheet import Datasheet
from ..diagnostics.phase_plane import (
    BASIN_TIME,
    OUTCOMES,
    basin_map,
    unforced,
    visited_range,
)
from ..diagnostics.run_data import Columns, RunData
from ..numerics.arrays import BoolArray, FloatArray
from ..units.quantity import prefixed, quantity
from .datasheet_rows import NOT_USED
from .figure import Band, Cells, Figure, Line, Panel, Points
from .instrument_table import instruments_figure
from .log_figures import residual_figures
from .paper_figures import study_figure

_Measured = tuple[FloatArray, FloatArray] | None
_Wanted = tuple[str, str, tuple[float, float], Callable[[Curves], FloatArray | None], _Measured]
WIDEST = 4.0  # times the main model's own frame, up to which it is widened for other models; or to twice the main model
OUTER = 0.05  # share of a curve at either end that widens no frame
FRAME_MARGIN = 1.5  # a curve is cut where it leaves the main model's visited part by more than this factor
LEAST_DRAWN = 1.0  # samples, on the logarithmic axis
CEILING = 1.5  # the energy is drawn up to this multiple of its largest value in the visited range without input
_EQUILIBRIA = {True: "stable equilibrium", False: "unstable equilibrium"}


def device_figures(data: RunData, sheet: Datasheet) -> dict[str, Figure]:
    """The figures that models allow: curves and energy need characteristic curves, basins a model that simulates."""
    figures = {"excitation": _excitation(data)}
    if sheet.curves:
        figures["energy"] = _energy(data, sheet)
        figures["curves"] = _curves(data, sheet)
    others = {
        "phase-portrait": _phase_portrait(data, sheet),
        "instruments": instruments_figure(data.instruments),
        **residual_figures(data, sheet.wells),
        **{f"study-{study.name}": study_figure(study.name, study.columns, study.units) for study in data.studies},
    }
    return figures | {name: figure for name, figure in others.items() if figure is not None}


def _curves(data: RunData, sheet: Datasheet) -> Figure:
    panels = []
    outside = []
    for name, unit, visited, pick, measured in _wanted_curves(data, sheet):
        curves = _curves_of(sheet, pick)
        frame = _frame(curves, visited, widened=not data.device.joint)
        panels.append(_curve_panel(name, unit, curves, frame, measured))
        # Models whose curve is visible in less than half of the visited part.
        inside = {c.model: ((c.y >= frame[0]) & (c.y <= frame[1]))[c.inner(visited)] for c in curves}
        gone = [m for m, visible in inside.items() if not data.device.joint and np.mean(visible) < 0.5]
        outside += [f"{name} of {', '.join(gone)}"] if gone else []
    band = (
        f" Bands: central {prefixed(COVERAGE, '%', 0)} % of what the training data leave open." if sheet.draws else ""
    )
    per_mass = "" if data.device.known_mass is not None else " Per unit mass, as no mass is given."
    cut = (
        "where hardly any sample lies and a curve runs away" if data.device.joint else "where a curve leaves the frame"
    )
    hidden = f" Mostly outside the frame: {'; '.join(outside)}." if outside else ""
    circles = " Circles: measured." if data.measured_curves else ""
    return Figure(
        "curves",
        "Characteristic curves",
        caption=f"Over the range of the training data; cut {cut}.{band}{per_mass}{hidden}{circles}",
        x_name="q",
        x_unit=data.device.displacement.symbol,
        panels=tuple(panels),
        columns=2,
    )


def _wanted_curves(data: RunData, sheet: Datasheet) -> Iterator[_Wanted]:
    """Force, damping as far as the main model has one, and the gain of each input."""
    first = next(iter(sheet.curves.values()))
    plant = data.device
    units = plant.curve_units
    measured = data.measured_curves
    # of a squared voltage on a known mass the gain is half the slope of a capacitance
    electrostatic = plant.squared and plant.inputs[0].symbol == "V" and plant.known_mass is not None
    factor, symbol, unit = (2.0, "∂C{}/∂q", units["dC"]) if electrostatic else (1.0, "g{}", units["g"])
    visited = visited_range(data)
    yield "restoring force F", units["F"], visited, lambda c: c.force, _on(measured, "F")
    if first.damping is not None:
        yield "damping d", units["d"], visited, lambda c: c.damping, _on(measured, "d")
    for k in range(len(first.gains)):
        yield (
            symbol.format("₁₂"[k]),
            unit,
            visited_range(data, k),
            partial(_gain, k=k, factor=factor),
            _on(measured, f"dC{k + 1}_dq") if electrostatic else None,
        )


def _on(measured: Columns, name: str) -> tuple[FloatArray, FloatArray] | None:
    """Places and values of a measured curve."""
    return (measured["q"], measured[name]) if name in measured else None


def _gain(curves: Curves, k: int, factor: float) -> FloatArray:
    return np.asarray(factor * curves.gains[k])


class _Curve(NamedTuple):
    """A model's curve y over q and the limits of its band, which are y itself without one."""

    model: str
    q: FloatArray
    y: FloatArray
    low: FloatArray
    high: FloatArray

    def inner(self, visited: tuple[float, float]) -> BoolArray:
        """The places in the visited part."""
        return np.asarray((self.q >= visited[0]) & (self.q <= visited[1]))


def _curves_of(sheet: Datasheet, pick: Callable[[Curves], FloatArray | None]) -> list[_Curve]:
    chosen = []
    for model, curves in sheet.curves.items():
        if (y := pick(curves)) is None:
            continue
        drawn = [c for draw in sheet.draws.get(model, ()) if (c := pick(draw)) is not None]
        low, high = np.quantile(drawn, [(1 - COVERAGE) / 2, (1 + COVERAGE) / 2], axis=0) if drawn else (y, y)
        chosen.append(_Curve(model, curves.q, y, low, high))
    return chosen


def _frame(curves: Sequence[_Curve], visited: tuple[float, float], *, widened: bool) -> tuple[float, float]:
    """Limits of the vertical axis: the visited part of the main model's band and a margin.

    They are `widened` by the central part of every other curve that is not too far away for the main model to be read.
    """
    inner = curves[0].inner(visited)
    bottom = float(curves[0].low[inner].min())
    top = float(curves[0].high[inner].max())
    middle = (bottom + top) / 2
    half = FRAME_MARGIN * (top - bottom) / 2
    frame = (middle - half, middle + half)
    room = max(WIDEST * half, abs(middle))
    for curve in curves[1:] if widened else ():
        low, high = np.nanquantile(curve.y[curve.inner(visited)], [OUTER, 1.0 - OUTER])
        if middle - room <= low and high <= middle + room:
            frame = (min(frame[0], low - 0.1 * half), max(frame[1], high + 0.1 * half))
    return frame


def _curve_panel(
    name: str,
    unit: str,
    curves: Sequence[_Curve],
    frame: tuple[float, float],
    measured: tuple[FloatArray, FloatArray] | None,
) -> Panel:
    lines = []
    bands = []
    rows = slice(None, None, 6)
    for model, q, y, low, high in curves:
        if low is not y:
            visible = (low[rows] < frame[1]) & (high[rows] > frame[0])
            limits = np.where(visible, np.clip([low[rows], high[rows]], *frame), np.nan)
            bands.append(Band(f"{model}, {prefixed(COVERAGE, '%', 0)} % band", model, q[rows], limits[0], limits[1]))
        inside = np.where((y >= frame[0]) & (y <= frame[1]), y, np.nan)
        lines.append(Line(model, model, q[rows], inside[rows]))
    circles = []
    if measured is not None:
        q, y = measured
        visible = (q >= lines[0].x[0]) & (q <= lines[0].x[-1]) & (y >= frame[0]) & (y <= frame[1])
        circles.append(Points("measured", "measured", q[visible], y[visible], "ring"))
    # The main model is drawn last, over its baselines.
    return Panel(name, unit, (*lines[1:], *lines[:1]), tuple(bands), tuple(circles))


def _energy(data: RunData, sheet: Datasheet) -> Figure:
    name, curves = next(iter(sheet.curves.items()))
    largest = np.max([data.device.peaks(log.motion.v) for log in data.logs], axis=0)
    roles = ("measured", "v1", "v2")
    cases = [
        (f"no {data.device.input_word}", np.zeros(len(curves.gains))),
        *(
            (f"v{k + 1} = {quantity(float(largest[k]), data.device.inputs[0].symbol)}", np.eye(len(curves.gains))[k])
            for k in range(len(curves.gains))
        ),
    ]
    lines = []
    points = list[Points]()
    ceiling = 0.0
    rows = slice(None, None, 4)
    low, high = visited_range(data)
    inner = (curves.q >= low) & (curves.q <= high)
    for role, (label, on) in zip(roles, cases, strict=False):
        u = on * data.device.acting(largest)
        loaded = Curves(curves.q, curves.force - u @ curves.gains, None, curves.gains)
        energy = loaded.energy
        ceiling = ceiling or CEILING * float(energy[inner].max())
        lines.append(Line(label, role, curves.q[rows], np.where(energy <= ceiling, energy, np.nan)[rows]))
        rest = [e for e in equilibria(loaded.q, loaded.force) if np.interp(e.q, loaded.q, energy) <= ceiling]
        points += _marked(rest, role, loaded.q, energy)
    source = f"{name}{NOT_USED}" if sheet.refused and name == sheet.model else name
    return Figure(
        "energy",
        "Energy landscape",
        caption=f"Potential of {source} without input and with each input alone, counted from its lowest point.",
        x_name="q",
        x_unit=data.device.displacement.symbol,
        panels=(Panel("energy U", data.device.energy_unit, tuple(lines), points=tuple(points)),),
        half=True,
    )


def _marked(
    places_of_rest: Sequence[CurveEquilibrium], role: str, q: FloatArray, heights: FloatArray
) -> Iterator[Points]:
    """Equilibria on a curve over q: dots where stable, rings where not."""
    for marker, kind in (("dot", True), ("ring", False)):
        if (places := np.array([e.q for e in places_of_rest if e.stable is kind])).size:
            yield Points(_EQUILIBRIA[kind], role, places, np.interp(places, q, heights), marker)  # type: ignore[arg-type]


def _phase_portrait(data: RunData, sheet: Datasheet) -> Figure | None:
    """Motion without input over the basins of two wells; None for a device or a model without them."""
    if sheet.model is None or (wells := outer_wells(sheet.curves[sheet.model], plant=data.device)) is None:
        return None
    curves = sheet.curves[sheet.model]
    unit = data.device.displacement.symbol
    word = data.device.input_word
    return Figure(
        "phase-portrait",
        "Phase portrait and basins",
        caption=(
            f"Measured motion while no {word} is on, over the basins of {sheet.model} without {word}: from each cell "
            f"the model was released and simulated for {BASIN_TIME:g} s."
        ),
        x_name="q",
        x_unit=unit,
        panels=(
            Panel(
                "q̇",
                f"{unit}/s",
                tuple(
                    Line(log.title, "measured" if log.role == "train" else "raw", *unforced(data, log))
                    for log in (*data.role("validation"), *data.role("train"))
                ),
                points=tuple(_marked(equilibria(curves.q, curves.force), "v2", np.zeros(1), np.zeros(1))),
                cells=Cells(OUTCOMES, *basin_map(data, data.models[sheet.model], wells[1].q)),
            ),
        ),
        tall=1.5,
    )


def _excitation(data: RunData) -> Figure:
    places, counts = centre_visits(data)
    half = float(places[1] - places[0]) / 2.0
    x: FloatArray = np.repeat(np.concatenate(([places[0] - half], places + half)), 2)[1:-1]
    heights = np.repeat(np.maximum(counts, LEAST_DRAWN), 2)
    return Figure(
        "excitation",
        "Where the device was seen",
        caption=f"Training samples nearest to each of {len(places)} basis centres; where they are few, curves are "
        "uncertain.",
        x_name="q",
        x_unit=data.device.displacement.symbol,
        panels=(
            Panel(
                "samples per centre",
                "1",
                (Line("training samples", "reference", x, heights),),
                (Band("training samples", "reference", x, np.full(x.size, LEAST_DRAWN), heights),),
                log=True,
            ),
        ),
        half=True,
    )
