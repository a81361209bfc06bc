"""A progress bar for calibrations on stderr, where that is a terminal."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager


@contextmanager
def progress_report() -> Iterator[Callable[[str, float], None] | None]:
    """Yield a callable that shows what is done and its share; None where stderr is no terminal."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("calibrating", total=1.0)
        yield lambda text, share: bar.update(task, description=text, completed=share)
