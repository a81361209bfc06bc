"""The columns of every table, each defined once: for the Parquet files, the terminal, the page, CSV and the docs.

The site publishes them. A test requires a new `SCHEMA_VERSION` when columns of a file change.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from ..units.units import HORIZONS

SCHEMA_VERSION = "3"

Dtype = Literal["float64", "int32", "int64", "string", "bool"]


@dataclass(frozen=True)
class Cell:
    """Printed form of a column of the scores; its interval follows where there are columns of one.

    Attributes
    ----------
    table : {"errors", "behaviour"}
        The table that has the column: that of the errors, or that of the behaviour.
    unit : str
        Unit of the printed number; empty for none.
    factor : float
        Printed number over the value in the file.
    digits : int or None
        Decimals of the printed number; None for three significant digits.
    note : str
        The sentence below the table. A column with a note is left out where no row has a value.
    out_of : str
        Key of a count that the value is a part of, as in ``2 of 14``.
    """

    table: Literal["errors", "behaviour"]
    unit: str = "%"
    factor: float = 100.0
    digits: int | None = 1
    note: str = ""
    out_of: str = ""


@dataclass(frozen=True)
class Column:
    """One column of a table.

    Attributes
    ----------
    key : str
        Its name in files.
    title : str
        Its heading in printed tables; empty for a column that only files have.
    unit : str
        SI unit of the values in files, "1" for numbers and texts without one.
    help : str
        Meaning of the values.
    cell : Cell or None
        Printed form of a score; None for a column that only files have.
    dtype : str
        Type in files.
    """

    key: str
    title: str
    unit: str
    help: str
    cell: Cell | None = None
    dtype: Dtype = "float64"

    @property
    def heading(self) -> str:
        """Title and printed unit."""
        unit = self.cell.unit if self.cell else ""
        return f"{self.title} [{unit}]" if unit else self.title


@dataclass(frozen=True)
class FactColumn(Column):
    """A fact of the device in the datasheet.

    Attributes
    ----------
    row : str
        Row of the printed datasheet that shows it.
    side : {"", "left", "right"}
        Well of the fact; empty for a fact of the whole device.
    fleet : str
        Its heading in the table of a fleet; empty where that has no such column.
    """

    row: str = ""
    side: Literal["", "left", "right"] = ""
    fleet: str = ""


def _text(key: str, help_: str) -> Column:
    return Column(key, "", "1", help_, dtype="string")


# "{q}" and "{v}" stand for the SI units of displacement and inputs: m or rad, V or whatever the device takes.
RECORD_COLUMNS = (
    Column("t", "t", "s", "time, on the log's own time base"),
    Column("q", "q", "{q}", "displacement of the joint, positive to the right; NaN where masked"),
    Column("v1", "v1", "{v}", "first input: measured voltage of the left membrane"),
    Column("v2", "v2", "{v2}", "second input: measured voltage of the right membrane"),
    Column("velocity", "q̇", "{q}/s", "measured velocity, where there is such a channel"),
    Column("segment", "", "1", "number of the gap-free segment; -1 where the row is masked", dtype="int32"),
)
RATE_COLUMNS = (Column("qdot", "q̇", "{q}/s", "velocity"), Column("qddot", "q̈", "{q}/s²", "acceleration"))
TUBE_COLUMNS = (
    Column("q_low", "", "{q}", "lower end of the 90 % tube of q, where the model has one"),
    Column("q_high", "", "{q}", "upper end of it"),
    Column(
        "q_other_low", "", "{q}", "lower end of the tube in the other well; NaN where the model is sure of the well"
    ),
    Column("q_other_high", "", "{q}", "upper end of it"),
)
PHI_COLUMN = Column("phi", "φ", "rad", "tip rotation, from q by kinematics: the static map of the analytical model")


def _band(of: str, how: str) -> tuple[Column, Column]:
    """The columns of a share's interval."""
    return (
        Column(f"{of}_low", "", "1", f"lower end of its 95 % interval: {how}"),
        Column(f"{of}_high", "", "1", "upper end of that interval"),
    )


def _horizons() -> Iterator[Column]:
    for name, (_, words) in HORIZONS.items():
        help_ = f"NRMSE {words} ahead of the measured state (q only)"
        yield Column(f"nrmse_{name}", words, "1", help_, Cell("behaviour", digits=2))
        yield from _band(f"nrmse_{name}", "moving-block bootstrap of the restarts")


