"""Prototypes of a batch: settings files, folders and tables, under the names of their run folders."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from ..errors import DebistError, InputError
from ..settings.prototype import load_prototype
from ..store import layout
from ..system.names import part_holds, part_of, slug
from .table import is_table, table_settings

FLEET_TABLE = "fleet.parquet"
FLEET_CSV = "fleet.csv"
FLEET_FACTS = "fleet-facts.parquet"
FLEET_REPORT = "fleet.html"
FLEET_FILES = (FLEET_TABLE, FLEET_CSV, FLEET_FACTS, FLEET_REPORT)
SETTINGS = "settings"
"""Folder for settings files that a batch writes."""
FAILED = "failed"
"""Folder for what prototypes printed that failed."""


class Shard(NamedTuple):
    """One of `of` parts of a fleet, counted from 1."""

    number: int = 1
    of: int = 1

    @classmethod
    def parse(cls, text: str) -> "Shard":
        """The shard that a text such as ``3/100`` names.

        Raises
        ------
        InputError
            It names none.
        """
        if (part := part_of(text)) is None:
            raise InputError(f"--shard {text}: write number/count such as 3/100; the numbers count from 1")
        return cls(*part)

    def holds(self, name: str) -> bool:
        """Whether the shard holds the prototype `name`, which depends on no other name."""
        return part_holds(self.number, self.of, name)

    @property
    def lock(self) -> str:
        """Name of the lock that its batch holds."""
        return f".batch-{self.number}-of-{self.of}.lock"


def prototype_files(places: Sequence[Path], output: Path, base: Path | None = None) -> list[Path]:
    """The settings files that are meant: files, all ``*.toml`` of folders, rows of a table.

    Parameters
    ----------
    places : sequence of Path
        What the user names.
    output : Path
        The folder of the runs: settings files of a table's rows are written into ``settings/`` there.
    base : Path, optional
        Settings that the rows of a table share; found beside the table if left out.

    Raises
    ------
    InputError
        A place that does not exist, a folder without settings files, or a table with mistakes.
    """
    files: list[Path] = []
    of_rows: dict[Path, Path] = {}
    for place in places:
        if is_table(place):
            for path in table_settings(place, base, output / SETTINGS):
                if path in of_rows:
                    raise InputError(f"{place}: a prototype of {of_rows[path]} has the name of {path.stem}, too")
                of_rows[path] = place
                files.append(path)
        elif place.is_dir():
            inside = sorted(place.glob("*.toml")) + sorted(place.glob("*/*.toml"))
            if not inside:
                raise InputError(f"{place}: holds no settings file (*.toml)")
            files += inside
        else:
            if not place.exists():
                raise InputError(f"{place}: no such file or folder")
            files.append(place)
    if base is not None and not of_rows:
        raise InputError("--base: is what the rows of a table share; name a table, such as fleet.csv")
    return list(dict.fromkeys(path.resolve() for path in files))


@dataclass(frozen=True)
class Member:
    """A prototype of a batch.

    Attributes
    ----------
    name : str
        Name of its run folder.
    settings : Path
        Its settings file.
    logs : tuple of Path
        Its raw logs; none where the settings have a mistake.
    error : str
        That mistake; empty without one.
    """

    name: str
    settings: Path
    logs: tuple[Path, ...] = ()
    error: str = ""


def members(prototypes: Sequence[Path]) -> list[Member]:
    """The prototypes with the names of their run folders, and their logs.

    Raises
    ------
    InputError
        Two prototypes of one name, capitals aside, or one that is named as a file of the fleet.
    """
    named: dict[str, Member] = {}
    reserved = (*FLEET_FILES, SETTINGS, FAILED)
    for path in prototypes:
        member = _member(path)
        folded = member.name.casefold()
        if folded in reserved:
            raise InputError(
                f"{path}: {member.name!r} is the name of a file of the fleet; name the prototype otherwise"
            )
        if (other := named.get(folded)) is not None:
            alike = "" if member.name == other.name else f" ({other.name!r}, which some disks take for the same)"
            raise InputError(
                f"{path}: a second prototype is named {member.name!r}{alike} after {other.settings}; names decide the "
                "run folders, change one"
            )
        named[folded] = member
    return list(named.values())


def _member(path: Path) -> Member:
    try:
        prototype = load_prototype(path)
    except DebistError as error:
        return Member(slug(path.stem), path, error=str(error))  # its own run fails with the reason
    logs = dict.fromkeys(log for _, log, _ in layout.raw_logs(prototype, path))
    return Member(prototype.folder, path, tuple(logs))
