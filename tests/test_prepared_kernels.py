"""Kernels that come with the package: made from today's sources, equal to compiled ones, and never needed."""

import hashlib
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from pipeline import prepared_kernels

_RUN = """import hashlib, sys
from pathlib import Path
from pipeline import prepared_kernels
prepared_kernels.PREPARED = Path(sys.argv[1])
import numpy as np
from pipeline.numerics.lag import first_order_lag
found = first_order_lag(np.sin(np.arange(50.0)), 0.1, 0.7)
print(hashlib.sha256(np.concatenate(found)).hexdigest(), len(first_order_lag.part.overloads))
"""


def test_they_are_made_from_the_sources_that_are_there() -> None:
    assert prepared_kernels.outdated() == [], "run `make kernels`"


def test_settings_and_run_folders_are_no_sources() -> None:
    """Else an edited message would have every user compile kernels anew."""
    with zipfile.ZipFile(prepared_kernels.PREPARED) as archive:
        files = [line.split()[0] for line in archive.read(prepared_kernels.SOURCES).decode().splitlines()]
    assert "numerics/lag.py" in files
    assert not [file for file in files if file.startswith(("settings", "runs/", "models/", "stages/"))]


def _run(prepared: Path, folder: Path) -> tuple[str, str]:
    """What a kernel computes in a process with an empty cache, and how many versions it compiled."""
    folder.mkdir()
    environment = os.environ | {"NUMBA_CACHE_DIR": str(folder)}
    run = [sys.executable, "-c", _RUN, str(prepared)]
    done = subprocess.run(run, env=environment, capture_output=True, text=True, check=True)
    result, compiled = done.stdout.split()
    return result, compiled


def _written_with_these_versions() -> bool:
    from pipeline.compiled import is_prepared
    from pipeline.numerics.lag import first_order_lag

    return is_prepared(first_order_lag)


def test_a_prepared_kernel_computes_what_a_compiled_one_does(tmp_path: Path) -> None:
    if not _written_with_these_versions():
        pytest.skip("prepared with other versions of Python, numba or LLVM")
    prepared, taken = _run(prepared_kernels.PREPARED, tmp_path / "prepared")
    compiled, made = _run(tmp_path / "nothing.zip", tmp_path / "compiled")
    assert (taken, made) == ("0", "1")
    assert prepared == compiled


@pytest.mark.parametrize("damage", ["no archive", "an entry", "its end"])
def test_a_damaged_file_is_no_obstacle(tmp_path: Path, damage: str) -> None:
    file = tmp_path / "kernels.zip"
    shutil.copy(prepared_kernels.PREPARED, file)
    content = bytearray(file.read_bytes())
    if damage == "no archive":
        content = bytearray(b"not a zip")
    elif damage == "its end":
        del content[len(content) // 2 :]
    else:
        with zipfile.ZipFile(file) as archive:
            entries = [entry for entry in archive.infolist() if "first_order_lag" in entry.filename]
        for entry in entries:
            start = entry.header_offset + 30 + len(entry.filename)
            content[start : start + entry.compress_size] = hashlib.sha256(b"").digest() * (
                entry.compress_size // 32 + 1
            )
    file.write_bytes(content)
    assert _run(file, tmp_path / "cache")[1] == "1"
