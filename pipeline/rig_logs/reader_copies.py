"""The process that readers of raw logs are copies of: a clean interpreter that has imported what a reader needs.

A copy (a fork) takes some milliseconds in place of the 0.2 s of an interpreter with its imports, and is as isolated:
the process that is copied has the surroundings of a new interpreter and opens no log, and each copy has limits of its
own and ends after one log. No thread may exist when a process is copied, because locks that it holds would stay locked;
where a library starts one nevertheless, nothing is copied, and readers get interpreters of their own.
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
from typing import Any

from pipeline.child_processes import exit_code, flush, isolated

CAN_COPY = sys.platform == "linux" and hasattr(os, "pidfd_open")
"""Whether processes can be copied here and their end be awaited beside others."""

_NO_THREAD = {"JE_ARROW_MALLOC_CONF": "background_thread:false"}  # of an allocator that pyarrow brings along
_BADNESS = Path("/proc/self/oom_score_adj")
_LONGEST_REQUEST, _LONGEST_ANSWER, _MOST_FILES = 1 << 14, 64, 16
_OUT_OF_THE_WAY, _HIGHEST = 100, 4096


class ReaderCopies:
    """The process that is copied, and the channel to it, which copies of this process may use as well.

    Parameters
    ----------
    environment : mapping of str to str
        All that it knows of the environment.
    """

    def __init__(self, environment: Mapping[str, str]) -> None:
        self._channel, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        program = f"from pipeline.rig_logs.reader_copies import serve; serve({theirs.fileno()})"
        with theirs:
            self._process = subprocess.Popen(
                isolated(program, "-S"),
                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                env={**environment, **_NO_THREAD}, pass_fds=[theirs.fileno()],
            )  # fmt: skip
        self._made_by = os.getpid()
        atexit.register(self.close)

    def run(
        self, reader: str, module: str | None, content: bytes, files: Sequence[int], timeout: float
    ) -> "subprocess.CompletedProcess[bytes] | None":
        """Call a function, named ``module:function``, in a copy: `content` is standard input, `files` are 3, 4, ….

        `module` is imported before the process is copied, so that the next copy has it too. None where no copy was
        made, or the process that is copied died.

        Raises
        ------
        subprocess.TimeoutExpired
            It did not end within `timeout` [s] and was killed.
        """
        with suppress(OSError), _scratch(b"") as out, _scratch(b"") as err, _scratch(content) as given:
            ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
            with ours:
                with theirs, _here() as here:
                    request = {"reader": reader, "module": module, "badness": _BADNESS.read_text()}
                    sent = [theirs.fileno(), here, given.fileno(), out.fileno(), err.fileno(), *files]
                    socket.send_fds(self._channel, [json.dumps(request).encode()], sent)
                ours.settimeout(timeout)
                try:
                    answer = ours.recv(_LONGEST_ANSWER)  # where `ours` is closed before it came, the copy is killed
                except TimeoutError:
                    raise subprocess.TimeoutExpired("reader", timeout) from None
            if answer:
                return subprocess.CompletedProcess([], int(answer), _content(out), _content(err))
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
            self._process.wait()
        self._channel.close()


@contextmanager
def _scratch(content: bytes) -> Iterator[Any]:
    """A file in memory with this content."""
    with os.fdopen(os.memfd_create("reader"), "w+b", buffering=0) as file:
        file.write(content)
        file.seek(0)
        yield file


@contextmanager
def _here() -> Iterator[int]:
    """The current folder, to which names of logs may be relative."""
    here = os.open(".", os.O_PATH | os.O_DIRECTORY)
    try:
        yield here
    finally:
        os.close(here)


def _content(file: Any) -> bytes:
    return os.pread(file.fileno(), os.fstat(file.fileno()).st_size, 0)


class _Server:
    """Copies this process for each request, tells how the copies ended, and kills those that nobody waits for."""

    def __init__(self, channel: socket.socket) -> None:
        self._interrupted = signal.signal(signal.SIGINT, signal.SIG_IGN)  # the program decides what it means
        self._channel, self._poll = channel, select.poll()
        self._ends: dict[int, tuple[int, int, socket.socket]] = {}  # by the copy's and by the channel's descriptor
        self._poll.register(channel, select.POLLIN)

    def run(self) -> None:
        """Until the other end of the channel is closed."""
        while True:
            # Requests come last, so that no new descriptor is taken for one that an event before was about.
            for descriptor, _ in sorted(self._poll.poll(), key=lambda event: event[0] == self._channel.fileno()):
                if descriptor == self._channel.fileno():
                    message, files, _, _ = socket.recv_fds(self._channel, _LONGEST_REQUEST, _MOST_FILES)
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
        with suppress(Exception):  # what cannot be imported is told by the copy
            importlib.import_module(request["module"] or "json")
        client = socket.socket(fileno=files[0])
        if sum(1 for _ in Path("/proc/self/task").iterdir()) == 1:
            pid = os.fork()
            if pid == 0:
                signal.signal(signal.SIGINT, self._interrupted)
                _work(request, files[1:])
            handle = os.pidfd_open(pid)
            self._ends[handle] = self._ends[client.fileno()] = handle, pid, client
            self._poll.register(handle, select.POLLIN)
            self._poll.register(client, select.POLLIN)
        else:
            client.close()
        for file in files[1:]:
            os.close(file)

    def _end(self, handle: int, pid: int, client: socket.socket) -> None:
        code = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
        del self._ends[handle], self._ends[client.fileno()]
        for watched in (handle, client.fileno()):
            with suppress(KeyError):
                self._poll.unregister(watched)
        os.close(handle)
        with client, suppress(OSError):
            client.send(str(code).encode())


def serve(descriptor: int) -> None:
    """Be the process that is copied, until the other end of the channel is closed."""
    importlib.import_module("pipeline.rig_logs.child")
    gc.collect()
    gc.freeze()
    with socket.socket(fileno=descriptor) as channel:
        server = _Server(channel)
        try:
            server.run()
        finally:
            server.kill()


def _work(request: dict[str, Any], files: list[int]) -> None:
    """In the copy: call the reader of the request, and end."""
    code = 1
    try:
        os.fchdir(files[0])
        above = [fcntl.fcntl(file, fcntl.F_DUPFD, _OUT_OF_THE_WAY) for file in files[1:]]
        for target, file in enumerate(above):
            os.dup2(file, target)
        os.closerange(len(above), _HIGHEST)
        with suppress(OSError):
            _BADNESS.write_text(request["badness"])
        module, _, function = request["reader"].partition(":")
        code = exit_code(getattr(importlib.import_module(module), function))
    except BaseException:
        traceback.print_exc()
    finally:
        flush()
        os._exit(code)
