"""What the processes of a batch inherit: the imports of a run, its compiled kernels, and a process for its readers."""

import importlib
import pkgutil
import sys
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

from pipeline.machine import settle_machine
from pipeline.process_copies import named

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


def warm_up(program: str) -> None:
    """Make this process ready to be copied for prototypes; one more process is ready to be copied for their readers.

    `program` is that of `pipeline.batch.worker.Workers`.
    """
    settle_machine()
    preload(program)
    from pipeline.rig_logs.guarded import start_readers

    start_readers()


def preload(program: str) -> None:
    """Import what a run by `program` needs, and load the compiled kernels that lie in the cache."""
    from pipeline.runs.environment import current_environment, recorded_versions

    for name in PACKAGES:
        package = importlib.import_module(f"pipeline.{name}")
        for module in pkgutil.iter_modules(package.__path__, f"pipeline.{name}."):
            importlib.import_module(module.name)
    for name in LIBRARIES:
        importlib.import_module(name)
    named(program).make_commands()
    recorded_versions(), current_environment()
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


def run_debist(program: str, title: str, arguments: list[str]) -> None:
    """Be the command ``debist``, which is `program`, with these arguments; `top` and `ps` show its title."""
    with suppress(OSError):
        Path("/proc/self/comm").write_text(title)
    sys.argv = ["debist", *arguments]
    named(program).work()
