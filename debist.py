"""debist in a checkout: the public names of the package `pipeline`, which is called `debist` where it is installed."""

from pipeline import (
    DebistError,
    Model,
    Run,
    __version__,
    check,
    compare,
    differentiate,
    identify,
    main,
    open_run,
    read_log,
)

__all__ = [
    "DebistError",
    "Model",
    "Run",
    "__version__",
    "check",
    "compare",
    "differentiate",
    "identify",
    "main",
    "open_run",
    "read_log",
]

if __name__ == "__main__":  # python -m debist
    main()
