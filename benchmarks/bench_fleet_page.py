"""The page of a large fleet: its size, the cost of making it, and the time until Chromium shows its first rows.

    python benchmarks/bench_fleet_page.py [--count 100000] [--page FILE]

The datasheet is that of a simulated device, its facts and errors varied at random; one in a hundred prototypes failed.
Without Chromium and its driver only size and cost are told.
"""

import argparse
import json
import shutil
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import numpy as np

from pipeline.diagnostics.facts.datasheet import make_datasheet
from pipeline.reporting.fleet_report import fleet_report
from pipeline.reporting.fleet_table import Summary, failed, summary
from tests.reporting.synthetic import run_data


def members(count: int) -> Iterator[Summary]:
    """Prototypes of a fleet, one after another."""
    data, rng = run_data(), np.random.default_rng(0)
    document = json.loads(json.dumps(make_datasheet(data).to_json(data)))
    for i in range(count):
        name = f"P{i:06}"
        if i % 100 == 99:
            yield failed(name, f"{name}.mat: channel 'Laser_q' is missing")
            continue
        facts = [fact | {"value": _varied(fact["value"], 0.1, rng)} for fact in document["facts"]]
        scores = [score | {"nrmse": _varied(score["nrmse"], 0.3, rng)} for score in document["scores"]]
        yield summary(name, document | {"facts": facts, "scores": scores}, f"{name}/report.html")


def _varied(value: float | None, spread: float, rng: np.random.Generator) -> float | None:
    return None if value is None else value * float(np.exp(rng.normal(0.0, spread)))


def browser() -> Any:
    """A running Chromium; None where there is none."""
    program, driver = shutil.which("chromium") or shutil.which("google-chrome"), shutil.which("chromedriver")
    if program is None or driver is None:
        return None
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    options.binary_location = program
    for argument in ("--headless=new", "--disable-gpu", "--disable-dev-shm-usage", "--no-sandbox"):
        options.add_argument(argument)
    return webdriver.Chrome(options=options, service=Service(driver))


def opened(running: Any, page: Path) -> float:
    """Wall time [s] from the start of loading until the first rows stand in the table."""
    running.get(page.as_uri())
    began = time.monotonic()
    while not running.execute_script("return document.documentElement.dataset.fleet"):
        if time.monotonic() - began > 60.0:
            raise SystemExit("the page shows no rows")
        time.sleep(0.005)
    return float(running.execute_script("return performance.now()")) / 1e3


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=100_000)
    parser.add_argument("--page", type=Path, help="keep the page here")
    options = parser.parse_args()
    began = time.process_time()
    drawn = list(members(options.count))
    made = time.process_time()
    text = fleet_report(drawn, "fleet")
    print(f"{options.count} prototypes: {len(text.encode()) / 1e6:.2f} MB, made in {time.process_time() - made:.1f} s "
          f"of processor time (and {made - began:.1f} s for what it shows)")  # fmt: skip
    with tempfile.TemporaryDirectory() as folder:
        page = options.page or Path(folder) / "fleet.html"
        page.write_text(text, encoding="utf-8")
        running = browser()
        if running is not None:
            times = [opened(running, page.resolve()) for _ in range(5)]
            running.quit()
            print(f"first rows in Chromium after {min(times):.2f} to {max(times):.2f} s")


if __name__ == "__main__":
    main()
