"""Control: from a run's identified joint to linear models, pulses, a switching map and a controller."""

import json
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from pipeline.errors import DataRefusedError, InputError
from pipeline.loading.held_models import controlled_model
from pipeline.runs import layout
from pipeline.runs.engine import Observer, Task, bring_up_to_date
from pipeline.runs.lock import run_lock
from pipeline.runs.outputs import new_outputs, rebased, remove_outdated
from pipeline.runs.run_folder import RunFolder, Written
from pipeline.settings import Prototype
from pipeline.tools.export import load_run_model

if TYPE_CHECKING:
    from pipeline.control.ensemble import Converters
    from pipeline.control.law import Law
    from pipeline.control.linear import LinearModel
    from pipeline.models.hybrid import HybridModel
    from pipeline.numerics.arrays import FloatArray

ALGORITHM = "7"
DRAWS = 32
FOLDER = "exports"
MOST_EQUILIBRIA = 9
"""Of a joint, by far: files of as many are looked for among those of an earlier call."""
_REFUSED = 0.15
"""NRMSE of q on a validation log above which no control is designed on a model: it does not know where the joint is."""
_MISSED = 2e-3
"""The same for the RMS residual [m] on the training logs."""
ASSUMED, DATA_SHEET, GIVEN = 4e-3, 0.36, 0.1
"""Lag of converters [s] of which no log tells anything, and the standard deviations of the logarithms: of that, for
converters of 2 to 7 ms, and of a lag that the user states."""
_LEAST_SPREAD = 0.02
"""The same of a lag from steps, at least: a step of another height takes another time."""
_SIZES = 1.5
"""Factor in length within which the distances of estimator and law fit a joint."""

Well = Literal["left", "right"]
Goal = Literal["time", "energy", "voltage"]
MOST = 3000.0


@dataclass(frozen=True)
class ControlSettings:
    """What a user may choose.

    Attributes
    ----------
    max_voltage : float or None
        Largest voltage [V]; the largest trained one if left out, 3 kV at most.
    lag : float or None
        Time constant of the converters [s]; that of the voltage steps in the training logs if left out.
    """

    max_voltage: float | None = None
    lag: float | None = None


@dataclass(frozen=True)
class ControlRun:
    """A run whose joint is to be controlled."""

    run: RunFolder
    prototype: Prototype
    model: "HybridModel"
    name: str
    artifact: str

    def highest(self, settings: ControlSettings) -> float:
        """Largest voltage [V].

        Raises
        ------
        InputError
            It lies outside the trained range.
        """
        trained = self.model.joint.largest_voltage
        wanted = min(trained, MOST) if settings.max_voltage is None else settings.max_voltage
        if not 0.0 < wanted <= 1.01 * trained:
            raise InputError(f"--max-voltage {wanted:g} V: outside the trained range, 0 to {trained:.0f} V")
        return float(min(wanted, trained))

    @property
    def records(self) -> tuple[str, ...]:
        """The artifacts that hold the measured voltages of the training logs."""
        return tuple(layout.record(role, log) for role, log, _ in layout.logs(self.prototype) if role == "train")

    def converters(self, settings: ControlSettings) -> tuple["Converters", str]:
        """The converters as given, as the training logs tell or as assumed, and how they are known.

        Where the logs tell the lag of one side only, both sides have it.
        """
        from pipeline.control.ensemble import Converters
        from pipeline.device_facts.converters import converter_lag

        if settings.lag is not None:
            return Converters((settings.lag, settings.lag), GIVEN), "given"
        tables = [self.run.read_table(name) for name in self.records]
        left, right = (converter_lag([(table["t"], table[v]) for table in tables]) for v in ("v1", "v2"))
        told = [each for each in (left, right) if each is not None]
        if not told:
            return Converters((ASSUMED, ASSUMED), DATA_SHEET), "assumed"
        one, other = left or told[0], right or told[0]
        spread = max(_LEAST_SPREAD, *(each.scatter for each in told))
        counts = " and ".join(str(each.steps if each else 0) for each in (left, right))
        return Converters((one.lag, other.lag), spread), f"from {counts} voltage steps of the training logs"