NOTED_COLUMNS = (
    Column(
        "outside_training", "outside", "1",
        "share of samples in states (q, q̇) that no training sample was near (q only)",
        Cell("behaviour", note="Outside: share of samples in states (q, q̇) that no training sample was near."),
    ),
    Column(
        "in_tube", "in tube", "1",
        "share of samples of q inside the 90 % tube of the free run; null for a model without one (q only)",
        Cell("behaviour", note="In tube: share of samples inside the 90 % tube of the free run."),
    ),
    Column(
        "basis_functions", "RBFs", "1",
        "Gaussian basis functions that act in each curve of the model; null for a model without any (q only)",
        Cell("errors", "per curve", 1.0, 0,
             "RBFs: basis functions that act; hybrid with 0 is its fitted equations alone."),
        "int64",
    ),
)  # fmt: skip
"""Scores that the notes of a free run hold under the same key (`pipeline.workflow.stage_validate`)."""

SCORE_COLUMNS = (
    _text("log", "name of the log"),
    _text("role", "train or validation"),
    _text("model", "name of the model"),
    Column("headline", "", "1", "whether it is the model that the run is judged by", dtype="bool"),
    _text("signal", "q, phi, qdot or qddot"),
    Column("nrmse", "NRMSE", "1", "root mean square error over the measured range (eq. 41); null if undefined"),
    *_band("nrmse", "moving-block bootstrap"),
    Column("above_lowest_low", "", "1",
           "lower end of the 95 % paired bootstrap interval of nrmse less the lowest of that log and signal; "
           "null for the lowest"),
    Column("above_lowest_high", "", "1", "upper end of that interval"),
    Column("rmse", "", "SI", "root mean square error, in `unit`"),
    _text("unit", "SI unit of the signal"),
    Column("n", "", "1", "number of samples compared", dtype="int64"),
    _text("status", "ok or diverged"),
    Column("diverged_at_s", "", "s", "time at which the free run diverged; null if it did not"),
    Column("well_agreement", "wells", "1", "share of samples with both in the same well (q only)",
           Cell("errors", note="Wells: share of samples in the measured well.")),
    *_band("well_agreement", "moving-block bootstrap"),
    Column("switch_accuracy", "switches", "1", "share of pulses after which both rest in one well (q only)",
           Cell("errors", note="Switches: share of pulses after which both rest in the same well (interval by "
                               "Bayesian bootstrap of the pulses).")),
    *_band("switch_accuracy", "Bayesian bootstrap of the pulses"),
    *_horizons(),
    *NOTED_COLUMNS,
    Column("outcomes", "", "1", "rests after a pulse that were given a probability for their well (q only)",
           dtype="int64"),
    Column(
        "ambiguous_outcomes", "ambiguous", "1", "those in which neither well has nine tenths of it (q only)",
        Cell("behaviour", "pulses", 1.0, 0,
             "Ambiguous: pulses that end so close to the barrier that, among runs drawn from the model's own "
             "uncertainty, fewer than 9 in ten come to rest in one well.", out_of="outcomes"),
        "int64",
    ),
)  # fmt: skip
TIME_COLUMNS = (
    Column("fit_s", "fit", "s", "processor time of the model's fit", Cell("errors", "s", 1.0, None)),
    Column("simulate_s", "run", "s", "processor time of the model's longest free run", Cell("errors", "s", 1.0, None)),
)
"""Columns that the printed table of the scores has beside those of the file."""

INSTRUMENT_COLUMNS = (
    _text("log", "name of the log"),
    _text("role", "train or validation"),
    _text("model", "model that measured: the main model, and rbf beside it"),
    _text("quantity", "gain_v1, gain_v2, zero_q, gain_q, delay or clock"),
    Column("estimate", "error", "SI", "error of the reading, relative to the training logs: reading over truth minus 1 "
           "for gains and the clock, reading minus truth for the zero (unit of q), time [s] by which the voltages are "
           "recorded later than they acted; null if not measured"),
    Column("standard_error", "", "SI", "its standard error"),
    Column("correction", "", "SI", "value for this log in [logs] that makes the readings true, together with what "
           "stands there"),
    Column("limit", "", "SI", "error below which it is of no practical interest"),
    Column("beyond", "", "1", "whether the error exceeds both 4 standard errors and the limit", dtype="bool"),
    Column("residual_ratio", "", "1", "what no instrument explains, over the same of the training logs"),
    _text("exchanged", "what is exchanged in this log: none, inputs, sign (of q) or both"),
    _text("status", "measured, not measured or another device"),
)  # fmt: skip

FLEET_COLUMNS = (
    _text("prototype", "name of the prototype"),
    Column("exit_code", "", "1", "exit code of its run; negative if a signal ended it", dtype="int64"),
    _text("reason", "why it failed; empty if it did not"),
    *SCORE_COLUMNS,
)

FLEET_FACT_COLUMNS = (
    _text("prototype", "name of the prototype"),
    _text("fact", "key of the fact, as in datasheet.json"),
    Column("value", "", "1", "its value, of the judged model, else as measured; in the unit beside it"),
    _text("fact_unit", "SI unit of the value"),
)

