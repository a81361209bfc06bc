"""In which environment an artifact is made: interpreter, platform, version of every installed package."""

import platform
import re
import sys
from collections.abc import Mapping
from functools import cache, lru_cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

from pipeline import __version__
from pipeline.runs.hashing import json_sha256

_KEY_LENGTH = 12
_RECORDED = ("numpy", "scipy", "numba", "pyarrow", "h5py", "pysindy")


@lru_cache(maxsize=1)
def current_environment() -> tuple[str, Mapping[str, Any]]:
    """Key and description of this process's environment.

    Returns
    -------
    key : str
        Beginning of the description's hash.
    description : mapping
        ``interpreter``, ``platform`` and ``packages`` (version by normalised name): no paths, no variables, no user.

    Notes
    -----
    Packages are taken from the names of their ``.dist-info`` folders, which by the wheel format say name and version;
    opening each one's metadata would take 0.1 s of every run.
    """
    packages: dict[str, str] = {}
    for folder in map(Path, sys.path):
        for entry in folder.glob("*.dist-info"):
            name, _, number = entry.name.removesuffix(".dist-info").rpartition("-")
            packages.setdefault(re.sub(r"[-_.]+", "-", name).lower(), number)
    described = {
        "interpreter": f"{platform.python_implementation()} {platform.python_version()}",
        "platform": platform.platform(),
        "packages": packages,
    }
    return json_sha256(described)[:_KEY_LENGTH], described


def recorded_versions() -> dict[str, str]:
    """Versions of debist and of the packages that can move a digit of a result."""
    return {"debist": __version__, **{package: _version(package) for package in _RECORDED}}


@cache
def _version(package: str) -> str:
    """The installed version; looking it up parses the package's description, 1.5 ms each time."""
    return version(package)
