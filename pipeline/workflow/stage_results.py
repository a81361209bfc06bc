"""What a stage came to, for the last lines of its command: gaps of each log, α, the model that was chosen."""

from typing import Any

from ..device.device import device
from ..store import layout
from ..store.run_folder import RunFolder
from ..system.names import log_title, true_name
from ..units.units import ALPHA_UNIT
from .engine import TIMES
from .run_models import CHOICE, IDENTIFIED


def ingested(run: RunFolder) -> list[dict[str, Any]]:
    """Of each log the rows of its uniform record, their interval [s], how many are masked, and its gaps in time."""
    results = []
    for role, log, path in layout.logs(run.prototype):
        notes = run.record(layout.signals(role, log)).notes
        results.append(
            {
                "log": log_title(role, true_name(path)),
                "rows": notes["rows"],
                "masked_rows": notes["masked_rows"],
                "interval_s": notes["interval"],
                "gaps": notes["gaps_in_time"],
            }
        )
    return results


def differentiated(run: RunFolder) -> list[dict[str, Any]]:
    """Of each log the method, and of each of its stretches α and the noise, in units that the settings have α in."""
    unit = ALPHA_UNIT[device(run.prototype).displacement.symbol][0]
    results = []
    for role, log, path in layout.logs(run.prototype):
        notes = run.record(layout.kinematics(role, log)).notes
        of_velocity = notes["of"] == "velocity"
        regularised = notes["method"] == "tvregdiff"
        results.append(
            {
                "log": log_title(role, true_name(path)),
                "method": notes["method"],
                "of": notes["of"],
                "alphas": [stretch["alpha"] for stretch in notes["stretches"]] if regularised else [],
                "alpha_unit": f"{unit}·s^{notes['order'] - of_velocity}" if regularised else "",
                "noises": [stretch["noise_std"] for stretch in notes["stretches"]],
                "noise_unit": f"{unit}/s" if of_velocity else unit,
            }
        )
    return results


def identified(run: RunFolder) -> list[dict[str, Any]]:
    """Of each identified model its processor time [s], whether it is the headline, and why where "auto" chose it."""
    notes = run.record(layout.MODELS).notes
    choice = notes.get(CHOICE, {})
    return [
        {
            "model": model,
            "headline": k == 0,
            "fit_s": notes[model].get(TIMES, {}).get("fit_s"),
            "reason": choice["reason"] if model == choice.get("chosen") else "",
        }
        for k, model in enumerate(notes[IDENTIFIED])
    ]
