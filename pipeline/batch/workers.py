"""The processes of a batch: copies of one that is warm where the system can do that, else interpreters of their own."""

import json
import os
import queue
import socket
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from pipeline.batch.worker import ONE_THREAD, Outcome, make_outcome, run_worker
from pipeline.child_processes import isolated

CAN_COPY = sys.platform == "linux" and hasattr(os, "pidfd_open")
"""Whether processes can be copied here and their end be awaited beside others."""

NO_THREAD = {"JE_ARROW_MALLOC_CONF": "background_thread:false"}
"""Keeps an allocator that pyarrow brings along from starting a thread when it is imported."""

_LONGEST_ANSWER = 1 << 12


class Workers:
    """Runs prototypes, each in a process of its own; as a context manager it ends its own process when it is left.

    Parameters
    ----------
    jobs : int
        Prototypes at a time.
    warm : bool
        Import beforehand what runs need: 2 s of processor time once, which the third prototype has repaid.
    """

    def __init__(self, jobs: int, warm: bool = True) -> None:
        self._jobs, self._warm = jobs, warm
        self._copied: _Copied | None = None
        self._starting = threading.Lock()

    def __enter__(self) -> "Workers":
        return self

    def __exit__(self, *_: object) -> None:
        if self._copied is not None:
            self._copied.close()

    def run(
        self, name: str, prototype: Path, output: Path, options: Sequence[str] = (), time_limit: float | None = None
    ) -> Outcome:
        """Run a prototype as ``debist run`` with these options and wait for its end; see `run_worker`."""
        if not CAN_COPY:
            return run_worker(name, prototype, output, options, time_limit=time_limit)
        channels, began = self._running(), time.perf_counter()
        channel = channels.get()
        try:
            with tempfile.TemporaryFile(prefix="debist-") as said:
                arguments = ["run", str(prototype), "-o", str(Path(output).absolute() / name), "--json", "--quiet"]
                request = {"arguments": [*arguments, *options], "title": name, "time_limit": time_limit}
                answer = _ask(channel, request, said.fileno())
                if answer is not None:
                    return make_outcome(name, prototype, began, answer, said, time_limit)
        finally:
            channels.put(channel)
        # The process that is copied is gone, and with it what it had made, or it has threads of its own.
        return run_worker(name, prototype, output, options, time_limit=time_limit)

    def _running(self) -> "queue.SimpleQueue[socket.socket]":
        """Free channels to the process that is copied; it is started with the first prototype, and anew if it died."""
        with self._starting:
            if self._copied is not None and self._copied.process.poll() is not None:
                self._copied.close()
                self._copied = None
            self._copied = self._copied or _Copied(self._jobs, self._warm)
            return self._copied.channels


class _Copied:
    """The process that is copied, and as many channels to it as there are jobs."""

    def __init__(self, jobs: int, warm: bool) -> None:
        pairs = [socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET) for _ in range(jobs)]
        theirs = [pair[1].fileno() for pair in pairs]
        self.process = subprocess.Popen(
            isolated(f"from pipeline.batch.fork_server import serve; serve({theirs!r}, {warm!r})"),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            pass_fds=theirs,
            env=os.environ | ONE_THREAD | NO_THREAD,
        )
        self.channels: queue.SimpleQueue[socket.socket] = queue.SimpleQueue()
        self._ends = [ours for ours, _ in pairs]
        for ours, their in pairs:
            their.close()
            self.channels.put(ours)

    def close(self) -> None:
        """End it, and with it whatever copy is left."""
        for end in self._ends:
            end.close()
        with suppress(subprocess.TimeoutExpired):
            self.process.wait(timeout=2.0)
        self.process.kill()
        self.process.wait()


def _ask(channel: socket.socket, request: dict[str, Any], standard_error: int) -> dict[str, Any] | None:
    """How the prototype's process ended; None if it was not made."""
    try:
        socket.send_fds(channel, [json.dumps(request).encode()], [standard_error])
        answer = channel.recv(_LONGEST_ANSWER)
    except OSError:
        return None
    document: dict[str, Any] = json.loads(answer) if answer else {"refused": True}
    return None if "refused" in document else document
