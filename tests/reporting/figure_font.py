"""Writes the font of the paper figures: ``python -m tests.reporting.figure_font``.

DejaVu Sans, cut down to the scripts and signs that the figures use. matplotlib embeds a subset of the font in every
PDF, and reading the layout tables of the whole DejaVu Sans for that costs three times as much as drawing the figure.
The asset lacks those tables; characters that it lacks come from the whole font.
"""

from pathlib import Path

import matplotlib as mpl
from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont

from pipeline import reporting
from pipeline.reporting.plotted import FONT, SANS

_BLOCKS = (
    (0x0020, 0x007E), (0x00A0, 0x017F), (0x0300, 0x03FF), (0x1E80, 0x1E9F), (0x2010, 0x203F), (0x2070, 0x209F),
    (0x2190, 0x219F), (0x2200, 0x226F),
)  # fmt: skip
_LAYOUT_TABLES = ("GDEF", "GPOS", "GSUB", "kern")
_FAMILY_RECORDS, _POSTSCRIPT_RECORD = (1, 4, 16), 6  # of the table "name" (OpenType 1.9)


def write_subset(path: Path) -> None:
    """Cut the font out of the DejaVu Sans that matplotlib brings (its licence lies beside the asset)."""
    options = Options(layout_features=[], hinting=False, name_IDs=["*"], notdef_outline=True, recalc_timestamp=False)
    options.drop_tables += _LAYOUT_TABLES
    with TTFont(Path(mpl.get_data_path()) / "fonts/ttf/DejaVuSans.ttf", recalcTimestamp=False) as font:
        subsetter = Subsetter(options)
        subsetter.populate(unicodes=[code for first, last in _BLOCKS for code in range(first, last + 1)])
        subsetter.subset(font)
        for record in font["name"].names:
            if record.nameID in _FAMILY_RECORDS:
                record.string = SANS[0]
            elif record.nameID == _POSTSCRIPT_RECORD:
                record.string = SANS[0].replace(" ", "")
        font.save(path)


if __name__ == "__main__":
    write_subset(Path(reporting.__path__[0]) / "assets" / FONT)
