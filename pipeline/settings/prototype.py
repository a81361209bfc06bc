"""The settings of one prototype: frozen, strict, read from one TOML file.

Only what changes results stands here; threads, verbosity and output folders are options of the commands.
The reference page of the settings is generated from the descriptions below.
"""

import difflib
from functools import partial
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal

from pydantic import AfterValidator, Field, field_validator, model_validator

from ..system.names import check_log_name, check_name, log_name, slug
from .file import GATES, checked, read_document
from .logs import ROLES, Channels, Logs, Number, SettingsTable, Whole, log_label
from .models import AUTO, CENTRES, ENTRIES, RBF_TIME_LIMIT, SMOOTHING, names


class Quantity(SettingsTable):
    """A number with its unit."""

    value: Number = Field(gt=0.0)
    """The number, above zero."""
    unit: str = Field(min_length=1, max_length=100)
    """Unit in pint notation."""


FILM_THICKNESS = 50.0
FIELD_LIMIT = 60.0
"""Values of the paper's joint [µm, V/µm]: 3 kV on an undeformed film of 50 µm."""


class Plant(SettingsTable):
    """Facts of the device."""

    mass: Quantity | None = None
    """Moving mass [kg] (inertia [kg·m²] for an angle without `parameters`); left out, curves are per unit mass."""
    inputs: Literal["squared", "linear"] = "squared"
    """Action of the inputs: "squared" (electrostatic force) or "linear" (a force-like input)."""
    inputs_before: Literal["auto", "first", "zero"] = "auto"
    """Inputs before a log began: as at its "first" sample, or "zero" (a drive that was off), for every
    model alike; "auto": hidden states of `rbf` start by inner validation, those of other models under the first."""
    parameters: str | None = None
    """Parameter set of the analytical model ("table1", "nominal" or a TOML file); left out for other devices. With
    it, a q in deg or rad is the angle of the joint, and becomes its displacement."""
    curves: str | None = None
    """CSV file of characteristic curves measured on a test stand, which `rbf` keeps while it learns
    the friction: columns "q [mm]" and any of "F [N]", "dC1_dq [nF/m]", "dC2_dq [nF/m]"; needs mass."""
    siblings: str | None = None
    """File of `debist fleet learn`: what joints of the same drawing teach this one. It is the prior of `hybrid` where
    held-out training data speak for it, and needs the parameter set of those joints in `parameters`."""
    film_thickness: Quantity = Quantity(value=FILM_THICKNESS, unit="µm")
    """Thickness of the undeformed film between the electrodes of the joint."""
    field_limit: Quantity = Quantity(value=FIELD_LIMIT, unit="V/µm")
    """Largest field in the undeformed film: `check` marks a log above it, and control keeps within it."""


FILM = {"film_thickness", "field_limit"}
"""Settings of the plant that bound voltages and change no fit."""


class Csv(SettingsTable):
    """Format of CSV logs, where it cannot be detected from the file."""

    encoding: str | None = None
    """Text encoding, such as latin-1."""
    delimiter: str | None = Field(default=None, min_length=1, max_length=1)
    """Column separator."""
    decimal: Literal[".", ","] | None = None
    """Decimal mark."""
    header_row: Whole | None = Field(default=None, ge=0, le=10_000)
    """Row of the column names, counted from 0."""


class Ingest(SettingsTable):
    """Conversion of raw logs to uniform records."""

    sample_interval: Number = Field(default=0.01, ge=1e-5, le=10.0)
    """Interval [s] of the uniform record on which models are identified and scored."""
    record_interval: Number = Field(default=0.001, ge=1e-6, le=10.0)
    """Interval [s] of the finer record that is differentiated, from the log's own step up to `sample_interval`."""
    sample_rate: Number | None = Field(default=None, gt=0.0, le=1e7)
    """Samples per second [Hz] of a log that has neither a time channel nor a time base of its own."""
    gaps: Literal["split", "refuse"] = "split"
    """Action at a gap: "split" the record there (rows that would reach across are masked) or "refuse" it."""
    time_reversal: Literal["refuse", "split", "unwrap"] = "refuse"
    """Action where time steps back: "refuse" the log, "split" there, which leaves out what does not pass the
    latest stamp, or "unwrap" a counter that begins anew: it goes on by its usual step."""
    rails: Literal["mask", "keep"] = "mask"
    """Action where q stays at its smallest or largest value for three samples or more, as at the end of a
    sensor's range: "mask" it, which leaves it out of derivatives, fits and scores, or "keep" it. "keep" also lets a
    log pass that stays there for long, as a drive that rests at its end positions."""
    lost: Literal["mask", "keep"] = "mask"
    """Action where q is lost: "mask" (lost rows: split) or "keep". Lost are jumps to a constant level far outside the
    rest for 50 ms or more (a laser without its target), bursts at one level, held values, and lost rows."""
    spikes: Literal["mask", "keep"] = "mask"
    """Action at single samples far off neighbours that agree: "mask" (inputs: a line across) or "keep"."""
    csv: Csv = Csv()
    """Format of CSV logs."""

    @model_validator(mode="after")
    def _record_is_finer(self) -> "Ingest":
        if "record_interval" in self.model_fields_set and self.record_interval > self.sample_interval:
            raise ValueError(
                f"record_interval is {self.record_interval:g} s, but sample_interval {self.sample_interval:g} s: the "
                "record is the finer one"
            )
        return self


