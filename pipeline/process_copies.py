"""A process that is copied (forked) for each piece of work, as readers of logs and prototypes of a batch are.

A copy takes some milliseconds in place of an interpreter with its imports (0.2 s for a reader, two seconds for a
prototype), and is as isolated: the process that is copied does no work itself, and each copy ends after one piece. No
thread may exist when a process is copied, because locks that it holds would stay locked; where a library starts one
nevertheless, nothing is copied, and the caller makes an interpreter of its own. What differs is what a copy inherits:
the surroundings of a new interpreter that has opened no log, or all that a run imports.
"""

import atexit
import fcntl
import gc
import importlib
import json
import os
import select
import signal
import socket
import subprocess
import sys
import traceback
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, NamedTuple

from pipeline.child_processes import end_with, exit_code, flush, isolated

CAN_COPY = sys.platform == "linux" and hasattr(os, "pidfd_open")
"""Whether processes can be copied here and their end be awaited beside others."""

BADNESS = Path("/proc/self/oom_score_adj")
"""How readily the kernel takes a process when memory runs out, thousandths of all memory; proc_pid_oom_score_adj(5)."""

_NO_THREAD = {"JE_ARROW_MALLOC_CONF": "background_thread:false"}  # of an allocator that pyarrow brings along
_LONGEST_MESSAGE, _MOST_FILES = 1 << 16, 16
_OUT_OF_THE_WAY = 100
_START, _GRACE = 120.0, 2.0
"""How long [s] to wait for a copy to begin, and for one that was killed to be gone."""


class End(NamedTuple):
    """How a process ended.

    Attributes
    ----------
    status : int
        Exit code; negative if a signal ended it.
    processor_seconds : float
        Processor time.
    memory : int
        Largest resident memory, as the system counts it.
    stopped : bool
        Whether it was killed after its time limit.
    """

    status: int
    processor_seconds: float = 0.0
    memory: int = 0
    stopped: bool = False


class Copies:
    """The process that is copied, and the channel to it, which copies of this process may use as well.

    Parameters
    ----------
    environment : mapping of str to str
        All that it knows of the environment.
    ready : str
        What it does before it is copied: a function, named ``module:function``, or a module, which is imported.
    options : str
        Further options of its interpreter, such as ``-S``.
    arguments : sequence of str
        What that function is called with.
    """

    def __init__(
        self, environment: Mapping[str, str], ready: str, *options: str, arguments: Sequence[str] = ()
    ) -> None:
        self._channel, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        program = f"from pipeline.process_copies import serve; serve({theirs.fileno()}, {ready!r}, *{[*arguments]!r})"
        with theirs:
            self._process = subprocess.Popen(
                isolated(program, *options),
                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                env={**environment, **_NO_THREAD}, pass_fds=[theirs.fileno()],
            )  # fmt: skip
        self._made_by = os.getpid()
        atexit.register(self.close)

    def run(
        self, work: str, *arguments: Any, files: Sequence[int], module: str | None = None, badness: str | None = None,
        time_limit: float | None = None,
    ) -> End | None:  # fmt: skip
        """Call a function, named ``module:function``, in a copy and wait for its end; threads may do so at once.

        Parameters
        ----------
        work : str
            The function.
        arguments : object
            Its arguments, which JSON can hold.
        files : sequence of int
            Descriptors that it finds as 0, 1, 2, …; all others are closed but those that `ready` has left open.
        module : str, optional
            Imported before the process is copied, so that the next copy has it too.
        badness : str, optional
            See `BADNESS`; that of this process by default.
        time_limit : float, optional
            Wall time [s] after which it is killed.

        Returns
        -------
        End or None
            None where no copy was made, or the process that is copied died.
        """
        with suppress(OSError):
            ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
            with ours:  # where it is closed before the end is told, the copy is killed
                with theirs, _here() as here:
                    request = {"work": work, "arguments": arguments, "module": module}
                    request["badness"] = badness or BADNESS.read_text()
                    socket.send_fds(self._channel, [json.dumps(request).encode()], [theirs.fileno(), here, *files])
                return _await_end(ours, time_limit)
        return None

    @property
    def ended(self) -> bool:
        """Whether the process that is copied is gone, as far as this process can know."""
        return self._made_by == os.getpid() and self._process.poll() is not None

    def close(self) -> None:
        """End the process that is copied, and with it the copies that are left."""
        if self._made_by == os.getpid():
            atexit.unregister(self.close)
            with suppress(OSError):
                self._channel.shutdown(socket.SHUT_RDWR)
            with suppress(subprocess.TimeoutExpired):
                self._process.wait(_GRACE)
            self._process.kill()
            self._process.wait()
        self._channel.close()


