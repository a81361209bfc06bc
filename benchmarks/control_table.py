"""The table of `control_fleet.py`: what was measured of each joint, kept in a file, as a line, and all together."""

import json
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from pipeline.numerics.arrays import FloatArray


@dataclass
class Found:
    """What was measured of one joint."""

    name: str
    kind: str
    lines: dict[str, list[float]] = field(default_factory=dict)


def told(found: list[Found]) -> None:
    def snaps(name: str) -> str:
        rows = np.concatenate([np.array(each.lines[name]).reshape(-1, 3) for each in found])
        good = rows[rows[:, 0] > 0.5]
        middle = (np.median(rows[:, 1]), 1e3 * np.median(rows[:, 2])) if len(good) else (np.inf, np.nan)
        return f"{100 * rows[:, 0].mean():9.1f}{middle[0]:12.3f}{middle[1]:14.2f}"

    print(f"\n{len(found)} joints\n{'':28s}{'snaps %':>9s}{'settling s':>12s}{'overshoot mm':>14s}   (medians)")
    for name in (
        "feedback",
        "feedforward",
        "pulse, nominal parameters",
        "pulse, rbf-paper",
        "plain 3 kV, 0.3 s",
        "plain 3 kV, 0.5 s",
    ):
        print(f"{name:28s}{snaps(name)}")

    def whole(name: str) -> FloatArray:
        return np.concatenate([each.lines[name] for each in found])

    held = np.array([max(each.lines["hold"]) for each in found])
    print(f"unstable equilibrium, 60 s, lag 1 and 3 ms: RMS at most 0.3 mm on {np.sum(held <= 0.3e-3)} of {len(found)}")
    fast = whole("ramp")
    for name, static in (("60 s", whole("static")), ("6 s", fast)):
        law, best = whole("share") * fast / static, whole("possible") * fast / static
        print(
            f"lowest voltage over that of a ramp of {name}: median {100 * np.median(law):.0f}, worst "
            f"{100 * law.max():.0f} %, at most 70 % in {np.sum(law < 0.705)} of {len(law)} directions; the best found "
            f"with known state: median {100 * np.median(best):.0f}, at most 70 % in {np.sum(best < 0.705)}"
        )
    charge = np.array([each.lines["charge"][0] for each in found])
    print(f"voltages at the unstable equilibrium, RMS: median {np.median(charge):.0f}, at most {charge.max():.0f} V")
    print(f"impulses caught: {100 * whole('caught').mean():.1f} % of {len(whole('caught'))}")
    print(f"Brier score of the switching probability: {whole('brier').mean():.4f} over {len(whole('brier'))} pulses")
    band = whole("band")
    print(f"band of 90 % holds the joint's lowest switching voltage: {100 * band.mean():.0f} % of {len(band)}")
    print(f"robustness: {100 * whole('robust').mean():.1f} % of {len(whole('robust'))} snaps")
    print(f"one step in C: {1e6 * whole('step').max():.1f} µs at most")


def line(each: Found) -> str:
    parts = []
    for name in ("feedback", "feedforward", "plain 3 kV, 0.5 s"):
        rows = np.array(each.lines[name]).reshape(-1, 3)
        parts.append(f"{name} {100 * rows[:, 0].mean():.0f} % {np.median(rows[:, 1]):.3f} s")
    held = "/".join(f"{1e3 * x:.2f}" for x in each.lines["hold"])
    shares = "/".join(f"{x:.2f}" for x in each.lines["share"])
    caught, score = np.mean(each.lines["caught"]), np.mean(each.lines["brier"])
    band, step = np.mean(each.lines["band"] or [np.nan]), 1e6 * each.lines["step"][0]
    robust = np.mean(each.lines["robust"])
    parts += [f"held {held} mm", f"voltage {shares}", f"caught {caught:.2f}", f"Brier {score:.3f}"]
    parts += [f"band {band:.2f}", f"robust {robust:.2f}", f"step {step:.1f} µs"]
    return f"{each.name}: {', '.join(parts)}"


def recorded(file: Path | None) -> list[Found]:
    """Joints that a file of results holds."""
    if file is None or not file.is_file():
        return []
    return [Found(**json.loads(line)) for line in file.read_text(encoding="utf-8").splitlines()]
