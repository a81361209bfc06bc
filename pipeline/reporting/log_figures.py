"""The figures of one log along its time: signals, derivatives, models, residuals (figs. 11–13, 15)."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..diagnostics.events import input_steps, voltage_switches
from ..diagnostics.residual_analysis import Residual, main_residual
from ..diagnostics.run_data import LogData, RunData, judged_log
from ..numerics.arrays import BoolArray, FloatArray, runs_of, sample_interval
from ..scoring.scores import fit_note
from ..scoring.wells import NoWells, Wells, snaps
from ..signals.log import UNKNOWN, unknown_rows
from ..units.quantity import grouped, moment, power, prefixed, quantity, significant
from ..units.units import ALPHA_UNIT, signal_units
from .figure import MARGIN, Band, Figure, Line, Panel
from .tables import HEADINGS

METHODS = {"tvregdiff": "TVRegDiff", "savitzky-golay": "Savitzky–Golay filter"}
BASELINES_SHOWN = 2
LOG_FIGURES = ("signals", "derivatives", "models", "residuals")
TUBE = "90 % tube"


def log_figures(data: RunData, log: LogData, wells: Wells | NoWells) -> dict[str, Figure]:
    """The figures of a log by kind, in the order of `LOG_FIGURES`."""
    return {
        "signals": _signals(data, log, wells),
        "derivatives": _derivatives(data, log, wells),
        "models": _models(data, log, wells),
        "residuals": _residuals(data, log, wells),
    }


def _timeline(
    data: RunData, log: LogData, wells: Wells | NoWells, kind: str, title: str, caption: str, panels: list[Panel]
) -> Figure:
    t = log.motion.t
    switched = {"voltage switched": voltage_switches(t, log.motion.v)} if data.device.joint else {}
    marks = switched or {f"{data.device.input_word} steps": input_steps(t, log.motion.v)}
    marks["device snaps over"] = t[snaps(log.motion.q, wells)]
    places = {name: at[~_unknown(log, at)] for name, at in marks.items()}
    return Figure(
        name=f"{log.key}-{kind}",
        title=f"{title}, {log.title}",
        caption=caption,
        x_name="time",
        x_unit="s",
        panels=tuple(panels),
        marks={name: at for name, at in places.items() if at.size},
        gaps=_masked(log.record["t"], log.record["segment"]),
        hidden=_hidden(data, log),
    )


def _unknown(log: LogData, t: FloatArray) -> BoolArray:
    """Mask of the times at which the inputs of a log are not known."""
    return unknown_rows(t, log.record_notes.get(UNKNOWN, ()))


def _hidden(data: RunData, log: LogData) -> tuple[str, ...]:
    """Models that are hidden at first: diverged ones, which leave every frame, and all baselines but the best two."""
    judged = "validation" if data.role("validation") else "train"
    errors: dict[str, list[float]] = {}
    for s in data.scores:
        if s["signal"] == "q" and s["role"] == judged:
            errors.setdefault(s["model"], []).append(np.inf if s["nrmse"] is None else float(s["nrmse"]))
    main_model, *baselines = data.model_names
    best = sorted(baselines, key=lambda name: max(errors.get(name, [np.inf])))[:BASELINES_SHOWN]
    shown = {m for m in (main_model, *best) if m in log.outcomes and log.outcomes[m]["status"] == "ok"}
    return tuple(name for name in log.predictions if name not in shown) if shown else ()


def _masked(t: FloatArray, segment: FloatArray) -> tuple[tuple[float, float], ...]:
    return tuple((float(t[rows.start]), float(t[min(rows.stop, len(t) - 1)])) for rows in runs_of(segment < 0))


def _signals(data: RunData, log: LogData, wells: Wells | NoWells) -> Figure:
    t = log.record["t"]
    panels = [
        Panel("q", data.device.displacement.symbol, (Line("q measured", "measured", t, log.record["q"]),)),
        _inputs(data, log),
    ]
    notes = log.record_notes
    raw = (
        f" (the raw log has {grouped(notes['raw_rows'])} rows, one every {quantity(notes['raw_step'], 's')})"
        if "raw_rows" in notes
        else ""
    )
    shaded = " Shaded: masked rows." if _masked(t, log.record["segment"]) else ""
    return _timeline(
        data,
        log,
        wells,
        kind="signals",
        title="Measured signals",
        caption=f"Cleaned record; the zoom ends at its samples, {quantity(sample_interval(t), 's')} apart{raw}."
        f"{shaded}",
        panels=panels,
    )


def _inputs(data: RunData, log: LogData, *, low: bool = False) -> Panel:
    """The inputs over time, without segments in which they are not known."""
    t = log.record["t"]
    sides = {"v1": " (left)", "v2": " (right)"} if data.device.joint else {}
    recorded = {
        name: np.where(_unknown(log, t), np.nan, log.record[name]) for name in ("v1", "v2") if name in log.record
    }
    lines = tuple(Line(name + sides.get(name, ""), name, t, values) for name, values in recorded.items())
    return Panel(data.device.input_word + "s" * (len(lines) > 1), data.device.inputs[0].symbol, lines, low=low)


def _derivatives(data: RunData, log: LogData, wells: Wells | NoWells) -> Figure:
    unit = signal_units(data.device.displacement.symbol)
    t = log.motion.t
    velocity = np.gradient(log.motion.q, t)
    raw = {"qdot": velocity, "qddot": np.gradient(velocity, t)}
    return _timeline(
        data,
        log,
        wells,
        kind="derivatives",
        title="Derivatives",
        caption=f"{differentiation(data, log)} Grey: central differences of the same samples, for comparison.",
        panels=[
            Panel("q", unit["q"], (Line("q measured", "measured", t, log.motion.q),), low=True),
            *(
                Panel(
                    HEADINGS[name],
                    unit[name],
                    (
                        Line("plain differences", "raw", t, differences),
                        Line("regularised", "measured", t, getattr(log.motion, name)),
                    ),
                )
                for name, differences in raw.items()
            ),
        ],
    )


def differentiation(data: RunData, log: LogData) -> str:
    """One sentence on how a log was differentiated and with which α."""
    notes = log.kinematics_notes
    segments = notes.get("stretches", ())
    if not segments:
        return "How it was differentiated was not recorded."
    alphas = [s["alpha"] for s in segments if s.get("alpha") is not None]
    unit = ALPHA_UNIT[data.device.displacement.symbol][0].replace("deg", "°")
    text = METHODS.get(str(notes["method"]), str(notes["method"]))
    if notes["method"] == "tvregdiff":
        text += f" of order {notes['order']}"
        unit += f"·s{power(notes['order'])}" if notes["order"] > 1 else "·s"
    text += f" at {quantity(notes['interval_s'], 's')}"
    if alphas:
        between = " … ".join(significant(alpha) for alpha in sorted({min(alphas), max(alphas)}))
        text += f", α = {between} {unit}"
    failed = sum(not s.get("converged", True) for s in segments)
    return text + (f"; {failed} of {len(segments)} segments did not converge." if failed else ", converged.")


def measured_signals(log: LogData) -> dict[str, FloatArray]:
    """The measured signals that models are compared with, by name; without φ, which is computed from q."""
    return {name: getattr(log.motion, name) for name in ("q", "qdot", "qddot")}


def _models(data: RunData, log: LogData, wells: Wells | NoWells) -> Figure:
    t = log.motion.t
    unit = signal_units(data.device.displacement.symbol)
    panels = []
    for name, measured in measured_signals(log).items():
        lines = [Line(m, m, t, table[name]) for m, table in log.predictions.items() if name in table]
        # The main model is drawn last, over the measurement and its baselines.
        drawn = (Line("measured", "measured", t, measured, wide=True), *lines[1:], *lines[:1])
        panels.append(Panel(HEADINGS[name], unit[name], drawn))
    gone = [f"{m} diverged at {moment(n['diverged_at_s'])}" for m, n in log.outcomes.items() if n["status"] != "ok"]
    caption = (
        f"Free runs from the log's first sample under its measured {data.device.input_word}s; nothing is fed back."
    )
    caption += f" {'; '.join(gone)}." if gone else ""
    return _timeline(data, log, wells, kind="models", title="Measured against models", caption=caption, panels=panels)


def overlay(data: RunData, log: LogData, wells: Wells | NoWells) -> Figure:
    """Q as measured and as the models run freely, with the fit of the main one that MATLAB's ``compare`` states."""
    main_model = data.model_names[0]
    t = log.motion.t
    measured = log.motion.q
    others = tuple(Line(m, m, t, run["q"]) for m, run in log.predictions.items() if m != main_model)
    lines = [Line("measured", "measured", t, measured, wide=True), *others]
    below = [_inputs(data, log, low=True)]
    caption = (
        f"Free run from the first sample under the measured {data.device.input_word}s; "
        "fit = 100 (1 − ‖error‖/‖q − mean‖) %."
    )
    bands: tuple[Band, ...] = ()
    limits = _limits([measured])
    if main_model in log.predictions:
        predicted = log.predictions[main_model]
        free = predicted["q"]
        lines.append(Line(f"{main_model}: {fit_note(measured, free)}", main_model, t, free))
        error = Line("model − measured", "raw", t, free - measured, parts=(free, measured))
        about: tuple[Band, ...] = ()
        limits = _limits([measured, free])
        off = _limits([free - measured])
        if "q_low" in predicted:
            bands = tuple(_tubes(predicted, main_model))
            about = (Band(TUBE, main_model, t, predicted["q_low"] - free, predicted["q_high"] - free),)
            caption += " Nine in ten samples of another log are expected inside the tube"
            limits, clipped = _with_tubes(limits, bands)
            off, _ = _with_tubes(off, about)
            caption += ", which reaches beyond the axis." if clipped else "."
        below.insert(0, Panel("error", data.device.displacement.symbol, (error,), bands=about, y_limits=off, low=True))
    return replace(
        _timeline(
            data,
            log,
            wells,
            kind="overlay",
            title="Measured against the model",
            caption=caption,
            panels=[Panel("q", data.device.displacement.symbol, tuple(lines), bands=bands, y_limits=limits), *below],
        ),
        hidden=tuple(line.label for line in others),
    )


