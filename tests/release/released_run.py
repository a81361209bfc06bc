"""A run folder as the present version leaves it: `python -m tests.release.released_run` writes it beside this module.

Each release adds one archive, `VERSION.zip`. `test_released_runs` opens all of them with the program at hand.
"""

import gzip
import os
import tempfile
import zipfile
from pathlib import Path

from typer.testing import CliRunner

from cli import app
from pipeline import __version__
from tests.prototypes import motion, settings, write_csv

FOLDER = Path(__file__).parent
SETTINGS = """\
[identify]
models = ["rbf-paper"]
smoothing = 1.0
[compare]
models = ["sindy"]
"""


def write_released_run(folder: Path) -> None:
    """Two simulated logs, their settings `released.toml`, and the run `run` without a page."""
    for name, seed in (("train", 3), ("validation", 4)):
        log = folder / f"{name}.csv"
        write_csv(log, *motion(8.0, 200.0, seed, noise=2e-6))
        log.with_suffix(".csv.gz").write_bytes(gzip.compress(log.read_bytes(), mtime=0))
        log.unlink()
    text = settings(SETTINGS, name="released", train="train.csv.gz", validation="validation.csv.gz")
    (folder / "released.toml").write_text(text, encoding="utf-8")
    os.chdir(folder)
    done = CliRunner().invoke(app, ["run", "released.toml", "-o", "run", "--no-report", "-q"])
    assert done.exit_code == 0, done.output


def main() -> None:
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        write_released_run(folder)
        archive = FOLDER / f"{__version__}.zip"
        with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as packed:
            for path in sorted(folder.rglob("*")):
                if path.is_file() and path.name != ".lock":
                    packed.write(path, path.relative_to(folder))
        os.chdir(FOLDER)
    print(archive, archive.stat().st_size)


if __name__ == "__main__":
    main()
