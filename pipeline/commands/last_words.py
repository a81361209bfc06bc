"""What is said where a library ends the process (`abort`), as C++ and Rust do if a small request for memory is refused.

No Python can run there: the interpreter may be anywhere, and memory is what is missing. So the handler of the signal is
eight instructions of x86-64 that ask Linux to write a line and to end the process; elsewhere a library ends as it does.
"""

import ctypes
import mmap
import platform
import signal
import struct
import sys
from contextlib import suppress

from pipeline.errors import InputError

LINE = (
    b"debist: a library gave up, as they do when memory runs out; what is written is whole, end other programs or "
    b"lower --jobs, and run again\n"
)
_WRITE, _EXIT_GROUP, _STANDARD_ERROR = 1, 231, 2
_TERMINATE = "_ZSt13set_terminatePFvvE"  # std::set_terminate, for the C++ exceptions that nobody catches
_kept: list[mmap.mmap] = []


def prepare_last_words() -> None:
    """From now on, an abort of this process and of its copies ends it with the line, and the exit code of bad input."""
    if _kept or sys.platform != "linux" or platform.machine() != "x86_64":
        return
    page = mmap.mmap(-1, mmap.PAGESIZE)
    start = ctypes.addressof(ctypes.c_char.from_buffer(page))
    line = start + mmap.PAGESIZE // 2
    page[line - start : line - start + len(LINE)] = LINE
    code = b"".join((
        b"\xbf" + struct.pack("<i", _STANDARD_ERROR),  # mov edi, 2
        b"\x48\xbe" + struct.pack("<q", line),  # mov rsi, line
        b"\xba" + struct.pack("<i", len(LINE)),  # mov edx, length
        b"\xb8" + struct.pack("<i", _WRITE) + b"\x0f\x05",  # mov eax, write; syscall
        b"\xbf" + struct.pack("<i", InputError.exit_code),  # mov edi, exit code
        b"\xb8" + struct.pack("<i", _EXIT_GROUP) + b"\x0f\x05",  # mov eax, exit_group; syscall
    ))  # fmt: skip
    page[: len(code)] = code
    system, handler = ctypes.CDLL(None), ctypes.c_void_p(start)
    if system.mprotect(handler, ctypes.c_size_t(mmap.PAGESIZE), mmap.PROT_READ | mmap.PROT_EXEC):
        return  # the system lets nobody make code
    _kept.append(page)
    system.signal(int(signal.SIGABRT), handler)
    with suppress(OSError, AttributeError):
        getattr(ctypes.CDLL("libstdc++.so.6"), _TERMINATE)(handler)
