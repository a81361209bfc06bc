"""What a user may choose by name, for commands and for what does the work; nothing is imported to know it."""

from typing import Literal

Target = Literal["c", "controller", "crate", "fmu", "json", "matlab"]
"""Form of an export."""
Typeface = Literal["sans", "serif"]
"""Of a figure."""
Well = Literal["left", "right"]
"""Where a joint rests."""
Goal = Literal["time", "energy", "voltage"]
"""What a pulse is to need least of."""