def _limits(signals: Sequence[FloatArray]) -> tuple[float, float]:
    """Least and largest value of all lines, with a margin at either end."""
    finite = [part[np.isfinite(part)] for part in signals]
    low = min((float(part.min()) for part in finite if part.size), default=-1.0)
    high = max((float(part.max()) for part in finite if part.size), default=1.0)
    margin = MARGIN * (high - low) or abs(low) * MARGIN or 1.0
    return low - margin, high + margin


def _with_tubes(limits: tuple[float, float], tubes: Sequence[Band]) -> tuple[tuple[float, float], bool]:
    """Limits of an axis that shows tubes too, by half of its length at most; and whether they are clipped."""
    low, high = limits
    least, largest = _limits([edge for tube in tubes for edge in (tube.low, tube.high)])
    most = 0.5 * (high - low)
    shown = max(min(low, least), low - most), min(max(high, largest), high + most)
    return shown, least < shown[0] or largest > shown[1]


def _tubes(predicted: Mapping[str, FloatArray], model: str) -> Iterator[Band]:
    """The tubes about a free run; that of the other well where the model is not sure of the well."""
    yield Band(TUBE, model, predicted["t"], predicted["q_low"], predicted["q_high"])
    if np.isfinite(predicted["q_other_low"]).any():
        yield Band(
            f"{TUBE} in the other well",
            "reference",
            predicted["t"],
            predicted["q_other_low"],
            predicted["q_other_high"],
        )


