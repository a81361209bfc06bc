"""A limit of address space ends a command with one line, and never within OpenBLAS."""

import subprocess
import sys
from pathlib import Path

import pytest

resource = pytest.importorskip("resource")
pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux limits the address space")
ROOT = Path(__file__).resolve().parents[2]
FULL = """
import mmap
from pipeline.system.machine import load_linear_algebra
load_linear_algebra()
import numpy as np, scipy.linalg.blas
held = []
for size in (1 << 24, 1 << 20):
    try:
        while True:
            held.append(mmap.mmap(-1, size))
    except OSError:
        pass
square = np.eye(40)
print(np.trace(scipy.linalg.blas.dgemm(1.0, square, square @ square)))
"""


def limited(megabytes, *words):
    """The words after Python under a limit of address space; ended after a minute."""
    most = megabytes << 20
    return subprocess.run(
        [sys.executable, *words], cwd=ROOT, capture_output=True, text=True, timeout=60, check=False,
        env={"OPENBLAS_NUM_THREADS": "1"}, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (most, most)),
    )  # fmt: skip


def test_products_need_no_more_memory_once_it_is_taken():
    assert limited(600, "-c", FULL).stdout == "40.0\n"


@pytest.mark.parametrize(
    ("megabytes", "words"),
    [
        (120, ("physics", "equilibria")),
        (220, ("physics", "equilibria")),
        (488, ("batch", "examples", "-o", "{folder}/runs")),
        (700, ("batch", "examples", "-o", "{folder}/runs")),
    ],
)
def test_too_little_address_space_is_one_line(tmp_path, megabytes, words):
    ended = limited(megabytes, "cli.py", *(word.format(folder=tmp_path) for word in words))
    assert ended.returncode == 2, ended.stderr
    assert ended.stderr.startswith("debist: not enough memory") and ended.stderr.count("\n") == 1
