"""The guarded child: opens one raw log under resource limits and writes its samples as plain bytes.

Request and answer are one JSON document each on standard input and output; samples go as little-endian float64
into a temporary file that the parent opened. Nothing that was read is executed, pickled or trusted: the parent
checks every offset against the file's length.
"""

import json
import os
import resource
import sys
from pathlib import Path
from typing import Any

import numpy as np

from pipeline.rig_logs.formats import open_source
from pipeline.rig_logs.limits import Limits
from pipeline.rig_logs.recording import missing_channel
from pipeline.rig_logs.source import CsvOptions, Entry, Source, UnreadableLogError

_CHUNK = 1 << 19
_LONGEST_ERROR = 2000
ALIGNMENT = 64


class _RefusedError(Exception):
    """A complete message for the user."""


def main(request: dict[str, Any]) -> None:
    """Answer one request on standard output."""
    limits = Limits(**request["limits"])
    path = Path(request["path"])
    _limit(limits, path.stat().st_size)
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # whatever a library prints must not mix with the answer
    try:
        answer = _read(path, request, limits)
    except _RefusedError as error:
        answer = {"error": str(error)}
    except UnreadableLogError as error:
        answer = {"error": f"{path}: {error}"}
    except MemoryError:
        answer = {
            "error": f"{path}: reading it needs more than {limits.memory(path.stat().st_size) >> 20} MB of memory"
        }
    except (OSError, ValueError, KeyError, IndexError, TypeError, OverflowError, RuntimeError) as error:
        answer = {"error": f"{path}: damaged or not what it claims to be ({type(error).__name__}: {error})"}
    if "error" in answer:  # libraries write paragraphs; a failure is one line
        answer["error"] = " ".join(answer["error"].split())[:_LONGEST_ERROR]
    json.dump(answer, answers)
    answers.flush()


def _limit(limits: Limits, file_bytes: int) -> None:
    for kind, value in (
        (resource.RLIMIT_AS, limits.memory(file_bytes)),
        (resource.RLIMIT_CPU, limits.seconds(file_bytes)),
        (resource.RLIMIT_FSIZE, limits.data_bytes + _CHUNK * 8),
        (resource.RLIMIT_CORE, 0),
    ):
        hard = resource.getrlimit(kind)[1]
        bound = value if hard == resource.RLIM_INFINITY else min(value, hard)
        resource.setrlimit(kind, (bound, bound))


def _read(path: Path, request: dict[str, Any], limits: Limits) -> dict[str, Any]:
    source = open_source(path, CsvOptions(**request["csv"]), limits)
    entries = source.entries()
    wanted = _wanted(path, entries, request["channels"])
    by_name = {entry.name: entry for entry in entries}
    bases = {entry.time: by_name[entry.time] for _, entry in wanted if entry.time is not None}
    needed = {entry.name: entry for entry in (*bases.values(), *(entry for _, entry in wanted))}
    _check_size(path, sum(entry.count for entry in needed.values()) * 8, limits)
    places = _write(source, list(needed), int(request["data_fd"]))
    return {
        "format": source.format,
        "notes": source.notes,
        "listed": [entry.name for entry in entries],
        "channels": [
            {
                "name": name,
                "unit": entry.unit,
                "dtype": entry.dtype,
                "samples": places[entry.name],
                "time": None if entry.time is None else places[entry.time],
            }
            for name, entry in wanted
        ],
    }


def _wanted(path: Path, entries: list[Entry], names: list[str] | None) -> list[tuple[str, Entry]]:
    """The entries asked for, each under the name by which it was asked for."""
    if names is None:
        return [(entry.name, entry) for entry in entries]
    found = {alias: entry for entry in entries for alias in entry.aliases}
    found.update({entry.name: entry for entry in entries})
    for name in names:
        if name not in found:
            raise _RefusedError(missing_channel(path, name, tuple(entry.name for entry in entries)))
    return [(name, found[name]) for name in names]


def _check_size(path: Path, size: int, limits: Limits) -> None:
    largest = limits.largest(path.stat().st_size)
    if size > largest:
        raise _RefusedError(
            f"{path}: declares {size / 1e6:.0f} MB of samples in a file of {path.stat().st_size / 1e6:.3g} MB, "
            f"beyond the limit of {largest / 1e6:.0f} MB; refused unread"
        )


def _write(source: Source, names: list[str], fd: int) -> dict[str, tuple[int, int]]:
    """Write the samples of the entries; offset and count of each."""
    load_all = getattr(source, "load_all", None)
    together = load_all(names) if load_all else None
    places = {}
    with os.fdopen(fd, "wb", closefd=False) as file:
        position = 0
        for name in names:
            samples = source.load(name) if together is None else together.pop(name)
            places[name] = (position, len(samples))
            for i in range(0, len(samples), _CHUNK):
                file.write(np.ascontiguousarray(samples[i : i + _CHUNK], dtype="<f8").data)
            padding = (-len(samples) * 8) % ALIGNMENT
            file.write(b"\0" * padding)
            position += len(samples) * 8 + padding
    return places


if __name__ == "__main__":
    main(json.loads(sys.stdin.readline()))
