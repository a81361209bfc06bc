"""The environments that a run was made in, as files for pip."""

from collections import Counter
from collections.abc import Mapping
from typing import Any

from pipeline.runs.manifest import Manifest

NAME = "environment.txt"


def environment_files(manifest: Manifest) -> dict[str, str]:
    """File names of the recorded environments by key: ``environment.txt`` is the one that made the most artifacts."""
    made = Counter(record.environment for record in manifest.artifacts.values())
    order = sorted(manifest.environments, key=lambda key: (-made[key], key))
    return {key: NAME if n == 1 else f"environment-{n}.txt" for n, key in enumerate(order, 1)}


def environment_text(described: Mapping[str, Any]) -> str:
    """One ``name==version`` for each installed package, in the form that pip reads; the rest as comments."""
    packages = dict(described["packages"])
    head = [
        f"# {described['interpreter']} on {described['platform']}",
        f"# debist {packages.pop('debist', 'of unknown version')}: install it from its repository",
    ]
    return "\n".join([*head, *(f"{name}=={number}" for name, number in sorted(packages.items()))]) + "\n"
