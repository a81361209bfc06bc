"""The gate: findings refuse the data unless the settings accept them, and what is accepted is told everywhere."""

from collections.abc import Iterable, Sequence
from typing import Any

from pipeline.errors import DataRefusedError
from pipeline.numerics.sampling.quality_gates import Finding
from pipeline.settings import Gate, Quality


def judge(where: str, findings: Sequence[Finding], settings: Quality) -> list[str]:
    """The findings that the settings accept, as texts for the manifest, the terminal and the report.

    Raises
    ------
    DataRefusedError
        A finding is not accepted; the text names all of them and the settings that would let them pass.
    """
    refused = [finding for finding in findings if finding.gate not in settings.accept]
    if refused:
        names = ", ".join(f'"{gate}"' for gate in dict.fromkeys((*settings.accept, *(f.gate for f in refused))))
        reasons = "; ".join(f"{finding.text}: {finding.advice}" for finding in refused)
        raise DataRefusedError(f"{where}: {reasons}. To use it knowingly, set [quality] accept = [{names}]")
    return [f"{finding.text} (accepted: {finding.gate})" for finding in findings]


def accepted_settings(settings: Quality, gates: Iterable[Gate]) -> dict[str, Any]:
    """What a recipe holds of the gate: nothing where nothing is accepted there."""
    accepted = sorted(set(settings.accept) & set(gates))
    return {"quality": {"accept": accepted}} if accepted else {}
