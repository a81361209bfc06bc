"""The process of a batch that has imported everything once and is copied (forked) for every prototype.

A copy takes 10 ms in place of the two seconds of an interpreter with its imports and compiled kernels, and is as
isolated: each prototype has a process of its own, made from one that never touches a prototype. No thread may exist
when a process is copied, because locks that it holds would stay locked; the libraries are told to start none, and where
one does nevertheless, the server refuses and prototypes get interpreters of their own.
"""

import gc
import importlib
import json
import os
import pkgutil
import select
import signal
import socket
import sys
import time
import traceback
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pipeline.batch.worker import end_with_parent
from pipeline.child_processes import exit_code
from pipeline.machine import settle_machine

PACKAGES = (
    "numerics", "solvers", "generated", "signals", "joint", "runs", "rig_logs", "scoring", "identification", "models",
    "device_facts", "loading", "checks", "stages",
)  # fmt: skip
"""Packages of `pipeline` that a run uses."""

LIBRARIES = (
    "pyarrow.parquet", "h5py", "scipy.signal", "scipy.optimize", "scipy.interpolate",
    "pipeline.commands.outcome", "pipeline.reporting.log_figures",
)  # fmt: skip
"""What they import within functions."""

_LONGEST_REQUEST = 1 << 16


@dataclass
class _Worker:
    """A copy at work, and where its end is to be told."""

    channel: socket.socket
    pid: int
    keeper: int
    deadline: float
    stopped: bool = False


def serve(channels: list[int], warm: bool) -> None:
    """Copy this process for each request on one of the channels, until the other ends are closed.

    A request is one message: a JSON document (``arguments`` of `debist`, ``title``, ``time_limit`` [s] or null) with
    the file for its standard error. The answer says how the copy ended: ``status``, ``processor_seconds``, ``memory``
    (as the system counts it) and ``stopped`` by the time limit; or ``refused``. Where it shall be `warm`, it first
    imports what runs need.
    """
    settle_machine()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the batch decides what an interruption means
    if warm:
        preload()
    readers = _readers() if warm else None
    sockets = {fd: socket.socket(fileno=fd) for fd in channels}
    workers: dict[int, _Worker] = {}
    gc.collect()
    gc.freeze()  # a collection in a copy would write to, and so duplicate, every page
    poll = select.poll()
    for fd in sockets:
        poll.register(fd, select.POLLIN)
    while sockets:
        for fd, _ in poll.poll(_patience(workers)):
            if fd in sockets:
                worker = _begin(sockets, fd, workers)
                if worker is None and fd not in sockets:
                    poll.unregister(fd)
                elif worker is not None:
                    watched = os.pidfd_open(worker.pid)
                    workers[watched] = worker
                    poll.register(watched, select.POLLIN)
            elif fd in workers:
                poll.unregister(fd)
                os.close(fd)
                _end(workers.pop(fd))
        for worker in workers.values():
            if time.monotonic() > worker.deadline and not worker.stopped:
                worker.stopped = True
                os.kill(worker.pid, signal.SIGKILL)
    if readers is not None:
        readers.close()


def _readers() -> Any:
    """The process that all copies have their readers of logs copied from."""
    from pipeline.rig_logs.guarded import start_readers

    return start_readers()


def preload() -> None:
    """Import what a run needs, and load the compiled kernels that lie in the cache."""
    for name in PACKAGES:
        package = importlib.import_module(f"pipeline.{name}")
        for module in pkgutil.iter_modules(package.__path__, f"pipeline.{name}."):
            importlib.import_module(module.name)
    for name in LIBRARIES:
        importlib.import_module(name)
    program: Any = importlib.import_module("cli").app
    program.make_commands()
    environment: Any = importlib.import_module("pipeline.runs.manifest")
    environment.recorded_versions(), environment.current_environment()
    for kernel in _kernels():
        with suppress(Exception):  # a cache that cannot be read costs time only, and is numba's own affair
            _load_cached(kernel)


def _kernels() -> Iterator[Any]:
    """The compiled functions of the modules that are imported."""
    from numba.core.registry import CPUDispatcher

    modules = [module for name, module in sys.modules.items() if name.startswith("pipeline.")]
    found = {id(item): item for module in modules for item in vars(module).values() if isinstance(item, CPUDispatcher)}
    yield from found.values()


def _load_cached(kernel: Any) -> None:
    """Load the versions of a kernel that the cache holds for this processor; it compiles nothing."""
    cache = kernel._cache
    held = cache._cache_file._load_index()
    for signature in {key[0] for key in held}:
        if cache._index_key(signature, kernel.targetctx.codegen()) in held:
            kernel.compile(signature)


def _patience(workers: dict[int, _Worker]) -> float | None:
    """Time [ms] to the next deadline."""
    nearest = min((worker.deadline for worker in workers.values() if not worker.stopped), default=float("inf"))
    return None if nearest == float("inf") else max(0.0, 1e3 * (nearest - time.monotonic()) + 1.0)


def _begin(sockets: dict[int, socket.socket], fd: int, workers: dict[int, _Worker]) -> _Worker | None:
    """Take a request and copy this process for it; a closed channel is forgotten, and the worker behind it killed."""
    channel = sockets[fd]
    message, files, _, _ = socket.recv_fds(channel, _LONGEST_REQUEST, 1)
    if not message:
        for worker in workers.values():
            if worker.channel is channel:
                os.kill(worker.pid, signal.SIGKILL)
        sockets.pop(fd).close()
        return None
    if sum(1 for _ in Path("/proc/self/task").iterdir()) > 1:
        os.close(files[0])
        _answer(channel, {"refused": True})
        return None
    request = json.loads(message)
    reader, keeper = os.pipe()
    pid = os.fork()
    if pid == 0:
        foreign = [*sockets, *workers, *(worker.keeper for worker in workers.values()), keeper]
        _work(request, reader, files[0], foreign)
    os.close(reader)
    os.close(files[0])
    limit = request["time_limit"]
    return _Worker(channel, pid, keeper, float("inf") if limit is None else time.monotonic() + limit)


def _work(request: dict[str, Any], standard_input: int, standard_error: int, foreign: list[int]) -> None:
    """In the copy: run `debist` with the arguments of the request, and end."""
    code = 1
    try:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        for descriptor, target in ((standard_input, 0), (nowhere, 1), (standard_error, 2)):
            os.dup2(descriptor, target)
            os.close(descriptor)
        for descriptor in foreign:
            os.close(descriptor)
        signal.signal(signal.SIGINT, signal.default_int_handler)
        with suppress(OSError):
            Path("/proc/self/comm").write_text(request["title"])  # what `top` and `ps` show
        end_with_parent()
        code = _run(request["arguments"])
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(code)


def _run(arguments: list[str]) -> int:
    import cli

    sys.argv = ["debist", *arguments]
    return exit_code(cli.app.work)


def _end(worker: _Worker) -> None:
    _, status, usage = os.wait4(worker.pid, 0)
    os.close(worker.keeper)
    answer = {
        "status": os.waitstatus_to_exitcode(status),
        "processor_seconds": usage.ru_utime + usage.ru_stime,
        "memory": usage.ru_maxrss,
        "stopped": worker.stopped,
    }
    _answer(worker.channel, answer)


def _answer(channel: socket.socket, document: dict[str, Any]) -> None:
    with suppress(OSError):  # the batch is gone, and nobody waits
        channel.send(json.dumps(document).encode())
