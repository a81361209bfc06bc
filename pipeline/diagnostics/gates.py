"""Whether data that something speaks against are used all the same: the gate of every stage."""

from collections.abc import Collection, Iterable, Sequence
from typing import Any

from ..errors import DataRefusedError
from ..settings.prototype import Gate, Quality
from ..signals.findings import Finding
from .sentences import sentences


def judge(
    where: str,
    findings: Sequence[Finding],
    settings: Quality,
    prior: Collection[str] = (),
    decides: str = "the joint's equations",
) -> list[str]:
    """The findings that do not refuse the data, as texts for the manifest, the terminal and the report.

    Parameters
    ----------
    where : str
        Name of the data, for the error.
    findings : sequence of Finding
        What speaks against them.
    settings : Quality
        What they accept.
    prior : collection of str
        Gates of what the data need not show, because a model knows it beforehand.
    decides : str
        What of the model does.

    Raises
    ------
    DataRefusedError
        A finding is not accepted; the text names all of them and the settings that would let them pass.
    """
    refused = [finding for finding in findings if finding.gate not in (*settings.accept, *prior)]
    if refused:
        gates = dict.fromkeys((*settings.accept, *(finding.gate for finding in refused)))
        names = ", ".join(f'"{gate}"' for gate in gates)
        reasons = "; ".join(": ".join(sentences(finding)) for finding in refused)
        raise DataRefusedError(f"{where}: {reasons}. To use it knowingly, set [quality] accept = [{names}]")
    accepted = [(sentences(finding)[0], finding.gate) for finding in findings]
    return [
        f"{text} (accepted: {gate})" if gate in settings.accept else f"{text}; there {decides} decide"
        for text, gate in accepted
    ]


def accepted_settings(settings: Quality, gates: Iterable[Gate]) -> dict[str, Any]:
    """What a recipe holds of the gate: nothing where nothing is accepted there."""
    accepted = sorted(set(settings.accept) & set(gates))
    return {"quality": {"accept": accepted}} if accepted else {}
