"""A designed controller as plain numbers and back."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from pipeline.control.law import Law
from pipeline.control.observer import Observer
from pipeline.errors import CorruptArtifactError


def law_to_json(law: Law) -> dict[str, Any]:
    """Every constant of a controller, SI."""
    found: dict[str, Any] = {name: _plain(value) for name, value in law._asdict().items() if name != "observer"}
    return found | {"observer": {name: _plain(value) for name, value in law.observer._asdict().items()}}


def law_from_json(values: Mapping[str, Any]) -> Law:
    """The controller back from `law_to_json`.

    Raises
    ------
    CorruptArtifactError
        A constant is missing, as in what another version of the program wrote.
    """
    try:
        observer = Observer(**{name: _array(values["observer"][name]) for name in Observer._fields})
        rest = {name: _array(values[name]) for name in Law._fields if name != "observer"}
        return Law(observer=observer, **rest)
    except (KeyError, TypeError, ValueError) as error:
        raise CorruptArtifactError(
            f"the designed controller cannot be read ({error}); run `debist control design` again"
        ) from None


def _plain(value: Any) -> Any:
    return value.tolist() if isinstance(value, np.ndarray) else float(value)


def _array(value: Any) -> Any:
    return np.array(value, dtype=np.float64) if isinstance(value, list) else float(value)
