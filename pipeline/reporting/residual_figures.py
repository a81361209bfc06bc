"""The residual of the headline model's free run: correlations with their bands, and spectrum."""

import numpy as np

from pipeline.device_facts.residual_analysis import Residual, headline_residual
from pipeline.device_facts.run_data import LogData, RunData, judged_log, squared_inputs
from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.figure import Band, Figure, Line, Panel


def residual_figures(data: RunData) -> dict[str, Figure]:
    """Correlations and spectrum for the worst validation log (training log without any); none of a short record."""
    log, model = judged_log(data), data.model_names[0]
    found = headline_residual(data, log)
    if found is None:
        return {}
    return {
        "residual-correlation": _correlation(data, log, model, found),
        "residual-spectrum": _spectrum(data, log, model, found),
    }


def _correlation(data: RunData, log: LogData, model: str, found: Residual) -> Figure:
    squared = squared_inputs(data)

    def panel(title: str, values: FloatArray, half: float) -> Panel:
        width = np.full(found.lags.size, half)
        band = Band("99 % band without correlation", "reference", found.lags, -width, width)
        return Panel(title, "1", (Line(f"residual of {model}", model, found.lags, values),), (band,))

    panels = [panel("autocorrelation", found.correlation, found.band)]
    for k, (values, half) in enumerate(zip(found.with_inputs, found.input_bands, strict=True), start=1):
        panels.append(panel(f"correlation with v{k}{'²' if squared else ''}", values, float(half)))
    caption = (
        f"Residual of q of {model}, {log.title}, after the input by so much time; {100 * found.outside:.0f} % of the "
        "correlations with the inputs lie outside their bands, 1 % would by chance. The free run's residual rings with "
        "the device, so that its autocorrelation leaves the band; correlation with an input is what the model misses."
    )
    title = "Residual analysis: memory and inputs"
    return Figure("residual-correlation", title, caption, "lag", "s", tuple(panels), columns=len(panels))


def _spectrum(data: RunData, log: LogData, model: str, found: Residual) -> Figure:
    lines = (
        Line("measured q", "measured", found.frequency, found.measured_density),
        Line(f"residual of {model}", model, found.frequency, found.density),
    )
    caption = f"Power spectral densities by Welch's method, {log.title}: where they meet the model explains nothing."
    unit = f"{data.displacement}²/Hz"
    panel = Panel("power spectral density", unit, lines, log=True)
    title = "Residual analysis: spectrum"
    return Figure("residual-spectrum", title, caption, "frequency", "Hz", (panel,), x_log=True, half=True)
