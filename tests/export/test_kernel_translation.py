"""The translator: what it understands means the same in C, and what it does not it refuses."""

import ctypes
import subprocess

import numpy as np
import pytest
from joints import COMPILER, STRICT

from pipeline.export.kernels.c_text import constants_text, function_text
from pipeline.export.kernels.kernel_reader import UntranslatableError
from pipeline.export.kernels.program import Array, Branch, expressions
from pipeline.export.kernels.translate import Translator

LIMIT = 3.0
TABLE = np.array([[1.0, -2.0], [0.5, 4.0]])


def swap(a, b):
    """Both values are read before either is written."""
    a, b = b, a + b
    return a - 2.0 * b


def branches(a, b):
    """A name that comes into being in both branches."""
    if a > b and not (b > -1e-9 and b < 1e-9):
        c = a / b
        c += 0.0 * c
    else:
        c = -(min(a, b, LIMIT) ** 2)
    for i in range(2):
        for j in range(2):
            if TABLE[i, j] < 0.0:
                break
            c -= TABLE[i, j] * (1.0 if 0.0 < a <= LIMIT else -a)
    return c


def end(sqrt, exp):
    """Parameters under names that C has already."""
    double = sqrt - (exp - 1.0) - (sqrt - exp) * 2.0 / (exp / 3.0)
    return np.exp(-double * double) + abs(exp)


def doubled(x):
    x[:] = 2.0


def empty(x):
    """What a known extent cuts off is not there."""
    if len(x) == 0:
        return 0.0
    return x[0]


@pytest.mark.skipif(COMPILER is None, reason="no C compiler here")
@pytest.mark.parametrize("kernel", [swap, branches, end], ids=lambda kernel: kernel.__name__)
def test_a_kernel_means_the_same_in_c(kernel, tmp_path):
    translator = Translator()
    made = translator.function(kernel, ("real", "real"), "kernel")
    helpers = "".join(
        f"static inline real {name}(real a, real b) {{ return b {sign} a ? b : a; }}\n"
        for name, sign in (("least", "<"), ("largest", ">"))
    )
    (tmp_path / "k.c").write_text(
        "#include <math.h>\ntypedef double real;\n#define R(x) x\n#define M(name) name\n"
        f"{helpers}static inline real square(real a) {{ return a * a; }}\n"
        f"{constants_text(translator.program)}\n{function_text(made)}\n"
        "double run(double a, double b);\ndouble run(double a, double b) { return kernel(a, b); }\n"
    )
    subprocess.run([COMPILER, *STRICT, "-O2", "-shared", "-fPIC", "k.c", "-o", "k.so", "-lm"], cwd=tmp_path, check=True)
    run = ctypes.CDLL(str(tmp_path / "k.so")).run
    run.restype, run.argtypes = ctypes.c_double, (ctypes.c_double, ctypes.c_double)
    for a in (-4.0, -0.3, 0.0, 1.7, 3.0, 5.5):
        for b in (-2.0, 0.4, 3.1):
            assert run(a, b) == pytest.approx(kernel(a, b), rel=1e-14, abs=1e-300), (a, b)


def test_changed_arrays_are_known_and_known_extents_decide():
    translator = Translator()
    assert [each.name for each in translator.function(doubled, (Array((2,)),)).changed] == ["x"]
    none, some = translator.function(empty, (Array((0,)),)), translator.function(empty, (Array((3,)),))
    assert (none.name, some.name) == ("empty", "empty_2")
    for made in (none, some):
        assert not [each for each in made.body if isinstance(each, Branch)]
        assert len(list(expressions(made.body))) < 5


def _comprehension(x):
    return sum([v for v in x])


def _while(x):
    while x[0] > 0.0:
        x[0] -= 1.0


def _power(x):
    return x[0] ** 0.5


def _view(x):
    part = x[1:]
    return part[0]


def _unknown(x):
    return np.linalg.norm(x)


@pytest.mark.parametrize("kernel", [_comprehension, _while, _power, _view, _unknown], ids=lambda k: k.__name__)
def test_what_is_beyond_the_subset_is_refused_by_name(kernel):
    with pytest.raises(UntranslatableError, match=rf"{kernel.__name__}: .* is beyond what the export translates"):
        Translator().function(kernel, (Array((3,)),))
