"""Tables as pandas DataFrames whose column names end in their units, and DataFrames back as signals."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from pipeline.errors import InputError
from pipeline.tools.in_memory import Signals

if TYPE_CHECKING:
    import pandas as pd

_OF_Q = {"q": "{}", "q_measured": "{}", "qdot": "{}_per_s", "qddot": "{}_per_s2"}
_LARGEST_INPUTS = 2


def column_name(name: str, displacement: str, inputs: str = "V") -> str:
    """``q`` → ``q_m``, ``qdot`` → ``qdot_m_per_s``, ``v1`` → ``v1_V``; pure numbers keep their names."""
    if name in _OF_Q:
        return f"{name}_{_OF_Q[name].format(displacement)}"
    known = {"t": "s", "phi": "rad", "v1": inputs, "v2": inputs, "u1": inputs, "u2": inputs}.get(name, "1")
    return name if known == "1" else f"{name}_{known}"


def frame(columns: Mapping[str, Any], displacement: str, inputs: str = "V") -> "pd.DataFrame":
    """Columns of a table, all of one length, with their SI units in the names."""
    import pandas as pd

    return pd.DataFrame({column_name(name, displacement, inputs): values for name, values in columns.items()})


def signals_of(table: "pd.DataFrame") -> Signals:
    """The signals of a DataFrame with the columns t_s, q_m or q_rad, v1_V and, with two inputs, v2_V.

    Raises
    ------
    InputError
        A column is missing.
    """
    displacement = next((name for name in ("q_m", "q_rad") if name in table), None)
    if displacement is None or "t_s" not in table or "v1_V" not in table:
        raise InputError(
            f"the DataFrame has the columns {', '.join(map(str, table.columns))}; "
            "give t_s, q_m (or q_rad), v1_V and, with two inputs, v2_V, in SI units"
        )
    voltages = [table[name] for name in ("v1_V", "v2_V") if name in table]
    return arrays_of(table["t_s"], table[displacement], *voltages)


def arrays_of(t: Any, q: Any, v1: Any, v2: Any = None) -> Signals:
    """The signals of single columns: arrays, lists or Series.

    Raises
    ------
    InputError
        A column is no column of numbers, or they differ in length.
    """
    columns = {}
    for name, values in {"t": t, "q": q, "v1": v1, "v2": v2}.items():
        if values is None:
            continue
        try:
            columns[name] = np.asarray(values, dtype=np.float64)
        except (TypeError, ValueError):
            raise InputError(f"{name} does not consist of numbers") from None
        if columns[name].ndim != 1:
            raise InputError(f"{name} has the shape {columns[name].shape}; give one column, shape (N,)")
        if len(columns[name]) != len(columns["t"]):
            raise InputError(f"{name} has {len(columns[name])} samples, but t has {len(columns['t'])}")
    inputs = [columns[name] for name in ("v1", "v2") if name in columns]
    return Signals(columns["t"], columns["q"], np.column_stack(inputs))
