"""All models on public measured sets of other devices, `python benchmarks/devices.py FOLDER [--only NAME]`.

Nothing is fetched. FOLDER holds what you downloaded, under these names; what is missing is left out:

  silverbox/SNLS80mV.mat                        an electronic Duffing circuit (nonlinearbenchmark.org, Silverbox)
  emps/DATA_EMPS.mat, DATA_EMPS_PULSES.mat      a friction drive (nonlinearbenchmark.org, EMPS)
  cascaded-tanks/dataBenchmark.mat              two tanks with overflow (nonlinearbenchmark.org, Cascaded Tanks)
  quarter-drone/sinal2…4_*.csv                  a propeller on an arm (helonayala/sysid, data/quarter_drone)
  ball-and-hoop/*.mat                           a motor that turns a hoop (helonayala/sysid, data/ball_and_hoop)
  ball-and-beam/*.mat                           a ball on a tilting beam (helonayala/sysid at commit bf088ed, data)
  ANYTHING/device.toml                          settings of any other device beside its logs, such as a soft actuator,
                                                or those of simulated_devices.py

Splits are the official ones (those of the `nonlinear_benchmarks` loader; for the drone its authors'; hoop and beam have
none: training on random steps, the beam's first and its first multisine; tests on other records). Everything goes
through the commands at default settings but for the sample interval, which is that of the log (10 ms for EMPS and 20 ms
for the beam, recorded at 1 ms). Runs start from the measured q of the first sample; where a log begins in motion, with
the velocity with which each model follows the first ten samples best. Every sample counts, where the loader leaves out
the first 20 (EMPS), 50 (Silverbox) and 5 (tanks) for initialisation. Numbers are free-run RMSE on the test logs.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import bench_quarter_drone as drone
import numpy as np
from scipy.io import loadmat

Prepare = Callable[[Path, Path], str]
"""Source folder, working folder → settings; writes the logs that they name."""


@dataclass(frozen=True)
class Device:
    """A set: how its logs and settings are made, the unit of the table and its factor from SI, published results."""

    needs: tuple[str, ...]
    prepare: Prepare
    unit: str
    factor: float
    published: dict[str, str] = field(default_factory=dict)


def settings(name: str, train: list[str], validation: list[str], unit: str, interval: float) -> str:
    """Settings of a device with one linear input, logged as `time, u, y`."""
    logs = [json.dumps([f"{log}.csv" for log in part]) for part in (train, validation)]
    return f"""name = "{name}"