def control_run(root: Path) -> ControlRun:
    """The identified joint of a run.

    Raises
    ------
    InputError
        The run holds no identified joint with two membranes.
    DataRefusedError
        Its validation refuses the model.
    """
    from pipeline.joint.condensed_kernels import INDEX
    from pipeline.joint.parameters import NOMINAL
    from pipeline.models.hybrid import HybridModel

    run = RunFolder.open(root)
    prototype = run.prototype
    name, artifact = controlled_model(run, prototype)
    model = load_run_model(run, prototype, name)
    if not isinstance(model, HybridModel):
        joint = "name the model 'hybrid' first in [identify] models"
        advice = joint if prototype.may_be_a_joint else "it is for a joint with two membranes, not for another device"
        raise InputError(f"{root}: its model is {name!r}; control needs the joint's equations: {advice}")
    size = float(model.joint.constants(model.theta)[INDEX["l"]]) / NOMINAL.l
    if not 1.0 / _SIZES < size < _SIZES:
        raise InputError(
            f"{root}: the joint is {size:.2g} times as long as that of the set 'nominal' ({1e3 * NOMINAL.l:.0f} mm); "
            "control is for joints of about its size"
        )
    _refuse_bad_model(run, name, model)
    return ControlRun(run, prototype, model, name, artifact)


def _refuse_bad_model(run: RunFolder, name: str, model: "HybridModel") -> None:
    missed = float(model.diagnostics.get("training_rms_m", 0.0))
    if missed > _MISSED:
        raise DataRefusedError(
            f"{run.root}: the model {name} misses its training data by {1e3 * missed:.1f} mm; control on it would be a "
            f"guess (limit {1e3 * _MISSED:.1f} mm); see `debist show {run.root}`"
        )
    if layout.SCORES not in run.manifest.artifacts:
        return
    table = run.read_table(layout.SCORES)
    rows = (table["model"] == name) & (table["role"] == "validation") & (table["signal"] == "q")
    for log, status, error in zip(table["log"][rows], table["status"][rows], table["nrmse"][rows], strict=True):
        if status != "ok" or not error <= _REFUSED:
            told = "diverges" if status != "ok" else f"has an NRMSE of {100.0 * error:.0f} % of q"
            raise DataRefusedError(
                f"{run.root}: the model {name} {told} on the validation log {log}; control on it would be a guess "
                f"(limit {100.0 * _REFUSED:.0f} %); see `debist show {run.root}`"
            )


def _artifact(
    root: Path,
    title: str,
    settings: Mapping[str, Any],
    observer: Observer,
    work: Callable[[ControlRun], dict[str, Any]],
) -> dict[str, Any]:
    """What `work` finds out, kept in the run as ``control/TITLE.json`` until the model or the settings change."""
    with run_lock(root):
        found = control_run(root)
        name = layout.control(title)

        def write(run: RunFolder) -> dict[str, Written]:
            """Find out and write the document."""
            document = json.dumps(work(found), indent=1, allow_nan=False, default=lambda value: value.tolist())
            return {name: run.write_text(name, document + "\n", {})}

        task = Task("control", title, ALGORITHM, settings, (found.artifact, *found.records), (name,), write)
        bring_up_to_date(found.run, [task], observer)
        return dict(json.loads(found.run.read_bytes(name)))


def linearise(root: Path, voltages: tuple[float, float], observer: Observer) -> dict[str, Any]:
    """Equilibria and their linear models under constant voltages [V], with the measured ring-downs beside them."""

    def work(found: ControlRun) -> dict[str, Any]:
        """Equilibria and linear models of the run's joint."""
        return {
            "format": "debist-linear/1",
            "model": found.name,
            "v_V": list(voltages),
            "equilibria": [each.to_json() | {"bode": bode(each)} for each in _linear_models(found, voltages)],
            "measured": _measured_ringing(found),
        }

    _check_range(control_run(root), voltages)
    return _artifact(root, "linear", {"voltages": list(voltages)}, observer, work)


