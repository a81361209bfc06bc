"""Tables and figures of the comparison in docs/: `python benchmarks/comparison_tables.py -o RUNS`.

Brings the runs of benchmarks/prototypes/*.toml in RUNS up to date (`debist run`, `debist study data`), then writes
docs/measured/comparison.md and docs/figures/comparison-*.svg from what they hold.
`--no-run` writes only. Processor times are those of the machine; everything else is the same wherever it is run.
"""

import argparse
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from datetime import date
from pathlib import Path
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")

import matplotlib

matplotlib.use("svg")
ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

import matplotlib.pyplot as plt  # noqa: E402 - after the choice of the backend
import numpy as np  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402

from pipeline.reporting.figure import MODEL_COLOURS  # noqa: E402
from pipeline.store import layout  # noqa: E402
from pipeline.store.run_folder import RunFolder  # noqa: E402
from pipeline.workflow.report_data import load_scores  # noqa: E402

EXAMPLES = {
    "P1": "P1, simulated",
    "P2": "P2, simulated",
    "P3": "P3, simulated",
    "quarter-drone": "Quarter drone, measured",
}
PAGE, FIGURES = ROOT / "docs" / "measured" / "comparison.md", ROOT / "docs" / "figures"
MEANING = """Errors are NRMSE of q on the validation logs, which no fit has seen, in % of the measured range.
P1 to P3 are simulated, the quarter drone is measured. [How models are
compared](../explanation/comparison.md) defines the numbers.
"""
STYLE: Any = {"svg.hashsalt": "debist", "font.size": 8, "axes.spines.top": False, "axes.spines.right": False}
MODELS = ("hybrid", "rbf", "rbf-paper", "sindy", "sindy-default", "narx", "analytical", "analytical-calibrated")
COLOUR = dict(zip(MODELS, MODEL_COLOURS, strict=False))
HORIZONS = (("nrmse_one_step", 0.01), ("nrmse_100ms", 0.1), ("nrmse_1s", 1.0), ("nrmse", 37.5))


def bring_up_to_date(runs: Path) -> None:
    """The commands that the page states."""
    for name in EXAMPLES:
        for command in commands(name, runs):
            subprocess.run([str(Path(sys.executable).with_name("debist")), *command], check=True, cwd=ROOT)


def commands(name: str, runs: Path | str) -> Iterator[list[str]]:
    yield ["run", f"benchmarks/prototypes/{name}.toml", "-o", f"{runs}/{name}", "-q"]
    if name == "P1":
        yield ["report", f"{runs}/{name}", "--figures", "sans"]
        yield ["study", "data", f"{runs}/{name}"]


def page(runs: Path) -> Iterator[str]:
    commit = subprocess.run(["git", "rev-parse", "--short=8", "HEAD"], capture_output=True, text=True, cwd=ROOT).stdout
    yield "# Measured: every model on the example logs\n\nWritten by `python benchmarks/comparison_tables.py -o RUNS` "
    yield f"({date.today():%-d %B %Y}, commit {commit.strip()}).\n\n"
    yield "<!-- not run: minutes, and logs that lie elsewhere -->\n```sh\n"
    yield "".join(f"debist {' '.join(c)}\n" for name in EXAMPLES for c in commands(name, "RUNS"))
    yield f"```\n\n{MEANING}\n## Free run, with its 95 % interval\n\n"
    rows = {name: validation_rows(runs / name) for name in EXAMPLES}
    yield from table({name: {model: free_run(row) for model, row in of.items()} for name, of in rows.items()})
    yield "\n## 1 s after a measured state\n\n"
    yield from table(
        {name: {model: percent(row["nrmse_1s"]) for model, row in of.items()} for name, of in rows.items()}
    )
    yield "\n## Fit, in seconds of processor time on one core\n\n"
    yield from table({name: fit_times(runs / name) for name in EXAMPLES})


def table(cells: dict[str, dict[str, str]]) -> Iterator[str]:
    """One row for each model, one column for each example."""
    titles = [title.split(",")[0] for title in EXAMPLES.values()]
    yield f"| model | {' | '.join(titles)} |\n| --- | {' | '.join(['---:'] * len(titles))} |\n"
    for model in MODELS:
        yield f"| {model} | {' | '.join(cells[name].get(model, '–') for name in EXAMPLES)} |\n"


def free_run(row: dict[str, Any]) -> str:
    if row["status"] != "ok":
        return f"diverged at {row['diverged_at_s']:.1f} s"
    return f"{percent(row['nrmse'])} [{percent(row['nrmse_low'])}, {percent(row['nrmse_high'])}]"


def percent(share: float | None) -> str:
    return "–" if share is None else f"{100 * share:.2f}"


def fit_times(root: Path) -> dict[str, str]:
    """Processor time [s] of the fit of each model."""
    run = RunFolder.open(root)
    notes = run.record(layout.MODELS).notes
    fits = {model: notes[model] for model in notes["identified"]}
    fits |= {model: run.record(layout.baseline(model)).notes for model in run.prototype.baselines}
    return {model: f"{fit['processor_time']['fit_s'] or 0.0:.2g}" for model, fit in fits.items()}


def save(figure: Figure, name: str) -> None:
    figure.savefig(FIGURES / f"comparison-{name}.svg", metadata={"Date": None})
    plt.close(figure)