def _await_end(channel: socket.socket, time_limit: float | None) -> End | None:
    channel.settimeout(_START)
    if not channel.recv(1):
        return None
    channel.settimeout(time_limit)
    try:
        answer, stopped = channel.recv(_LONGEST_MESSAGE), False
    except TimeoutError:
        channel.shutdown(socket.SHUT_WR)
        channel.settimeout(_GRACE)
        answer, stopped = b"", True
        with suppress(TimeoutError):  # a process that waits for a disk cannot be killed
            answer = channel.recv(_LONGEST_MESSAGE)
    if answer:
        return End(**json.loads(answer), stopped=stopped)
    return End(-signal.SIGKILL, stopped=True) if stopped else None


@contextmanager
def _here() -> Iterator[int]:
    """The current folder, to which names of files may be relative."""
    here = os.open(".", os.O_PATH | os.O_DIRECTORY)
    try:
        yield here
    finally:
        os.close(here)


def named(name: str) -> Any:
    """The module of this name, or what follows a colon in it."""
    module, _, function = name.partition(":")
    found = importlib.import_module(module)
    return getattr(found, function) if function else found


def serve(descriptor: int, ready: str, *arguments: str) -> None:
    """Be the process that is copied, until the other end of the channel is closed."""
    interrupted = signal.signal(signal.SIGINT, signal.SIG_IGN)  # the program decides what it means
    made_ready = named(ready)
    if callable(made_ready):
        made_ready(*arguments)
    gc.collect()
    gc.freeze()  # a collection in a copy would write to, and so duplicate, every page
    with socket.socket(fileno=descriptor) as channel:
        server = _Server(channel, interrupted)
        try:
            server.run()
        finally:
            server.kill()


class _Server:
    """Copies this process for each request, tells how the copies ended, and kills those that nobody waits for."""

    def __init__(self, channel: socket.socket, interrupted: Any) -> None:
        self._channel, self._poll, self._interrupted = channel, select.poll(), interrupted
        self._ends: dict[int, tuple[int, int, socket.socket]] = {}  # by the copy's and by the channel's descriptor
        self._poll.register(channel, select.POLLIN)

    def run(self) -> None:
        """Until the other end of the channel is closed."""
        while True:
            # Requests come last, so that no new descriptor is taken for one that an event before was about.
            for descriptor, _ in sorted(self._poll.poll(), key=lambda event: event[0] == self._channel.fileno()):
                if descriptor == self._channel.fileno():
                    message, files, _, _ = socket.recv_fds(self._channel, _LONGEST_MESSAGE, _MOST_FILES)
                    if not message:
                        return
                    self._begin(json.loads(message), files)
                elif descriptor in self._ends:
                    handle, pid, client = self._ends[descriptor]
                    if descriptor == handle:
                        self._end(handle, pid, client)
                    else:
                        self._poll.unregister(client)
                        os.kill(pid, signal.SIGKILL)

    def kill(self) -> None:
        """End the copies that are left."""
        for _, pid, _ in self._ends.values():
            os.kill(pid, signal.SIGKILL)

    def _begin(self, request: dict[str, Any], files: list[int]) -> None:
        if request["module"]:
            with suppress(Exception):  # what cannot be imported is told by the copy
                importlib.import_module(request["module"])
        client = socket.socket(fileno=files[0])
        if sum(1 for _ in Path("/proc/self/task").iterdir()) == 1:
            parent, pid = os.getpid(), os.fork()
            if pid == 0:
                signal.signal(signal.SIGINT, self._interrupted)
                _work(request, files[1:], [self._channel.fileno(), files[0], *self._ends], parent)
            handle = os.pidfd_open(pid)
            self._ends[handle] = self._ends[client.fileno()] = handle, pid, client
            self._poll.register(handle, select.POLLIN)
            self._poll.register(client, select.POLLIN)
            with suppress(OSError):
                client.send(b"!")  # it has begun
        else:
            client.close()
        for file in files[1:]:
            os.close(file)

    def _end(self, handle: int, pid: int, client: socket.socket) -> None:
        _, status, usage = os.wait4(pid, 0)
        del self._ends[handle], self._ends[client.fileno()]
        for watched in (handle, client.fileno()):
            with suppress(KeyError):
                self._poll.unregister(watched)
        os.close(handle)
        end = {
            "status": os.waitstatus_to_exitcode(status),
            "processor_seconds": usage.ru_utime + usage.ru_stime,
            "memory": usage.ru_maxrss,
        }
        with client, suppress(OSError):  # who waited may be gone
            client.send(json.dumps(end).encode())


def _work(request: dict[str, Any], files: list[int], of_server: Sequence[int], parent: int) -> None:
    """In the copy: do the work of the request, and end."""
    code = 1
    try:
        os.fchdir(files[0])
        above = [fcntl.fcntl(file, fcntl.F_DUPFD, _OUT_OF_THE_WAY) for file in files[1:]]
        for descriptor in {*of_server, *files}:
            os.close(descriptor)
        for target, file in enumerate(above):
            os.dup2(file, target)
            os.close(file)
        end_with(parent)
        with suppress(OSError):
            BADNESS.write_text(request["badness"])
        code = exit_code(lambda: named(request["work"])(*request["arguments"]))
    except BaseException:
        traceback.print_exc()
    finally:
        flush()
        os._exit(code)
