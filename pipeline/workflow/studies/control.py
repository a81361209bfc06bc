"""Linear models, switching maps, pulses and a controller for a run's identified joint."""

import json
from collections.abc import Iterator, Mapping
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from ...control.controller import closed_on_model
from ...control.design import Settings, design as design_law
from ...control.ensemble import INTERVAL, Converters, Ensemble, ensemble_of
from ...control.estimator import PERIOD
from ...control.law import Law
from ...control.margins import Margins, margins
from ...control.plant import ASSUMED_LAG, LinearModel, equilibria
from ...control.pulses import design_pulse
from ...control.switching_map import PULSES, TYPICAL, lowest_voltage, switching_map, with_voltage_error
from ...device.device import JOINT
from ...diagnostics.events import rest_events
from ...errors import InputError
from ...models.hybrid.model import HybridModel
from ...numerics.arrays import FloatArray
from ...numerics.metrics import BAND, step_metrics
from ...rig.excitation import ENDINGS, Sequence, save_sequence
from ...scoring.wells import wells_of
from ...signals.log import log_of
from ...store import layout
from ...store.outputs import new_outputs, rebased
from ...system.names import Goal, Well
from ...system.worker_pool import OnProgress
from ..engine import Observer
from .controlled_run import ControlRun, ControlSettings, control_run, kept_document

DRAWS = 32
"""Draws of the joint from its posterior, beside the estimate."""
SETTLES = 0.3
"""Time [s] in which a good controller settles in a well."""
GAIN = 1.3
"""Factor on the gain, up and down, that a good controller stands at the unstable equilibrium; it also stands a delay as
long as the lag of usual converters."""


def linearise(root: Path, voltages: tuple[float, float], observer: Observer) -> dict[str, Any]:
    """Equilibria and their linear models under constant voltages [V], with the measured ring-downs beside them."""
    control_run(root).check_voltages("--v1, --v2", *voltages)
    return kept_document(root, "linear", {"voltages": list(voltages)}, observer, partial(_linear, voltages))


def _linear(voltages: tuple[float, float], joint_run: ControlRun, _on_progress: OnProgress) -> dict[str, Any]:
    """Equilibria and linear models of the run's joint."""
    return {
        "format": "debist-linear/1",
        "model": joint_run.name,
        "v_V": list(voltages),
        "equilibria": [
            model.to_json() | {"bode": bode(model)}
            for model in equilibria(joint_run.plant, np.array(voltages, np.float64))
        ],
        "measured": _measured_ringing(joint_run),
    }


def linear_models(root: Path, voltages: tuple[float, float]) -> list[LinearModel]:
    """Equilibria and linear models of a run's joint under constant voltages [V]."""
    joint_run = control_run(root)
    joint_run.check_voltages("v1, v2", *voltages)
    return equilibria(joint_run.plant, np.array(voltages, dtype=np.float64))


def bode(model: LinearModel) -> dict[str, list[float]]:
    """Transfer from the squared voltages [V²] to the reading [m], from 0.05 to 200 Hz: dB and degrees."""
    f = np.geomspace(0.05, 200.0, 200)
    identity = np.eye(len(model.a))
    response = np.array(
        [(model.c @ np.linalg.solve(2j * np.pi * hertz * identity - model.a, model.b_squared))[0] for hertz in f]
    )
    columns = {"f_Hz": f.tolist()}
    for side, name in enumerate(("left", "right")):
        columns[f"{name}_dB"] = (20.0 * np.log10(np.abs(response[:, side]) * 1e9)).tolist()
        columns[f"{name}_deg"] = np.degrees(np.unwrap(np.angle(response[:, side]))).tolist()
    return columns


def _measured_ringing(joint_run: ControlRun) -> dict[str, Any]:
    """Mean frequency [Hz] and damping ratio of the ring-downs in both wells, over all logs, as in the datasheet."""
    logs = [(role, log) for role, log, _ in layout.logs(joint_run.prototype)]
    measured = [log_of(joint_run.run.read_table(layout.kinematics(*log))) for log in logs]
    hum = {line for log in logs for line in joint_run.run.record(layout.record(*log)).notes.get("hum", ())}
    events = rest_events([(log.t, log.q, log.v) for log in measured], wells_of(measured, plant=JOINT), hum, plant=JOINT)
    ringing = {}
    for side in ("left", "right"):
        frequencies = events.get(f"frequency_{side}", ())
        dampings = events.get(f"damping_{side}", ())
        ringing[side] = {
            "ring_downs": len(frequencies),
            "frequency_Hz": float(np.mean(frequencies)) if len(frequencies) else None,
            "damping_ratio": float(np.mean(dampings)) if len(dampings) else None,
        }
    return ringing


