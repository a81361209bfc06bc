"""Logs for notebooks and scripts: read, checked and differentiated as in a run; models compared on one. SI units."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from ..errors import InputError
from ..system.machine import one_thread
from .model import Model

if TYPE_CHECKING:
    import pandas as pd
    from numpy.typing import ArrayLike

_EVEN = 1e-3
"""Share of the interval by which a step of uniform times may differ from it."""


def read_log(log: str | Path, settings: str | Path) -> "pd.DataFrame":
    """A raw log of any format that debist reads, by the channels and units of a settings file.

    Parameters
    ----------
    log : str or Path
        The log; it need not be one of the settings.
    settings : str or Path
        Settings file of a prototype, as `debist init` drafts it.

    Returns
    -------
    pandas.DataFrame
        Columns t_s, q_m (q_rad), v1_V and v2_V at the stamps of q, as `identify` and `Model.score` take them; q_m of
        a joint whose angle is logged. Inputs
        with stamps of their own are interpolated; rows in which a value is missing are left out, and nothing is masked.

    Raises
    ------
    InputError
        The settings have mistakes, or the log cannot be read or lacks a channel.
    """
    import numpy as np

    from ..device.parameters import parameter_set
    from ..workflow.place import load_settings
    from ..workflow.si_log import read_si
    from .in_memory import frame, si_symbols

    prototype = load_settings(Path(settings))
    signals = read_si(Path(log), prototype, parameter_set(prototype, Path(settings)))
    t, q = signals.q
    columns = {"t": t, "q": q}
    for name, (own, samples) in signals.beside.items():
        finite = np.isfinite(own) & np.isfinite(samples)
        columns[name] = samples if own is t else np.interp(t, own[finite], samples[finite], left=np.nan, right=np.nan)
    columns.pop("velocity", None)
    return frame({name: np.asarray(column) for name, column in columns.items()}, *si_symbols(prototype)).dropna(
        ignore_index=True
    )


@one_thread
def check(place: str | Path) -> "pd.DataFrame":
    """What `debist check` finds in the logs of a settings file, or of a run folder.

    Returns
    -------
    pandas.DataFrame
        A row for each check: log, what, found, limit, state (ok, note, wrong, not seen), gate, advice, more,
        values, a dict of numbers with the SI unit in the key, and the code of the finding.

    Raises
    ------
    DebistError
        Bad settings, or a log that cannot be read or that ingest refuses.
    """
    from dataclasses import asdict

    import pandas as pd

    from ..diagnostics.check import check_rows
    from ..workflow.engine import Unheard
    from ..workflow.inspection import check as check_tool

    _, findings = check_tool(Path(place), Unheard())
    return pd.DataFrame([asdict(row) for row in check_rows(findings)])


@one_thread
def differentiate(
    t: "ArrayLike", q: "ArrayLike", *, method: Literal["tvregdiff", "savitzky-golay"] = "tvregdiff",
    order: Literal[1, 2, 3, 4] = 3, alpha: float | None = None, epsilon: float | None = None,
) -> "pd.DataFrame":  # fmt: skip
    """Velocity and acceleration of a displacement at uniform times, as a run differentiates it.

    Parameters
    ----------
    t, q : array_like, shape (N,)
        Uniform times [s] and displacement [m, or any unit], without gaps.
    method, order, alpha, epsilon
        As of `pipeline.signals.differentiate.differentiate`; α and ε are chosen by the noise if both are left out.

    Returns
    -------
    pandas.DataFrame
        Columns t_s, q (smoothed), qdot and qddot, in the unit of q, per s and per s²; ``attrs`` hold alpha, epsilon
        and the noise.

    Raises
    ------
    InputError
        Columns that differ in length, times that are not uniform, or samples that are not finite.
    """
    import numpy as np
    import pandas as pd

    from ..models.base import real_numbers
    from ..signals.differentiate import differentiate as differentiated
    from .in_memory import seconds

    times = seconds(t)
    samples = real_numbers(q, "q")
    if times.ndim != 1 or times.shape != samples.shape or times.size < 2:
        raise InputError(f"t has the shape {times.shape}, q {samples.shape}; give columns of one length, shape (N,)")
    interval = float(times[-1] - times[0]) / (times.size - 1)
    if not np.all(np.abs(np.diff(times) - interval) <= _EVEN * interval):
        raise InputError("t is not uniform; interpolate q, or split it at its gaps")
    rates = differentiated(samples, interval, method=method, order=order, alpha=alpha, epsilon=epsilon)
    table = pd.DataFrame({"t_s": times, "q": rates.q_smooth, "qdot": rates.qdot, "qddot": rates.qddot})
    table.attrs = {"alpha": rates.alpha, "epsilon": rates.epsilon, "noise_std": rates.noise_std}
    return table


def compare(models: Sequence[Model], log: Any) -> "pd.DataFrame":
    """Scores of several models on one log, a DataFrame as `Model.score` takes it; the column model comes first.

    Raises
    ------
    InputError
        No model, or a log that does not fit one of them.
    """
    import pandas as pd

    if not isinstance(models, Sequence) or not models or not all(isinstance(model, Model) for model in models):
        raise InputError(f"models is {models!r}; give a list of the models that are compared, as [first, second]")
    tables = [model.score(log) for model in models]
    for model, table in zip(models, tables, strict=True):
        table.insert(0, "model", model.name)
    return pd.concat(tables, ignore_index=True)
