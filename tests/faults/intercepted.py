"""A piece of work in a forked process whose calls to the file system are seen, made to fail, or answered with SIGKILL.

Faults at this level reach what C libraries do as well (HDF5, Arrow, zlib), at every single call.
"""

import array
import mmap
import os
import signal
import socket
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from pipeline.errors import DebistError
from tests.faults.system_calls import CHANGING, Kind, Waiting, attend, hand_over, supported

BUG = 1
KILL = -int(signal.SIGKILL)
_LONGEST = 1 << 16
_CREATES = os.O_CREAT | os.O_TRUNC


@dataclass(frozen=True)
class Call:
    """The `number`-th call that touches the folder, counted from 1; it waits while its answer is thought over."""

    number: int
    name: str
    path: str
    files: tuple[str, ...] = ()
    waiting: Waiting | None = None


Answer = Callable[[Call], int]
"""What happens to a call: 0, it is done; an error number, it fails; `KILL`, the process dies instead."""


@dataclass(frozen=True)
class Ended:
    """How the work ended: exit code (negative: the signal), what it said, and the calls that touched the folder."""

    code: int
    text: str
    calls: list[Call]


def available() -> bool:
    """Whether calls can be intercepted here."""
    return supported() and intercepted(lambda: None, Path("/"), lambda _: 0).code == 0


def intercepted(work: Callable[[], object], folder: Path, answer: Answer, kinds: dict[str, Kind] = CHANGING) -> Ended:
    """Do the work in a fork of this process; `answer` decides on each of its calls that touch something in `folder`."""
    said = mmap.mmap(-1, _LONGEST)  # shared memory: no call that could be made to fail
    ours, theirs = socket.socketpair()
    pid = os.fork()
    if pid == 0:
        _be_worker(work, theirs, said, kinds)
    with ours:
        theirs.close()
        _, ancillary, _, _ = ours.recvmsg(1, socket.CMSG_SPACE(4))
    calls: list[Call] = []
    if ancillary:
        listener = array.array("i", ancillary[0][2])[0]
        try:
            attend(listener, pid, _judge(pid, str(folder), answer, kinds, calls))
        finally:
            os.close(listener)
    code = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
    return Ended(code, said[:].rstrip(b"\0").decode("utf-8", "replace"), calls)


def _judge(
    pid: int, folder: str, answer: Answer, kinds: dict[str, Kind], calls: list[Call]
) -> Callable[[Waiting], int | None]:
    names = {kind.number: (name, kind) for name, kind in kinds.items()}

    def judge(waiting: Waiting) -> int | None:
        name, kind = names[waiting.number]
        if kind.flags is not None and not waiting.arguments[kind.flags] & _CREATES:
            return 0
        files = waiting.files(kind)
        within = [path for path in files if path == folder or path.startswith(f"{folder}/")]
        if not within:
            return 0
        calls.append(Call(len(calls) + 1, name, within[-1], tuple(files), waiting))
        verdict = answer(calls[-1])
        if verdict == KILL:
            os.kill(pid, signal.SIGKILL)  # while its call waits, which is never done
            return None
        return verdict

    return judge


def _be_worker(work: Callable[[], object], parent: socket.socket, said: mmap.mmap, kinds: dict[str, Kind]) -> None:
    code = BUG
    try:
        listener = hand_over(kinds)
        socket.send_fds(parent, [b"x"], [listener])
        os.close(listener)
        parent.close()
        work()
        code = 0
    except DebistError as error:
        code = error.exit_code
        _say(said, str(error))
    except BaseException:
        _say(said, traceback.format_exc())
    finally:
        os._exit(code)


def _say(said: mmap.mmap, text: str) -> None:
    content = text.encode()[-_LONGEST:]
    said[: len(content)] = content
