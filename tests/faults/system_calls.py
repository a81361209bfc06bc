"""The system calls that touch files, and the kernel's way to hand them to another process before they are done.

Seccomp user notification, Linux 5.5 and later, by ``ctypes``; seccomp_unotify(2). No tracer is needed, nor any right.
"""

import ctypes
import errno
import fcntl
import os
import platform
import select
import struct
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Kind:
    """A kind of call: its number on x86-64, and which arguments say its files: a descriptor or (folder, path) pairs."""

    number: int
    descriptor: int | None = None
    paths: tuple[tuple[int | None, int], ...] = ()
    flags: int | None = None


CHANGING = {
    "write": Kind(1, 0),
    "pwrite64": Kind(18, 0),
    "writev": Kind(20, 0),
    "sendfile": Kind(40, 0),
    "fsync": Kind(74, 0),
    "fdatasync": Kind(75, 0),
    "ftruncate": Kind(77, 0),
    "fchmod": Kind(91, 0),
    "fallocate": Kind(285, 0),
    "pwritev": Kind(296, 0),
    "copy_file_range": Kind(326, 2),
    "truncate": Kind(76, paths=((None, 0),)),
    "rename": Kind(82, paths=((None, 0), (None, 1))),
    "mkdir": Kind(83, paths=((None, 0),)),
    "rmdir": Kind(84, paths=((None, 0),)),
    "creat": Kind(85, paths=((None, 0),)),
    "link": Kind(86, paths=((None, 0), (None, 1))),
    "unlink": Kind(87, paths=((None, 0),)),
    "symlink": Kind(88, paths=((None, 1),)),
    "chmod": Kind(90, paths=((None, 0),)),
    "mkdirat": Kind(258, paths=((0, 1),)),
    "unlinkat": Kind(263, paths=((0, 1),)),
    "renameat": Kind(264, paths=((0, 1), (2, 3))),
    "renameat2": Kind(316, paths=((0, 1), (2, 3))),
    "open": Kind(2, paths=((None, 0),), flags=1),
    "openat": Kind(257, paths=((0, 1),), flags=2),
}
"""Calls that change a file or a folder; `open` does where its flags create or empty a file."""

READING = {
    "open": Kind(2, paths=((None, 0),)),
    "openat": Kind(257, paths=((0, 1),)),
    "read": Kind(0, 0),
    "pread64": Kind(17, 0),
    "readv": Kind(19, 0),
    "getdents64": Kind(217, 0),
    "lseek": Kind(8, 0),
    "mmap": Kind(9, 4),
    "stat": Kind(4, paths=((None, 0),)),
    "fstat": Kind(5, 0),
    "lstat": Kind(6, paths=((None, 0),)),
    "newfstatat": Kind(262, paths=((0, 1),)),
    "statx": Kind(332, paths=((0, 1),)),
    "access": Kind(21, paths=((None, 0),)),
    "readlink": Kind(89, paths=((None, 0),)),
}
"""Calls that read a file, a folder, or what is known of them."""

NEEDS_SPACE = frozenset(CHANGING) - {
    *("fsync", "fdatasync", "ftruncate", "truncate", "fchmod", "chmod", "unlink", "unlinkat", "rmdir"),
    *("rename", "renameat", "renameat2"),
}
"""Calls that a full disk refuses."""

_AT_FDCWD = -100 & 0xFFFFFFFF
_PATH_MAX = 4096
_INSTALL, _NEW_LISTENER = 1, 1 << 3
_SECCOMP, _NO_NEW_PRIVS = 317, 38
_RECEIVE, _SEND = 0xC0502100, 0xC0182101
_NOTIFICATION, _ANSWER = struct.Struct("QIIiIQ6Q"), struct.Struct("QqiI")
_CONTINUE = 1
_libc = ctypes.CDLL(None, use_errno=True)


def supported() -> bool:
    """Whether this module knows the machine's calls."""
    return platform.system() == "Linux" and platform.machine() == "x86_64"


