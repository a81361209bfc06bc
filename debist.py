"""debist in Python: identify a model from arrays or DataFrames, or open a run.

>>> import debist
>>> model = debist.identify(t, q, v1, v2, mass=0.0405, parameters="nominal")  # doctest: +SKIP
>>> model.score(t, q, v1, v2)  # doctest: +SKIP
>>> debist.open_run("runs/P1").plot("curves")  # doctest: +SKIP
"""

from pipeline import __version__
from pipeline.api.run import Model, Run, check, compare, differentiate, identify, open_run, read_log
from pipeline.errors import DebistError

__all__ = [
    "DebistError",
    "Model",
    "Run",
    "__version__",
    "check",
    "compare",
    "differentiate",
    "identify",
    "open_run",
    "read_log",
]

if __name__ == "__main__":  # python -m debist
    from cli import app

    app(prog_name="debist")
