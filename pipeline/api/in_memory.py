"""Signals in memory instead of logs in files: the same cleaning, derivatives, fits and scores as in a run."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from ..device.device import device
from ..device.parameters import parameter_set
from ..diagnostics.check import check_logs, refusing, remarks
from ..diagnostics.copies import shared_recordings
from ..diagnostics.log_facts import LogSignals
from ..diagnostics.sentences import sentences
from ..errors import DataRefusedError, InputError, warn_user
from ..models.base import FreeRun, kind_of, real_numbers
from ..models.model_type import StoredModel, model_type
from ..numerics.arrays import FloatArray
from ..settings.models import AUTO, ENTRIES, entry, names
from ..settings.prototype import Plant, Prototype, parse_prototype
from ..signals.columns import Signal, codes_in, masked
from ..signals.findings import scale_suspicion
from ..signals.log import UNKNOWN, Log, RawLog, log_of
from ..signals.remarks import code_remarks
from ..store import layout
from ..store.columns import TUBE_COLUMNS
from ..store.run_folder import RunFolder
from ..workflow.prior_knowledge import prior_knowledge_in
from ..workflow.run_contents import load_motion, motion
from ..workflow.si_log import on_uniform_clocks, with_displacement
from ..workflow.stage_check import log_signals
from ..workflow.steps.differentiate import kinematics
from ..workflow.steps.identify import identified, training
from ..workflow.steps.ingest import examined, record_columns

OF_RUN = "debist_log"
"""Key of a DataFrame's ``attrs``: folder of the run, role and name of the log that it holds."""
_OF_Q = {
    "q": "{}",
    "q_measured": "{}",
    **{column.key: "{}" for column in TUBE_COLUMNS},
    "qdot": "{}_per_s",
    "qddot": "{}_per_s2",
}


@dataclass(frozen=True)
class Signals:
    """One log in SI units.

    Attributes
    ----------
    t, q : FloatArray, shape (N,)
        Time stamps [s] and displacement [m or rad].
    v : FloatArray, shape (N, K)
        Voltages [V], K = 1 or 2.
    unit : {"m", "rad"} or None
        Unit of q, if its column names one.
    """

    t: FloatArray
    q: FloatArray
    v: FloatArray
    unit: str | None = None


def settings(
    *,
    inputs: int,
    angle: bool,
    action: str,
    mass: float | None,
    model: str,
    parameters: str | None,
    more: Mapping[str, Any],
) -> Prototype:
    """Settings for signals in SI units.

    Parameters
    ----------
    inputs : int
        Number of inputs, 1 or 2.
    angle : bool
        True if q is in rad.
    action : {"squared", "linear"}
        Action of the inputs.
    mass : float or None
        Moving mass [kg] or inertia [kg·m²].
    model : str
        Name of the model, or "auto".
    parameters : str or None
        Parameter set of the analytical joint.
    more : mapping
        Further tables of a settings file, such as ``{"identify": {…}}``.
    """
    channels = {
        "q": {"channel": "q", "unit": "rad" if angle else "m"},
        **{f"v{k}": {"channel": f"v{k}", "unit": "V"} for k in range(1, inputs + 1)},
    }
    turned = angle and parameters is None  # else the angle of a joint, which becomes its displacement
    plant = {
        "inputs": action,
        "mass": None if mass is None else {"value": mass, "unit": "kg m^2" if turned else "kg"},
        "parameters": parameters,
    }
    if entry(model) is None and model != AUTO:
        raise InputError(f"no model {model!r}; there are {', '.join((AUTO, *(each.name for each in ENTRIES)))}")
    document: dict[str, Any] = {
        "name": "signals",
        "logs": {"train": ["signals"]},
        "channels": channels,
        "plant": plant,
        "identify": {"models": [model]} if model in (AUTO, *names("identify")) else {},
    }
    if not isinstance(more, Mapping):
        raise InputError(
            f"settings is {more!r}; give a mapping of tables, as {{'ingest': {{'sample_interval': 0.005}}}}"
        )
    of_plant = {f"plant.{key}" for key, value in plant.items() if value != getattr(Plant(), key)}
    keys = {f"{name}.{key}" for name, table in more.items() if isinstance(table, Mapping) for key in table}
    if taken := sorted((keys | more.keys()) & {"name", "logs", "channels", "identify.models", *of_plant}):
        raise InputError(f"settings has {', '.join(taken)}; the arguments of the function give these: leave them out")
    for name, table in more.items():
        document[name] = {**document.get(name, {}), **_plain(table)} if isinstance(table, Mapping) else table
    prototype = parse_prototype(document, "debist.identify")
    compared = model in names("compare")
    not_taken = f"which the model {model!r} does not take"
    unread = (
        ("compare.curves", prototype.compare.curves, "which only the report of a run draws"),
        ("compare.models", prototype.compare.models, "but the argument `model` names the model"),
        ("ingest.sample_rate", prototype.ingest.sample_rate, "but t has the time of each sample"),
        ("plant.curves", prototype.plant.curves if compared else None, not_taken),
        ("plant.siblings", prototype.plant.siblings if compared else None, not_taken),
    )
    for key, value, why in unread:
        if value is not None:
            raise InputError(f"settings has {key}, {why}; leave it out")
    return prototype


