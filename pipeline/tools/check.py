"""Check a prototype without a run folder: its logs are ingested into a temporary one, nothing is fitted."""

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from pipeline.runs.engine import Observer, bring_up_to_date
from pipeline.runs.run_folder import RunFolder
from pipeline.settings import Prototype
from pipeline.stages import ingest
from pipeline.stages.belonging import load_settings
from pipeline.stages.check import examine

if TYPE_CHECKING:
    from pipeline.checks.rows import CheckRow


def check(place: Path, observer: Observer) -> "tuple[Prototype, list[CheckRow]]":
    """Look at the logs of a settings file, or again at those that a run folder holds.

    Raises
    ------
    DebistError
        Bad settings, a log that cannot be read or that ingest refuses.
    """
    if place.is_dir():
        run = RunFolder.open(place)
        prototype = run.prototype
        return prototype, examine(run, prototype)
    prototype = load_settings(place)
    with TemporaryDirectory(prefix="debist-check-") as folder:
        run = RunFolder.create(Path(folder) / "run", prototype.model_dump(mode="json"), place)
        bring_up_to_date(run, ingest.tasks(prototype, place), observer)
        return prototype, examine(run, prototype)
