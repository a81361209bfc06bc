"""Logs against settings: honest logs pass, and what is certain without a model is caught, each by its own row."""

import time
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from pipeline.device import device as joint
from pipeline.device.device import Device
from pipeline.diagnostics.check import CheckRow, beside, check_logs, check_rows, refusing
from pipeline.diagnostics.log_facts import LogSignals
from pipeline.diagnostics.sentences import sentences
from pipeline.numerics.arrays import FloatArray
from pipeline.rig.joint import simulate
from pipeline.rig.parameters import nominal
from pipeline.signals.findings import Finding
from pipeline.units.units import SiUnit
from tests.models.hybrid.test_hybrid import pulses
from tests.prototypes import motion

RATE, DURATION = 1000.0, 37.5
JOINT = replace(joint.JOINT, known_mass=0.041)


@pytest.fixture(scope="module")
def pair() -> list[LogSignals]:
    logs = []
    for name, seed in (("training log", 35), ("validation log", 36)):
        t, q, v = motion(DURATION, RATE, seed, excitation=name.removesuffix(" log"), noise=2e-6)
        logs.append(LogSignals(name, t, q, v, 1.0 / RATE, 2e-6))
    return logs


def _remarkable(findings: list[Finding]) -> dict[tuple[str, str], str]:
    """Severity of every finding that asks for a look, by code and subject."""
    return {(each.code, each.subject): each.severity for each in findings if each.severity in ("fair", "poor")}


def _codes(findings: list[Finding]) -> set[str]:
    return {code for code, _ in _remarkable(findings)}


def _gates(findings: list[Finding]) -> set[str | None]:
    return {finding.gate for finding in refusing(findings)}


def _late(log: LogSignals, samples: int) -> LogSignals:
    """The recorder of the voltages was started so many samples earlier than that of q."""
    return replace(log, t=log.t[samples:], q=log.q[:-samples], v=np.ascontiguousarray(log.v[samples:]))


def _v(change: Callable[[FloatArray], FloatArray]) -> Callable[[LogSignals], LogSignals]:
    return lambda log: replace(log, v=np.ascontiguousarray(change(log.v)))


def _q(change: Callable[[FloatArray], FloatArray]) -> Callable[[LogSignals], LogSignals]:
    return lambda log: replace(log, q=change(log.q))


def test_honest_logs_pass_without_a_remark(pair: list[LogSignals]) -> None:
    findings = check_logs(pair, JOINT, 0.01)
    assert {finding.severity for finding in findings} == {"good"}, _remarkable(findings)
    assert not [row for row in check_rows(findings) if "±" in row.found]


@pytest.mark.parametrize(
    ("spoilt", "code", "subject", "gate"),
    [
        (_v(lambda v: v[:, ::-1]), "side", "v1", "sides"),
        (_q(lambda q: -q), "side", "v2", "sides"),
        (_v(lambda v: 1e-3 * v), "coupling", "stated", "scale"),
        (_q(lambda q: 1e3 * q), "range", "q", "scale"),
        (_v(lambda v: 1e3 * v), "range", "v2", "scale"),
        (_q(lambda q: 0.0 * q + 5e-6), "still", "q", "scale"),
        (_v(lambda v: v * [1.0, 2.0]), "coupling_ratio", "", None),
        (lambda log: _late(log, 60), "late_answer", "q", None),
        (_q(lambda q: q - 0.04), "rests", "q", None),
        (_q(lambda q: np.round(q / 1e-3) * 1e-3), "resolution", "q", None),
        (_v(lambda v: v + np.array([0.0, 150.0])), "rest_level", "v2", None),
        (_v(lambda v: 1.5 * v), "field", "", None),
        (_v(lambda v: v * [1.0, 0.0]), "never_on", "v2", None),
        (_v(lambda v: np.hstack([v[:, :1], np.sqrt(v.max() ** 2 - v[:, :1] ** 2)])), "correlated", "", None),
        (lambda log: replace(log, held=5), "held", "q", None),
    ],
)  # fmt: skip
def test_a_mistake_is_caught_by_its_finding(
    pair: list[LogSignals], spoilt, code: str, subject: str, gate: str | None
) -> None:
    resolution = 1e-3 if code == "resolution" else None
    logs = [replace(spoilt(log), resolution=resolution) for log in pair]
    findings = check_logs(logs, JOINT, 0.01)
    assert _remarkable(findings).get((code, subject)) == ("fair" if gate is None else "poor"), _remarkable(findings)
    assert _gates(findings) == ({gate} if gate else set())
    assert all(sentences(finding)[1] for finding in findings if finding.severity in ("fair", "poor"))