def write_linear(root: Path, document: Mapping[str, Any], output: Path | None, *, force: bool) -> list[Path]:
    """Write linear models as JSON and MAT (v5).

    Parameters
    ----------
    root : Path
        Run folder.
    document : mapping
        The linear models.
    output : Path or None
        Folder of the files; None: the exports of the run.
    force : bool
        True if files of others may be replaced.
    """
    from scipy.io import savemat

    folder = output or root / layout.EXPORTS
    with new_outputs(folder, "control", force=force, made_from=control_run(root).origin) as staged:
        (staged / "linear.json").write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8", newline="\n")
        structs = {
            f"equilibrium_{number}": {
                **{name: np.array(point[name]) for name in ("A", "B", "C", "D", "B_squared")},
                "x0": np.array(point["x0"])[:, None],
                "v0": np.array(point["v_V"])[:, None],
                "q0": point["q_m"],
                "stable": float(point["stable"]),
            }
            for number, point in enumerate(document["equilibria"], start=1)
        }
        savemat(staged / "linear.mat", structs)
        written = sorted(staged.iterdir())
    return [rebased(path, staged, folder) for path in written]


def switching_maps(root: Path, settings: ControlSettings, observer: Observer) -> dict[str, Any]:
    """P(switch | voltage, duration) both ways, with its band."""
    return kept_document(
        root,
        "map",
        {"lag": settings.lag, "draws": DRAWS, "highest": control_run(root).limit},
        observer,
        partial(_maps, settings),
    )


def _maps(settings: ControlSettings, joint_run: ControlRun, on_progress: OnProgress) -> dict[str, Any]:
    """Both maps of the run's joint."""
    converters, lags_known = joint_run.converters(settings)
    return {
        "format": "debist-switching-map/3",
        "draws": DRAWS,
        "lags_s": converters.lags,
        "lags_known": lags_known,
        "maps": [
            _one_map(joint_run, converters, "right", lambda what, share: on_progress(what, share / 2.0)),
            _one_map(joint_run, converters, "left", lambda what, share: on_progress(what, 0.5 + share / 2.0)),
        ],
    }


def _one_map(joint_run: ControlRun, converters: Converters, to: Well, on_progress: OnProgress) -> dict[str, Any]:
    """The map to a well and the lowest voltages that bring the joint there, by whose errors the map's draws differ."""
    model = joint_run.model
    places = joint_run.places
    on_progress(f"lowest voltages to the {to}", 0.0)
    lowest = [lowest_voltage(model, converters, places, to, duration) for duration in PULSES]
    joint = with_voltage_error(ensemble_of(model, DRAWS, converters), lowest)
    result = switching_map(joint, places, to, on_progress)
    return {**asdict(result), "lowest": [asdict(pulse) for pulse in lowest if pulse is not None]}


def pulse(
    root: Path, to: Well, start: Well | None, goal: Goal, settings: ControlSettings, observer: Observer
) -> dict[str, Any]:
    """A feedforward snap to a well and what the model predicts of it.

    Parameters
    ----------
    root : Path
        Run folder.
    to : {"left", "right"}
        Well to bring the joint to.
    start : {"left", "right"} or None
        Well it rests in; None: the other one.
    goal : str
        Quantity that the pulse minimises.
    settings : ControlSettings
        Limits of the voltages, and lags.
    observer : Observer
        Receives what happens.
    """
    if start == to:
        raise InputError(f"--from {start}: the joint is there already; a pulse brings it from one well to the other")
    highest = control_run(root).highest(settings)

    decides = {"to": to, "goal": goal, "highest": highest, "lag": settings.lag, "draws": DRAWS}
    return kept_document(root, f"pulse-to-{to}", decides, observer, partial(_pulse, to, goal, settings, highest))


