"""Model files with one entry changed: loaded, used and exported, or refused in one line; never more than that."""

import io
import os
import resource
import traceback
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from hypothesis import strategies as st

from pipeline.device.parameters import NOMINAL
from pipeline.errors import DebistError
from pipeline.export import fmu, sources
from pipeline.export.templates import words
from pipeline.models.analytical.model import AnalyticalModel
from pipeline.models.base import HasCurves, predictor
from pipeline.models.model_type import model_from_tree
from pipeline.models.narx import NarxModel
from pipeline.store.hashing import flatten
from pipeline.store.trees import parse_tree
from tests.export import joints

SECONDS, MEMORY = 30, 1 << 30
"""What one changed file may take: processor time [s], and memory [bytes] beside what the process has."""
_NUMBERS = (0.0, -1.0, 1.0, 2.0, np.nan, np.inf, -np.inf, 1e308, -1e308, 5e-324, 1e-30, 1e12, 2.0**62, -(2.0**62))
_WHOLE = (0, -1, 1, 2, 7, 65, 2000002, 2**31, 2**62, -(2**62))


def narx() -> NarxModel:
    """A damped spring under two inputs."""
    return NarxModel(
        structure=np.array([3, 2, 1, 2]),
        exponents=np.array([[1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 0, 1, 0], [3, 0, 0, 0, 0]]),
        coefficients=np.array([-1e-4, -1e-4, 1e-5, 1e-5]),
        scales=np.array([0.01, 1e-3, 1e-3, 9e6, 9e6]),
        interval_s=0.01,
        inputs="squared",
        bounds=np.array([-0.1, 0.1]),
        diagnostics={"library_terms": 4, "inner_validation_nrmse_of_folds": np.array([0.1, 0.2])},
    )


MODELS: dict[str, Callable[[], Any]] = {
    "hybrid": joints.hybrid,
    "rbf": joints.data_driven,
    "turning arm": joints.turning_arm,
    "held": lambda: joints.held_slider(0.004),
    "rbf-paper": joints.paper,
    "sindy": joints.sindy,
    "narx": narx,
    "analytical": lambda: AnalyticalModel(parameters=NOMINAL),
}
EXPORTED = {"rbf", "turning arm", "held", "rbf-paper", "sindy"}


def leaves(tree: dict[str, Any]) -> dict[str, Any]:
    """The entries of a tree by path."""
    return dict(flatten(tree))


@st.composite
def changes(draw: st.DrawFn, entries: dict[str, Any]) -> dict[str, Any]:
    """The entries with one of them deleted, renamed, or of another kind, shape or value."""
    changed, path = dict(entries), draw(st.sampled_from(sorted(entries)))
    value = np.asarray(changed.pop(path))
    if value.dtype.kind in "US":
        texts = ("", "linear", "squared", "record", "rbf", "*/ x", "\n", "x" * 20_000, 3, np.zeros(3))
        new = draw(st.sampled_from((None, *texts)))
    else:
        new = draw(st.one_of(_kinds(value), _shapes(value), _values(value)))
    if new is None:
        if draw(st.booleans()):
            changed[path + "_"] = value
    else:
        changed[path] = new
    return changed


def _kinds(value: np.ndarray) -> st.SearchStrategy[Any]:
    others = (value.astype(kind) for kind in (complex, "S8", "f2", "i1", bool, "f8"))
    return st.sampled_from([None, "text", *others])


def _shapes(value: np.ndarray) -> st.SearchStrategy[Any]:
    flat = value.ravel()
    return st.sampled_from(
        [
            flat[:0],
            flat[:1],
            flat[0] if flat.size else 0.0,
            flat[:-1],
            value[None],
            value.T.copy(),
            np.repeat(flat, 2),
            np.repeat(np.atleast_1d(value), 2, axis=-1),
            np.resize(flat if flat.size else [0.0], 100_000),
        ]
    )