def _plain(table: Mapping[str, Any]) -> dict[str, Any]:
    """Values of a table of settings: numbers of NumPy become Python's, paths become texts."""
    texts = {key: str(value) if isinstance(value, Path) else value for key, value in table.items()}
    return {key: value.item() if isinstance(value, np.generic) else value for key, value in texts.items()}


def log_in(table: Any) -> Log | None:
    """The log that a model is scored on, from a log of a run (`pipeline.api.run.Run.log`); None for other signals.

    A log that is still as `Run.log` returned it is read from the run again. It then has its parts and the voltages
    between the samples, as the run itself simulates it. One with other values is differentiated anew.
    """
    if not hasattr(table, "columns") or "segment" not in table:
        return None
    names = {
        "t_s": "t",
        "v1_V": "v1",
        "v2_V": "v2",
        "segment": "segment",
        **{column_name(name, unit): name for unit in ("m", "rad") for name in ("q", "qdot", "qddot")},
    }
    columns = {names[name]: np.asarray(table[name]) for name in table.columns if name in names}
    if not {"t", "q", "qdot", "qddot", "v1"} <= columns.keys():
        return None
    if OF_RUN in table.attrs:
        root, role, log = table.attrs[OF_RUN]
        run = RunFolder.open(Path(root))
        stored = run.read_table(layout.kinematics(role, log))
        if all(np.array_equal(stored[name], columns[name], equal_nan=True) for name in columns):
            return load_motion(run, run.prototype, role, log)
        rows = np.minimum(np.searchsorted(stored["t"], columns["t"]), len(stored["t"]) - 1)
        if not all(np.array_equal(stored[name][rows], columns[name], equal_nan=True) for name in columns):
            return None  # derivatives of before a change are not those of after it
    return log_of(columns)


def refuse_other_units(sizes: Mapping[str, float], prototype: Prototype) -> None:
    """Refuse magnitudes of q or v that no device has in SI units.

    Raises
    ------
    InputError
        They look like another unit's.
    """
    plant = device(prototype)
    for name, size in sizes.items():
        unit = plant.displacement.symbol if name.startswith("q") else plant.inputs[0].symbol
        if (factor := scale_suspicion(size, plant.plausible_span(unit))) is not None and factor > 1.0:
            raise InputError(
                f"{name} is up to {size:.4g}, which looks {factor:g} times too large for {unit}: give SI units"
            )


def cleaned(signals: Signals, prototype: Prototype, where: str) -> tuple[Log, LogSignals, tuple[str, ...]]:
    """Clean signals, bring them to the uniform grid and differentiate them; the angle of a joint becomes its q.

    Returns
    -------
    Log
        On the uniform grid, with derivatives.
    LogSignals
        Signals for the checks.
    tuple of str
        Remarks, and masked samples.

    Raises
    ------
    DataRefusedError
        The quality gates refuse them; the text begins with `where`.
    """
    stamps = np.ascontiguousarray(signals.t)
    given = {"q": signals.q} | {f"v{k}": column for k, column in enumerate(signals.v.T, start=1)}
    codes = {name: codes_in(column) for name, column in given.items()}
    q, *inputs = (Signal(stamps, np.ascontiguousarray(masked(given[name], codes[name])[:])) for name in given)
    log = on_uniform_clocks(
        RawLog(
            q,
            tuple(inputs),
            notes=tuple(remark.of(name) for name, counts in codes.items() for remark in code_remarks(counts)),
        )
    )
    if signals.unit != "m":
        log = with_displacement(log, device(prototype), parameter_set(prototype, _in_this_folder()))
    measured = log.q.samples[np.isfinite(log.q.samples)]
    refuse_other_units({"q": float(np.ptp(measured)) if measured.size else 0.0}, prototype)
    resamplings, noticed = examined(log, prototype, where)
    fine, coarse = (record_columns(resampling.record(), tuple(log.beside)) for resampling in resamplings)
    moved, _ = kinematics(coarse, fine, prototype)
    notes = {**noticed, "raw_step": resamplings[0].report.raw_step}
    return (
        motion(moved, fine, prototype, notes.get(UNKNOWN, ())),
        log_signals(where, fine, notes),
        tuple(f"{where}: {text}" for text in noticed["warnings"]),
    )


