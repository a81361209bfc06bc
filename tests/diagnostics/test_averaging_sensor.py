"""A sensor that averages over a window sees the motion late: its window in the settings mends the delay."""

from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from cli import app
from tests.prototypes import motion, settings, write_csv

WINDOW = 80
PLAIN, AVERAGED = 'unit = "mm" }', 'unit = "mm", average = 0.08 }'


@pytest.fixture(scope="module")
def prototype(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("averaging")
    t, q, v = motion(30.0, 1000.0, 1, noise=3e-6)
    sums, last = np.concatenate(([0.0], np.cumsum(q))), np.arange(1, q.size + 1)
    first = np.maximum(last - WINDOW, 0)
    write_csv(folder / "log.csv", t, (sums[last] - sums[first]) / (last - first), v)
    (folder / "P.toml").write_text(settings(), encoding="utf-8")
    return folder / "P.toml"


def test_the_window_is_named_and_taken(prototype: Path) -> None:
    noted = CliRunner().invoke(app, ["check", str(prototype), "-q"])
    assert noted.exit_code == 0, noted.stderr
    assert "averages over a window, give that as `average` in [channels] q" in noted.stdout.replace("\n", " ")
    prototype.write_text(settings().replace(PLAIN, AVERAGED), encoding="utf-8")
    taken = CliRunner().invoke(app, ["check", str(prototype), "-q"])
    assert taken.exit_code == 0, taken.stderr
    assert "(!)" not in taken.stdout
    assert "q: 80 ms averaged by its sensor: half of it is taken off its time" in taken.stderr