def hand_over(kinds: dict[str, Kind]) -> int:
    """From now on every call of these kinds by this process waits for an answer; the descriptor to give it by.

    Raises
    ------
    OSError
        The kernel does not offer it.
    """
    load, equal, give, notify, allow = 0x20, 0x15, 0x06, 0x7FC00000, 0x7FFF0000
    numbers = sorted({kind.number for kind in kinds.values()})
    program = [(load, 0, 0, 0)]
    program += [(equal, len(numbers) - i, 0, number) for i, number in enumerate(numbers)]
    program += [(give, 0, 0, allow), (give, 0, 0, notify)]
    code = b"".join(struct.pack("HBBI", *instruction) for instruction in program)
    held = ctypes.create_string_buffer(code, len(code))
    header = ctypes.create_string_buffer(struct.pack("HxxxxxxQ", len(program), ctypes.addressof(held)))
    if _libc.prctl(_NO_NEW_PRIVS, 1, 0, 0, 0) == 0:
        listener = int(_libc.syscall(_SECCOMP, _INSTALL, _NEW_LISTENER, header))
        if listener >= 0:
            return listener
    raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))


@dataclass(frozen=True)
class Waiting:
    """A call that waits for its answer."""

    identity: int
    pid: int
    number: int
    arguments: tuple[int, ...]

    def files(self, kind: Kind) -> list[str]:
        """The paths of the files that it touches."""
        if kind.descriptor is not None:
            return [self._held(self.arguments[kind.descriptor])]
        found = []
        for folder, path in kind.paths:
            text = self._text(self.arguments[path])
            if not text.startswith("/"):
                base = _AT_FDCWD if folder is None else self.arguments[folder] & 0xFFFFFFFF
                held = str(Path(f"/proc/{self.pid}/cwd").readlink()) if base == _AT_FDCWD else self._held(base)
                text = f"{held}/{text}" if text else held
            found.append(text)
        return found

    def written(self) -> bytes:
        """What a `write` or `pwrite64` is about to write."""
        with Path(f"/proc/{self.pid}/mem").open("rb", buffering=0) as memory:
            memory.seek(self.arguments[1])
            return memory.read(self.arguments[2])

    def position(self) -> int:
        """Where in its file a `write` is going to write."""
        lines = Path(f"/proc/{self.pid}/fdinfo/{self.arguments[0] & 0xFFFFFFFF}").read_text().splitlines()
        return int(lines[0].split()[1])

    def _held(self, descriptor: int) -> str:
        try:
            return str(Path(f"/proc/{self.pid}/fd/{descriptor & 0xFFFFFFFF}").readlink())
        except OSError:  # no descriptor, as in an anonymous mapping
            return ""

    def _text(self, address: int) -> str:
        with Path(f"/proc/{self.pid}/mem").open("rb", buffering=0) as memory:
            memory.seek(address)
            return memory.read(_PATH_MAX).partition(b"\0")[0].decode("utf-8", "surrogateescape")


def attend(listener: int, pid: int, answer: Callable[[Waiting], int | None]) -> None:
    """Answer each call of process `pid` until its end: 0, it is done; an error number, it fails; None, it waits."""
    ending, waiter = os.pidfd_open(pid), select.poll()
    try:
        waiter.register(listener, select.POLLIN)
        waiter.register(ending, select.POLLIN)
        while True:
            ready = dict(waiter.poll())
            if ready.get(listener, 0) & select.POLLIN:
                _answer_one(listener, answer)
            elif ready:
                return
    finally:
        os.close(ending)


def _answer_one(listener: int, answer: Callable[[Waiting], int | None]) -> None:
    received = bytearray(_NOTIFICATION.size)
    try:
        fcntl.ioctl(listener, _RECEIVE, received)
        identity, pid, _, number, _, _, *arguments = _NOTIFICATION.unpack(received)
        error = answer(Waiting(identity, pid, number, tuple(arguments)))
        if error is not None:
            fcntl.ioctl(listener, _SEND, bytearray(_ANSWER.pack(identity, 0, -error, 0 if error else _CONTINUE)))
    except OSError as gone:
        if gone.errno not in (errno.ENOENT, errno.EINTR):  # its process was killed meanwhile
            raise