def _in_this_folder() -> Path:
    """The settings file that paths in settings are relative to where there is none."""
    return Path.cwd() / "settings.toml"


def identify_signals(
    logs: Sequence[Signals], prototype: Prototype, name: str
) -> tuple[StoredModel, dict[str, Any], list[Log]]:
    """The model of that name, or the main model for `AUTO`; notes on the fits; and the logs.

    What `debist check` would refuse is warned of: the note ``contradictions`` holds it.

    Raises
    ------
    DataRefusedError
        The signals do not show what the model needs, or are in other units, as voltages in kV.
    """
    settings_file = _in_this_folder()
    parameters = parameter_set(prototype, settings_file)
    prior = prior_knowledge_in(settings_file, prototype, parameters)
    parts = [cleaned(log, prototype, f"log {number}") for number, log in enumerate(logs, start=1)]
    measured, records, warnings = map(list, zip(*parts, strict=True))
    findings = [
        *check_logs(records, device(prototype), prototype.ingest.sample_interval),
        *(finding for _, _, finding in shared_recordings(records)),
    ]
    unaccepted = [finding for finding in refusing(findings) if finding.gate not in prototype.quality.accept]
    contradictions = [": ".join(sentences(finding)) for finding in unaccepted]
    if units := [text for finding, text in zip(unaccepted, contradictions, strict=True) if finding.gate == "scale"]:
        accept = "settings={'quality': {'accept': ['scale']}}"
        raise DataRefusedError(f"{units[0]}; give SI units, or if they are, accept it: {accept}")
    for text in (*contradictions, *remarks(findings)):
        warn_user(text)
    if name in names("compare"):
        model = model_type(name).fit(training(measured, prototype, parameters))
        notes: dict[str, Any] = {"warnings": [], name: model.describe()}
    else:
        models, notes = identified(measured, prototype, parameters, prior)
        model = next(iter(models.values()))
    notes["warnings"] = [
        *(text for texts in warnings for text in texts),
        *remarks(findings),
        *contradictions,
        *notes["warnings"],
    ]
    notes["contradictions"] = contradictions
    return model, notes, measured


def column_name(name: str, displacement: str, inputs: str = "V") -> str:
    """``q`` → ``q_m``, ``qdot`` → ``qdot_m_per_s``, ``v1`` → ``v1_V``; pure numbers keep their names."""
    if name in _OF_Q:
        return f"{name}_{_OF_Q[name].format(displacement)}"
    unit = {"t": "s", "phi": "rad", "v1": inputs, "v2": inputs, "u1": inputs, "u2": inputs}.get(name, "1")
    return name if unit == "1" else f"{name}_{unit}"


def frame(columns: Mapping[str, Any], displacement: str, inputs: str = "V") -> pd.DataFrame:
    """Columns of a table, all of one length, with their SI units in the names."""
    return pd.DataFrame({column_name(name, displacement, inputs): values for name, values in columns.items()})


def free_run_frame(
    run: FreeRun, tubes: Mapping[str, FloatArray], v: FloatArray, units: tuple[str, str], **more: FloatArray
) -> pd.DataFrame:
    """A free run as a table; its ``attrs`` hold how it ended.

    Parameters
    ----------
    run : FreeRun
        The run.
    tubes : mapping of str to FloatArray
        Tubes of q, or none.
    v : FloatArray, shape (N, K)
        Voltages [V].
    units : (str, str)
        SI symbols of the displacement and of the inputs.
    **more : FloatArray
        Further columns by name.
    """
    inputs = {f"v{k}": column for k, column in enumerate(v.T, start=1)}
    table = frame({**{"t": run.t, "q": run.q, "qdot": run.qdot, "qddot": run.qddot}, **tubes, **inputs, **more}, *units)
    table.attrs = {"status": run.status, "diverged_at_s": run.diverged_at_s}
    return table


def as_pandas(t: Any) -> Any:
    """A table of another library, such as polars or pyarrow, as one of pandas; anything else as it is."""
    return t.to_pandas() if hasattr(t, "columns") and hasattr(t, "to_pandas") else t


def signals_of(table: pd.DataFrame) -> Signals:
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
    if other := [name for name in table.columns if "v2_V" not in table and f"{name}".lower().startswith("v2")]:
        raise InputError(f"the DataFrame has the column {other[0]}; call it v2_V and give it in V, or leave it out")
    return replace(
        arrays_of(table["t_s"], table[displacement], *(table[name] for name in ("v1_V", "v2_V") if name in table)),
        unit=displacement.removeprefix("q_"),
    )


