"""The JSON documents of a run, read back: what their readers take from them is there and of the right kind."""

import json
import math
from functools import cache
from types import GenericAlias
from typing import Any

from pydantic import BaseModel, ValidationError

from ..errors import CorruptArtifactError
from ..system.names import Well
from . import layout
from .run_folder import RunFolder
from .schemas import Number, kind, list_of

Row = list[float]
Pairs = list[tuple[float, float]]


@cache
def _kinds() -> dict[str, type[BaseModel]]:
    """What the readers of each document take from it."""
    ringing = {"frequency_Hz": Number, "damping_ratio": Number}
    bode = kind(f_Hz=Row, left_dB=Row, right_dB=Row, left_deg=Row, right_deg=Row)
    matrices = dict.fromkeys(("A", "B", "C", "D", "B_squared"), list[Row])
    equilibrium = kind(
        q_m=float, v_V=Row, stable=bool, poles_1_s=Pairs, states=list[str], x0=Row, bode=bode, **matrices, **ringing
    )
    lowest = kind(duration=float, voltage=float, low=float, high=float, until=Number)
    switching = kind(to=Well, voltages=Row, durations=Row, probability=list[Row], lowest=list_of(lowest))
    pulse = kind(
        to=Well, t_s=Row, v_V=Pairs, predicted=kind(t_s=Row, q_m=Row, low_m=Row, high_m=Row), settling_s=Number,
        settling_90_s=tuple[Number, Number], overshoot_m=float, switching_probability=float, largest_voltage_V=float,
    )  # fmt: skip
    step = kind(settling_s=Number, overshoot_m=float, rms_m=float)
    margins = kind(gain_low=float, gain_high=float, delay_s=float, friction_high=float)
    design = kind(
        model=str, origin=str, places_m=kind(left=float, saddle=float, right=float), largest_voltage_V=float,
        slew_V_s=Number, average_V=Number, lags_s=tuple[float, float], lags_known=str, margins=margins | None,
        predicted=kind(steps=GenericAlias(tuple, (step,) * 3), t_s=Row, q_m=Row, target_m=Row, v_V=Pairs),
        law=dict[str, Any],
    )  # fmt: skip
    check = kind(
        log=str, what=str, found=str, limit=str, state=(str, "ok"), gate=(str | None, None), advice=(str, ""),
        more=(str, ""), values=(dict[str, float], {}), code=(str, ""),
    )  # fmt: skip
    finding = kind(about=str, grade=str, name=str, statement=str, advice=str)
    score = kind(
        log=str, role=str, model=str, signal=str, status=str, nrmse=(Number, None), switch_accuracy=(Number, None)
    )
    fact = kind(
        key=str, title=str, unit=str, value=Number, low=Number, high=Number, measured=Number, measured_spread=Number,
        events=int, free_run=(Number, None), in_draws=(Number, None),
    )  # fmt: skip
    datasheet = kind(
        verdict=kind(data=str, model=str, checks=list_of(finding)), name=str, facts_from=str | None,
        judged_model=str | None, scores=list_of(score), facts=list_of(fact),
    )  # fmt: skip
    return {
        layout.CHECK: kind(rows=list_of(check)),
        layout.DATASHEET: datasheet,
        layout.control("linear"): kind(
            equilibria=list_of(equilibrium), measured=kind(left=kind(**ringing), right=kind(**ringing))
        ),
        layout.control("map"): kind(maps=list_of(switching)),
        layout.control("pulse-to-left"): pulse,
        layout.control("pulse-to-right"): pulse,
        layout.control("design"): design,
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
        _kinds()[name].model_validate_json(content)
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
