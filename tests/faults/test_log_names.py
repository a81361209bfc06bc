"""Names of logs: as long as a file's may be, filed under a safe form of which no two are equal."""

import pytest

from pipeline.names import SAFE, check_log_name, check_name, log_name, slug

LONG = "2024-04-23_12-00-05_rig-B_joint-07_pulses_2800V_laser-range-50mm_run"


@pytest.mark.parametrize(
    "name", [f"{LONG}003", f"{LONG} Prüfling", "ü" * 200, "長" * 80, "a=b; 3$", "😀", "-1", "#7^2"]
)
def test_a_long_name_of_a_log_is_filed_under_a_safe_one(name):
    assert check_log_name(f"logs/{name}.csv") == name
    assert SAFE.fullmatch(log_name(f"{name}.csv"))
    assert log_name(f"{name}.csv") == log_name(f"other/{name}.mat")


def test_long_names_that_begin_alike_are_filed_apart():
    assert len({log_name(f"{LONG}{i:03d}.csv") for i in range(100)}) == 100
    assert log_name(f"{LONG}001.csv").startswith(LONG[:55])


def test_names_beyond_what_files_may_have_are_refused():
    with pytest.raises(ValueError, match="1 to 250 visible characters"):
        check_log_name("x" * 251)
    with pytest.raises(ValueError, match="1 to 64 visible characters"):
        check_name("x" * 65)


@pytest.mark.parametrize("stem", ["con", "nul.x", "log.", "a.b."])
def test_a_drafted_name_is_one_that_is_taken(stem):
    assert check_name(slug(stem)) == slug(stem)