def _pulse(
    to: Well, goal: Goal, settings: ControlSettings, highest: float, joint_run: ControlRun, on_progress: OnProgress
) -> dict[str, Any]:
    """The pulse and what the model and its posterior make of it."""
    left, saddle, right = joint_run.places
    begin, end = (left, right) if to == "right" else (right, left)
    converters, lags_known = joint_run.converters(settings)
    joint = with_draws(joint_run.model, converters, (left, saddle, right), to)
    snap = design_pulse(joint, begin, end, right - left, highest, goal, on_progress)
    low, high = np.quantile(snap.q[1:], [0.05, 0.95], axis=0)
    return {
        "format": "debist-pulse/2",
        "channels": {"time": "s", "v1": "V, command to the left converter", "v2": "V, to the right one"},
        "to": to,
        "minimised": goal,
        "start_m": begin,
        "target_m": end,
        "largest_voltage_V": float(snap.v.max()),
        "lags_s": converters.lags,
        "lags_known": lags_known,
        "settling_s": _finite(snap.settling_s),
        "settling_90_s": [_finite(snap.settling_low_s), _finite(snap.settling_high_s)],
        "overshoot_m": snap.overshoot_m,
        "switching_probability": snap.probability,
        "draws": DRAWS,
        "segments_s_share": snap.segments,
        "t_s": snap.t,
        "v_V": snap.v,
        "predicted": {"t_s": INTERVAL * np.arange(snap.q.shape[1]), "q_m": snap.q[0], "low_m": low, "high_m": high},
    }


def with_draws(model: HybridModel, converters: Converters, places: tuple[float, float, float], to: Well) -> Ensemble:
    """The joint with the draws that judge a pulse to a well: their voltages err as its lowest voltage may.

    Parameters
    ----------
    model : HybridModel
        The identified joint.
    converters : Converters
        Lags of the converters.
    places : (float, float, float)
        Left rest, unstable equilibrium and right rest [m].
    to : {"left", "right"}
        Well of the pulse.
    """
    lowest = lowest_voltage(model, converters, places, to, TYPICAL)
    return with_voltage_error(ensemble_of(model, DRAWS, converters), [lowest])


def _finite(value: float) -> float | None:
    return value if np.isfinite(value) else None


def check_pulse_name(output: Path) -> None:
    """Refuse a name that a pulse cannot be written to, before it is computed.

    Raises
    ------
    InputError
        It has another ending.
    """
    if output.suffix.lower() not in (*ENDINGS, ""):
        raise InputError(f"{output}: a pulse is written as {' and '.join(ENDINGS)}; name it so, or without an ending")


def write_pulse(root: Path, document: Mapping[str, Any], output: Path, *, force: bool) -> list[Path]:
    """Write a pulse of a run as CSV and MAT at 1 kHz, as `debist rig closed-loop --play` and test benches read it.

    Parameters
    ----------
    root : Path
        Run folder.
    document : mapping
        The pulse.
    output : Path
        The file.
    force : bool
        True if a file of others may be replaced.
    """
    check_pulse_name(output)
    sequence = Sequence(np.array(document["t_s"]), np.array(document["v_V"]))
    about = {key: value for key, value in document.items() if key not in ("t_s", "v_V", "predicted")}
    with new_outputs(output.parent, "control", force=force, made_from=control_run(root).origin) as staged:
        for ending in ENDINGS:
            save_sequence(staged / f"{output.stem}{ending}", sequence, about)
        written = sorted(staged.iterdir())
    return [rebased(path, staged, output.parent) for path in written]


def design(root: Path, settings: ControlSettings, observer: Observer) -> dict[str, Any]:
    """The controller of a run's joint, kept in the run, and what the model predicts of it."""
    highest = control_run(root).highest(settings)

    return kept_document(
        root, "design", asdict(settings) | {"highest": highest}, observer, partial(_design, settings, highest)
    )


