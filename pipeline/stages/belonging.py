"""Which run folder belongs to which settings file, and what is known to be wrong before any work."""

from pathlib import Path

from pipeline.errors import InputError
from pipeline.loading import measured_curves
from pipeline.loading.raw_logs import load_settings, refuse_training_as_validation, require_sources
from pipeline.runs import layout
from pipeline.runs.hashing import file_sha256
from pipeline.runs.manifest import MANIFEST, Manifest, changes, load_manifest
from pipeline.runs.run_folder import RunFolder
from pipeline.settings import ROLES, Prototype, load_prototype, parse_prototype
from pipeline.stages import ingest


def default_output(prototype_file: Path) -> Path:
    """The run folder where none is named."""
    return Path("runs") / load_settings(prototype_file).folder


def place_of(given: Path, output: Path | None = None) -> tuple[Path, Path]:
    """Settings file and run folder, of which one is given: a run knows its settings file, a prototype its folder.

    Raises
    ------
    DebistError
        A folder without a run, bad settings, or a run whose settings file is gone.
    """
    if not given.is_dir():
        return given, output or default_output(given)
    if not (given / MANIFEST).exists():
        raise InputError(f"{given}: is a folder; name a settings file (*.toml), or the folder of a run")
    prototype_file = Path(load_manifest(given).prototype_file)
    if not prototype_file.is_file():
        raise InputError(f"{given}: its settings file {prototype_file} is gone; name the settings file instead")
    return prototype_file, output or given


def run_folder(given: Path) -> Path:
    """The run folder that is meant: itself, or the one of a settings file."""
    return default_output(given) if given.suffix.lower() == ".toml" and given.is_file() else given


def before_any_work(prototype: Prototype, prototype_file: Path, root: Path, *, replace: bool) -> None:
    """Everything that would make the work worthless and is known before it."""
    if (root / MANIFEST).is_file() and not replace:
        _refuse_foreign(load_manifest(root), prototype, prototype_file, root)
    require_sources([*ingest.tasks(prototype, prototype_file), *measured_curves.tasks(prototype, prototype_file)])
    refuse_training_as_validation(prototype, prototype_file)


def _refuse_foreign(stored: Manifest, prototype: Prototype, prototype_file: Path, root: Path) -> None:
    """A run folder belongs to a prototype: to its name, and to at least one of its logs."""
    if not stored.artifacts:
        return
    advice = "choose another folder with -o, or say --replace to overwrite it"
    if stored.prototype["name"] != prototype.name:
        raise InputError(
            f"{root}: holds the run of the prototype {stored.prototype['name']!r}, not of {prototype.name!r}; {advice}"
        )
    made_of = {digest for record in stored.artifacts.values() for digest in record.recipe.inputs.values()}
    before = Path(stored.prototype_file)
    paths = {layout.source(log, before).resolve() for role in ROLES for log in stored.prototype["logs"][role]}
    own = [layout.source(log, prototype_file) for _, _, log in layout.logs(prototype)]
    known = any(path.resolve() in paths for path in own)
    if not known and not any(path.is_file() and file_sha256(path) in made_of for path in own):
        raise InputError(f"{root}: holds a run of {prototype.name!r} from other logs, none of them of today; {advice}")


def settings_of(run: RunFolder) -> Prototype:
    """The settings that a run was made from."""
    return parse_prototype(run.manifest.prototype, f"{run.root}/manifest.json")


def edited(run: RunFolder) -> list[str]:
    """What differs between the settings file of today and what the run was made from; nothing if the file is gone.

    Raises
    ------
    InputError
        The file has mistakes.
    """
    path = Path(run.manifest.prototype_file)
    if not path.is_file():
        return []
    return changes(load_prototype(path).model_dump(mode="json"), settings_of(run).model_dump(mode="json"))
