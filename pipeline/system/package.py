"""Places in this package by name, whatever the package is called: `pipeline` in a checkout, `debist` installed."""

import ast
import importlib
import inspect
from functools import cache
from itertools import pairwise
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


@cache
def texts_below(kind: type) -> dict[str, str]:
    """The text below each field of a class of this package, by the field's name; from its source.

    pydantic would read the sources of all classes when they are made, which takes 0.2 s of every start.
    """
    texts: dict[str, str] = {}
    for owner in reversed(kind.__mro__):
        if owner.__module__.startswith(PACKAGE):
            source: Any = ast.parse(inspect.getsource(importlib.import_module(owner.__module__)))
            statements = next(entry.body for entry in source.body if getattr(entry, "name", "") == owner.__name__)
            for field, below in pairwise([*statements, None]):
                match field, below:
                    case ast.AnnAssign(target=ast.Name(id=name)), ast.Expr(value=ast.Constant(value=str(text))):
                        texts[name] = inspect.cleandoc(text)
                    case ast.AnnAssign(target=ast.Name(id=name)), _:
                        texts[name] = ""
    return texts
