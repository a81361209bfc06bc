"""The prototypes of the fleet, and which of their stage manifests still hold."""

import hashlib
import json
import subprocess
import sys
from pathlib import Path

OUTPUT = Path(config["output"])
RUN = OUTPUT / "{name}"
LAST_STAGE = "report" if config["report"] else "compare"
STAGES = ["ingest", "check", "differentiate", "identify", "instruments", "validate", "scores", "compare"]
STAGES += ["report"] if config["report"] else []
FLEET_TABLES = [OUTPUT / name for name in ("fleet.parquet", "fleet.csv", "fleet-facts.parquet", "fleet.html")]
_RUNS_AT_A_TIME = 500  # keeps the command line short


def listed_prototypes():
    """The prototypes of the fleet as `debist batch` finds them; those with bad settings are named and left out."""
    command = ["debist", "batch", *config["prototypes"], "-o", str(OUTPUT), "--list", "--json"]
    listed = subprocess.run(command, stdout=subprocess.PIPE)
    if listed.returncode != 0:
        sys.exit("the prototypes cannot be listed; the line above names the reason")
    found = json.loads(listed.stdout)["prototypes"]
    for prototype in found:
        if prototype["error"]:
            print(f"left out: {prototype['error']}", file=sys.stderr)
    return {prototype["name"]: prototype for prototype in found if not prototype["error"]}


LISTED = listed_prototypes()
PROTOTYPES = {name: Path(prototype["settings"]) for name, prototype in LISTED.items()}


def raw_logs(name):
    """The raw logs of a prototype."""
    return LISTED[name]["logs"]


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
        states = subprocess.run(
            ["debist", "status", "--brief", "--json", *map(str, some)], stdout=subprocess.PIPE, check=True
        )
        for run in json.loads(states.stdout)["runs"]:
            stale = [i for i, stage in enumerate(STAGES) if run["error"] or stage in run["stale"]]
            follows = [manifest(run["run"], stage) for i, stage in enumerate(STAGES) if stale and i >= stale[0]]
            dropped += [path for path in follows if path.exists()]
    for path in (*dropped, *(FLEET_TABLES if dropped else ())):
        path.unlink(missing_ok=True)


if config["check_content"] and workflow.is_main_process:
    drop_what_no_longer_holds()
