"""Tables as trajectories and records: the voltages between the samples go where their samples go."""

from dataclasses import dataclass, replace
from types import SimpleNamespace

import numpy as np

from pipeline.settings.prototype import Prototype, parse_prototype
from pipeline.signals.log import EDGE, UNKNOWN, Log, log_of
from pipeline.store import layout
from pipeline.store.tables import Table
from pipeline.workflow.run_contents import load_motion

ROWS, REFINED = 60, 10


@dataclass
class Shelf:
    """A run folder of two tables."""

    kinematics: Table
    fine: Table
    unknown: tuple[tuple[float, float], ...] = ()

    def record(self, _: str) -> SimpleNamespace:
        return SimpleNamespace(notes={UNKNOWN: self.unknown})

    def read_table(self, name: str) -> Table:
        return {layout.kinematics("train", "log"): self.kinematics, layout.record("train", "log"): self.fine}[name]


def shelf(refined: int, *, start: float = 12.345, more: int = 3) -> Shelf:
    """A log whose voltages say when they were measured."""
    t = start + 0.01 * np.arange(ROWS)
    segment = np.where(np.arange(ROWS) < 4, -1, np.where(np.arange(ROWS) < 30, 0, 1))
    segment[25:30] = -1
    q = np.where(segment < 0, np.nan, np.sin(t))
    kinematics = {"t": t, "q": q, "qdot": q, "qddot": q, "v1": t, "v2": -t, "segment": segment}
    grid = start + 0.01 / refined * np.arange((ROWS - 1) * refined + more)
    return Shelf(kinematics, {"t": grid, "v1": grid, "v2": -grid})


def settings(**tables: object) -> Prototype:
    channels = {key: {"channel": key, "unit": unit} for key, unit in (("q", "m"), ("v1", "V"), ("v2", "V"))}
    return parse_prototype({"name": "d", "logs": {"train": ["log.csv"]}, "channels": channels, **tables}, "d.toml")


def motion_of(stored: Shelf, prototype: Prototype | None = None) -> Log:
    return load_motion(stored, prototype or settings(), "train", "log")  # type: ignore[arg-type]


def times(refined: int) -> np.ndarray:
    return 12.345 + 0.01 * np.arange(ROWS)[:, None] + 0.01 / refined * np.arange(refined)


def test_each_sample_keeps_the_voltages_until_the_next() -> None:
    log = motion_of(shelf(REFINED))
    assert log.drive.shape == (ROWS, REFINED, 2)
    np.testing.assert_allclose(log.drive[:-1, :, 0], times(REFINED)[:-1])
    np.testing.assert_allclose(log.drive[:, 0, 1], -log.t)
    np.testing.assert_array_equal(log.drive_of(fine=False), np.column_stack([log.t, -log.t]))


def test_parts_and_segments_carry_them_along() -> None:
    log = motion_of(shelf(REFINED))
    whole = log.to_fit()
    np.testing.assert_allclose(whole.drive[:, 0, 0], whole.t)
    part = whole.part(10, 20)
    np.testing.assert_allclose(part.drive[:, 0, 0], part.t)
    assert part.past is not None
    np.testing.assert_allclose(part.past[:, 0, 0], whole.t[:10])
    deeper = part.part(3, 8)
    assert deeper.past is not None
    np.testing.assert_allclose(deeper.past[:, 0, 0], whole.t[:13])
    assert [len(segment.t) for segment in log.segments()] == [21, 30]
    for segment in log.segments():
        np.testing.assert_allclose(segment.drive[:, 0, 0], segment.t)
        assert segment.v.shape[1:] == (2,)


def test_inputs_that_were_zero_before_the_log_begin_at_zero_for_every_model() -> None:
    log = motion_of(shelf(REFINED))
    begun = motion_of(shelf(REFINED), settings(plant={"inputs_before": "zero"}))
    first = int(np.argmax(log.valid))
    assert np.abs(begun.v[first]).max() == np.abs(begun.drive[first, 0]).max() == 0.0
    np.testing.assert_array_equal(begun.v[first + 1 :], log.v[first + 1 :])
    np.testing.assert_array_equal(begun.drive[first, 1:], log.drive[first, 1:])
    assert log.v[first, 0] != 0.0


def test_a_log_that_begins_in_motion_is_learned_from_where_its_velocity_is_known() -> None:
    t = 0.01 * np.arange(40 * EDGE)
    moving = {"t": t, "segment": np.zeros(t.size, dtype=np.int32), "v1": t}
    moving |= {"q": np.sin(9.0 * t), "qdot": 9.0 * np.cos(9.0 * t), "qddot": -81.0 * np.sin(9.0 * t)}
    resting = moving | {"q": np.where(t < 0.2, 0.0, moving["q"])}
    assert log_of(moving).begins_in_motion
    assert not log_of(resting).begins_in_motion
    assert not log_of(moving | {"velocity": moving["qdot"]}).begins_in_motion
    assert log_of(resting).to_fit().past is None
    whole = log_of(moving).to_fit()
    assert whole.t[0] == t[EDGE]
    assert whole.past is not None
    np.testing.assert_array_equal(whole.past[:, 0], t[:EDGE])


def test_a_log_without_its_inputs_for_a_while_is_trained_on_in_parts() -> None:
    whole = shelf(1)
    t = whole.kinematics["t"]
    cut = motion_of(replace(whole, unknown=((t[24], t[30]),)))
    assert np.flatnonzero(~cut.recorded).tolist() == [25, 26, 27, 28, 29]
    assert cut.part_rows() == [slice(4, 25), slice(30, ROWS)]
    short = motion_of(replace(whole, unknown=((t[5], t[7]), (t[8], t[30]))))
    assert short.part_rows() == [slice(30, ROWS)]
    nothing = motion_of(replace(whole, unknown=tuple((t[k], t[k + 2]) for k in range(0, ROWS - 2, 3))))
    assert nothing.part_rows() == [slice(4, ROWS)]
    assert motion_of(whole).recorded.all() and motion_of(whole).part_rows() == [slice(4, ROWS)]
