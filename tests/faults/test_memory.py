"""No more memory, once or from some moment on: said in a line, nothing is lost, and a rerun mends it."""

import errno
import random

import pytest

from tests.faults.intercepted import Answer, intercepted
from tests.faults.system_calls import ALLOCATING
from tests.faults.test_crash import check_whole


def once(number: int) -> Answer:
    return lambda call: errno.ENOMEM if call.number == number else 0


def for_a_while(number: int) -> Answer:
    """Ten requests in a row; who asks in another way gets nothing either."""
    return lambda call: errno.ENOMEM if number <= call.number < number + 10 else 0


def exhaust(bench, start: str, answer: Answer) -> str:
    """The run meets the answers; how it ended."""
    bench.start(start)
    ended = intercepted(bench.make, None, answer, ALLOCATING)
    is_memory = any(word in ended.text for word in ("MemoryError", "Cannot allocate memory", "malloc of size"))
    assert ended.code in (0, 2) or (ended.code == 1 and is_memory), (ended.code, ended.text)
    check_whole(bench.run) if bench.run.exists() else None
    bench.check_mended()
    return {0: "done nevertheless", 2: "told"}.get(ended.code, "told")


@pytest.mark.usefixtures("interception")
@pytest.mark.parametrize("wanted", [3, pytest.param(60, marks=pytest.mark.long)])
def test_memory_ends_at_some_requests(bench, wanted, count):
    """In every stage: the requests are drawn from all that a run makes."""
    bench.start("changed")
    calls = intercepted(bench.make, None, lambda _: 0, ALLOCATING).calls
    numbers = random.Random(wanted).sample(range(1, len(calls) + 1), min(wanted, len(calls)))
    ends = [exhaust(bench, "changed", kind(number)) for number in numbers for kind in (once, for_a_while)]
    count.append(f"{len(ends)} of {2 * len(calls)}, {ends.count('told')} told, {ends.count('done nevertheless')} done")
