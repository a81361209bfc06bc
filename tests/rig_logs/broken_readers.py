"""What stands in for the reader of logs in tests: readers that die, hang, babble or lie."""

import json
import os
import signal
import sys
import time
from pathlib import Path


def dies() -> None:
    os.kill(os.getpid(), signal.SIGSEGV)


def raises() -> None:
    raise RuntimeError("boom")


def babbles() -> None:
    print("no json")


def never_ends() -> None:
    import resource

    sys.stdin.readline()
    resource.setrlimit(resource.RLIMIT_CPU, (1, 2))
    while True:
        pass


def promises_samples_that_are_not_there() -> None:
    channel = {"name": "q", "unit": "", "dtype": "", "time": None, "samples": [[0, 1000000]]}
    print(json.dumps({"format": "", "notes": [], "listed": [], "channels": [channel]}))


def sleeps() -> None:
    """After it has written its number into the file that standard input names."""
    Path(sys.stdin.read()).write_text(str(os.getpid()))
    time.sleep(60)


def tells_of_itself() -> None:
    """What it finds, before it soils what a next one could find."""
    facts = {
        "parent": os.getppid(), "environment": sorted(os.environ), "here": str(Path.cwd()), "given": sys.stdin.read(),
        "open": sorted(int(entry.name) for entry in Path("/proc/self/fd").iterdir()),
        "touched": "touched" in sys.modules,
        "badness": Path("/proc/self/oom_score_adj").read_text(),
    }  # fmt: skip
    sys.modules["touched"] = sys
    os.environ["SOILED"] = str(Path.cwd())
    os.chdir("/")
    print(json.dumps(facts))