def linear_models(root: Path, voltages: tuple[float, float]) -> "list[LinearModel]":
    """Equilibria and linear models of a run's joint under constant voltages [V]."""
    found = control_run(root)
    _check_range(found, voltages)
    return _linear_models(found, voltages)


def _linear_models(found: ControlRun, voltages: tuple[float, float]) -> "list[LinearModel]":
    from pipeline.control.linear import equilibria
    from pipeline.control.plant import plant_of

    return equilibria(plant_of(found.model), np.array(voltages, dtype=np.float64))


def _check_range(found: ControlRun, voltages: tuple[float, float]) -> None:
    v_max = found.model.joint.largest_voltage
    if not all(0.0 <= v <= 1.01 * v_max for v in voltages):
        raise InputError(f"v1, v2: outside the trained range, 0 to {v_max:.0f} V")


def bode(model: "LinearModel") -> dict[str, list[float]]:
    """Transfer from the squared voltages [V²] to the reading [m], from 0.05 to 200 Hz: dB and degrees."""
    f = np.geomspace(0.05, 200.0, 200)
    identity = np.eye(len(model.a))
    answers = np.array(
        [(model.c @ np.linalg.solve(2j * np.pi * each * identity - model.a, model.b_squared))[0] for each in f]
    )
    found = {"f_Hz": f.tolist()}
    for side, name in enumerate(("left", "right")):
        found[f"{name}_dB"] = (20.0 * np.log10(np.abs(answers[:, side]) * 1e9)).tolist()
        found[f"{name}_deg"] = np.degrees(np.unwrap(np.angle(answers[:, side]))).tolist()
    return found


def _measured_ringing(found: ControlRun) -> dict[str, Any]:
    """Median frequency [Hz] and damping ratio of the ring-downs in both wells after switching off, over all logs."""
    from pipeline.device_facts.events import rest_facts
    from pipeline.loading.trajectories import voltages, wells_of

    tables = [found.run.read_table(layout.kinematics(role, log)) for role, log, _ in layout.logs(found.prototype)]
    wells = wells_of(tables)
    facts = rest_facts([(table["t"], table["q"], voltages(table)) for table in tables], wells)
    rings = {"left": facts.rings_left, "right": facts.rings_right}
    return {
        side: {
            "ring_downs": len(each),
            "frequency_Hz": float(np.median([ring.frequency for ring in each])) if each else None,
            "damping_ratio": float(np.median([ring.damping for ring in each])) if each else None,
        }
        for side, each in rings.items()
    }


def write_linear(root: Path, document: Mapping[str, Any], output: Path | None, *, force: bool) -> list[Path]:
    """Write linear models as JSON, MAT (v5) and one CSV of the matrices for each equilibrium."""
    from scipy.io import savemat

    folder = output or root / FOLDER
    with new_outputs(folder, "control", force=force) as staged:
        (staged / "linear.json").write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")
        structs: dict[str, Any] = {}
        for number, each in enumerate(document["equilibria"], start=1):
            matrices = {name: np.array(each[name]) for name in ("A", "B", "C", "D", "B_squared")}
            structs[f"equilibrium_{number}"] = matrices | {
                "x0": np.array(each["x0"])[:, None], "v0": np.array(each["v_V"])[:, None], "q0": each["q_m"],
                "stable": float(each["stable"]),
            }  # fmt: skip
            header = ",".join([*each["states"], "v1 [V]", "v2 [V]", "v1^2 [V^2]", "v2^2 [V^2]"])
            rows = np.hstack([matrices["A"], matrices["B"], matrices["B_squared"]])
            lines = [
                f"rate of {name}," + ",".join(map(repr, row))
                for name, row in zip(each["states"], rows.tolist(), strict=True)
            ]
            text = (
                f"# equilibrium at q = {each['q_m']!r} m, v = {each['v_V']}\nrow,{header}\n" + "\n".join(lines) + "\n"
            )
            (staged / f"linear-{number}.csv").write_text(text, encoding="utf-8")
        savemat(staged / "linear.mat", structs)
        written = sorted(staged.iterdir())
    numbers = range(len(document["equilibria"]) + 1, MOST_EQUILIBRIA + 1)
    remove_outdated(folder, (f"linear-{number}.csv" for number in numbers), "control")
    return [rebased(path, staged, folder) for path in written]


