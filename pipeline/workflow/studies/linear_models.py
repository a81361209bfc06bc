"""Equilibria of a run's joint and the linear models about them, kept in the run and written for other programs."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from ...control.plant import LinearModel, equilibria
from ...device.device import JOINT
from ...diagnostics.facts.events import rest_facts
from ...scoring.wells import wells_of
from ...signals.log import log_of
from ...store import layout
from ...store.outputs import new_outputs, rebased, remove_outdated
from ...system.progress import OnProgress
from ..engine import Observer
from .controlled_run import ControlRun, control_run, kept_document

MOST_EQUILIBRIA = 9
"""Most equilibria of a joint, by far: an earlier call left files of at most this number."""


def linearise(root: Path, voltages: tuple[float, float], observer: Observer) -> dict[str, Any]:
    """Equilibria and their linear models under constant voltages [V], with the measured ring-downs beside them."""

    def work(joint_run: ControlRun, _on_progress: OnProgress) -> dict[str, Any]:
        """Equilibria and linear models of the run's joint."""
        return {
            "format": "debist-linear/1",
            "model": joint_run.name,
            "v_V": list(voltages),
            "equilibria": [model.to_json() | {"bode": bode(model)} for model in _linear_models(joint_run, voltages)],
            "measured": _measured_ringing(joint_run),
        }

    control_run(root).check_voltages("--v1, --v2", *voltages)
    return kept_document(root, "linear", {"voltages": list(voltages)}, observer, work)


def linear_models(root: Path, voltages: tuple[float, float]) -> list[LinearModel]:
    """Equilibria and linear models of a run's joint under constant voltages [V]."""
    joint_run = control_run(root)
    joint_run.check_voltages("v1, v2", *voltages)
    return _linear_models(joint_run, voltages)


def _linear_models(joint_run: ControlRun, voltages: tuple[float, float]) -> list[LinearModel]:
    return equilibria(joint_run.plant, np.array(voltages, dtype=np.float64))


def bode(model: LinearModel) -> dict[str, list[float]]:
    """Transfer from the squared voltages [V²] to the reading [m], from 0.05 to 200 Hz: dB and degrees."""
    f = np.geomspace(0.05, 200.0, 200)
    identity = np.eye(len(model.a))
    answers = np.array(
        [(model.c @ np.linalg.solve(2j * np.pi * hertz * identity - model.a, model.b_squared))[0] for hertz in f]
    )
    answer = {"f_Hz": f.tolist()}
    for side, name in enumerate(("left", "right")):
        answer[f"{name}_dB"] = (20.0 * np.log10(np.abs(answers[:, side]) * 1e9)).tolist()
        answer[f"{name}_deg"] = np.degrees(np.unwrap(np.angle(answers[:, side]))).tolist()
    return answer


def _measured_ringing(joint_run: ControlRun) -> dict[str, Any]:
    """Mean frequency [Hz] and damping ratio of the ring-downs in both wells, over all logs, as in the datasheet."""
    logs = [(role, log) for role, log, _ in layout.logs(joint_run.prototype)]
    measured = [log_of(joint_run.run.read_table(layout.kinematics(*log))) for log in logs]
    hum = {line for log in logs for line in joint_run.run.record(layout.record(*log)).notes.get("hum", ())}
    wells = wells_of(measured, plant=JOINT)
    facts = rest_facts([(log.t, log.q, log.v) for log in measured], wells, hum, plant=JOINT)
    rings = {"left": facts.rings_left, "right": facts.rings_right}
    return {
        side: {
            "ring_downs": len(decays),
            "frequency_Hz": float(np.mean([ring.frequency for ring in decays])) if decays else None,
            "damping_ratio": float(np.mean([ring.damping for ring in decays])) if decays else None,
        }
        for side, decays in rings.items()
    }


def write_linear(root: Path, document: Mapping[str, Any], output: Path | None, *, force: bool) -> list[Path]:
    """Write linear models as JSON, MAT (v5) and one CSV of the matrices for each equilibrium.

    Parameters
    ----------
    root : Path
        Run folder.
    document : mapping
        The linear models.
    output : Path or None
        Folder of the files; None: the exports of the run.
    force : bool
        Whether files of others may be replaced.
    """
    from scipy.io import savemat

    folder = output or root / layout.EXPORTS
    with new_outputs(folder, "control", force=force, made_from=control_run(root).origin) as staged:
        (staged / "linear.json").write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8", newline="\n")
        structs: dict[str, Any] = {}
        for number, point in enumerate(document["equilibria"], start=1):
            matrices = {name: np.array(point[name]) for name in ("A", "B", "C", "D", "B_squared")}
            structs[f"equilibrium_{number}"] = matrices | {
                "x0": np.array(point["x0"])[:, None], "v0": np.array(point["v_V"])[:, None], "q0": point["q_m"],
                "stable": float(point["stable"]),
            }  # fmt: skip
            header = ",".join([*point["states"], "v1 [V]", "v2 [V]", "v1^2 [V^2]", "v2^2 [V^2]"])
            rows = np.hstack([matrices["A"], matrices["B"], matrices["B_squared"]])
            lines = [
                f"rate of {name}," + ",".join(map(repr, row))
                for name, row in zip(point["states"], rows.tolist(), strict=True)
            ]
            readings = np.hstack([matrices["C"], matrices["D"], np.zeros_like(matrices["D"])])
            lines += [",".join(["reading of q [m]", *map(repr, row)]) for row in readings.tolist()]
            text = (
                f"# equilibrium at q = {point['q_m']!r} m, v = {point['v_V']}\nrow,{header}\n" + "\n".join(lines) + "\n"
            )
            (staged / f"linear-{number}.csv").write_text(text, encoding="utf-8", newline="\n")
        savemat(staged / "linear.mat", structs)
        written = sorted(staged.iterdir())
    numbers = range(len(document["equilibria"]) + 1, MOST_EQUILIBRIA + 1)
    remove_outdated(folder, (f"linear-{number}.csv" for number in numbers), "control")
    return [rebased(path, staged, folder) for path in written]
