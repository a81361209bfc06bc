"""The JSON documents of a run, read back: what their readers take from them is there and of the right kind."""

import json
import math
from typing import Any

from pydantic import BaseModel, ConfigDict, ValidationError

from pipeline.checks.rows import State
from pipeline.errors import CorruptArtifactError
from pipeline.names import Well
from pipeline.runs import layout
from pipeline.runs.run_folder import RunFolder

Number = float | None
"""JSON has no number that is not finite: null stands for it."""
Row = list[float]


class Document(BaseModel):
    """Values are not converted; what is not named may be there."""

    model_config = ConfigDict(strict=True, extra="allow", allow_inf_nan=False)


class _Bode(Document):
    f_Hz: Row
    left_dB: Row
    right_dB: Row
    left_deg: Row
    right_deg: Row


class _Ringing(Document):
    frequency_Hz: Number
    damping_ratio: Number


class _Equilibrium(_Ringing):
    q_m: float
    v_V: Row
    stable: bool
    poles_1_s: list[tuple[float, float]]
    states: list[str]
    x0: Row
    A: list[Row]
    B: list[Row]
    C: list[Row]
    D: list[Row]
    B_squared: list[Row]
    bode: _Bode


class _Measured(Document):
    left: _Ringing
    right: _Ringing


class _Linear(Document):
    equilibria: list[_Equilibrium]
    measured: _Measured


class _Lowest(Document):
    duration: float
    voltage: float
    low: float
    high: float
    until: Number


class _OneMap(Document):
    to: Well
    voltages: Row
    durations: Row
    probability: list[Row]
    lowest: list[_Lowest]


class _Map(Document):
    maps: list[_OneMap]


class _Band(Document):
    t_s: Row
    q_m: Row
    low_m: Row
    high_m: Row


class _Pulse(Document):
    to: Well
    t_s: Row
    v_V: list[tuple[float, float]]
    predicted: _Band
    settling_s: Number
    settling_90_s: tuple[Number, Number]
    overshoot_m: float
    switching_probability: float
    largest_voltage_V: float


class _Step(Document):
    settling_s: Number
    overshoot_m: float
    rms_m: float


class _Loop(Document):
    steps: tuple[_Step, _Step, _Step]
    t_s: Row
    q_m: Row
    target_m: Row
    v_V: list[tuple[float, float]]


class _Places(Document):
    left: float
    saddle: float
    right: float


class _Margins(Document):
    gain_low: float
    gain_high: float
    delay_s: float
    friction_high: float


class _Design(Document):
    model: str
    origin: str
    places_m: _Places
    largest_voltage_V: float
    slew_V_s: Number
    average_V: Number
    lags_s: tuple[float, float]
    lags_known: str
    margins: _Margins | None
    predicted: _Loop
    law: dict[str, Any]


class _CheckRow(Document):
    model_config = ConfigDict(extra="forbid")

    log: str
    what: str
    found: str
    limit: str
    state: State = "ok"
    gate: str | None = None
    advice: str = ""
    more: str = ""
    values: dict[str, float] = {}


class _Check(Document):
    rows: list[_CheckRow]


class _Finding(Document):
    about: str
    grade: str
    name: str
    statement: str
    advice: str


class _Verdict(Document):
    data: str
    model: str
    checks: list[_Finding]


class _Score(Document):
    log: str
    role: str
    model: str
    signal: str
    status: str
    nrmse: Number = None
    switch_accuracy: Number = None


class _Fact(Document):
    key: str
    title: str
    unit: str
    value: Number
    low: Number
    high: Number
    measured: Number
    measured_spread: Number
    events: int
    free_run: Number = None
    in_draws: Number = None


class _Datasheet(Document):
    verdict: _Verdict
    name: str
    facts_from: str | None
    judged_model: str | None
    scores: list[_Score]
    facts: list[_Fact]


_SHAPES: dict[str, type[Document]] = {
    layout.CHECK: _Check,
    layout.DATASHEET: _Datasheet,
    layout.control("linear"): _Linear,
    layout.control("map"): _Map,
    layout.control("pulse-to-left"): _Pulse,
    layout.control("pulse-to-right"): _Pulse,
    layout.control("design"): _Design,
}


def read_document(run: RunFolder, name: str) -> dict[str, Any]:
    """A JSON artifact.

    Raises
    ------
    CorruptArtifactError
        It is damaged, or an entry is missing or of another kind.
    """
    content = run.read_bytes(name)
    try:
        _SHAPES[name].model_validate_json(content)
        return dict(json.loads(content, parse_float=_finite, parse_constant=_finite))
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False, include_context=False)[0]
        reason = f"{'.'.join(map(str, first['loc']))}: {first['msg']}"
    except ValueError as error:
        reason = str(error)
    raise CorruptArtifactError(f"{run.path(name)}: cannot be read ({reason}); `debist {_made_by(name)}` makes it anew")


def _finite(text: str) -> float:
    if not math.isfinite(value := float(text)):
        raise ValueError(f"holds {text}")
    return value


def _made_by(name: str) -> str:
    return layout.command_of(name) or "run"