def validation_rows(root: Path) -> dict[str, dict[str, Any]]:
    return {s["model"]: s for s in load_scores(root) if s["role"] == "validation" and s["signal"] == "q"}


def draw_errors(runs: Path) -> None:
    """Free-run error of q on the log that nothing was fitted to, with its interval; diverged runs at the edge."""
    figure, axes = plt.subplots(1, len(EXAMPLES), figsize=(9.0, 2.6), sharey=True, layout="constrained")
    for axis, (name, title) in zip(axes, EXAMPLES.items(), strict=True):
        rows = validation_rows(runs / name)
        for place, model in enumerate(MODELS):
            row = rows.get(model)
            if row is None:
                continue
            if row["nrmse"] is None:
                axis.text(95.0, place, "diverged", ha="right", va="center", color=COLOUR[model])
                continue
            axis.plot([100 * row["nrmse_low"], 100 * row["nrmse_high"]], [place, place], color=COLOUR[model], lw=1.5)
            axis.plot(100 * row["nrmse"], place, "o", color=COLOUR[model], ms=5)
        axis.set(xscale="log", xlim=(0.02, 100.0), title=title, xlabel="NRMSE of q [%]")
        axis.set_xticks([0.1, 1, 10, 100], ["0.1", "1", "10", "100"])
        axis.grid(axis="x", lw=0.3)
    axes[0].set_yticks(range(len(MODELS)), MODELS)
    axes[0].invert_yaxis()
    save(figure, "errors")


def draw_horizons(runs: Path) -> None:
    """Error against how far ahead is predicted."""
    figure, axes = plt.subplots(1, len(EXAMPLES), figsize=(9.0, 2.6), sharey=True, layout="constrained")
    for axis, (name, title) in zip(axes, EXAMPLES.items(), strict=True):
        for model, row in validation_rows(runs / name).items():
            known = [(ahead, 100 * row[key]) for key, ahead in HORIZONS if row[key] is not None]
            axis.plot(*zip(*known, strict=True), "o-", color=COLOUR[model], lw=1.0, ms=3, label=model)
        axis.set(xscale="log", yscale="log", title=title, xlabel="time ahead")
        axis.set_xticks([ahead for _, ahead in HORIZONS], ["one step", "0.1 s", "1 s", "free run"], rotation=45)
        axis.minorticks_off()
        axis.grid(lw=0.3)
    axes[0].set_ylabel("NRMSE of q [%]")
    axes[0].set_yticks([0.01, 0.1, 1, 10], ["0.01", "0.1", "1", "10"])
    drawn = {label: line for axis in axes for line, label in zip(*axis.get_legend_handles_labels(), strict=True)}
    lines = [drawn[model] for model in MODELS if model in drawn]
    figure.legend(lines, [line.get_label() for line in lines], loc="outside lower center", ncols=8, frameon=False)
    save(figure, "horizons")


def draw_pulse(runs: Path, models: Sequence[str] = ("hybrid", "sindy", "narx", "rbf-paper")) -> None:
    """The six seconds of P1's validation log around the place where the recipe of the paper first loses the well."""
    run = RunFolder.open(runs / "P1")
    measured = run.read_table(layout.kinematics("validation", "validation"))
    runs_of = {m: run.read_table(layout.predictions("validation", "validation", m)) for m in models}
    lost = np.abs(runs_of["rbf-paper"]["q"] - measured["q"]) > 0.5 * np.nanmax(np.abs(measured["q"]))
    start = float(measured["t"][np.argmax(lost)]) - 2.0
    rows = (measured["t"] >= start) & (measured["t"] <= start + 6.0)
    figure, (top, bottom) = plt.subplots(
        2, 1, figsize=(7.0, 3.4), sharex=True, height_ratios=(3, 1), layout="constrained"
    )
    top.plot(measured["t"][rows], 1e3 * measured["q"][rows], color="black", lw=2.2, alpha=0.5, label="log")
    for model, table in runs_of.items():
        top.plot(measured["t"][rows], 1e3 * table["q"][rows], color=COLOUR[model], lw=1.0, label=model)
    for name, style in (("v1", "-"), ("v2", "--")):
        bottom.plot(measured["t"][rows], 1e-3 * measured[name][rows], style, color="0.3", lw=1.0, label=name)
    top.set_ylabel("q [mm]")
    bottom.set(ylabel="v [kV]", xlabel="t [s]")
    top.legend(frameon=False, ncols=5, loc="upper center", bbox_to_anchor=(0.5, 1.2))
    bottom.legend(frameon=False, ncols=2, loc="upper right")
    save(figure, "pulse")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "runs", metavar="RUNS")
    parser.add_argument("--no-run", action="store_true")
    options = parser.parse_args()
    runs = options.output.resolve()
    if not options.no_run:
        bring_up_to_date(runs)
    PAGE.write_text("".join(page(runs)), encoding="utf-8")
    with plt.rc_context(STYLE):
        for draw in (draw_errors, draw_horizons, draw_pulse):
            draw(runs)
    shutil.copyfile(RunFolder.open(runs / "P1").path("figures/curves.svg"), FIGURES / "comparison-curves.svg")


if __name__ == "__main__":
    main()
