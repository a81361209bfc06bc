"""All checks of a prototype's logs, as findings: each log by itself, without a model."""

from collections.abc import Sequence
from dataclasses import replace

from ..device.device import Device
from ..signals.findings import Finding
from .input_findings import input_findings
from .log_facts import log_facts
from .motion_findings import motion_findings, starts
from .weak_form import LogSignals


def check_logs(logs: Sequence[LogSignals], plant: Device, sample_interval: float) -> list[Finding]:
    """Look at every log; logs are compared by the fitted model, not here.

    `sample_interval` [s] is that of the identification.
    Cost: 0.2 s of processor time for each log of 40,000 samples.
    """
    facts = [log_facts(log, sample_interval, plant) for log in logs]
    findings = [finding for fact in facts for finding in (*motion_findings(fact, plant), *input_findings(fact, plant))]
    seen = {finding.subject for finding in findings if finding.code in ("side", "push")}  # in some log
    for place, finding in enumerate(findings):
        if finding.code in ("idle_input", "never_on") and finding.subject in seen:
            findings[place] = replace(finding, severity="unseen")
    return [*findings, *starts(facts)]


def refusing(findings: Sequence[Finding]) -> list[Finding]:
    """What would make the model wrong: the first finding of each gate."""
    first = {finding.gate: finding for finding in reversed(findings) if finding.gate is not None}
    return [first[gate] for gate in dict.fromkeys(finding.gate for finding in findings if finding.gate is not None)]
