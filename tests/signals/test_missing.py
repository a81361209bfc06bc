"""What is missing of a voltage while the displacement is known: planted holes are counted, located and refused."""

import numpy as np
import pytest

from pipeline.errors import DataRefusedError
from pipeline.signals.columns import CHUNK, missing
from pipeline.signals.findings import missing_findings

STEP, N = 1e-3, 2 * CHUNK + 17
T = 100.0 + STEP * np.arange(N)
Q, V = np.sin(T), np.cos(T)


def test_a_whole_signal_lacks_nothing() -> None:
    found = missing((T, Q), {"v1": (T, V)})["v1"]
    assert (found.not_finite, found.before, found.after, found.share) == (0, 0.0, 0.0, 0.0)
    assert np.isnan(found.first)


@pytest.mark.parametrize(("share", "refused"), [(0.09, False), (0.11, True)])
@pytest.mark.parametrize("where", ["middle", "end"])
def test_samples_that_are_none(share: float, refused: bool, where: str) -> None:
    lost = round(share * N)
    begin = N - lost if where == "end" else N // 2
    v = V.copy()
    v[begin : begin + lost] = np.nan
    found = missing((T, Q), {"v1": (T, v)})["v1"]
    assert found.not_finite == lost
    assert found.first == T[begin]
    assert found.after == pytest.approx(lost * STEP if where == "end" else 0.0)
    assert found.share == pytest.approx(share, abs=1e-4)
    assert [one.gate for one in missing_findings({"v1": found})] == ["missing"] * refused


def test_a_time_base_of_its_own_that_begins_late_and_ends_early() -> None:
    stamps = T[(T > 110.0) & (T < 250.0)]
    found = missing((T, Q), {"v1": (stamps, np.zeros_like(stamps))})["v1"]
    assert found.before == pytest.approx(stamps[0] - T[0])
    assert found.after == pytest.approx(T[-1] - stamps[-1])
    assert found.not_finite == 0
    (refused,) = missing_findings({"v2": found})
    assert (refused.code, refused.subject) == ("signal_missing", "v2")
    assert refused.numbers["share"].value == found.share


def test_no_sample_at_all_is_refused() -> None:
    with pytest.raises(DataRefusedError, match="no sample is finite"):
        missing((T, Q), {"v1": (T, np.full(N, np.nan))})["v1"]
