"""The environment a run was made in: interpreter, platform and the version of every installed package."""

import platform
from collections.abc import Mapping
from importlib.metadata import distributions, version


def environment_text() -> str:
    """One ``name==version`` for each installed package, in the form that pip reads; the rest as comments."""
    installed = {str(entry.metadata["Name"]).lower(): entry.version for entry in distributions() if entry.metadata}
    head = [
        f"# {platform.python_implementation()} {platform.python_version()} on {platform.platform()}",
        f"# debist {installed.pop('debist', 'of unknown version')}: install it from its repository",
    ]
    return "\n".join([*head, *(f"{name}=={number}" for name, number in sorted(installed.items()))]) + "\n"


def changed_versions(recorded: Mapping[str, str]) -> dict[str, tuple[str, str]]:
    """Packages that are installed in another version than recorded: recorded and installed version by name."""
    installed = {name: version(name) for name in recorded if name != "debist"}
    return {name: (recorded[name], number) for name, number in installed.items() if number != recorded[name]}
