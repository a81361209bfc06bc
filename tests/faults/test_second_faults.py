"""A fault while another one is being mended: old or new, never half, and mended by the run after that."""

import random

import pytest

from tests.faults.intercepted import KILL, Answer
from tests.faults.power_loss import Disk
from tests.faults.test_crash import STARTS, check_set_aside, check_whole
from tests.faults.test_io_errors import TOLD, io_error, no_space

FAULTS = {"kill": lambda number: lambda call: KILL if call.number == number else 0, "EIO": io_error, "ENOSPC": no_space}


def power_failure(bench, number: int, rng: random.Random) -> None:
    """A run during which the power fails at that call, if it comes so far."""
    disk = Disk(bench.run)

    def watch(call) -> int:
        if call.number == number:
            return KILL
        disk.take(call)
        return 0

    if bench.intercepted(watch).code == KILL:
        disk.lay_out(disk.after_a_failure(rng))


def fault_at(bench, start: str, answer: Answer) -> None:
    """A run that meets these answers, and leaves what is whole."""
    ended = bench.intercepted(answer)
    assert ended.code in (*TOLD, KILL), ended.text
    check_whole(bench.run, damaged=start == "damaged") if bench.run.exists() else None


@pytest.mark.usefixtures("interception")
@pytest.mark.parametrize("start", STARTS)
@pytest.mark.parametrize("wanted", [2, pytest.param(50, marks=pytest.mark.long)])
def test_a_fault_while_a_fault_is_mended(bench, start, wanted, count):
    """Kill, I/O error or full disk; then one of these or a power failure, soon in the next run or later in it."""
    calls, rng = len(bench.calls(start)), random.Random(wanted)
    met = dict.fromkeys((*FAULTS, "power"), 0)
    for _ in range(wanted):
        bench.start(start)
        first, second = rng.choice(list(FAULTS)), rng.choice([*FAULTS, "power"])
        fault_at(bench, start, FAULTS[first](rng.randint(1, calls)))
        number = rng.randint(1, rng.choice([20, calls]))  # what is left over is swept and settled at the beginning
        if second == "power":
            power_failure(bench, number, rng)
            check_whole(bench.run, damaged=start == "damaged") if bench.run.exists() else None
        else:
            fault_at(bench, start, FAULTS[second](number))
        met[second] += 1
        bench.check_mended()
        check_set_aside(bench, start)
    count.append(f"{wanted} pairs; second was " + ", ".join(f"{name} {times}" for name, times in met.items()))