@pytest.mark.parametrize(
    ("declared", "gate"),
    [
        ({"known_mass": 41.0}, {"scale"}), ({"known_mass": None}, set()), ({"known_mass": 0.041 / 8.0}, set()),
        ({"film_thickness": 50e-9}, set()), ({"film_thickness": 50e-3}, set()), ({"field_limit": 60e12}, set()),
    ],
)  # fmt: skip
def test_units_of_the_settings_are_told_by_the_order_of_magnitude(pair, declared, gate) -> None:
    findings = check_logs(pair[:1], replace(JOINT, **declared), 0.01)
    assert _gates(findings) == gate
    assert _codes(findings) == ({"field_units"} if "known_mass" not in declared else {"coupling"} if gate else set())


@pytest.mark.parametrize("slower", [0.25, 4.0])
def test_a_smaller_or_larger_joint_passes(pair: list[LogSignals], slower: float) -> None:
    """Built n times as large: n times as slow and as long, n³ times as heavy, the same slope of the capacitance."""
    logs = [replace(log, t=slower * log.t, q=slower * log.q, v=log.v * slower) for log in pair]
    assert not _gates(check_logs(logs, replace(JOINT, known_mass=0.041 * slower**3), 0.01))


@pytest.mark.parametrize("samples", [35, 60, 120])
def test_a_late_answer_has_its_size_and_refuses_nothing(pair: list[LogSignals], samples: int) -> None:
    (late,) = (each for each in check_logs([_late(pair[0], samples)], JOINT, 0.01) if each.code == "late_answer")
    assert (late.severity, late.gate) == ("fair", None)
    assert late.numbers["late"].value == pytest.approx(1e-3 * samples, abs=0.011)
    device = replace(JOINT, action="linear")  # whose answer may depend on frequency
    assert "late_answer" not in _codes(check_logs([_late(pair[0], samples)], device, 0.01))


def test_an_input_that_is_not_named_shows_by_starts_from_rest(pair: list[LogSignals]) -> None:
    for side in (0, 1):
        logs = [replace(log, v=np.ascontiguousarray(log.v[:, [side]])) for log in pair]
        rows = check_logs(logs, replace(JOINT, inputs=JOINT.inputs[:1]), 0.01)
        found = [each for each in rows if each.code == "undriven_starts"]
        assert any(each.numbers["starts"].value >= 2 for each in found)


@pytest.mark.parametrize("resting", [0, 1, 2])
def test_an_input_that_never_changes_hides_no_starts_from_rest(pair: list[LogSignals], resting: int) -> None:
    """One of the two columns, or both, hold a constant in place of the voltages that moved the joint."""
    v = pair[0].v.copy()
    v[:, resting:] = 0.0
    found = [each for each in check_logs([replace(pair[0], v=v)], JOINT, 0.01) if each.code == "undriven_starts"]
    assert bool(found) == (resting < 2)


