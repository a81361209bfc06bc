"""debist in Python: identify a model from arrays or DataFrames, or open a run.

>>> import debist
>>> model = debist.identify(t, q, v1, v2, mass=0.0405, parameters="nominal")  # doctest: +SKIP
>>> model.score(t, q, v1, v2)  # doctest: +SKIP
>>> debist.open_run("runs/P1").plot("curves")  # doctest: +SKIP

The package is called `debist` where it is installed, and `pipeline` in a checkout, where ``debist.py`` stands for it.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .api.run import Model, Run, check, compare, differentiate, identify, open_run, read_log
    from .errors import DebistError

__version__ = "0.3.0"
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


def __getattr__(name: str) -> Any:
    """A public name, whose module is imported when it is first used."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    if name == "DebistError":
        from .errors import DebistError

        return DebistError
    from .api import run

    return getattr(run, name)


def __dir__() -> list[str]:
    """The public names."""
    return sorted(__all__)


def main() -> None:
    """Run the command `debist`."""
    from .commands.app import app

    app(prog_name="debist")
