"""The parameter set of the analytical model that the settings name."""

import difflib
from typing import TYPE_CHECKING

from pipeline.errors import InputError

if TYPE_CHECKING:
    from pipeline.physics.parameters import JointParameters


def joint_parameters(name: str) -> "JointParameters":
    """A shipped parameter set by name.

    Raises
    ------
    InputError
        There is none of that name.
    """
    from pipeline.physics.parameters import PARAMETER_SETS

    if name in PARAMETER_SETS:
        return PARAMETER_SETS[name]
    close = difflib.get_close_matches(name, PARAMETER_SETS, n=1)
    hint = f"did you mean {close[0]!r}?" if close else f"there are {', '.join(PARAMETER_SETS)}"
    raise InputError(f"plant.parameters: no parameter set {name!r}; {hint}")