StudyName = Literal["alpha", "basis", "data", "online"]
STUDY_COLUMNS: dict[StudyName, tuple[Column, ...]] = {
    "alpha": (
        Column("alpha", "α", "{q}·s^order", "regularisation parameter"),
        Column("misfit", "misfit", "{q}", "RMS of record less regularised signal: above the noise, the signal suffers"),
        Column("roughness", "roughness", "{q}/s²", "mean change of the acceleration from sample to sample"),
    ),
    "basis": (
        Column("basis_functions", "M", "1", "number M of Gaussians per curve"),
        Column("smoothing", "σₙ", "1", "width over distance of the centres, sigma_n"),
        Column("mse", "error", "({q}/s²)²", "mean squared error of the acceleration on the training logs"),
        Column("condition", "condition", "1", "condition number of the regressor"),
        Column("nrmse", "NRMSE", "1", "free-run NRMSE of q on the other logs, at most 1"),
    ),
    "data": (
        Column("samples", "samples", "1", "training samples"),
        Column("noise", "noise", "{q}", "standard deviation of the noise added to q"),
        Column("nrmse", "NRMSE", "1", "median free-run NRMSE of q on the other logs, at most 1"),
        Column("nrmse_low", "", "1", "smallest of the repeats"),
        Column("nrmse_high", "", "1", "largest of the repeats"),
    ),
    "online": (
        Column("forgetting", "λ", "1", "forgetting factor λ of the recursive least squares"),
        Column("drift", "drift", "1", "share by which the restoring force grows over the log"),
        Column("t", "t", "s", "length of the stream so far"),
        Column("curve_error", "error of the curve", "1", "RMS error of the restoring force over its range"),
        Column("prediction_error", "prediction error", "1",
               "error of the acceleration before each sample, over its RMS"),
    ),
}  # fmt: skip

STABLE = "stable_"
"""Start of the keys of stable states of a device with three or more, or none."""


def _of_wells(kind: str, title: str, unit: str, row: str, help_: str, fleet: str = "") -> Iterator[FactColumn]:
    """A fact of the left and of the right well; `title` has a place for the side, `fleet` is without it."""
    for side in ("left", "right"):
        heading = f"{fleet} {side}" if fleet else ""
        yield FactColumn(f"{kind}_{side}", title.format(side), unit, help_, row=row, side=side, fleet=heading)


def _switches() -> Iterator[FactColumn]:
    for membrane in ("v1", "v2"):
        for side, out_of in (("right", "left"), ("left", "right")):
            yield FactColumn(
                f"switch_{membrane}_to_{side}",
                f"lowest steady {membrane} that switches to the {side}",
                "{v}",
                "voltage at which the well vanishes (a fold)",
                row="lowest steady input that switches out of it",
                side=out_of,  # type: ignore[arg-type]
                fleet=f"switching {membrane}, to {side}",
            )


_RING = "of a small free oscillation without input"
_SHARE = "share of critical damping in that oscillation"
_SLOPE = "slope of the restoring force at rest without input"
# {q}, {v}, {U}, {k} stand for the device's units of displacement, input, energy and stiffness.
FACT_COLUMNS = (
    *_of_wells("well", "rest on the {}", "{q}", "rest position", "stable equilibrium without input", "rest"),
    *_of_wells("barrier", "energy barrier out of the {} well", "{U}", "energy barrier out of it",
               "potential energy of the unstable equilibrium over that of the well", "barrier"),
    *_switches(),
    *_of_wells("stiffness", "stiffness in the {} well", "{k}", "stiffness", _SLOPE),
    *_of_wells("frequency", "ring-down frequency in the {} well", "Hz", "ring-down frequency", _RING, "frequency"),
    *_of_wells("damping", "damping ratio in the {} well", "1", "damping ratio", _SHARE, "damping"),
    FactColumn("rest", "rest position", "{q}", "stable equilibrium without input", row="rest position"),
    FactColumn("stiffness", "stiffness at rest", "{k}", _SLOPE, row="stiffness at rest"),
    FactColumn("frequency", "ring-down frequency", "Hz", _RING, row="ring-down frequency"),
    FactColumn("damping", "damping ratio", "1", _SHARE, row="damping ratio"),
    FactColumn(STABLE, "stable state", "{q}", "each stable equilibrium of a device without one or two",
               row="stable states"),
    FactColumn("saddle", "unstable equilibrium", "{q}", "between the wells", row="unstable equilibrium"),
    FactColumn("asymmetry_wells", "asymmetry of the wells, (q₊ + q₋)/(q₊ − q₋)", "%", "0 for a symmetric joint",
               row="asymmetry of rests (q₊\u00a0+\u00a0q₋)/(q₊\u00a0−\u00a0q₋)"),
    FactColumn("asymmetry_barriers", "asymmetry of the wells' depth, ΔU over the mean barrier", "%",
               "0 for a symmetric joint", row="asymmetry of depths, ΔU over mean barrier"),
)  # fmt: skip
