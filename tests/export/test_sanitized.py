"""Exports of models whose numbers are absurd, but pass the schema, compile and do nothing undefined."""

import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pipeline.errors import DebistError
from pipeline.export.sources import c_sources
from pipeline.models.model_type import model_from_tree
from tests.export.joints import (
    COMPILER,
    STRICT,
    Subject,
    data_driven,
    held_slider,
    hybrid,
    paper,
    sindy,
    subject,
    turning_arm,
)

MODELS = {
    "hybrid": hybrid, "rbf": data_driven, "turning arm": turning_arm, "held": held_slider, "paper": paper,
    "sindy": sindy,
}  # fmt: skip
HARNESS = """
#include "{id}.h"
int main(void)
{{
    static const double volts[] = {{0.0, 1e3, -1e3, 1e300, 0.0}};
    {id}_state s;
    {id}_real v[{ID}_INPUTS] = {{0}}, y[3];
    for (int q = -1; q < 2; q++) {{
        {id}_start(&s, 0.01 * q, 1e3 * q, v);
        for (int i = 0; i < 100; i++) {{
            for (int k = 0; k < {ID}_INPUTS; k++) v[k] = volts[(i / 10 + k) % 5];
            {id}_step(&s, v);
            {id}_read(&s, y);
            (void){id}_check(&s);
        }}
    }}
    return 0;
}}
"""
SANITISED = ("-g", "-O1", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")


def absurd(tree: dict[str, Any], random: np.random.Generator) -> dict[str, Any]:
    """The tree with some of its numbers far from what they were."""

    def moved(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: moved(each) for key, each in value.items()}
        if isinstance(value, float) or (isinstance(value, np.ndarray) and value.dtype.kind == "f"):
            return value * 10.0 ** (random.integers(-6, 7) * (random.random() < 0.2))
        return value

    return {key: moved(value) if key not in ("prior_std", "diagnostics") else value for key, value in tree.items()}


def forged(name: str, seed: int) -> Subject | None:
    """Of many absurd ones, the first that the schema lets pass."""
    model, random = MODELS[name](), np.random.default_rng(seed)
    for _ in range(200):
        try:
            made = model_from_tree(model.name, absurd(model.to_tree(), random))
            what = subject(made, 1.0, inputs=made.input_count)
            what.realisation()
        except DebistError:
            continue
        return what
    return None


@pytest.mark.long
@pytest.mark.skipif(COMPILER is None, reason="no C compiler here")
@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", MODELS)
def test_an_absurd_model_does_nothing_undefined(name: str, seed: int, tmp_path: Path) -> None:
    what = forged(name, seed)
    assert what is not None
    for file, text in c_sources(what, what.realisation()).items():
        (tmp_path / file).write_text(text, encoding="utf-8")
    own = what.identifier
    (tmp_path / "main.c").write_text(HARNESS.format(id=own, ID=own.upper()), encoding="utf-8")
    build = [COMPILER, *STRICT, *SANITISED, "main.c", f"{own}.c", "-o", "run", "-lm"]
    subprocess.run(build, cwd=tmp_path, check=True)
    done = subprocess.run([tmp_path / "run"], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