def _design(
    settings: ControlSettings, highest: float, joint_run: ControlRun, _on_progress: OnProgress
) -> dict[str, Any]:
    """The controller, kept in the run, and its prediction."""
    plant = joint_run.plant
    converters, lags_known = joint_run.converters(settings)
    law = design_law(plant, Settings(highest, converters.lags, settings.slew, settings.average))
    left, saddle, right = joint_run.places
    predicted = _predicted(law, (left, saddle, right))
    _refuse_stuck(joint_run.run.root, predicted, highest, right - left)
    held = margins(plant, law, saddle)
    return {
        "format": "debist-controller/5",
        "prototype": joint_run.prototype.name,
        "model": joint_run.name,
        "origin": joint_run.run.record(joint_run.artifact).content_hash,
        "places_m": {"left": left, "saddle": saddle, "right": right},
        "targets_m": [plant.reading(q) for q in law.places],
        "largest_voltage_V": highest,
        "slew_V_s": settings.slew,
        "average_V": settings.average,
        "lags_s": converters.lags,
        "lags_known": lags_known,
        "margins": None if held is None else asdict(held),
        "pumps": {f"to_{side}": law.number(f"pumped_{side}") > 0.5 for side in ("right", "left")},
        "predicted": predicted,
        "warnings": [
            *_misses(predicted, right - left),
            *_thin(held),
            *_too_much(law, saddle, settings.average),
        ],
        "law": law.to_json(),
    }


def _refuse_stuck(root: Path, predicted: Mapping[str, Any], highest: float, distance: float) -> None:
    """Refuse a controller that leaves the model more than a quarter of the wells' distance from a well."""
    q = np.array(predicted["q_m"])
    target = np.array(predicted["target_m"])
    for step, side in zip(np.flatnonzero(np.diff(target))[1:], ("right", "left"), strict=False):
        if abs(q[step] - target[step]) > 0.25 * distance:
            raise InputError(
                f"{root}: at most {highest:g} V do not bring the model into its {side} well, not even by swinging it "
                "up; allow a larger --max-voltage"
            )


def _misses(predicted: Mapping[str, Any], distance: float) -> Iterator[str]:
    """Goals that the controller misses on the model itself; a joint that differs will not do better."""
    for place, step in zip(("right well", "left well"), predicted["steps"], strict=False):
        if step["settling_s"] is None or step["settling_s"] > SETTLES:
            taken = "does not settle" if step["settling_s"] is None else f"takes {1e3 * step['settling_s']:.0f} ms"
            yield (
                f"the model {taken} to the {place}, {1e3 * SETTLES:.0f} ms are usual; allow a larger --max-voltage, or "
                "play a pulse (`debist control pulse`)"
            )
        if step["rms_m"] > BAND * distance:
            yield f"the model rests {1e3 * step['rms_m']:.2f} mm away from the {place}"


def _thin(held: Margins | None) -> Iterator[str]:
    """Margins that are smaller than joints differ from their models."""
    wide = held is not None and max(held.gain_low, 1.0 / held.gain_high) < 1.0 / GAIN and held.delay_s > ASSUMED_LAG
    if not wide:
        yield "the margins at the unstable equilibrium are small: a joint that differs from its model may leave it"


def _too_much(law: Law, saddle: float, average: float | None) -> Iterator[str]:
    """Warning where the unstable equilibrium (reading, m) takes more voltage for long than its mean may be."""
    needed = law.holding_voltage(saddle - law.number("offset"))
    if average is not None and not needed <= average:
        yield (
            f"the unstable equilibrium takes {needed:.0f} V; with --average-voltage {average:g} V it may be lost after "
            "some seconds"
        )


def _predicted(law: Law, places: tuple[float, float, float]) -> dict[str, Any]:
    """The closed loop on the model: to the right, back, to the unstable equilibrium."""
    left, saddle, right = places
    slow = int(max(law.number("pumped_right"), law.number("pumped_left")))
    target = np.repeat([left, right, left, saddle], [50, 1500 + 4000 * slow, 1500 + 4000 * slow, 1500])
    q, v = closed_on_model(law, law, left, target)
    t: FloatArray = np.linspace(0.0, PERIOD * (target.size - 1), target.size)
    steps = [asdict(step) for step in step_metrics(t, q, target, right - left)[1:]]
    every = slice(None, None, 5)
    return {"steps": steps, "t_s": t[every], "q_m": q[every], "target_m": target[every], "v_V": v[every]}