def arrays_of(t: Any, q: Any, v1: Any, v2: Any = None) -> Signals:
    """The signals of single columns: arrays, lists or Series; `v1` may hold both voltages, shape (N, 2).

    Parameters
    ----------
    t : array_like, shape (N,)
        Times [s], durations or time stamps.
    q : array_like, shape (N,)
        Displacement [m or rad].
    v1 : array_like, shape (N,) or (N, 2)
        First voltage [V], or both.
    v2 : array_like, shape (N,), optional
        Second voltage [V].

    Raises
    ------
    InputError
        A column is no column of numbers, NaN where there is none, or they differ in length.
    """
    if v2 is None and (both := real_numbers(v1, "v1")).ndim == 2:
        if both.shape[1] > 2 or (len(both) != np.size(t) and both.shape[1] == np.size(t)):
            raise InputError(f"v1 has the shape {both.shape}; give one or two columns of voltages, shape (N, 2)")
        v1, v2 = (*both.T, None)[:2]
    columns = _columns({"t": t, "q": q, "v1": v1, "v2": v2}, gaps=True)
    return Signals(columns.pop("t"), columns.pop("q"), np.column_stack(list(columns.values())))


def voltages_of(t: Any, v: Any) -> tuple[FloatArray, FloatArray]:
    """Times (N,) and voltages (N, K) of arrays, v of shape (N, K) or (N,), or of one DataFrame.

    Raises
    ------
    InputError
        A column is missing or no column of finite numbers, or they differ in length.
    """
    t = as_pandas(t)
    if hasattr(t, "columns"):
        if v is not None or "t_s" not in t or "v1_V" not in t:
            raise InputError("give one DataFrame with t_s, v1_V and, with two inputs, v2_V, or t and v")
        t, v = t["t_s"], t[[name for name in ("v1_V", "v2_V") if name in t]].to_numpy()
    if v is None:
        raise InputError("v is missing; give t and v, or one DataFrame")
    table = real_numbers(v, "v")
    table = table[:, None] if table.ndim == 1 else table
    if table.ndim != 2:
        raise InputError(f"v has the shape {table.shape}; give one column for each voltage, shape (N, K)")
    if len(table) != (size := np.size(t)) and table.shape[1] == size:
        raise InputError(f"v has the shape {table.shape}; give one column for each voltage: np.column_stack([v1, v2])")
    columns = _columns({"t": t, **{f"v{k}": column for k, column in enumerate(table.T, start=1)}}, gaps=False)
    return columns.pop("t"), np.column_stack(list(columns.values()))


def seconds(t: Any) -> FloatArray:
    """Times [s]: time stamps count from the first, durations and numbers from zero.

    Raises
    ------
    InputError
        None of these.
    """
    if (kind := kind_of(t)) not in "mM":
        return real_numbers(t, "t")
    stamps = np.asarray(t)
    since = stamps - stamps.ravel()[:1] if kind == "M" else stamps
    return np.asarray(since / np.timedelta64(1, "s"), dtype=np.float64)


def _columns(given: Mapping[str, Any], *, gaps: bool) -> dict[str, FloatArray]:
    """Columns of finite numbers, all as long as t, without those that are None. `gaps` become NaN, except in t."""
    columns: dict[str, FloatArray] = {}
    for name, values in given.items():
        if values is None:
            continue
        if not columns and name != "t":
            raise InputError("t is missing; give the times [s]")
        columns[name] = seconds(values) if name == "t" else real_numbers(values, name)
        if columns[name].ndim != 1:
            raise InputError(f"{name} has the shape {columns[name].shape}; give one column, shape (N,)")
        if len(columns[name]) != len(columns["t"]):
            raise InputError(f"{name} has {len(columns[name])} samples, but t has {len(columns['t'])}")
        if not columns[name].size:
            raise InputError(f"{name} is empty")
        is_gap = gaps and name != "t"
        if len(bad := np.flatnonzero(~np.isfinite(columns[name]) & ~(is_gap & np.isnan(columns[name])))):
            remedy = "leave out such rows: a gap in t is no harm" if gaps else "interpolate it there"
            raise InputError(f"{name} is not finite at sample {bad[0]}; {remedy}")
    return columns


def si_symbols(prototype: Prototype) -> tuple[str, str]:
    """SI symbols of the displacement and of the inputs."""
    plant = device(prototype)
    return plant.displacement.symbol, plant.inputs[0].symbol