@st.composite
def _values(draw: st.DrawFn, value: np.ndarray) -> Any:
    new = value.copy()
    extreme = draw(st.sampled_from(_WHOLE if value.dtype.kind in "iu" else _NUMBERS))
    if not new.ndim:
        return type(value.item())(extreme) if value.dtype.kind != "b" else extreme
    if new.size:
        place = draw(st.integers(0, new.size - 1)) if draw(st.booleans()) else slice(None)
        new.ravel()[place] = extreme if draw(st.booleans()) else -new.ravel()[place]
    return new


def content(entries: dict[str, Any]) -> bytes:
    """The bytes of an HDF5 file with these entries."""
    stream = io.BytesIO()
    with h5py.File(stream, "w") as file:
        for path, value in entries.items():
            array = np.asarray(value)
            if array.dtype.kind == "U":
                file.create_dataset(path, data=array.astype(object), dtype=h5py.string_dtype())
            else:
                file[path] = array
    return stream.getvalue()


def use(name: str, data: bytes, *, exported: bool = False) -> None:
    """Load a model from the bytes of its file and do with it what commands do."""
    kind = joints_name(name)
    model = model_from_tree(kind, parse_tree(data, Path("model.h5")))
    t, v = joints.pulses(1.0, model.input_count)
    run = model.simulate(t, v, 0.001, 0.0)
    q, qdot = 1e-3 * np.sin(t), 1e-3 * np.cos(t)
    for predicted in predictor(model)(t, v, q, qdot, np.array([0, 19]), np.array([3, 5])):
        assert len(predicted) in (4, 6)
    assert run.q.shape == t.shape
    about = model.describe()
    assert all(words(str(each)).isascii() for each in about.values())
    if isinstance(model, HasCurves) and kind != "analytical":
        model.curves(np.linspace(-0.01, 0.01, 5))
    if exported and name in EXPORTED:
        what = joints.subject(model, 1.0, inputs=model.input_count)
        made = what.realisation()
        fmu.fmu_sources(what, made)
        fmu.description(what, made, fmu.guid(what))
        sources.function_source(what)
        sources.document(what)


def joints_name(name: str) -> str:
    """The model's own name."""
    return {"turning arm": "rbf", "held": "rbf"}.get(name, name)


def outcome(work: Callable[[], None]) -> str:
    """What becomes of some work in a fork of this process with limits: used, refused, or what went wrong."""
    reading, writing = os.pipe()
    pid = os.fork()
    if pid == 0:
        _limited(work, writing)
    os.close(writing)
    with os.fdopen(reading, "rb") as stream:
        told = stream.read().decode()
    code = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
    return told if code == 0 else f"signal {-code} {told}"


def _limited(work: Callable[[], None], writing: int) -> None:
    told = "used"
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[0])
        most = pages * resource.getpagesize() + MEMORY
        resource.setrlimit(resource.RLIMIT_AS, (most, most))
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
        with np.errstate(all="ignore"):
            work()
    except DebistError as error:
        text = str(error)
        told = "refused" if error.exit_code in (2, 4) and "\n" not in text and len(text) < 2500 else f"says {text}"
    except BaseException:
        told = traceback.format_exc()
    finally:
        os.write(writing, told.encode())
        os._exit(0)


def tally(
    name: str, *, exported: bool = False
) -> tuple[Callable[[dict[str, Any]], None], Counter[str], dict[str, Any]]:
    """A property of changed entries of one model, what it counts, and the entries to change."""
    entries, counts = leaves(MODELS[name]().to_tree()), Counter[str]()
    use(name, content(entries), exported=exported)  # what it imports and compiles is there before the forks

    def hold(changed: dict[str, Any]) -> None:
        """Used or refused."""
        found = outcome(lambda: use(name, content(changed), exported=exported))
        counts[found] += 1
        assert found in ("used", "refused"), found

    return hold, counts, entries