class Differentiate(SettingsTable):
    """Differentiation of the displacement."""

    method: Literal["tvregdiff", "savitzky-golay"] = "tvregdiff"
    """Differentiator: total-variation regularised, or Savitzky-Golay filter."""
    order: Literal[1, 2, 3, 4] = 3
    """Derivative whose variation TVRegDiff penalises; 1 is the paper's, applied twice for the acceleration."""
    alpha: Number | Literal["auto"] = "auto"
    """Regularisation parameter, for q in mm [mm·s^order], deg or mV; "auto": by the log's noise; the paper's: 0.01."""
    epsilon: Number | None = Field(default=None, gt=0.0, le=1e6)
    """With a fixed alpha: rounding of the variation's corner, for q in mm [(mm/s^order)²], deg or mV; default 1e-6."""

    @field_validator("alpha")
    @classmethod
    def _positive(cls, value: float | str) -> float | str:
        if isinstance(value, float) and not value > 0.0:
            raise ValueError('must be a positive number or "auto"')
        return value

    @model_validator(mode="after")
    def _alpha_applies(self) -> "Differentiate":
        if self.method != "tvregdiff" and self.alpha != AUTO:
            raise ValueError(f'alpha is for method = "tvregdiff"; {self.method!r} goes by the noise, leave alpha out')
        if self.alpha == "auto" and self.epsilon is not None:
            raise ValueError('epsilon is chosen together with alpha = "auto"; give alpha too, or leave epsilon out')
        return self


class Structure(SettingsTable):
    """Elements of `rbf`; "auto": by inner validation on the training logs."""

    friction: Literal["auto", "viscous", "coulomb", "lag", "lags", "maxwell-slip", "lag+slip", "lags+slip"] = "auto"
    """Friction beside the damping d(q). "viscous": none; "coulomb": one stop operator; "lag": one relaxing
    element; "lags": two hidden shapes and a slow relaxing element; "maxwell-slip": three stop operators; "lag+slip",
    "lags+slip": with one stop operator. "auto": by inner validation on the training logs, "lags+slip" for a
    bistable joint."""
    force: Literal["auto", "curve", "polynomial", "offset"] = "auto"
    """Restoring force: a cubic with Gaussians, the cubic alone, or a constant for a free mass."""
    damping: Literal["auto", "curve", "constant"] = "auto"
    """Damping d(q): a curve or a number."""
    drag: Literal["auto", "none", "quadratic"] = "auto"
    """Drag of a fluid, by the square of the speed."""
    stops: Literal["auto", "none", "both"] = "auto"
    """End stops, one on either side, with a stiffness and a resistance while they are touched."""
    gain: Literal["auto", "curve", "constant"] = "auto"
    """Gain of each input: a curve or a number."""
    drive: Literal["auto", "direct", "lag", "delay", "lag+delay", "effect-lag"] = "auto"
    """Dynamics from an input to the device: at once, behind a first-order lag, a constant delay, or both. With
    "effect-lag" the effect of the input lags, as heat or pressure follows a power."""
    effect: Literal["auto", "plain", "bent", "dead-zone"] = "auto"
    """Static curve of an input: "plain" (in proportion, or by its square), "bent" (steeper or flatter at zero, as of
    an amplifier, valve or motor that saturates), or "dead-zone" (no effect near zero)."""
    hold: Literal["auto", "linear", "zero", "cubic", "record"] = "auto"
    """Inputs between two samples: a line, held (a zero-order hold), a cubic spline, or the finer record."""


def _known_names(given: tuple[str, ...], choices: tuple[str, ...]) -> tuple[str, ...]:
    """The names, each once.

    Raises
    ------
    ValueError
        An unknown name.
    """
    for name in given:
        if name not in choices:
            close = difflib.get_close_matches(name, choices, n=1)
            hint = f"did you mean {close[0]!r}?" if close else f"there are {', '.join(choices)}"
            raise ValueError(f"no model {name!r} here; {hint}")
    return tuple(dict.fromkeys(given))


