"""A measured machine: the propeller arm of the quarter drone against what others published of it."""

import subprocess
import sys
from pathlib import Path

import pytest

BENCHMARK = Path(__file__).resolve().parents[3] / "benchmarks" / "bench_quarter_drone.py"
NARX, GREY_BOX, NETWORK = "polynomial NARX", "grey box, scipy", "neural ODE, second"


@pytest.mark.long
def test_the_arm_is_predicted_better_than_by_published_models(shared_folder: Path) -> None:
    """On steps than by each of them, on the other records than by the worst of those that are named."""
    done = subprocess.run(
        [sys.executable, BENCHMARK, shared_folder / "measured" / "quarter-drone"],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    rows = {line[:26].strip(): list(map(float, line[26:].split())) for line in done.stdout.splitlines()[1:-1]}
    own, published = rows["debist rbf"], [row for name, row in rows.items() if not name.startswith("debist")]
    assert own[1] < min(row[1] for row in published)
    assert own[0] < rows[NETWORK][0]
    assert own[2] < rows[GREY_BOX][2] < rows[NARX][2]
