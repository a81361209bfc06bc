"""What a laid-out figure consists of, whoever draws it: the page, an SVG file, a PDF or a PNG."""

from dataclasses import dataclass
from typing import Literal

from pipeline.numerics.arrays import FloatArray

Kind = Literal[
    "frame", "grid", "zero", "gap", "mark", "snap", "cell0", "cell1", "cell2", "band", "line", "wide", "trace", "dot",
    "ring", "cross",
]  # fmt: skip


@dataclass(frozen=True)
class Style:
    """What a shape is, and the colour class (`pipeline.reporting.palette.slot`) of whom it shows."""

    kind: Kind
    slot: str = ""
    dashed: bool = False


@dataclass(frozen=True)
class Stroke:
    """Lines through points, each of shape (n, 2)."""

    style: Style
    paths: tuple[FloatArray, ...]


@dataclass(frozen=True)
class Area:
    """A filled outline, shape (n, 2)."""

    style: Style
    outline: FloatArray


@dataclass(frozen=True)
class Box:
    """A rectangle; y counts downwards from the top."""

    style: Style
    x: float
    y: float
    width: float
    height: float


@dataclass(frozen=True)
class Disc:
    """A circle."""

    style: Style
    x: float
    y: float
    radius: float


@dataclass(frozen=True)
class Text:
    """Text at the end of a baseline, or at its middle; `turned` reads upwards."""

    text: str
    x: float
    y: float
    kind: Literal["tick", "label"] = "tick"
    anchor: Literal["start", "mid", "end"] = "start"
    turned: bool = False


Shape = Stroke | Area | Box | Disc | Text


@dataclass(frozen=True)
class Drawing:
    """A figure as shapes, in drawing units; later shapes lie over earlier ones.

    Attributes
    ----------
    title : str
    width, height : float
    text : float
        Height of the letters.
    shapes : tuple of Shape
    """

    title: str
    width: float
    height: float
    text: float
    shapes: tuple[Shape, ...]
