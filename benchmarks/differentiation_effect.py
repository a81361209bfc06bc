"""What the differentiator does to the identified models: free-run NRMSE of q on the validation logs of P1 to P3.

    python benchmarks/differentiation_effect.py [P1 P2 P3]

Takes a minute of processor time per prototype; needs the example logs beside the repository.
"""

import json
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parent / "prototypes"
VARIANTS: dict[str, dict[str, object]] = {
    "order 3, 1 ms (default)": {},
    "order 2, 1 ms": {"order": 2},
    "order 4, 1 ms": {"order": 4},
    "order 3, 10 ms": {"record_interval": 0.01},
    "Savitzky-Golay, 1 ms": {"method": "savitzky-golay"},
    "paper: order 1, alpha 0.01, 10 ms": {"order": 1, "alpha": 0.01, "epsilon": 1e-6, "record_interval": 0.01},
}


def debist(*arguments: str) -> str:
    command = [str(Path(sys.executable).with_name("debist")), *arguments]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def settings(example: Path, differentiate: dict[str, object]) -> str:
    """The example's settings file with absolute paths to its logs, another `[differentiate]` and record."""
    text = example.read_text(encoding="utf-8")
    for paths in tomllib.loads(text)["logs"].values():
        for path in paths:
            text = text.replace(f'"{path}"', json.dumps(str((example.parent / path).resolve())))
    lines = [f"{key} = {json.dumps(value)}" for key, value in differentiate.items() if key != "record_interval"]
    record = ["[ingest]", "record_interval = 0.01"] if "record_interval" in differentiate else []
    return "\n".join([text, "[differentiate]", *lines, *record, ""])


def scores(example: Path, folder: Path, differentiate: dict[str, object]) -> dict[str, str]:
    prototype = folder / "prototype.toml"
    prototype.write_text(settings(example, differentiate), encoding="utf-8")
    run = str(folder / "run")
    debist("ingest", str(prototype), "-o", run)
    debist("differentiate", run)
    debist("identify", run)
    records = json.loads(debist("validate", run, "--json"))["scores"]
    rows = [r for r in records if r["role"] == "validation" and r["signal"] == "q"]
    return {r["model"]: f"{100 * r['nrmse']:.2f}" if r["status"] == "ok" else r["status"] for r in rows}


def main(names: list[str]) -> None:
    print(f"{'prototype':10s} {'differentiation':36s} NRMSE of q [%] by model, validation")
    for name in names:
        for variant, differentiate in VARIANTS.items():
            with tempfile.TemporaryDirectory() as folder:
                found = scores(EXAMPLES / f"{name}.toml", Path(folder), differentiate)
                print(f"{name:10s} {variant:36s} " + "  ".join(f"{m} {s}" for m, s in found.items()), flush=True)


if __name__ == "__main__":
    main(sys.argv[1:] or ["P1", "P2", "P3"])
