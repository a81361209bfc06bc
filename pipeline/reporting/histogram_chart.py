"""A distribution over a fleet too large for dots: bars of counts along the axis of the strip chart."""

import numpy as np
from markupsafe import Markup

from pipeline.reporting.strip_chart import BASE, LEFT, RADIUS, RIGHT, Strip, axis_of, labelled

BARS, TOP = 60, 10.0


def histogram(strip: Strip) -> Markup:
    """The distribution as an ``<svg>``; outliers have a colour of their own, the upright line is the median."""
    known = np.isfinite(strip.values)
    values, marked = strip.values[known], strip.outliers[known]
    x, ticks = axis_of(values, strip.unit)
    places = x(values)
    edges = np.linspace(LEFT + RADIUS, RIGHT - RADIUS, BARS + 1)
    counts = np.histogram(places, edges)[0]
    outliers = np.histogram(places[marked], edges)[0]
    height = (BASE - TOP) / max(1, int(counts.max()))
    parts = [*ticks]
    for i in np.flatnonzero(counts):
        text = f"{counts[i]} prototypes" + (f", {outliers[i]} outliers" if outliers[i] else "")
        left, width = edges[i], edges[1] - edges[0] - 0.6
        inner = counts[i] - outliers[i]
        bar = Markup('<path class="{}" d="M{:.1f} {:.1f}v{:.1f}h{:.1f}v{:.1f}z"><title>{}</title></path>')
        if inner:
            parts.append(bar.format("bar v1", left, BASE, -inner * height, width, inner * height, text))
        if outliers[i]:  # at least a pixel: one outlier among a hundred thousand shall be seen
            tall = max(1.5, outliers[i] * height)
            parts.append(bar.format("bar v2", left, BASE - inner * height, -tall, width, tall, text))
    middle = float(np.median(values))
    at = float(x(np.array(middle)))
    parts.append(Markup('<path class="line reference" d="M{0:.1f} 8V{1}"/>').format(at, BASE))
    return labelled(strip, middle, parts)