@pytest.mark.parametrize("drift", [0.0, 5e-5])
def test_small_inputs_of_a_rest_are_no_drift(drift: float) -> None:
    """A spring whose linear input rests at 7 % of its largest value to one side, and later to the other."""
    t = np.arange(0.0, 40.0, 1e-3)
    v = np.where(t % 2.0 < 1.0, np.where(t % 4.0 < 2.0, 1.0, -1.0), 0.07 * np.sign(t - 20.0))[:, None]
    q = 0.01 * v[:, 0] + drift * t + np.random.default_rng(3).normal(0.0, 1e-5, t.size)
    device = Device(None, JOINT.displacement, JOINT.inputs[:1], "linear", None)
    rows = check_logs([LogSignals("training log", t, q, v, 1e-3)], device, 0.01)
    found = [each.numbers["drift"].value for each in rows if each.code == "drift"]
    assert found == ([pytest.approx(drift, rel=0.05)] if drift else [])


def test_a_command_has_no_noise_and_a_measurement_has_its_own(pair: list[LogSignals]) -> None:
    measured = replace(pair[0], v=pair[0].v + np.random.default_rng(1).normal(0.0, 4.0, pair[0].v.shape))
    for log, noise in ((pair[0], None), (measured, 4.0)):
        codes = ("command", "input_noise")
        (found,) = (each for each in check_logs([log], JOINT, 0.01) if each.subject == "v1" and each.code in codes)
        assert found.code == codes[noise is not None]
        assert noise is None or found.numbers["noise"].value == pytest.approx(noise, rel=0.1)


@pytest.mark.parametrize("law", [np.square, np.positive, lambda u: u * np.abs(u)], ids=["squared", "linear", "monitor"])
def test_the_law_of_an_input_of_both_signs_is_told(law: Callable[[FloatArray], FloatArray]) -> None:
    """A spring under one input, by the law that is declared and by the other one."""
    rng, h = np.random.default_rng(4), 1.0 / RATE
    u = np.repeat(rng.uniform(-1.0, 1.0, 300), 120)
    q, p, x = 0.0, 0.0, np.empty(u.size)
    for i, force in enumerate(law(u)):
        x[i] = q
        p += h * (force - 40.0 * q - 2.0 * p)
        q += h * p
    log = LogSignals("training log", h * np.arange(u.size), 0.1 * x, u[:, None], h)
    for squared in (True, False):
        one = Device(None, JOINT.displacement, (SiUnit(1.0, "A"),), "squared" if squared else "linear", None)
        (found,) = (each for each in check_logs([log], one, 0.01) if "left_by_linear" in each.numbers)
        right = law is (np.square if squared else np.positive)
        assert found.severity == ("good" if right else "fair")
        assert found.code == ("law" if law in (np.square, np.positive) else "signed_monitor")