[logs]
train = {logs[0]}
validation = {logs[1]}
[channels]
time = {{ channel = "time", unit = "s" }}
q  = {{ channel = "y", unit = "{unit}" }}
v1 = {{ channel = "u", unit = "V" }}
[plant]
inputs = "linear"
[ingest]
sample_interval = {interval!r}
record_interval = {min(interval, 0.001)!r}
"""


def write(folder: Path, name: str, u: np.ndarray, y: np.ndarray, step: float) -> None:
    table = np.column_stack([step * np.arange(len(u)), u, y])
    np.savetxt(folder / f"{name}.csv", table, delimiter=",", header="time,u,y", comments="", fmt="%.9g")


def silverbox(source: Path, folder: Path) -> str:
    data, step = loadmat(source / "SNLS80mV.mat"), 1.0 / 610.35
    u, y = data["V1"][0], data["V2"][0]
    multisine = slice(40650, 127400)
    split = int(0.75 * (multisine.stop - multisine.start))
    write(folder, "train", u[multisine][:split], y[multisine][:split], step)
    write(folder, "multisine", u[multisine][split:], y[multisine][split:], step)
    write(folder, "arrow", u[100:40575], y[100:40575], step)
    return settings("silverbox", ["train"], ["multisine", "arrow"], "V", step).replace(
        f"record_interval = {0.001!r}", f"record_interval = {step!r}"
    )


def emps(source: Path, folder: Path) -> str:
    for name, file in (("train", "DATA_EMPS.mat"), ("test", "DATA_EMPS_PULSES.mat")):
        data = loadmat(source / file)
        write(folder, name, data["vir"][:, 0], data["qm"][:, 0], 1e-3)
    return settings("emps", ["train"], ["test"], "m", 0.01)


def tanks(source: Path, folder: Path) -> str:
    data = loadmat(source / "dataBenchmark.mat")
    step = float(data["Ts"][0, 0])
    write(folder, "train", data["uEst"][:, 0], data["yEst"][:, 0], step)
    write(folder, "test", data["uVal"][:, 0], data["yVal"][:, 0], step)
    return settings("cascaded-tanks", ["train"], ["test"], "V", step) + 'rails = "keep"\n'  # overflow is the subject


HOOP = {"random": "randomStepSequence", "fixed": "fixedStepSequence", "closed": "closedLoop"}
BEAM_TRAIN = {"multisine": "05_multisine_01", "steps": "03_random_steps_01"}
BEAM_TEST = {"multisine-2": "06_multisine_02", "steps-3": "03_random_steps_03", "swept": "04_swept_sine"}


def hoop(source: Path, folder: Path) -> str:
    _as_csv(source, folder, HOOP, 0.1)
    text = settings("ball-and-hoop", ["random"], ["fixed", "closed"], "V", 0.1)
    return text.replace("record_interval = 0.001", "record_interval = 0.1")


def beam(source: Path, folder: Path) -> str:
    _as_csv(source, folder, BEAM_TRAIN | BEAM_TEST, 1e-3)
    return settings("ball-and-beam", [*BEAM_TRAIN], [*BEAM_TEST], "V", 0.02)


def _as_csv(source: Path, folder: Path, logs: dict[str, str], step: float) -> None:
    for name, file in logs.items():
        data = loadmat(source / f"{file}.mat")
        write(folder, name, data["u"].ravel(), data["y"].ravel(), step)


def quarter_drone(source: Path, folder: Path) -> str:
    for log, stem in drone.RECORDS.items():
        record = source / f"{stem}_malha_fechada.csv"
        if log != "swept":
            drone.write_part(record, folder / "train" / f"{log}.csv", drone.START, drone.SPLIT)
        start = drone.START if log == "swept" else drone.SPLIT
        drone.write_part(record, folder / "validation" / f"{log}.csv", start, drone.STOP)
    return drone.SETTINGS


DEVICES = {
    "silverbox": Device(
        ("SNLS80mV.mat",), silverbox, "mV", 1e3, {"published, last multisine": "0.26 to 0.36", "our bar": "0.26 / 0.5"}
    ),
    "emps": Device(("DATA_EMPS.mat", "DATA_EMPS_PULSES.mat"), emps, "mm", 1e3, {"best published": "2.6"}),
    "cascaded-tanks": Device(
        ("dataBenchmark.mat",), tanks, "V", 1.0, {"published": "grey box 0.19, state-space network 0.31"}
    ),
    "ball-and-hoop": Device(tuple(f"{name}.mat" for name in HOOP.values()), hoop, "V", 1.0),
    "ball-and-beam": Device(tuple(f"{name}.mat" for name in (BEAM_TRAIN | BEAM_TEST).values()), beam, "V", 1.0),
    "quarter-drone": Device(
        tuple(f"{stem}_malha_fechada.csv" for stem in drone.RECORDS.values()), quarter_drone, "deg", 180.0 / np.pi,
        {name: " / ".join(f"{value:.3f}" for value in row) for name, row in drone.PUBLISHED.items()},
    ),
}  # fmt: skip


def run(prototype: Path, out: Path) -> tuple[dict[str, dict[str, float | None]], str]:
    """Test RMSE in SI by model and log; what was chosen, and which share of the tests its tubes hold."""
    debist = [str(Path(sys.executable).parent / "debist")]
    quiet = subprocess.DEVNULL
    subprocess.run([*debist, "ingest", prototype.name, "-o", out], cwd=prototype.parent, check=True, stdout=quiet)
    for stage in ("differentiate", "identify", "validate", "compare"):
        subprocess.run([*debist, stage, out], check=True, stdout=quiet)
    shown = subprocess.run([*debist, "validate", out, "--json"], check=True, capture_output=True)
    errors: dict[str, dict[str, float | None]] = {}
    held = []
    for row in json.loads(shown.stdout)["scores"]:
        if row["role"] == "validation" and row["signal"] == "q":
            errors.setdefault(row["model"], {})[row["log"]] = row["rmse"] if row["status"] == "ok" else None
            held += [] if row["in_tube"] is None else [f"{row['log']} {100.0 * row['in_tube']:.0f} %"]
    manifest = json.loads((out / "manifest.json").read_text(encoding="utf-8"))
    notes = manifest["artifacts"]["model.h5"]["notes"].get("rbf")
    if notes is None:
        return errors, "the joint's equations were chosen"
    seconds = notes["processor_time"]["fit_s"]
    converged = "converged" if notes["converged"] else "NOT converged"
    tubes = f"tubes hold {', '.join(held)}"
    return errors, f"{notes['chosen']}; {converged}; {tubes}; {seconds:.1f} s of processor time"


def table(name: str, unit: str, factor: float, errors: dict[str, dict[str, float | None]]) -> None:
    logs = list(next(iter(errors.values())))
    print(f"\n{name}: test RMSE [{unit}]" + "".join(f"{log:>14}" for log in logs))
    for model, by in errors.items():
        cells = ["diverged" if (e := by.get(log)) is None else f"{factor * e:.4g}" for log in logs]
        print(f"  {model:<24}" + "".join(f"{cell:>14}" for cell in cells))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", help="one of the sets")
    given = parser.parse_args()
    missing = {
        name: [file for file in device.needs if not (given.folder / name / file).exists()]
        for name, device in DEVICES.items()
        if (given.folder / name).is_dir()
    }
    for name, files in missing.items():
        if files:
            print(f"{name} is left out: {given.folder / name} has no {', '.join(files)}")
    known = [name for name, files in missing.items() if not files]
    others = sorted(path.parent.name for path in given.folder.glob("*/device.toml"))
    wanted = [name for name in (*known, *others) if given.only in (None, name)]
    if not wanted:
        parser.error(f"{given.folder} holds none of the sets; this script's first lines say which files it looks for")
    for name in wanted:
        device = DEVICES.get(name)
        with tempfile.TemporaryDirectory() as temporary:
            folder = Path(temporary)
            prototype = given.folder.resolve() / name / "device.toml"
            if device is not None:
                prototype = folder / "device.toml"
                prototype.write_text(device.prepare(given.folder / name, folder), encoding="utf-8")
            errors, chosen = run(prototype, folder / "run")
        table(name, device.unit if device else "SI", device.factor if device else 1.0, errors)
        for source, row in (device.published if device else {}).items():
            print(f"  {source:<32}{row}")
        print(f"  rbf: {chosen}", flush=True)


if __name__ == "__main__":
    main()
