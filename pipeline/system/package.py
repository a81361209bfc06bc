"""Places in this package by name, whatever the package is called: `pipeline` in a checkout, `debist` installed."""

import importlib
from typing import Any

PACKAGE = __name__.partition(".")[0]


def full_name(place: str) -> str:
    """The full name of a module, such as ``pipeline.rig_logs.child`` for ``rig_logs.child``."""
    return f"{PACKAGE}.{place}"


def object_at(place: str) -> Any:
    """Object at ``module:attribute``, such as ``models.narx:NARX``."""
    module, _, attribute = place.partition(":")
    return getattr(importlib.import_module(full_name(module)), attribute)


def program_version() -> str:
    """The version of the program."""
    return str(importlib.import_module(PACKAGE).__version__)