def test_a_ring_down_over_the_barrier_is_no_unnamed_input() -> None:
    """Hardly damped, a joint goes over the barrier several times after a pulse, and then stays where it is."""
    t = np.arange(0.0, 40.0, 1.0 / RATE)
    since, side = t % 5.0, np.where(t // 5.0 % 2.0, 1.0, -1.0)
    ringing = 3.5 * np.exp(-since) * np.cos(2.0 * np.pi * 2.9 * since)
    v = np.column_stack([np.where((since > 4.7) & (side == sign), 3e3, 0.0) for sign in (-1.0, 1.0)])
    log = LogSignals("train/light", t, 0.01 * side * (1.0 + ringing), v, 1.0 / RATE)
    assert "undriven_starts" not in _codes(check_logs([log], JOINT, 0.01))


@pytest.mark.parametrize(("kept", "found"), [(True, ["wrapped"]), (False, [])])
def test_an_angle_that_is_kept_within_a_turn_is_refused(kept: bool, found: list[str]) -> None:
    """A pendulum that goes round, and one that swings by nearly a turn."""
    t = np.arange(0.0, 30.0, 1e-3)
    q = np.pi * (t / 5.0 + np.sin(2.0 * t)) if kept else 0.97 * np.pi * np.sin(2.0 * t)
    v = np.abs(np.sin(0.7 * t))[:, None]
    log = LogSignals("train/a", t, (q + np.pi) % (2.0 * np.pi) - np.pi, v, 1e-3)
    one = Device(None, SiUnit(1.0, "rad"), JOINT.inputs[:1], "squared", None)
    assert [each.gate for each in check_logs([log], one, 0.01) if each.code == "wrapped"] == found


def test_what_is_no_joint_is_not_judged_as_one(pair: list[LogSignals]) -> None:
    """One input that pushes to the left, late, and was never off: nothing is refused or noted of it."""
    logs = [_late(replace(log, q=-log.q, v=np.ascontiguousarray(log.v[:, :1] + 3e3)), 60) for log in pair]
    for declared in (
        replace(JOINT, inputs=JOINT.inputs[:1], known_mass=None),
        Device(None, SiUnit(1.0, "rad"), (SiUnit(0.01, "1"),), "linear", None),
    ):
        rows = check_logs(logs, declared, 0.01)
        assert not _gates(rows)
        assert not {"late_answer", "rest_level", "field", "field_units"} & _codes(rows)


def test_gaps_silence_weak_and_short_logs_are_no_findings(pair: list[LogSignals]) -> None:
    q = pair[0].q.copy()
    q[5000:5400] = np.nan
    t, weak, v = motion(DURATION, RATE, 36, excitation="validation", gain=0.45, noise=2e-6)
    assert weak.max() < 0.0, "too weak to switch"
    short = replace(pair[1], t=pair[1].t[:900], q=pair[1].q[:900], v=pair[1].v[:900])
    for log in (replace(pair[0], q=q), replace(pair[1], v=0.0 * pair[1].v), LogSignals("b", t, weak, v, 1e-3), short):
        assert not _gates(check_logs([pair[0], log], JOINT, 0.01))


def test_the_angle_of_a_joint_is_named_and_may_answer_at_other_times(pair: list[LogSignals]) -> None:
    """Voltages turn the tip before the joint moves: q by the angle has no delay that a recorder could make up for."""
    moved = [_late(pair[0], 60)]
    found = [
        {finding.code for finding in check_logs(moved, replace(JOINT, angle=angle), 0.01)}
        for angle in (None, SiUnit(1.0, "rad"))
    ]
    assert [codes & {"from_angle", "late_answer"} for codes in found] == [{"late_answer"}, {"from_angle"}]


def test_the_angle_of_a_joint_given_as_a_length_answers_early_and_is_named() -> None:
    t, v = pulses(3, 16.0)
    fine = np.arange(round(4000.0 * t[-1]) + 1) / 4000.0
    volts = np.column_stack([np.interp(fine, t, column) for column in v.T])
    moved = simulate(nominal(), volts, 1.0 / 4000.0, stride=2)
    at = slice(None, None, 4)
    noise = np.random.default_rng(1).normal(0.0, 5e-6, (2, moved.phi[at].size))
    for q, told in ((moved.q[at], False), (1e-3 * np.degrees(moved.phi[at]), True)):
        log = LogSignals("log", fine[::4][: q.size], q + noise[0], volts[::4][: q.size], 1e-3, 5e-6)
        said = [": ".join(sentences(each)) for each in check_logs([log], JOINT, 0.01) if each.severity == "fair"]
        assert any("if it is the angle of a joint, give it in deg or rad" in text for text in said) is told, said


def test_a_table_of_many_logs_costs_as_much_as_its_rows() -> None:
    rows = [
        CheckRow(f"log {i}", f"subject {k}", f"{i}", "", "note" if i == 7 else "ok")
        for i in range(3000)
        for k in range(10)
    ]
    begin = time.process_time()
    header, table = beside(rows)
    assert header[1] == "most remarkable of 3000 logs" and {row[1] for row in table} == {"7 (!)"}
    assert time.process_time() - begin < 2.0  # 0.1 s; 5 s if each log is sought in all rows
