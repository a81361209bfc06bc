"""The prototypes of the fleet, and which of their stage manifests still hold."""

import hashlib
import json
import subprocess
import tomllib
from pathlib import Path

from pipeline.names import slug

OUTPUT = Path(config["output"])
RUN = OUTPUT / "{name}"
LAST_STAGE = "report" if config["report"] else "compare"
STAGES = ["ingest", "check", "differentiate", "identify", "validate", "scores", "compare"]
STAGES += ["report"] if config["report"] else []
FLEET_TABLES = [OUTPUT / "fleet.parquet", OUTPUT / "fleet.csv", OUTPUT / "fleet.html"]
_RUNS_AT_A_TIME = 500  # keeps the command line short


def settings_files(place):
    """The settings files of a place, found as `debist batch` finds them."""
    path = Path(place)
    if path.is_dir():
        return sorted(path.glob("*.toml")) + sorted(path.glob("*/*.toml"))
    members = tomllib.loads(path.read_text(encoding="utf-8")).get("prototypes")
    return [path] if members is None else [path.parent / member for member in members]


def name_of(path):
    return slug(tomllib.loads(path.read_text(encoding="utf-8"))["name"])


PROTOTYPES = {name_of(path): path for place in config["prototypes"] for path in settings_files(place)}


def raw_logs(name):
    """The raw logs of a prototype, relative to its settings file."""
    path = PROTOTYPES[name]
    logs = tomllib.loads(path.read_text(encoding="utf-8"))["logs"]
    return [path.parent / log for role in ("train", "validation") for log in logs.get(role, ())]


def settings_hash(name):
    """Changes with the settings' text, whatever the file's time stamp says."""
    return hashlib.sha256(PROTOTYPES[name].read_bytes()).hexdigest()[:16]


def manifest(run, stage):
    return Path(run) / "stages" / f"{stage}.json"


def drop_what_no_longer_holds():
    """Remove the manifests of stages that debist calls stale: artifacts damaged, raw logs changed, algorithms raised.

    Snakemake goes by time stamps where files are large; debist goes by content. A manifest that is gone is made again,
    with what follows from it: the tables of the fleet go too, since Snakemake asks for no input of what is there.
    """
    dropped = []
    runs = [OUTPUT / name for name in PROTOTYPES if (OUTPUT / name / "stages").is_dir()]
    for first in range(0, len(runs), _RUNS_AT_A_TIME):
        some = runs[first : first + _RUNS_AT_A_TIME]
        told = subprocess.run(
            ["debist", "status", "--brief", "--json", *map(str, some)], stdout=subprocess.PIPE, check=True
        )
        for run in json.loads(told.stdout)["runs"]:
            stale = [i for i, stage in enumerate(STAGES) if run["error"] or stage in run["stale"]]
            follows = [manifest(run["run"], stage) for i, stage in enumerate(STAGES) if stale and i >= stale[0]]
            dropped += [path for path in follows if path.exists()]
    for path in (*dropped, *(FLEET_TABLES if dropped else ())):
        path.unlink(missing_ok=True)


if config["check_content"] and workflow.is_main_process:
    drop_what_no_longer_holds()