def _residuals(data: RunData, log: LogData, wells: Wells | NoWells) -> Figure:
    t = log.motion.t
    unit = signal_units(data.device.displacement.symbol)
    panels = []
    for name, measured in measured_signals(log).items():
        lines = [
            Line(m, m, t, table[name] - measured, parts=(table[name], measured))
            for m, table in log.predictions.items()
            if name in table
        ]
        panels.append(Panel(f"error of {HEADINGS[name]}", unit[name], (*lines[1:], *lines[:1])))
    wrong = " A model in the wrong well is off by the distance of the wells." if isinstance(wells, Wells) else ""
    caption = f"Errors are model minus measurement.{wrong}"
    panels = [_models(data, log, wells).panels[0], *panels, _inputs(data, log, low=True)]
    return _timeline(data, log, wells, kind="residuals", title="Residuals", caption=caption, panels=panels)


def residual_figures(data: RunData, wells: Wells | NoWells) -> dict[str, Figure]:
    """Correlations and spectrum for the worst validation log (training log without any); none of a short record."""
    log = judged_log(data)
    model = data.model_names[0]
    if (residual := main_residual(data, log)) is None:
        return {}
    return {
        "residual-correlation": _correlation(data, log, model, residual, rings=isinstance(wells, Wells)),
        "residual-spectrum": _spectrum(data, log, model, residual),
    }


def _correlation(data: RunData, log: LogData, model: str, residual: Residual, *, rings: bool) -> Figure:
    square = "²" if data.device.squared else ""
    titles = ("autocorrelation", *(f"correlation with v{k}{square}" for k in range(1, len(residual.with_inputs) + 1)))
    correlations = (residual.correlation, *residual.with_inputs)
    bands = (residual.band, *residual.input_bands)
    panels = [
        Panel(
            title,
            "1",
            (Line(f"residual of {model}", model, residual.lags, values),),
            (
                Band(
                    "99 % band without correlation",
                    "reference",
                    residual.lags,
                    np.full(residual.lags.size, -half),
                    np.full(residual.lags.size, half),
                ),
            ),
        )
        for title, values, half in zip(titles, correlations, bands, strict=True)
    ]
    colour = "rings with the device" if rings else "fades as slowly as the device settles"
    return Figure(
        "residual-correlation",
        title="Residual analysis: memory and inputs",
        caption=(
            f"{log.title.capitalize()}: {prefixed(residual.outside, '%', 0)} % of the correlations with inputs lie "
            f"outside their bands, 1 % would by chance. The residual {colour}; what correlates with an input the model "
            "misses."
        ),
        x_name="lag",
        x_unit="s",
        panels=tuple(panels),
        columns=len(panels),
    )


def _spectrum(data: RunData, log: LogData, model: str, residual: Residual) -> Figure:
    return Figure(
        "residual-spectrum",
        title="Residual analysis: spectrum",
        caption=f"Power spectral densities by Welch's method, {log.title}: where they meet the model explains nothing.",
        x_name="frequency",
        x_unit="Hz",
        panels=(
            Panel(
                "power spectral density",
                f"{data.device.displacement.symbol}²/Hz",
                (
                    Line("measured q", "measured", residual.frequency, residual.measured_density),
                    Line(f"residual of {model}", model, residual.frequency, residual.density),
                ),
                log=True,
            ),
        ),
        x_log=True,
        half=True,
    )
