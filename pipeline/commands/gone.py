"""What replaces commands, options and values that are gone: one line for whoever still gives them."""

from collections.abc import Sequence
from typing import Any

COMMANDS = {
    "repair": "`debist run PROTOTYPE.toml -o RUN` sets aside what is damaged and makes it anew",
    "study settings": "`debist batch TABLE.csv -o DIR` runs a row for each combination of settings",
}
_EXPERIMENT = "{} in the TOML file of --experiment"
_SCENARIO = "{} in the TOML file of --scenario"
_DESIGN = "{} in the TOML file of --design"
_SEARCH = "{} in the TOML file of --search"
_NO_FORCE = "name another place, or remove the file"
OPTIONS = {
    "--output": "-o",
    "--file": "-o",
    "--quiet": "-q",
    "-j": "--jobs",
    "-m": "--model",
    "-f": "--figure",
    "-c": "--controller",
    "-p": "--parameters",
    "--report": "leave it out: the report is made unless --no-report is given",
    "--keep-going": "leave it out: the others go on unless --fail-fast is given",
    "--capabilities": "`debist --help`, and the README",
    "batch --set": "a table with a row for each combination of settings, and `debist diff` for its runs",
    "diff --format": "--json",
    "series --format": "--json",
    "series -o": "--page",
    "status --watch": "`watch debist status DIR`",
    "verify --all": "a loop of the shell over the runs",
    "verify --subset": "leave it out: all files are checked",
    "physics calibrate --set": 'a TOML file for --parameters: base = "nominal", then the values',
    "physics calibrate --starts": _SEARCH.format("starts"),
    "physics calibrate --seed": _SEARCH.format("seed"),
    "physics calibrate --jobs": _SEARCH.format("threads"),
    "physics calibrate --force": _NO_FORCE,
    "physics calibrate --figure": "the table, or the correlations of --json",
    "rig --faults": _EXPERIMENT.format('faults = ["gaps"]'),
    "rig --charging-time": _EXPERIMENT.format("charging_time_s"),
    "rig --size": _EXPERIMENT.format("size"),
    "rig --train": _EXPERIMENT.format("training_logs"),
    "rig --validation": _EXPERIMENT.format("validation_logs"),
    "rig --excitation": _EXPERIMENT.format("excitation"),
    "rig --age": _EXPERIMENT.format("age_days"),
    "rig --drift": _EXPERIMENT.format("the table [drift]"),
    "rig --force": _NO_FORCE,
    "rig simulate --play": _EXPERIMENT.format("play"),
    "rig excite --model": _DESIGN.format("model"),
    "rig excite --joints": _DESIGN.format("joints"),
    "rig excite --seed": _DESIGN.format("seed"),
    "rig excite --max-field": _DESIGN.format("max_field_V_per_um"),
    "rig excite --rest": _DESIGN.format("rest_s"),
    "rig excite --rate": _DESIGN.format("rate_Hz"),
    "rig excite --kinds": _DESIGN.format('kinds = ["pulse"]'),
    "rig excite --basis-functions": _DESIGN.format("basis_functions"),
    "rig excite --candidates": _DESIGN.format("candidates"),
    "rig closed-loop --from": _SCENARIO.format('start = "left"'),
    "rig closed-loop --format": _SCENARIO.format("format"),
    "rig closed-loop --lag": _SCENARIO.format("lag_s"),
    "rig closed-loop --highest": _SCENARIO.format("highest_V"),
    "rig closed-loop --push": _SCENARIO.format("[[pushes]] start_s, force_N, length_s"),
    "rig closed-loop --hand": _SCENARIO.format("[[hands]] start_s, force_N, length_s"),
    "rig closed-loop --shake": _SCENARIO.format("[[shakes]] start_s, force_N, frequency_Hz, length_s"),
    "rig closed-loop --drag": _SCENARIO.format("drag_N"),
    "rig closed-loop --friction": _SCENARIO.format("friction"),
    "rig closed-loop --lost": _SCENARIO.format("[[lost]] start_s, length_s"),
    "rig closed-loop --frozen": _SCENARIO.format("[[frozen]] start_s, length_s"),
    "rig closed-loop --barrier": _SCENARIO.format("barrier_percent"),
    "rig closed-loop --noise": _SCENARIO.format("noise"),
    "rig closed-loop --seed": _SCENARIO.format("seed"),
}
"""By the option, alone or after the command or group that had it."""


def replacement(error: Any, given: Sequence[str]) -> str | None:
    """The line for a usage error that comes of a command or an option that is gone; None for others.

    Parameters
    ----------
    error : Exception
        As typer raises it.
    given : sequence of str
        The words of the command.
    """
    for command in (" ".join(given[:2]), " ".join(given[:1])):
        if command in COMMANDS:
            return f"`debist {command}` is gone; instead: {COMMANDS[command]}"
    option = getattr(error, "option_name", None)
    context = getattr(error, "ctx", None)
    if option is None or context is None:
        return None
    path = context.command_path.split()[1:]
    for words in (" ".join([*path, option]), " ".join([*path[:1], option]), option):
        if (instead := OPTIONS.get(words)) is not None:
            return f"{option} is gone; instead: {instead}"
    return None