def switching_maps(root: Path, settings: ControlSettings, observer: Observer) -> dict[str, Any]:
    """P(switch | voltage, duration) both ways, with its band."""

    def work(found: ControlRun) -> dict[str, Any]:
        """Both maps of the run's joint."""
        from pipeline.control.ensemble import ensemble_of
        from pipeline.control.linear import three
        from pipeline.control.plant import plant_of
        from pipeline.control.switching_map import switching_map

        wells = tuple(each.q for each in three(plant_of(found.model)))
        converters, known = found.converters(settings)
        joint = ensemble_of(found.model, DRAWS, converters)
        maps = [switching_map(joint, (wells[0], wells[1], wells[2]), to) for to in ("right", "left")]
        return {
            "format": "debist-switching-map/2",
            "draws": DRAWS + 1,
            "lags_s": converters.lags,
            "lags_known": known,
            "maps": [asdict(each) for each in maps],
        }

    return _artifact(root, "map", {"lag": settings.lag, "draws": DRAWS}, observer, work)


def pulse(
    root: Path, to: Well, start: Well | None, goal: Goal, settings: ControlSettings, observer: Observer
) -> dict[str, Any]:
    """A feedforward snap to a well and what the model predicts of it."""
    if start == to:
        raise InputError(f"--from {start}: the joint is there already; a pulse brings it from one well to the other")
    highest = control_run(root).highest(settings)

    def work(found: ControlRun) -> dict[str, Any]:
        """The pulse and what the model and its posterior make of it."""
        from pipeline.control.ensemble import INTERVAL, ensemble_of
        from pipeline.control.linear import three
        from pipeline.control.plant import plant_of
        from pipeline.control.pulses import design_pulse

        left, _, right = (each.q for each in three(plant_of(found.model)))
        begin, end = (left, right) if to == "right" else (right, left)
        converters, known = found.converters(settings)
        joint = ensemble_of(found.model, DRAWS, converters)
        made = design_pulse(joint, begin, end, right - left, highest, goal)
        low, high = np.quantile(made.q[1:], [0.05, 0.95], axis=0)
        return {
            "format": "debist-pulse/2",
            "channels": {"time": "s", "v1": "V, command to the left converter", "v2": "V, to the right one"},
            "to": to,
            "minimised": goal,
            "start_m": begin,
            "target_m": end,
            "largest_voltage_V": float(made.v.max()),
            "lags_s": converters.lags,
            "lags_known": known,
            "settling_s": _finite(made.settling_s),
            "settling_90_s": [_finite(made.settling_low_s), _finite(made.settling_high_s)],
            "overshoot_m": made.overshoot_m,
            "switching_probability": made.probability,
            "draws": DRAWS,
            "segments_s_share": made.segments,
            "t_s": made.t,
            "v_V": made.v,
            "predicted": {"t_s": INTERVAL * np.arange(made.q.shape[1]), "q_m": made.q[0], "low_m": low, "high_m": high},
        }

    chosen = {"to": to, "goal": goal, "highest": highest, "lag": settings.lag, "draws": DRAWS}
    return _artifact(root, f"pulse-to-{to}", chosen, observer, work)


def _finite(value: float) -> float | None:
    return value if np.isfinite(value) else None


