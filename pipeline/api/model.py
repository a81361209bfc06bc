"""Models for notebooks and scripts: identified from arrays or DataFrames, simulated, scored, drawn, saved and exported.

SI units. A file of a saved model also has its settings and what travels along.
"""

import json
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property, partial
from numbers import Real
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

import numpy as np
import pandas as pd

from ..device.device import device
from ..diagnostics.characteristics import believed_wells, stable_rests
from ..errors import CorruptArtifactError, InputError, warn_user
from ..export.subject import Subject, Validity
from ..models.base import DynamicModel, HasCurves, HasDraws, real_numbers
from ..models.free_runs import free_run, wanted_tubes
from ..models.model_file import ModelFile, Sizes, Span, Table, Unit, columns_of, read_part
from ..models.model_type import StoredModel, model_from_tree
from ..numerics.arrays import FloatArray
from ..numerics.metrics import fit_percent
from ..scoring.scores import fit_note, predicted
from ..scoring.wells import wells_of
from ..settings.file import translated
from ..settings.prototype import Prototype, parse_prototype
from ..signals.log import Log
from ..store.hashing import tree_hash
from ..store.outputs import new_outputs, rebased
from ..store.trees import read_tree, write_tree
from ..system.machine import one_thread
from ..units.quantity import axis_scale, moment
from ..units.units import column_suffix
from ..workflow.export import MODELS, write_model
from ..workflow.run_contents import subject_on
from ..workflow.steps.score import ComparedRun, measured_path, score_rows
from .in_memory import (
    Signals,
    arrays_of,
    as_pandas,
    cleaned,
    frame,
    free_run_frame,
    identify_signals,
    log_in,
    refuse_other_units,
    settings as settings_of,
    si_symbols,
    signals_of,
    voltages_of,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike


_COARSEST = 30.0  # times the sample interval that a step of times may be: 1 kHz in ms has 100


_CHECK = "check"
"""Group of the file with what travels along beside the model."""


class _File(ModelFile):
    """Metadata that are saved beside the model."""

    sizes: ClassVar[Sizes] = {"N": (2, 10_000_000), "K": (1, 2)}
    name: str
    """Name of the model, and of its group."""
    settings_json: str
    """Settings, as JSON."""
    t: Annotated[FloatArray, Table("N"), Unit("s")]
    """Times of the log that an export is checked on."""
    v: Annotated[FloatArray, Table("N K"), Unit("SI")]
    """Inputs of the model."""
    start: Annotated[FloatArray, Table("2"), Unit("SI")]
    """Displacement and velocity at its beginning."""
    q: Annotated[Span, Unit("SI")]
    """Least and largest displacement of the training logs."""
    qdot: Annotated[Span, Unit("SI")]
    """Least and largest velocity."""
    inputs: Annotated[FloatArray, Table("K 2"), Unit("SI")]
    """Least and largest value of each input."""


class Model:
    """A dynamic model of a device with one displacement and one or two inputs, in SI units.

    Attributes
    ----------
    name : str
        Such as ``hybrid`` or ``rbf``.
    core : DynamicModel
        Model that computes: ``simulate(t, v, q0, qdot0)`` with arrays.
    notes : dict
        Accepted findings and choices of its identification.
    """

    def __init__(
        self,
        core: DynamicModel,
        prototype: Prototype,
        notes: Mapping[str, Any] | None = None,
        *,
        subject: Callable[[], Subject],
    ) -> None:
        self.core = core
        self.name = core.name
        self.notes = dict(notes or {})
        self._prototype = prototype
        self._made_subject = subject

    def __repr__(self) -> str:
        logs = self.notes.get("training", "")
        return f"Model({self.name!r}, {self.inputs} input{'s' * (self.inputs > 1)}{logs and f', {logs}'})"

    @property
    def inputs(self) -> int:
        """Number of inputs."""
        return self.core.input_count

    @cached_property
    def _subject(self) -> Subject:
        return self._made_subject()

    def save(self, path: str | Path) -> Path:
        """Write the model with its settings as one HDF5 file, which `load` reads; `notes` are left out.

        Raises
        ------
        InputError
            The model cannot be filed, or the file cannot be written.
        """
        subject = self._subject
        if not hasattr(subject.model, "to_tree"):
            raise InputError(f"the model {subject.name} cannot be saved; identify another one")
        bounds = subject.validity
        beside = {
            "name": subject.name,
            "settings_json": json.dumps(self._prototype.model_dump(mode="json"), sort_keys=True),
            "t": subject.t,
            "v": subject.v,
            "start": np.array(subject.start),
            "q": np.array(bounds.q),
            "qdot": np.array(bounds.qdot),
            "inputs": np.array(bounds.v),
        }
        write_tree(
            Path(path),
            {_CHECK: beside, subject.name: subject.model.to_tree()},
            columns_of(device(self._prototype), {_CHECK: _File, subject.name: type(subject.model)}),
        )
        return Path(path)

    @classmethod
    def load(cls, path: str | Path) -> "Model":
        """The model that `save` wrote.

        Raises
        ------
        InputError
            There is no such file.
        CorruptArtifactError
            The file is damaged, or no saved model.
        """
        import h5py

        advice = "`Model.save` writes one, and `debist.open_run` opens the folder of a run"
        if not Path(path).is_file():
            raise InputError(f"{path}: no such file; {advice}")
        tree = read_tree(Path(path)) if h5py.is_hdf5(path) else {}
        if not isinstance(tree.get(_CHECK), dict):
            raise CorruptArtifactError(f"{path}: is no saved model; {advice}")
        held = read_part(_File, tree[_CHECK], "in the file", "identify")
        if not isinstance(model_tree := tree.get(held.name), dict):
            raise CorruptArtifactError(f"{path}: holds no model {held.name!r}, which it names; save it again")
        try:
            document: Any = json.loads(held.settings_json)
            if not isinstance(document, dict):
                raise ValueError("no tables")
            prototype = parse_prototype(translated(document), str(path))
        except (ValueError, InputError, RecursionError) as error:
            raise CorruptArtifactError(
                f"{path}: its settings cannot be read ({error}); save the model again"
            ) from error
        core = model_from_tree(held.name, model_tree)
        plant = device(prototype)
        return cls(
            core,
            prototype,
            subject=partial(
                Subject,
                prototype=prototype.name,
                name=held.name,
                model=core,
                validity=Validity(
                    q=tuple(held.q),
                    qdot=tuple(held.qdot),
                    v=tuple(tuple(row) for row in held.inputs),
                    sample_interval=prototype.ingest.sample_interval,
                    q_unit=plant.displacement.symbol,
                    v_units=tuple(unit.symbol for unit in plant.inputs),
                ),
                origin=tree_hash(model_tree),
                t=held.t,
                v=held.v,
                start=(float(held.start[0]), float(held.start[1])),
                curve_units=plant.curve_units,
            ),
        )

    def export(self, target: Literal["c", "fmu", "json", "matlab"], output: str | Path) -> list[Path]:
        """Write the model for another tool into a folder and return the files; see `debist export`.

        Raises
        ------
        InputError
            No such form of a model, a form that cannot carry it, or a file of others in the folder.
        """
        if target not in MODELS:
            raise InputError(f"no export {target!r} of a model alone; there are {', '.join(MODELS)}")
        subject = self._subject
        with new_outputs(Path(output), "export", made_from={"model": subject.origin}) as staged:
            written = write_model(target, subject, staged).written
        return [rebased(path, staged, Path(output)) for path in written]

    @one_thread
    def simulate(
        self,
        t: "ArrayLike | pd.DataFrame",
        v: "ArrayLike | None" = None,
        q0: float | None = None,
        qdot0: float = 0.0,
        *,
        tube: bool = False,
    ) -> pd.DataFrame:
        """Free run from an initial state.

        Parameters
        ----------
        t : array_like, shape (N,), or DataFrame
            Uniform times [s]; or the columns t_s, v1_V and v2_V together, v being left out.
        v : array_like, shape (N, inputs)
            Voltages [V]; between the samples as the model takes them, `hybrid` by a cubic spline, others by lines.
        q0, qdot0 : float
            Initial displacement [m] and velocity [m/s].
        tube : bool
            With the 90 % tubes of q, for a model that has them (`hybrid`, `rbf`).

        Returns
        -------
        pandas.DataFrame
            t_s, q_m, qdot_m_per_s, qddot_m_per_s2 (rad for an angle) and the voltages; NaN after a divergence. With
            tubes q_low_m, q_high_m, and q_other_low_m, q_other_high_m where the model is not sure of the well.
            ``attrs`` holds ``status`` ("ok" or "diverged") and ``diverged_at_s``.

        Raises
        ------
        InputError
            Signals that do not fit the model or each other, or a model without tubes.
        """
        times, volts = voltages_of(t, v)
        self._check_columns(volts.shape[1], None)
        if q0 is None:
            raise InputError("q0 is missing; give the displacement at the first sample")
        if not all(isinstance(number, Real) for number in (q0, qdot0)):
            raise InputError("q0 and qdot0 are one number each: the displacement and the velocity at the first sample")
        step = float(times[-1] - times[0]) / max(1, times.size - 1)
        usual = self._prototype.ingest.sample_interval
        if step > _COARSEST * usual:
            raise InputError(
                f"t has a step of {step:g} s, and the model was fitted to steps of {usual:g} s: give t in s"
            )
        refuse_other_units({"q0": abs(q0), "v": float(abs(volts).max(initial=0.0))}, self._prototype)
        self._warn_beyond([*volts.T], q0)
        run = self.core.simulate(times, volts, q0, qdot0)
        core = self.core
        drawn = core.simulate_draws(times, volts, q0, qdot0)[0] if tube and isinstance(core, HasDraws) else None
        tubes = wanted_tubes(run.q, drawn, core) if tube else {}
        return free_run_frame(run, tubes, volts, self._units)

    @one_thread
    def score(
        self,
        t: "ArrayLike | pd.DataFrame",
        q: "ArrayLike | None" = None,
        v1: "ArrayLike | None" = None,
        v2: "ArrayLike | None" = None,
    ) -> pd.DataFrame:
        """Errors of the free run over a measured log, from its first sample.

        Parameters
        ----------
        t, q, v1, v2 : array_like, shape (N,)
            Times [s], displacement [m or rad] and voltages [V], as raw as they are; or one DataFrame with the columns
            t_s, q_m, v1_V, v2_V. A log of a run, as `Run.log` returns it, is scored as the report does.

        Returns
        -------
        pandas.DataFrame
            One row for q, q̇ and q̈: fit_percent (as MATLAB's ``compare``), nrmse (a fraction, eq. 41) and its 95 %
            interval, rmse, unit, n, status, and for q the agreement of wells and switches.

        Raises
        ------
        InputError
            Signals that do not fit the model or each other, or numbers that look like millimetres or kilovolts.

        Warns
        -----
        UserWarning
            Remarks on the log, and its masked samples.
        """
        log = self._measured(t, q, v1, v2)
        plant = device(self._prototype)
        run = free_run(log, self.core)
        pairs = {name: (getattr(log, name), getattr(run, name)) for name in ("q", "qdot", "qddot")}
        wells = believed_wells(wells_of([log], plant=plant), self.name, stable_rests(self.core, [log.q]), plant=plant)
        rows = [
            {"signal": row["signal"], "fit_percent": fit_percent(*pairs[row["signal"]]), "unit": row["unit"]} | row
            for row in score_rows(
                plant, log, ComparedRun(pairs, {"status": run.status, "diverged_at_s": run.diverged_at_s}), wells
            )
        ]
        # NaN in place of a number that is not defined, as after a divergence.
        return pd.DataFrame([{key: np.nan if value is None else value for key, value in row.items()} for row in rows])

    @one_thread
    def predict(
        self,
        t: "ArrayLike | pd.DataFrame",
        q: "ArrayLike | None" = None,
        v1: "ArrayLike | None" = None,
        v2: "ArrayLike | None" = None,
        *,
        ahead: int = 1,
    ) -> pd.DataFrame:
        """Displacement `ahead` samples after each measured one, as a predictive controller needs it.

        Parameters
        ----------
        t, q, v1, v2 : array_like, shape (N,)
            A measured log as of `score`.
        ahead : int
            Samples of the uniform record ahead, at least 1; the default record has one every 10 ms.

        Returns
        -------
        pandas.DataFrame
            t_s, q_m (predicted) and q_measured_m (or _rad); NaN where the measured state `ahead` samples before, or
            an input since, is not known, and where the prediction diverged.

        Raises
        ------
        InputError
            `ahead` below 1 or beyond the log, or signals that do not fit the model.

        Notes
        -----
        A model takes its hidden states from the measurement before. Cost: `ahead` simulated samples for each sample.
        """
        log = self._measured(t, q, v1, v2)
        if ahead not in range(1, len(log.t)):
            raise InputError(f"ahead is {ahead}; give 1 to {len(log.t) - 1} samples")
        path, predict = measured_path(log, self.core)
        return frame({"t": log.t, "q": predicted(predict, path, int(ahead)), "q_measured": log.q}, *self._units)

    def plot(
        self,
        t: "ArrayLike | pd.DataFrame",
        q: "ArrayLike | None" = None,
        v1: "ArrayLike | None" = None,
        v2: "ArrayLike | None" = None,
        *,
        ax: "Axes | None" = None,
    ) -> "Axes":
        """Measured and simulated displacement of a log with the fit in percent, as MATLAB's ``compare`` draws it.

        Parameters
        ----------
        t, q, v1, v2 : array_like, shape (N,)
            A measured log as of `score`.
        ax : matplotlib.axes.Axes, optional
            Axes to draw on; new ones if left out.
        """
        from matplotlib import pyplot

        log = self._measured(t, q, v1, v2)
        run = free_run(log, self.core)
        if ax is None:
            ax = pyplot.subplots(figsize=(7.16, 2.6), layout="constrained")[1]
        unit, factor = axis_scale(self._units[0], float(abs(log.known_q).max()))
        ended = run.diverged_at_s
        note = fit_note(log.q, run.q) if ended is None else f"diverged at {moment(ended)}"
        ax.plot(log.t, factor * log.q, color="0.6", linewidth=2.5, label="measured")
        ax.plot(log.t, factor * run.q, color="#0072B2", linewidth=1.0, label=f"{self.name}: {note}")
        ax.set(xlabel="time in s", ylabel=f"q in {unit}")
        ax.legend(ncols=2, loc="lower left", bbox_to_anchor=(0.0, 1.0), frameon=False)
        return ax

    @one_thread
    def curves(self, q: "ArrayLike") -> pd.DataFrame:
        """Characteristic curves at q [m], shape (n,): force, damping, slopes of the capacitances (fig. 14).

        Raises
        ------
        InputError
            The model has none.
        """
        if not isinstance(self.core, HasCurves):
            raise InputError(f"the model {self.name} has no characteristic curves")
        places = np.atleast_1d(real_numbers(q, "q"))
        if places.ndim != 1:
            raise InputError(f"q has the shape {places.shape}; give one column of displacements, shape (n,)")
        refuse_other_units({"q": float(abs(places).max(initial=0.0))}, self._prototype)
        units = device(self._prototype).curve_units
        return pd.DataFrame(
            {
                f"q_{self._units[0]}": places,
                **{
                    f"{name}_{column_suffix(units[name.split('_')[0].rstrip('12')])}": curve
                    for name, curve in self.core.curves(places).items()
                },
            }
        )

    def describe(self) -> dict[str, Any]:
        """Structure, parameters and diagnostics, with units in the keys."""
        return self.core.describe()

    @property
    def _units(self) -> tuple[str, str]:
        """SI symbols of the displacement and of the inputs."""
        return si_symbols(self._prototype)

    def _measured(self, t: Any, q: Any, v1: Any, v2: Any) -> Log:
        t = as_pandas(t)
        log = log_in(t) if q is None else None
        if log is not None:
            self._check_columns(log.v.shape[1], "m" if "q_m" in t else "rad")
        else:
            signals = _logs(t, q, v1, v2)
            if len(signals) > 1:
                raise InputError(f"{len(signals)} logs were given; give one after the other")
            self._check_columns(signals[0].v.shape[1], signals[0].unit)
            log, _, remarks = cleaned(signals[0], self._prototype, "the log")
            for text in remarks:
                warn_user(text)
        self._warn_beyond(list(log.v.T))
        return log

    def _warn_beyond(self, inputs: list[FloatArray], q0: float | None = None) -> None:
        for text in self._subject.validity.beyond(inputs, q0):
            warn_user(text)

    def _check_columns(self, count: int, unit: str | None) -> None:
        if count != self.inputs:
            raise InputError(f"the log has {count} voltage(s), the model {self.name} {self.inputs}")

        if unit not in (None, self._units[0], device(self._prototype).logged.symbol):
            raise InputError(f"q of the log is in {unit}, that of the model {self.name} in {self._units[0]}")


@one_thread
def identify(
    t: "ArrayLike | pd.DataFrame | Sequence[pd.DataFrame]",
    q: "ArrayLike | None" = None,
    v1: "ArrayLike | None" = None,
    v2: "ArrayLike | None" = None,
    *,
    mass: float | None = None,
    parameters: str | Path | None = None,
    inputs: Literal["squared", "linear"] = "squared",
    angle: bool = False,
    model: str = "auto",
    settings: Mapping[str, Mapping[str, Any]] | None = None,
) -> Model:
    """Identify a model from measured signals, without a run folder.

    Parameters
    ----------
    t, q, v1, v2 : array_like, shape (N,)
        Times [s], displacement [m, or rad for an angle] and one or two voltages [V], as raw as they are: any rate,
        gaps in t and NaN allowed. The angle of a joint with `parameters` becomes its displacement. Or one DataFrame
        with the columns t_s, q_m (q_rad), v1_V, v2_V, or a list of them, one for a log. Both voltages may come as one
        array `v1` of shape (N, 2), as `Model.simulate` takes them.
    mass : float, optional
        Moving mass [kg] (inertia [kg·m²] for an angle); without it the curves are per unit mass.
    parameters : str or Path, optional
        Parameter set of the analytical joint: "nominal", "table1" or a file ``*.toml``. Without it a hybrid model's
        equations are scaled to the device by the data.
    inputs : {"squared", "linear"}
        Action of the inputs: the force goes with v² (electrostatic) or v.
    angle : bool
        True if q is an angle; a column q_rad is one anyway.
    model : str
        "auto" (hybrid or rbf, whichever predicts held-out training data better), or the name of a model: "hybrid",
        "rbf", "rbf-paper", "sindy", "sindy-default", "narx", "analytical" or "analytical-calibrated".
    settings : mapping, optional
        Tables of a settings file, such as ``{"ingest": {"sample_interval": 0.005}}``, or
        ``{"identify": {"structure": {"friction": "lag"}}}``. Paths in them are relative to the current folder.

    Returns
    -------
    Model

    Raises
    ------
    InputError
        Signals of different lengths, infinite samples, settings that are not valid.
    DataRefusedError
        The signals do not show what the model needs; the text names what to do.

    Warns
    -----
    UserWarning
        The signals contradict the arguments in what `debist check` refuses or marks by (!): sides exchanged, a wrong
        unit, a delay, an input that was left out.

    Notes
    -----
    Remarks and masked samples are listed in ``notes["warnings"]`` of the model. Cost: 5 to 20 s of processor time for a
    log of 37.5 s.

    Examples
    --------
    >>> model = debist.identify(t, q, v1, v2, mass=0.0405, parameters="nominal")  # doctest: +SKIP
    >>> model.simulate(t, np.column_stack([v1, v2]), q0=0.01).plot("t_s", "q_m")  # doctest: +SKIP
    """
    logs = _logs(t, q, v1, v2)
    count = logs[0].v.shape[1]
    unit = logs[0].unit
    if any((log.v.shape[1], log.unit) != (count, unit) for log in logs):
        raise InputError("the logs differ in their columns; give all of them the same voltages, and q in one unit")
    if angle and unit == "m":
        raise InputError("q_m is a length, but angle=True; call the column q_rad, or leave angle out")
    prototype = settings_of(
        inputs=count,
        angle=angle or unit == "rad",
        action=inputs,
        mass=mass,
        model=model,
        parameters=None if parameters is None else str(parameters),
        more=settings or {},
    )
    core, notes, cleaned_logs = identify_signals(logs, prototype, model)
    length = sum(log.duration for log in cleaned_logs)
    notes["training"] = f"trained on {len(logs)} log{'s' * (len(logs) > 1)} of {length:.4g} s"
    return Model(core, prototype, notes, subject=partial(_subject_of, core, prototype, cleaned_logs))


def _subject_of(model: StoredModel, prototype: Prototype, logs: Sequence[Log]) -> Subject:
    """A model that was identified from kinematics, with its bounds; an export is checked on the first log."""
    return subject_on(
        logs[0].longest_part(), model, prototype, logs=logs, name=model.name, origin=tree_hash(model.to_tree())
    )


def _logs(t: Any, q: Any, v1: Any, v2: Any) -> list[Signals]:
    t = [as_pandas(table) for table in t] if isinstance(t, list | tuple) else as_pandas(t)
    if q is not None:
        if v1 is None:
            raise InputError("v1 is missing; give t, q and v1 (and v2), or one DataFrame")
        return [arrays_of(t, q, v1, v2)]
    tables = [t] if hasattr(t, "columns") else t
    if not isinstance(tables, list | tuple) or not tables or not all(hasattr(table, "columns") for table in tables):
        raise InputError("q and v1 are missing; give t, q and v1 (and v2), or DataFrames with t_s, q_m, v1_V, v2_V")
    return [signals_of(table) for table in tables]