class Identify(SettingsTable):
    """Identification of models."""

    models: Annotated[tuple[str, ...], AfterValidator(partial(_known_names, choices=(AUTO, *names("identify"))))] = (
        Field(default=(AUTO, "rbf", "rbf-paper"), min_length=1)
    )
    """Models to identify; the first is the main model. "auto": "hybrid" or "rbf", whichever predicts held-out training
    data better; as the first name, it leaves that place to another that holds training logs which this one loses, or
    predicts better by horizon. "hybrid": the joint's equations, with data-driven corrections where these help. "rbf":
    the physics-informed RBF network from data alone. "rbf-paper": section 4.2 of the paper to the letter."""
    basis_functions: Whole = Field(default=CENTRES, ge=2, le=200)
    """Basis functions M of each curve of `rbf-paper`."""
    smoothing: Number = Field(default=SMOOTHING, gt=0.0, le=10.0)
    """Width of a basis function of `rbf-paper` over the distance of the centres, sigma_n."""
    corrections: Literal["auto", "none", "always"] = "auto"
    """RBF corrections of `hybrid`; "auto": where the equations leave an error and held-out data speak for them."""
    structure: Structure = Structure()
    """Elements of `rbf`."""
    time_limit: Number = Field(default=RBF_TIME_LIMIT, gt=0.0, le=1e6)
    """Processor time [s] for `rbf`, search and fit together; for a device that is no bistable joint it grows with the
    samples of the training logs beyond 7,500. It counts evaluations by a stated cost and not the clock,
    so results do not depend on the machine; a fit that it cuts short is reported as not converged."""


class Compare(SettingsTable):
    """Baselines on the same logs."""

    models: Annotated[tuple[str, ...], AfterValidator(partial(_known_names, choices=names("compare")))] | None = None
    """Baselines to fit and score: SINDy at its best, pysindy's defaults, a polynomial NARX, the analytical model with
    the parameters of the set and calibrated; all that apply if left out (the analytical ones need plant.parameters).
    Names: sindy, sindy-default, narx, analytical, analytical-calibrated."""
    candidates: Whole | None = Field(default=None, ge=1, le=1_000_000)
    """Candidates after which the search of SINDy or NARX ends with the best so far; it ends by itself if left out. They
    are counted and not timed, so that results do not depend on the machine."""
    curves: str | None = None
    """CSV file of measured characteristic curves, drawn beside those of the models: columns "q [mm]" and any of
    "F [N]", "d [N s/m]", "dC1_dq [nF/m]", "dC2_dq [nF/m]", in the units that the heading names; needs plant.mass."""


LogGate = Literal["masked", "missing", "repeated", "dropped", "jitter", "rails", "hum", "rate"]
CheckGate = Literal["sides", "scale", "wrapped"]
TrainingGate = Literal["idle", "undriven", "one-well", "visits", "rank"]
Gate = Literal[LogGate, CheckGate, TrainingGate]


class Quality(SettingsTable):
    """Data that are refused (exit code 3) unless they are accepted knowingly."""

    accept: tuple[Gate, ...] = ()
    """Findings that do not refuse the data; they are recorded in the manifest and graded poor in the report. Of a
    log: "masked", "missing", "repeated", "dropped", "jitter", "rails", "hum", "rate". Of what `debist check` finds:
    "sides" (v1 pushes to the left, as in a device whose membranes are wired the other way round), "scale", "wrapped"
    (an angle that jumps by a turn). Of the training data: "idle", "undriven", "one-well", "visits", "rank"."""

    @field_validator("accept", mode="before")
    @classmethod
    def _present(cls, value: Any) -> Any:
        if gone := [gate for gate in value if gate in GATES] if isinstance(value, list | tuple) else []:
            raise ValueError(f"{gone[0]!r} refuses no data any more: leave it out")
        return value


