"""SINDy's regression in weak form: pysindy's feature library, integrated against test functions over each stretch.

Both sides of q̈ = Σ c_p θ_p(x) are multiplied by a test function φ = (1 − s²)⁴ of half width H and integrated;
integration by parts leaves −∫ φ' q̇ dt on the left, so no second derivative of the measurement enters (Messenger & Bortz
2021, doi:10.1137/20M1343166). Stretches differ in length, which pysindy's weak library does not take in one fit
(dynamicslab/pysindy issue 187): every stretch has a library of its own, so no test function straddles a gap. pysindy
draws the places of test functions from NumPy's global state (its issue 485), which is seeded here and put back.
"""

import importlib
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from pipeline.baselines.polynomial_dynamics import COSINE, FIRST_INPUT, FRICTION, SINE, Q
from pipeline.numerics.arrays import FloatArray, IntArray

HIGHEST, COUPLED = 7, 4
"""Highest power of q alone, and of q as a factor of velocities, inputs and lags."""


@contextmanager
def seeded() -> Iterator[None]:
    """Pysindy's random draws from one seed, and its warnings, which free runs judge, out of the user's sight."""
    state = np.random.get_state()  # noqa: NPY002
    np.random.seed(0)  # noqa: NPY002
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    finally:
        np.random.set_state(state)  # noqa: NPY002


def feature_library(variables: int, angle: bool) -> Any:
    """Pysindy's library of the powers of q, and of q (for an `angle` also sin q, cos q) times every other variable."""
    pysindy = importlib.import_module("pysindy")
    others = [k for k in range(variables) if k not in (Q, SINE, COSINE)]
    libraries = [pysindy.PolynomialLibrary(HIGHEST), pysindy.PolynomialLibrary(COUPLED), pysindy.IdentityLibrary()]
    inputs, tensors = [[Q], [Q], others], [[0, 1, 1]]
    if angle:
        libraries.append(pysindy.PolynomialLibrary(1))
        inputs, tensors = [*inputs, [SINE, COSINE]], [[0, 1, 1, 0], [0, 0, 1, 1]]
    return pysindy.GeneralizedLibrary(libraries, tensors, inputs, exclude_libraries=[1, 2])


def exponents_of(names: list[str], variables: int) -> IntArray:
    """Powers of the variables in features that pysindy calls ``x0^2 x5``, shape (P, variables)."""
    table = np.zeros((len(names), variables), dtype=np.int64)
    for row, name in zip(table, names, strict=True):
        for factor in name.split():
            if factor == "1":
                continue
            variable, _, power = factor[1:].partition("^")
            row[int(variable)] += int(power or 1)
    return table


def weak_rows(
    x: FloatArray, qdot: FloatArray, interval: float, half_width: float, count: int, angle: bool
) -> tuple[IntArray, FloatArray, FloatArray]:
    """Rows of the regression from one gap-free stretch.

    Parameters
    ----------
    x : FloatArray, shape (N, V)
        Scaled variables along it.
    qdot : FloatArray, shape (N,)
        Velocity [m/s].
    interval : float
        Its sample interval [s].
    half_width : float
        H [s], less than half of the stretch.
    count : int
        Test functions.
    angle : bool
        Whether sin q and cos q are candidates.

    Returns
    -------
    exponents : IntArray, shape (P, V)
        The candidate terms.
    rows : FloatArray, shape (count, P)
        ∫ φ θ_p dt.
    target : FloatArray, shape (count,)
        −∫ φ' q̇ dt. Cost: about 2 ms a test function, nearly all of it in setting up pysindy's library.
    """
    pysindy = importlib.import_module("pysindy")
    features, grid = feature_library(x.shape[1], angle), interval * np.arange(len(x))
    with seeded():
        terms = np.asarray(features.fit_transform(x))
        exponents = exponents_of(features.get_feature_names([f"x{k}" for k in range(x.shape[1])]), x.shape[1])
        first = np.sort(np.unique(exponents, axis=0, return_index=True)[1])  # the libraries share some terms
        weak = pysindy.WeakPDELibrary(
            pysindy.IdentityLibrary(), spatiotemporal_grid=grid, K=count, H_xt=half_width, p=4
        )
        rows = np.asarray(weak.fit_transform(terms[:, first]))
        target = np.asarray(weak.convert_u_dot_integral(qdot[:, None]))[:, 0]
    return exponents[first], rows, target


def admitted(
    exponents: IntArray, inputs: int, degrees: tuple[int, int, int], friction: bool, turning: bool, lags: set[int]
) -> IntArray:
    """Which terms belong to a library: their places in `exponents`.

    Parameters
    ----------
    exponents : IntArray, shape (P, V)
        All candidate terms.
    inputs : int
        Number of inputs.
    degrees : (int, int, int)
        Highest power of q alone, as a factor of velocities and lags, and as a factor of inputs.
    friction : bool
        Whether tanh(q̇/w) is one of them.
    turning : bool
        Whether 1, sin q and cos q stand in the place of the powers of q.
    lags : set of int
        Columns of the lag states that may enter.
    """
    alone, moving, driven = degrees
    chosen = []
    for place, row in enumerate(exponents):
        circle = int(row[SINE] + row[COSINE])
        if (row[Q] if turning else circle) or (not turning and row[FRICTION] and row[Q]):
            continue
        power = circle if turning else int(row[Q])
        others = [k for k in np.flatnonzero(row) if k not in (Q, SINE, COSINE)]
        limit = alone
        if others:
            (other,) = others
            last = FIRST_INPUT + inputs
            if (other == FRICTION and not friction) or (other >= last and other not in lags):
                continue
            limit = driven if FIRST_INPUT <= other < last else moving
        if power <= limit:
            chosen.append(place)
    return np.array(chosen, dtype=np.int64)
