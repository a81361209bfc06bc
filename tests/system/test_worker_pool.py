"""Calls in processes end as calls in this process do, and the death of a process is an error that names a way out."""

import os
import time
import warnings
from functools import partial

import pytest

from pipeline.errors import WARNING, DebistError, InputError
from pipeline.system.isolation import at_end
from pipeline.system.worker_pool import in_processes, meanwhile, pool, silent


def _square(number):
    time.sleep(0.02 * (3 - number % 3))  # later items end first
    return number * number


def _reports(on_progress):
    on_progress("half", 0.5)
    warnings.warn(f"{WARNING}look", stacklevel=1)
    warnings.warn("of a library", stacklevel=1)
    return os.getpid()


def _raises(error, on_progress):
    raise error


def _dies(on_progress):
    os._exit(3)


def _one(call, seen):
    with pool(2) as processes:
        processes.begin(7, call, lambda what, share: seen.append((what, share)))
        ((key, result),) = processes.finished()
        assert key == 7
        return result()


@pytest.mark.parametrize("jobs", [1, 3])
def test_results_are_in_the_order_of_the_items(jobs):
    assert list(in_processes(_square, range(8), jobs)) == [number * number for number in range(8)]
    assert list(in_processes(_square, [], jobs)) == []


def test_progress_result_and_warnings_for_the_user_come_back():
    seen: list = []
    with pytest.warns(UserWarning, match="look") as given:
        assert _one(_reports, seen) != os.getpid()
    assert seen == [("half", 0.5)] and len(given) == 1


def test_an_error_keeps_its_type_and_an_unknown_one_its_traceback():
    with pytest.raises(InputError, match="file x"):
        _one(partial(_raises, InputError("file x")), [])
    with pytest.raises(ZeroDivisionError) as raised:
        _one(partial(_raises, ZeroDivisionError("no")), [])
    assert "_raises" in raised.value.__notes__[0]


def test_a_process_that_dies_is_an_error_and_the_pool_goes_on_with_another():
    with pytest.raises(DebistError, match="--jobs 1"):
        _one(_dies, [])
    with pool(2) as processes:
        processes.begin(0, _dies, print)
        processes.finished()
        processes.begin(1, _reports, lambda what, share: None)
        assert [key for key, _ in processes.finished()] == [1]


def _slow(on_progress):
    time.sleep(60.0)


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_call_made_meanwhile_gives_its_result_and_its_error(jobs):
    seen: list = []
    with meanwhile(_reports, lambda what, share: seen.append((what, share)), jobs) as result, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert (result() == os.getpid()) is (jobs == 1)
    assert seen == [("half", 0.5)]
    failing = meanwhile(partial(_raises, InputError("file x")), silent, jobs)
    with failing as result, pytest.raises(InputError, match="file x"):
        result()


def test_a_call_whose_result_nobody_wants_is_ended():
    began = time.perf_counter()
    with meanwhile(_slow, silent, 2):
        pass
    assert time.perf_counter() - began < 30.0


def _leaves(path, on_progress):
    at_end(partial(path.write_text, "kept", encoding="utf-8"))


def test_a_process_does_at_its_end_what_it_was_asked_to(tmp_path):
    with pool(2) as processes:
        processes.begin(0, partial(_leaves, tmp_path / "end"), silent)
        processes.finished()
    with meanwhile(partial(_leaves, tmp_path / "other"), silent, 2) as result:
        result()
    assert [(tmp_path / name).read_text(encoding="utf-8") for name in ("end", "other")] == ["kept", "kept"]
