"""What stands in for the reader of logs in tests: readers that die, hang, babble or lie."""

import os
import resource
import signal
import time
from pathlib import Path


def dies(send, request) -> None:
    os.kill(os.getpid(), signal.SIGSEGV)


def raises(send, request) -> None:
    raise RuntimeError("boom")


def babbles(send, request) -> None:
    send("no answer")
    send({"answer": "none"})


def never_ends(send, request) -> None:
    resource.setrlimit(resource.RLIMIT_CPU, (1, 2))
    while True:
        pass


def sleeps(send, request) -> None:
    time.sleep(60)


def promises_samples_that_are_not_there(send, request) -> None:
    channel = {"name": "q", "unit": "", "dtype": "", "time": None, "samples": [[0, 1000000]]}
    Path(request["samples"]).touch()
    send({"answer": {"format": "", "notes": [], "listed": [], "rates": {}, "channels": [channel]}})