def check_pulse_name(output: Path) -> None:
    """Refuse a name that a pulse cannot be written to, before it is computed.

    Raises
    ------
    InputError
        It has another ending.
    """
    from pipeline.rig.excitation import ENDINGS

    if output.suffix.lower() not in (*ENDINGS, ""):
        raise InputError(f"{output}: a pulse is written as {' and '.join(ENDINGS)}; name it so, or without an ending")


def write_pulse(document: Mapping[str, Any], output: Path, *, force: bool) -> list[Path]:
    """Write a pulse as CSV and MAT at 1 kHz, as `debist rig closed-loop --play` and test benches read it."""
    from pipeline.rig.excitation import ENDINGS, Sequence, save_sequence

    check_pulse_name(output)
    t, v = np.array(document["t_s"]), np.array(document["v_V"])
    about = {key: value for key, value in document.items() if key not in ("t_s", "v_V", "predicted")}
    with new_outputs(output.parent, "control", force=force) as staged:
        for ending in ENDINGS:
            save_sequence(staged / f"{output.stem}{ending}", Sequence(t, v), about)
        written = sorted(staged.iterdir())
    return [rebased(path, staged, output.parent) for path in written]


def design(root: Path, settings: ControlSettings, observer: Observer) -> dict[str, Any]:
    """The controller of a run's joint, kept in the run, and what the model predicts of it."""
    highest = control_run(root).highest(settings)

    def work(found: ControlRun) -> dict[str, Any]:
        """The controller, kept in the run, and its prediction."""
        from pipeline.control.design import Settings
        from pipeline.control.design import design as design_law
        from pipeline.control.linear import three
        from pipeline.control.plant import plant_of

        plant = plant_of(found.model)
        converters, known = found.converters(settings)
        law = design_law(plant, Settings(highest, converters.lags))
        left, saddle, right = (each.q for each in three(plant))
        predicted = _predicted(law, (left, saddle, right))
        _refuse_stuck(root, predicted, highest, right - left)
        return {
            "format": "debist-controller/3",
            "prototype": found.prototype.name,
            "model": found.name,
            "origin": found.run.record(found.artifact).content_hash,
            "places_m": {"left": left, "saddle": saddle, "right": right},
            "targets_m": [plant.reading(q) for q in law.places],
            "largest_voltage_V": highest,
            "lags_s": converters.lags,
            "lags_known": known,
            "pumps": {f"to_{side}": law.number(f"pumped_{side}") > 0.5 for side in ("right", "left")},
            "predicted": predicted,
            "law": law.to_json(),
        }

    return _artifact(root, "design", {"highest": highest, "lag": settings.lag}, observer, work)


def _refuse_stuck(root: Path, predicted: Mapping[str, Any], highest: float, distance: float) -> None:
    q, target = np.array(predicted["q_m"]), np.array(predicted["target_m"])
    for step, side in zip(np.flatnonzero(np.diff(target))[1:], ("right", "left"), strict=False):
        if abs(q[step] - target[step]) > 0.25 * distance:
            raise InputError(
                f"{root}: at most {highest:g} V do not bring the model into its {side} well, not even by swinging it "
                "up; allow a larger --max-voltage"
            )


def _predicted(law: "Law", places: tuple[float, float, float]) -> dict[str, Any]:
    """The closed loop on the model: to the right, back, to the unstable equilibrium."""
    from pipeline.control.controller import PERIOD, closed_on_model
    from pipeline.control.step_metrics import step_metrics

    left, saddle, right = places
    slow = int(max(law.number("pumped_right"), law.number("pumped_left")))
    target = np.repeat([left, right, left, saddle], [50, 1500 + 4000 * slow, 1500 + 4000 * slow, 1500])
    q, v = closed_on_model(law, law, left, target)
    t: FloatArray = np.linspace(0.0, PERIOD * (target.size - 1), target.size)
    steps = [asdict(step) for step in step_metrics(t, q, target, right - left)[1:]]
    every = slice(None, None, 5)
    return {"steps": steps, "t_s": t[every], "q_m": q[every], "target_m": target[every], "v_V": v[every]}
