"""What the system does not let be read is named by its path."""

import errno
from pathlib import Path

import pytest

from pipeline.errors import InputError
from pipeline.runs.confined import reading


@pytest.mark.parametrize(
    ("named", "told"),
    [("run/scores.parquet", "run/scores.parquet"), ("predictions", "run"), (7, "run"), (None, "run")],
    ids=["a file within", "a bare name", "a descriptor", "nothing"],
)
def test_the_place_is_told_whatever_the_system_named(named: str | int | None, told: str) -> None:
    with pytest.raises(InputError, match=f"^{told}: cannot be read: Input/output error"), reading(Path("run")):
        raise OSError(errno.EIO, "Input/output error", named)