class Prototype(SettingsTable):
    """Everything that decides the results of one prototype."""

    gone: ClassVar = {
        "differentiate.reweighted": "leave it out: the penalty is always lifted where the acceleration jumps",
        "differentiate.rate": 'leave it out; for "signals" give [ingest] record_interval the value of sample_interval',
        "differentiate.method": 'write method = "savitzky-golay", or leave it out',
        "identify.basis": "leave it out: `rbf-paper` has Gaussians",
        "identify.rbf_basis_functions": "leave it out: inner validation chooses the number",
        "identify.rbf_smoothing": "leave it out: inner validation chooses the width",
        "identify.rbf_prior": "leave it out: inner validation chooses the prior",
    }
    name: Annotated[str, AfterValidator(check_name)]
    """Name of the prototype; letters of any script, blanks and brackets too. A safe form of it names its folder."""
    logs: Logs
    channels: Channels
    plant: Plant = Plant()
    quality: Quality = Quality()
    ingest: Ingest = Ingest()
    differentiate: Differentiate = Differentiate()
    identify: Identify = Identify()
    compare: Compare = Compare()

    @model_validator(mode="after")
    def _log_names(self) -> "Prototype":
        for role in ROLES:
            logs = [log_label(log) for log in getattr(self.logs, role)]
            filed = [log_name(log) for log in logs]
            for log, name in zip(logs, filed, strict=True):
                check_log_name(log)
                if [other.casefold() for other in filed].count(name.casefold()) > 1:
                    raise ValueError(
                        f"logs.{role}: two logs are named {name!r}, by which a run files them: rename one of the files"
                    )
        if twice := set(map(log_label, self.logs.train)) & set(map(log_label, self.logs.validation)):
            raise ValueError(f"logs.validation: {min(twice)!r} is a training log too; validate on a log of its own")
        return self

    @model_validator(mode="after")
    def _consistent(self) -> "Prototype":
        """Refuse what does not suit the device, and what nothing reads; M and σ_n also decide gates and studies."""
        plant = self.plant
        no_rbf = not {AUTO, "rbf"} & {*self.identify.models}
        no_hybrid = not {AUTO, "hybrid"} & {*self.identify.models}
        of_rbf = 'is for "rbf", which identify.models does not name'
        of_hybrid = 'is for "hybrid", which identify.models does not name'
        of_joint = "is for the joint's two squared voltages; leave it out for this device"
        rules = (
            *(
                (
                    plant.parameters is None and entry.name in (self.compare.models or ()),
                    f"compare.models: {entry.name!r} needs a parameter set; name one as plant.parameters",
                )
                for entry in ENTRIES
                if entry.needs_parameters
            ),
            (
                "hybrid" in self.identify.models and not self.may_be_a_joint,
                'identify.models: "hybrid" has two squared inputs; take "rbf" for another device',
            ),
            (
                self.compare.curves is not None and plant.mass is None,
                "compare.curves: measured forces compare with a known mass only; give plant.mass",
            ),
            (
                plant.parameters is not None and not self.may_be_a_joint,
                "plant.parameters: the joint has two squared inputs; name v1 and v2 in [channels], or leave the set "
                "out for another device",
            ),
            (
                plant.siblings is not None and plant.parameters is None,
                "plant.siblings: siblings are joints of one drawing; give plant.parameters too",
            ),
            (
                plant.curves is not None and plant.mass is None,
                "plant.curves: measured forces move a known mass only; give plant.mass",
            ),
            *(
                (no_rbf and value != AUTO, f"identify.structure.{key}: {of_rbf}")
                for key, value in self.identify.structure
            ),
            (no_rbf and self.identify.time_limit != RBF_TIME_LIMIT, f"identify.time_limit: {of_rbf}"),
            (no_rbf and plant.curves is not None, f"plant.curves: {of_rbf}"),
            (no_hybrid and plant.siblings is not None, f"plant.siblings: {of_hybrid}"),
            (no_hybrid and self.identify.corrections != AUTO, f"identify.corrections: {of_hybrid}"),
            *(
                (
                    not self.may_be_a_joint and getattr(plant, key) != Plant.model_fields[key].default,
                    f"plant.{key}: {of_joint}",
                )
                for key in sorted(FILM)
            ),
            (
                self.channels.qdot is not None and self.differentiate.alpha != AUTO,
                "differentiate.alpha: is for the displacement; a measured velocity (channels.qdot) is smoothed by its "
                "own noise, leave alpha and epsilon out",
            ),
        )
        for broken, words in rules:
            if broken:
                raise ValueError(words)
        return self

    @property
    def may_be_a_joint(self) -> bool:
        """True if the device has the two squared inputs of the joint's equations."""
        return self.channels.v2 is not None and self.plant.inputs == "squared"

    @property
    def folder(self) -> str:
        """The safe form of its name, for folders and files."""
        return slug(self.name)

    @property
    def baselines(self) -> tuple[str, ...]:
        """The baselines to compare with: those named, or all that apply to the device."""
        if self.compare.models is not None:
            return self.compare.models
        has_set = self.plant.parameters is not None
        return tuple(e.name for e in ENTRIES if e.part == "compare" and (has_set or not e.needs_parameters))


def load_prototype(path: Path) -> Prototype:
    """Read a prototype's TOML file; raises what `read_document` and `parse_prototype` do."""
    return parse_prototype(read_document(path), str(path))


def parse_prototype(document: dict[str, Any], where: str) -> Prototype:
    """Check settings that were read from `where`.

    Raises
    ------
    InputError
        Everything that is wrong, each with the key and a suggestion.
    """
    return checked(document, Prototype, where)
