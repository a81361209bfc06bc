"""Logs against settings: honest logs pass, and every mistake of a first hour is caught, by its own name."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from pipeline.checks.check import check_logs
from pipeline.checks.declared import Declared
from pipeline.checks.limits import LENGTH_ERRORS
from pipeline.checks.log_facts import log_facts
from pipeline.checks.rest_level import rest_level
from pipeline.checks.rows import CheckRow, findings
from pipeline.checks.weak_form import LogSignals
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.linear_filters import first_order_lag
from pipeline.scoring.wells import snaps
from tests.double_well import DoubleWell
from tests.prototypes import motion

RATE, DURATION = 1000.0, 37.5
STIFFER = DoubleWell(stiffness=9.0)
JOINT = Declared(squared=True, displacement="m", inputs=("V", "V"), mass=0.041, sample_interval=0.01)


def _log(device: DoubleWell, name: str, seed: int, excitation: str = "training", slower: float = 1.0) -> LogSignals:
    """A log of a planted device with 2 µm of noise; `slower` makes it a larger one that does all that later."""
    t, q, v = motion(DURATION, RATE, seed, device=device, excitation=excitation, noise=2e-6)
    return LogSignals(name, slower * t, q, v, slower / RATE)


@pytest.fixture(scope="module")
def pair() -> list[LogSignals]:
    return [_log(DoubleWell(), "train/a", 35), _log(DoubleWell(), "validation/b", 36, "validation")]


def _wrong(rows: list[CheckRow]) -> set[str]:
    return {finding.gate for finding in findings(rows)}


def _numbers(rows: list[CheckRow], what: str) -> list[str]:
    return [row.found for row in rows if row.what == what]


def _later(log: LogSignals, samples: int) -> LogSignals:
    """The recorder of the voltages was started so much earlier than that of q."""
    return replace(log, t=log.t[samples:], q=log.q[:-samples], v=np.ascontiguousarray(log.v[samples:]))


def _earlier(log: LogSignals, samples: int) -> LogSignals:
    """The recorder of q was started so much earlier than that of the voltages."""
    return replace(log, t=log.t[samples:], q=log.q[samples:], v=np.ascontiguousarray(log.v[:-samples]))


def _beginning(log: LogSignals, seconds: float = 8.0) -> LogSignals:
    """Its first seconds, too short to be sure that it is another device."""
    few = slice(0, round(seconds / log.interval))
    return replace(log, t=log.t[few], q=log.q[few], v=log.v[few])


def test_honest_logs_of_one_device_pass(pair: list[LogSignals]) -> None:
    rows = check_logs(pair, JOINT)
    assert {row.state for row in rows} == {"ok"}, [row for row in rows if row.state != "ok"]


@pytest.mark.parametrize(
    ("change", "what"),
    [
        (lambda q, v: (q + 0.6e-3, v), "zero of q"),
        (lambda q, v: (q, 0.75 * v), "gain of voltages"),
        (lambda q, v: (q, v[:, ::-1]), "same device"),
        (lambda q, v: (q, np.roll(v, -30, axis=0)), "answer of q"),
    ],
)
def test_what_changes_within_a_log_is_noted(
    pair: list[LogSignals], change: Callable[[FloatArray, FloatArray], tuple[FloatArray, FloatArray]], what: str
) -> None:
    log, later = pair[0], pair[0].t > 0.5 * pair[0].t[-1]
    q, v = change(log.q, log.v)
    changed = replace(log, q=np.where(later, q, log.q), v=np.where(later[:, None], v, log.v))
    notes = [row for row in check_logs([changed], JOINT) if row.what == f"{what}, second half"]
    assert [(row.state, row.gate, row.log) for row in notes] == [("note", None, log.name)]
    assert "not of one piece" in notes[0].advice


@pytest.mark.parametrize("measured", [slice(None, 18_000), slice(19_000, None), slice(None, 18_760)])
def test_a_log_of_which_one_half_is_masked_is_compared_with_nothing(pair: list[LogSignals], measured: slice) -> None:
    q = np.full_like(pair[0].q, np.nan)
    q[measured] = pair[0].q[measured]
    assert not [row for row in check_logs([replace(pair[0], q=q)], JOINT) if row.what.endswith("second half")]


def test_a_longer_log_promises_a_smaller_error(pair: list[LogSignals]) -> None:
    what = "length, usual error"
    shown = _numbers([*check_logs([_beginning(pair[0], 10.0)], JOINT), *check_logs(pair[:1], JOINT)], what)
    lengths, errors = zip(*(cell.removesuffix(" %").split(" s, ") for cell in shown), strict=True)
    assert list(map(float, lengths)) == [10.0, 37.5]
    expected = [LENGTH_ERRORS[1][1], LENGTH_ERRORS[3][1]]
    assert list(map(float, errors)) == pytest.approx(expected, rel=0.03)
    assert expected[1] < expected[0]
    assert not _numbers(check_logs(pair, replace(JOINT, squared=False)), what)


@pytest.mark.parametrize(
    ("film", "key"),
    [
        ({"film_thickness": 50e-3}, "plant.film_thickness is 50 mm, which of films is 1 µm to 3 mm"),
        ({"film_thickness": 50e-9}, "plant.film_thickness is 50 nm"),
        ({"field_limit": 60e3}, "plant.field_limit is 60 kV/m"),
        ({"field_limit": 60e12}, "plant.field_limit is 60000 GV/m"),
    ],
)
def test_a_film_of_another_unit_is_noted_with_its_key(pair: list[LogSignals], film: dict[str, float], key: str) -> None:
    (row,) = (row for row in check_logs(pair[:1], replace(JOINT, **film)) if row.what == "largest field")
    assert row.state == "note"
    assert row.advice.startswith(key) and row.advice.endswith("check its unit")


def test_a_field_above_the_limit_is_noted_of_a_joint_alone(pair: list[LogSignals]) -> None:
    strong = replace(pair[0], v=1.5 * pair[0].v)
    (row,) = (row for row in check_logs([strong], JOINT) if row.what == "largest field")
    assert (row.state, row.gate, row.found) == ("note", None, "90.0 V/µm")
    assert "film_thickness" in row.advice
    assert [r.state for r in check_logs([strong], replace(JOINT, film_thickness=80e-6)) if r.what == row.what] == ["ok"]
    assert "largest field" not in {r.what for r in check_logs([strong], replace(JOINT, squared=False))}


@pytest.mark.parametrize("samples", [-18, pytest.param(13, marks=pytest.mark.long)])
def test_a_log_of_another_clock_is_told_beside_the_first(pair: list[LogSignals], samples: int) -> None:
    """Though alone its delay is no remark: sensors and drives of honest logs are as late, or early."""
    first = _later(pair[0], 8)
    moved = _later(pair[1], 8 + samples) if samples > 0 else _earlier(pair[1], -8 - samples)
    rows = check_logs([first, moved], JOINT)
    (row,) = (row for row in rows if row.what == "answer of q")
    assert (row.log, row.state, row.gate) == (moved.name, "note", None)
    assert row.values["later_s"] == pytest.approx(1e-3 * samples, abs=1.5e-3)
    assert ("later" if samples > 0 else "earlier") in row.advice
    assert not [row for row in check_logs([first, _later(pair[1], 14)], JOINT) if row.what == "answer of q"]
    # Of another device the lag of the answer may depend on frequency and amplitude.
    assert not [row for row in check_logs([first, moved], replace(JOINT, squared=False)) if row.what == "answer of q"]


@pytest.mark.parametrize("rest", [0.0, 5e-6 * (1.0 + 1e-15)])
def test_a_sensor_that_shows_no_motion_is_named(pair: list[LogSignals], rest: float) -> None:
    q = np.full_like(pair[0].q, rest)
    q[::2] = np.nextafter(q[::2], 1.0) if rest else 0.0  # as a change of units rounds
    rows = check_logs([replace(pair[0], q=q)], JOINT)
    (row,) = (row for row in rows if row.what == "range of q")
    assert (row.state, row.gate, row.advice.split(":")[0]) == ("wrong", "scale", "q does not move")


def test_an_input_that_is_not_named_is_told(pair: list[LogSignals]) -> None:
    """Without v2 every snap to the left happens while the only input is off."""
    logs = [replace(log, v=np.ascontiguousarray(log.v[:, :1])) for log in pair]
    rows = [
        row for row in check_logs(logs, replace(JOINT, inputs=("V",))) if row.what == "snaps while the input is off"
    ]
    assert rows and {row.state for row in rows} == {"note"}
    assert all("the second input as v2" in row.advice for row in rows)


def test_what_cannot_be_seen_of_an_input_is_said_by_what_the_input_does(pair: list[LogSignals]) -> None:
    log = pair[0]
    about = 95.0 + 9.0 * np.sin(0.7 * log.t)  # a coolant flow: always on, and changing
    once = np.where(log.t < 0.02, 3000.0, 0.0)
    noise = np.random.default_rng(0).normal(0.0, 3.0, log.t.size)
    said = {}
    for name, v in (
        ("about", about),
        ("once", once),
        ("steady", np.full_like(once, 4.0)),
        ("off", 0.0 * once),
        ("noise", noise),
    ):
        other = replace(JOINT, inputs=("V",), squared=False)
        (row,) = (r for r in check_logs([replace(log, v=v[:, None])], other) if r.what == "push of v1")
        said[name] = row.found, row.state
    assert said["about"] == ("cannot be told apart from the motion", "not seen")
    assert said["once"] == said["steady"] == ("hardly ever changes", "not seen")
    assert said["off"] == ("hardly ever on", "note")
    assert said["noise"] == ("nothing but noise", "note")


@pytest.mark.parametrize("slower", [0.25, pytest.param(4.0, marks=pytest.mark.long)])
def test_a_smaller_or_larger_joint_passes(pair: list[LogSignals], slower: float) -> None:
    """Built n times as large: n times as slow and as long, n³ times as heavy, the same slope of the capacitance."""
    logs = [replace(log, t=slower * log.t, q=slower * log.q, v=log.v * slower) for log in pair]
    assert not _wrong(check_logs(logs, replace(JOINT, mass=0.041 * slower**3)))


@pytest.mark.parametrize(
    ("spoilt", "gate"),
    [
        (lambda log: replace(log, v=np.ascontiguousarray(log.v[:, ::-1])), "sides"),
        (lambda log: replace(log, q=-log.q), "sides"),
        (lambda log: replace(log, v=1e-3 * log.v), "scale"),
        (lambda log: replace(log, q=1e3 * log.q), "scale"),
        (lambda log: _later(log, 60), "delay"),
    ],
    ids=["v1 and v2 swapped", "q negated", "kV read as V", "mm read as m", "60 ms between the recorders"],
)
def test_a_mistake_in_both_logs_is_caught(pair: list[LogSignals], spoilt, gate: str) -> None:
    assert gate in _wrong(check_logs([spoilt(log) for log in pair], JOINT))


@pytest.mark.parametrize(
    ("factor", "state"),
    [
        (2.0, "note"),
        (0.1, "wrong"),
        *(pytest.param(*each, marks=pytest.mark.long) for each in ((0.5, "note"), (10.0, "wrong"))),
    ],
)
def test_a_wrong_scale_of_one_side_shows_between_the_sides(pair: list[LogSignals], factor: float, state: str) -> None:
    rows = check_logs([replace(log, v=log.v * [1.0, factor]) for log in pair], replace(JOINT, mass=None))
    assert {row.state for row in rows if row.what == "coupling of v1 over v2"} == {state}


def test_two_inputs_that_are_one_are_told(pair: list[LogSignals]) -> None:
    assert not _numbers(check_logs(pair, JOINT), "v2 beside v1")
    v = pair[0].v[:, :1]
    tied = replace(pair[0], v=np.hstack([v, np.sqrt(np.square(v.max()) - np.square(v))]))
    (row,) = (row for row in check_logs([tied], JOINT) if row.what == "v2 beside v1")
    assert row.state == "note" and "correlation -1" in row.found


def test_a_probe_with_a_zero_error_is_told(pair: list[LogSignals]) -> None:
    rows = check_logs([replace(pair[0], v=pair[0].v + np.array([0.0, 150.0]))], JOINT)
    assert [(row.what, row.state) for row in rows if row.what.startswith("rest level")] == [
        ("rest level of v2", "note")
    ]


@pytest.mark.parametrize("zero", [-0.04, pytest.param(0.04, marks=pytest.mark.long)])
def test_a_laser_that_was_not_zeroed_is_told_and_refuses_nothing(pair: list[LogSignals], zero: float) -> None:
    rows = check_logs([replace(log, q=log.q + zero) for log in pair], JOINT)
    assert {row.state for row in rows if row.what == "rests"} == {"note"} and not _wrong(rows)


def _law_of_a_spring(law: Callable[[FloatArray], FloatArray], *, squared: bool) -> CheckRow:
    """The row on the law of one input of both signs that drives a spring by some law, under the one declared."""
    rng, h = np.random.default_rng(4), 1.0 / RATE
    u = np.repeat(rng.uniform(-1.0, 1.0, 300), 120)
    q, p, x = 0.0, 0.0, np.empty(u.size)
    for i, force in enumerate(law(u)):
        x[i] = q
        p += h * (force - 40.0 * q - 2.0 * p)
        q += h * p
    log = LogSignals("training log", h * np.arange(u.size), 0.1 * x, u[:, None], h)
    declared = Declared(squared=squared, displacement="m", inputs=("A",), mass=None, sample_interval=0.01)
    (row,) = (row for row in check_logs([log], declared) if row.what == "law of the inputs")
    return row


@pytest.mark.parametrize("squared", [True, False])
def test_the_law_of_an_input_of_both_signs_is_told(squared: bool) -> None:
    for said in (True, False):
        row = _law_of_a_spring(np.square if squared else np.positive, squared=said)
        assert row.state == ("ok" if said == squared else "note"), row


def test_a_signed_monitor_of_two_membranes_is_told() -> None:
    for said in (True, False):
        row = _law_of_a_spring(lambda u: u * np.abs(u), squared=said)
        assert row.state == "note"
        assert 'part = "positive"' in row.advice


def test_a_ring_down_over_the_barrier_is_no_unnamed_input() -> None:
    """Hardly damped, a joint goes over the barrier several times after a pulse, and then stays where it is."""
    t = np.arange(0.0, 40.0, 1.0 / RATE)
    since, side = t % 5.0, np.where(t // 5.0 % 2.0, 1.0, -1.0)
    ringing = 3.5 * np.exp(-since) * np.cos(2.0 * np.pi * 2.9 * since)
    v = np.column_stack([np.where((since > 4.7) & (side == sign), 3e3, 0.0) for sign in (-1.0, 1.0)])
    log = LogSignals("train/light", t, 0.01 * side * (1.0 + ringing), v, 1.0 / RATE)
    facts = log_facts(log, 0.01, squared=True, joint=True)
    assert len(snaps(log.q, facts.wells)) > 30
    assert facts.undriven == 0


def test_logs_of_one_simple_device_at_two_rates_are_of_one_device(pair: list[LogSignals]) -> None:
    """What the weak form leaves of such a device is so little that the coarser steps alone exceed it."""
    coarse = replace(
        pair[1], t=pair[1].t[::4], q=pair[1].q[::4], v=np.ascontiguousarray(pair[1].v[::4]), raw_step=4 / RATE
    )
    assert not _wrong(check_logs([pair[0], coarse], JOINT))


@pytest.mark.parametrize("lag", [pytest.param(40, marks=pytest.mark.long), 120])
def test_the_delay_is_told(pair: list[LogSignals], lag: int) -> None:
    rows = check_logs([_later(pair[0], lag)], JOINT)
    for what in ("delay of q after v1", "delay of q after v2"):
        (told,) = _numbers(rows, what)
        value, error = (float(part) for part in told.removesuffix(" ms").split(" ± "))
        assert abs(value - lag) < 3.0 and error < 3.0
    assert log_facts(_later(pair[0], lag), 0.01, squared=True, joint=True).lag is None


def test_a_delay_that_no_clock_need_make_is_shown_and_does_not_refuse(pair: list[LogSignals]) -> None:
    rows = [row for row in check_logs([_later(pair[0], 17)], JOINT) if row.what.startswith("delay")]
    assert {(row.state, row.gate) for row in rows} == {("note", None)}
    assert all('drive = "lag" or "delay"' in row.advice for row in rows)


def test_a_lag_of_the_inputs_is_told_from_a_delay_and_does_not_refuse(pair: list[LogSignals]) -> None:
    """Electrodes that charge slowly; the voltages of the log are those in front of them."""
    v = pair[0].v
    behind = np.column_stack([first_order_lag(np.ascontiguousarray(side), 1.0 / RATE, 0.05)[0] for side in v.T])
    slow = replace(pair[0], q=DoubleWell().simulate(behind, 1.0 / RATE))
    assert log_facts(slow, 0.01, squared=True, joint=True).lag == pytest.approx(0.05, rel=0.4)
    rows = [row for row in check_logs([slow], JOINT) if row.what.startswith("delay")]
    assert {(row.state, row.gate) for row in rows} == {("note", None)}
    assert all("better than any delay" in row.advice for row in rows)


@pytest.mark.parametrize(("kept", "found"), [(True, ["wrapped"]), (False, [])])
def test_an_angle_that_is_kept_within_a_turn_is_refused(kept: bool, found: list[str]) -> None:
    """A pendulum that goes round, and one that swings by nearly a turn."""
    t = np.arange(0.0, 30.0, 1e-3)
    q = np.pi * (t / 5.0 + np.sin(2.0 * t)) if kept else 0.97 * np.pi * np.sin(2.0 * t)
    v = np.abs(np.sin(0.7 * t))[:, None]
    log = LogSignals("train/a", t, (q + np.pi) % (2.0 * np.pi) - np.pi, v, 1e-3)
    one = Declared(squared=True, displacement="rad", inputs=("V",), mass=None, sample_interval=0.01)
    assert [row.gate for row in check_logs([log], one) if row.what == "jumps of the angle"] == found


def test_one_late_voltage_is_told_from_the_other(pair: list[LogSignals]) -> None:
    log = pair[0]
    v = np.stack([log.v[60:, 0], log.v[:-60, 1]], axis=1)
    rows = check_logs([replace(log, t=log.t[:-60], q=log.q[:-60], v=v)], JOINT)
    assert [row.what for row in rows if row.state == "wrong"] == ["delay of q after v1"]


def test_kilograms_for_grams_are_caught(pair: list[LogSignals]) -> None:
    assert _wrong(check_logs(pair, replace(JOINT, mass=41.0))) == {"scale"}
    assert not _wrong(check_logs(pair, replace(JOINT, mass=None)))


def test_milliseconds_read_as_seconds_are_caught(pair: list[LogSignals]) -> None:
    logs = [replace(log, t=1e3 * log.t) for log in pair]
    assert "time-base" in _wrong(check_logs(logs, replace(JOINT, sample_interval=10.0)))


@pytest.mark.parametrize(
    "other",
    [
        STIFFER,
        DoubleWell(left_well=10.0e-3),
        DoubleWell(damping=0.25),
    ],
    ids=["stiffer", "another left well", "more damping"],
)
def test_the_log_of_another_joint_is_caught(pair: list[LogSignals], other: DoubleWell) -> None:
    rows = check_logs([pair[0], _log(other, "validation/other", 36, "validation")], JOINT)
    assert _wrong(rows) == {"device"}
    assert not _wrong(check_logs([_beginning(pair[0]), _beginning(_log(other, "validation/other", 36))], JOINT))


def test_other_membranes_look_like_other_probes_and_are_told_as_such(pair: list[LogSignals]) -> None:
    """A log cannot tell a stronger membrane from a probe that shows too little."""
    stronger = _log(DoubleWell(left_force=7.0e-9, right_force=9.8e-9), "validation/other", 36, "validation")
    rows = check_logs([pair[0], stronger], JOINT)
    assert not _wrong(rows)
    told = {row.what: row.advice for row in rows if row.state == "note" and row.log == "validation/other"}
    assert any(what.startswith("gain of") for what in told)
    assert "but for the gain of its inputs" in told["same device"]


@pytest.mark.parametrize(("shift", "state"), [(0.4e-3, "note"), (-2e-3, "wrong")])
def test_a_sensor_that_was_zeroed_anew_is_told_from_another_device(
    pair: list[LogSignals], shift: float, state: str
) -> None:
    rows = check_logs([pair[0], replace(pair[1], q=pair[1].q + shift)], JOINT)
    (row,) = (row for row in rows if row.what == "zero of q")
    assert (row.log, row.state, row.gate) == (pair[1].name, state, "device" if state == "wrong" else None)
    assert row.values["zero_m"] == pytest.approx(shift, abs=0.1e-3)
    assert ("take that off" if shift > 0.0 else "add that to") in row.advice
    told = {row.what: row for row in rows if row.log == pair[1].name}
    assert told["same device"].state != "wrong" and not [what for what in told if what.startswith("gain")]
    wider = check_logs([pair[0], replace(pair[1], q=1.2 * pair[1].q)], JOINT)
    assert not [row for row in wider if row.what == "zero of q"]
    assert [row.state for row in wider if row.what == "same device"] == ["wrong"]


def _probe(log: LogSignals, *, gain: float = 1.0, offset: float = 0.0) -> LogSignals:
    """What a probe shows that multiplies, and adds an error [V]."""
    return replace(log, v=log.v * gain + offset)


@pytest.mark.parametrize(
    ("gain", "offset", "samples"),
    [
        (1.0, 25.0, 0),
        (0.9, -60.0, -25),
        (1.0, 300.0, 15),
        *(pytest.param(*each, marks=pytest.mark.long) for each in ((1.0, -150.0, 0), (0.95, 60.0, 0), (1.05, 0.0, 40))),
    ],
)
def test_gain_offset_and_delay_of_a_log_are_told_apart(
    pair: list[LogSignals], gain: float, offset: float, samples: int
) -> None:
    """Each with its sign and size, whatever else is off, and without a word on what is not."""
    spoilt = _probe(pair[1], gain=gain, offset=offset)
    moved = _later(spoilt, samples) if samples > 0 else _earlier(spoilt, -samples) if samples else spoilt
    rows = {row.what: row for row in check_logs([pair[0], moved], JOINT) if row.log == moved.name}
    assert ("gain of voltages" in rows) == (gain != 1.0)
    if gain != 1.0:
        assert rows["gain of voltages"].values["gain"] * gain == pytest.approx(1.0, abs=0.03)
    for k in (1, 2):
        level = rows.get(f"rest level of v{k}")
        assert (level is not None) == (offset != 0.0)
        if level is not None:
            assert level.values["level_V"] - level.values["level_of_first_V"] == pytest.approx(offset, abs=1.0)
            assert f"rests at {offset:.0f}".replace("-", "−") in level.advice
    assert ("answer of q" in rows) == (samples != 0)
    if samples:
        assert rows["answer of q"].values["later_s"] == pytest.approx(1e-3 * samples, abs=4e-3)
    assert rows["same device"].state in ("ok", "note")


@pytest.mark.parametrize("bias", [pytest.param(150.0, marks=pytest.mark.long), 600.0])
def test_a_drive_that_was_biased_in_one_log_is_no_error_of_its_probe(pair: list[LogSignals], bias: float) -> None:
    t, _, v = motion(DURATION, RATE, 36, excitation="validation")
    v = np.maximum(v, bias)
    log = LogSignals("validation/b", t, DoubleWell().simulate(v, 1.0 / RATE), v, 1.0 / RATE)
    rows = [row for row in check_logs([pair[0], log], JOINT) if row.log == log.name]
    assert not [row for row in rows if row.what.startswith("gain")]
    assert all("if its drive was off" in row.advice for row in rows if row.what.startswith("rest level"))


def test_the_level_of_rest_is_that_of_the_drive_switched_off() -> None:
    pulses = np.repeat(np.random.default_rng(0).choice([0.0, 0.0, 3e3], 100), 50)
    ramps = np.abs(3e3 * np.sin(np.linspace(0.0, 60.0, 2_000)))
    noise = np.random.default_rng(1).normal(0.0, 7.0, pulses.size + ramps.size)
    for offset in (-150.0, -3.0, 0.0, 84.0):
        v = np.concatenate([pulses, ramps]) + noise + offset
        assert rest_level(v) == pytest.approx(offset, abs=1.0)
        assert rest_level(-v) == pytest.approx(-offset, abs=1.0)
    assert rest_level(np.linspace(-1.0, 1.0, 1_000)) is None
    assert rest_level(np.zeros(10)) == 0.0


def test_a_log_that_visits_one_well_only_is_no_other_device(pair: list[LogSignals]) -> None:
    t, q, v = motion(DURATION, RATE, 36, excitation="validation", gain=0.45, noise=2e-6)
    assert q.max() < 0.0, "too weak to switch"
    assert not _wrong(check_logs([pair[0], LogSignals("validation/weak", t, q, v, 1.0 / RATE)], JOINT))


def test_what_is_no_joint_is_not_judged_as_one(pair: list[LogSignals]) -> None:
    """One input that pushes to the left, late: its numbers are shown, and nothing is refused."""
    logs = [_later(replace(log, q=-log.q, v=np.ascontiguousarray(log.v[:, :1])), 60) for log in pair]
    for declared in (
        Declared(squared=True, displacement="m", inputs=("V",), mass=None, sample_interval=0.01),
        Declared(squared=False, displacement="rad", inputs=("%",), mass=None, sample_interval=0.01),
    ):
        assert not _wrong(check_logs(logs, declared))


def test_gaps_and_silence_are_no_findings(pair: list[LogSignals]) -> None:
    q = pair[0].q.copy()
    q[5000:5400] = np.nan
    holes = replace(pair[0], q=q)
    still = replace(pair[1], v=np.zeros_like(pair[1].v))
    assert not _wrong(check_logs([holes, pair[1]], JOINT))
    assert {row.state for row in check_logs([still], JOINT) if row.what.startswith("push")} == {"note"}


@pytest.mark.parametrize(("side", "share"), [(0, 0.35), (1, 0.0)])
def test_a_log_that_was_driven_otherwise_is_never_surely_of_another_joint(
    pair: list[LogSignals], side: int, share: float
) -> None:
    """What hidden states do differs with the drive: honest logs of one joint have had 5.7 times the misfit."""
    other = _log(STIFFER, "validation/b", 36, "validation")
    v = other.v.copy()
    v[:, side] *= share
    rows = check_logs([pair[0], replace(other, v=v)], JOINT)
    assert [row.state for row in rows if row.what == "same device"] in (["note"], ["ok"], ["not seen"])


def test_only_a_voltage_of_a_joint_that_has_one_sign_need_return_to_zero() -> None:
    t = np.arange(0.0, 20.0, 0.01)
    u = np.repeat(np.random.default_rng(0).choice([-3e3, 3e3], 50), 40)
    q = 0.01 * np.sin(3.0 * t)

    def rows(v: np.ndarray, declared: Declared = JOINT) -> list[CheckRow]:
        both = np.column_stack([v, np.maximum(u, 0.0)])[:, : len(declared.inputs)]
        return check_logs([LogSignals("train/a", t, q, both, 0.01)], declared)

    assert not _numbers(rows(u), "rest level of v1")
    assert _numbers(rows(u + 5e3), "rest level of v1") == ["2.00 kV"]
    for unit, displacement in (("%", "rad"), ("V", "rad"), ("%", "m")):  # a fan that was never off
        fan = Declared(squared=True, displacement=displacement, inputs=(unit,), mass=None, sample_interval=0.01)
        assert not _numbers(rows(u + 5e3, fan), "rest level of v1")
    steps = np.repeat(np.random.default_rng(1).uniform(0.5e3, 10e3, 50), 40)  # commanded so, and never at rest
    assert not _numbers(rows(steps), "rest level of v1")


def test_noise_that_an_encoders_steps_hide_is_told_so() -> None:
    t, step = np.arange(0.0, 20.0, 0.01), 2.0 * np.pi / 4096.0
    q = step * np.round(np.sin(3.0 * t) / step)
    log = LogSignals("train/a", t, q, np.sin(t)[:, None], 0.01, 4e-15, step)
    rotary = Declared(squared=False, displacement="rad", inputs=("V",), mass=None, sample_interval=0.01)
    (row,) = (row for row in check_logs([log], rotary) if row.what == "resolution of q")
    assert row.more == "noise below that"
