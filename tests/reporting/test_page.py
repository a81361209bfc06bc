"""The page as text: policy and hashes, escaping, determinism, size; and its parts."""

import base64
import hashlib
import html
import html.parser
import json
import re
import xml.etree.ElementTree as ET
import zlib
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest

from pipeline.diagnostics.facts.data_quality import data_checks
from pipeline.diagnostics.facts.datasheet import FORMAT, Datasheet, make_datasheet
from pipeline.diagnostics.facts.run_data import RunData
from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.canvas import page_chart
from pipeline.reporting.figure import Figure, Line, Panel, extreme_places, thinned, window, x_range
from pipeline.reporting.fleet_report import LISTED, fleet_report
from pipeline.reporting.fleet_table import failed, summary
from pipeline.reporting.page import LONGEST, MISSING, json_for_script, packed, viewer_data
from pipeline.reporting.run_report import figures_of, run_report
from pipeline.reporting.short_tables import headline_table
from pipeline.scoring.wells import NoWells
from pipeline.signals.log import voltages
from pipeline.units.quantity import axis_scale, quantity
from tests.reporting.synthetic import HOSTILE, figures_of_one_log, run_data, run_figures, run_sheet, without_models

MEGABYTE = 1_000_000


def report_of(data: RunData) -> tuple[str, Datasheet]:
    sheet = make_datasheet(data)
    return run_report(data, sheet, figures_of(data, sheet)), sheet


@cache
def report_page() -> str:
    return run_report(run_data(), run_sheet(), run_figures())


@cache
def fleet_page() -> str:
    document = json.loads(json.dumps(run_sheet().to_json(run_data())))
    members = [summary(f"P{i:02}", _varied(document, i), f"P{i:02}/report.html") for i in range(12)]
    members.append(failed(f"bad{HOSTILE}", f"no log {HOSTILE}"))
    return fleet_report(members, f"fleet{HOSTILE}")


@cache
def large_fleet_page() -> str:
    document = json.loads(json.dumps(run_sheet().to_json(run_data())))
    varied = [_varied(document, i) for i in range(12)]
    names = [f"P{i:04}" for i in range(LISTED + 100)]
    members = [summary(n, varied[i % 12], f"{n}/report.html") for i, n in enumerate(names) if i % 50]
    members += [failed(f"bad{i}{HOSTILE}", f"no log {i} {HOSTILE}") for i in range(3)]
    return fleet_report(iter(members), f"fleet{HOSTILE}")


def _varied(document: dict[str, Any], i: int) -> dict[str, Any]:
    factor = 1.0 + 0.03 * ((7 * i) % 12) + (3.0 if i == 5 else 0.0)
    facts = [f | {"value": None if f["value"] is None else factor * f["value"]} for f in document["facts"]]
    rows = [s | {"nrmse": None if s["nrmse"] is None else factor * s["nrmse"]} for s in document["scores"]]
    return document | {"facts": facts, "scores": rows, "name": f"P{i:02}"}


class _Elements(html.parser.HTMLParser):
    """Every start tag with its attributes, and the text inside scripts and styles."""

    def __init__(self) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.inline: dict[str, list[str]] = {"script": [], "style": []}
        self._inside = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))
        self._inside = tag if tag in self.inline and ("type", "application/json") not in attrs else ""

    def handle_endtag(self, tag: str) -> None:
        self._inside = ""

    def handle_data(self, data: str) -> None:
        if self._inside:
            self.inline[self._inside].append(data)


def _elements(page: str) -> _Elements:
    parser = _Elements()
    parser.feed(page)
    return parser


@pytest.mark.parametrize("page", [report_page, fleet_page, large_fleet_page])
def test_the_policy_allows_exactly_the_pages_own_script_and_style(page: Any) -> None:
    found = _elements(page())
    policy = next(a["content"] for t, a in found.tags if t == "meta" and a.get("http-equiv"))
    assert policy is not None
    assert policy.startswith("default-src 'none';")
    assert "unsafe" not in policy
    for kind in ("script", "style"):
        assert len(found.inline[kind]) == 1
        digest = base64.b64encode(hashlib.sha256(found.inline[kind][0].encode()).digest()).decode()
        assert f"{kind}-src 'sha256-{digest}'" in policy


@pytest.mark.parametrize("page", [report_page, fleet_page, large_fleet_page])
def test_nothing_is_inline_and_nothing_is_loaded(page: Any) -> None:
    for tag, attributes in _elements(page()).tags:
        assert tag not in ("link", "img", "iframe", "object", "embed", "base", "form")
        for name, value in attributes.items():
            assert not name.startswith("on"), (tag, name)
            assert name not in ("style", "src", "srcset", "xlink:href")
            if name == "href":
                assert str(value).startswith(("#", "./")), value


@pytest.mark.parametrize("page", [report_page, fleet_page, large_fleet_page])
def test_hostile_names_stay_text(page: Any) -> None:
    text = page()
    assert "<script>window.pwned" not in text
    assert "&lt;script&gt;window.pwned" in text
    assert text.count("</script>") == len(re.findall(r"<script[ >]", text))


def test_json_cannot_end_its_script_element_and_reads_back() -> None:
    document = {"a": [HOSTILE, "</script><!--", "\u2028", 1.5, None]}
    text = json_for_script(document)
    assert not set("<>&") & set(text)
    assert json.loads(text) == document
    with pytest.raises(ValueError, match="Out of range float"):
        json_for_script({"a": float("nan")})


def test_the_size_stays_in_the_budget() -> None:
    assert len(report_page().encode()) < 0.6 * MEGABYTE
    assert len(fleet_page().encode()) < 0.2 * MEGABYTE


def test_a_run_without_models_or_notes_still_has_a_page() -> None:
    page, sheet = report_of(without_models(run_data()))
    assert "Characteristic curves" not in page
    assert "Phase portrait" in page
    assert sheet.model is None
    assert sheet.headline == "rbf"


def test_the_datasheet_document_is_json_with_si_units() -> None:
    document = json.loads(json.dumps(run_sheet().to_json(run_data()), allow_nan=False))
    assert document["format"] == FORMAT
    units = {fact["key"]: fact["unit"] for fact in document["facts"]}
    assert units["well_left"] == "m"
    assert units["barrier_left"] == "J"
    assert document["verdict"]["model"] == "good"


def test_figures_are_well_formed_and_without_inline_style() -> None:
    for figure in figures_of_one_log().values():
        for drawing in page_chart(replace(figure, title=HOSTILE), run_data().model_names):
            text = str(drawing)
            assert "style=" not in text
            assert "nan" not in text
            root = ET.fromstring(text)  # noqa: S314 - our own text
            assert root.find("title") is not None
            # A stroke of their own would stay black in the dark theme.
            assert not [path for path in root.iterfind(".//defs/path[@id]") if "stroke" in path.attrib]
            assert all("stroke" in use.attrib for use in root.iterfind(".//use[@fill='#ffffff']"))


def test_thinning_keeps_every_peak() -> None:
    y = np.sin(np.linspace(0.0, 60.0, 50_000))
    y[12_345] = 7.0
    y[40_000:40_010] = np.nan
    thin = thinned(Line("", "measured", np.arange(y.size) * 1e-3, y), 500)
    assert thin.y.size == 1000
    assert np.nanmax(thin.y) == 7.0
    assert np.nanmin(thin.y) == np.nanmin(y)


def test_a_window_cuts_lines_marks_and_gaps() -> None:
    t = np.arange(100.0)
    panel = Panel("q", "m", (Line("", "measured", t, t),))
    figure = Figure("f", "", "", "t", "s", (panel,), marks={"a": t}, gaps=((10.0, 30.0), (90.0, 95.0)))
    cut = window(figure, 20.0, 40.0)
    assert cut.panels[0].lines[0].x[[0, -1]].tolist() == [20.0, 40.0]
    assert cut.marks["a"].size == 21
    assert x_range(window(figure, -5.0, 200.5), cut.panels[0]) == (20.0, 40.0)
    assert window(figure, -5.0, 200.5).panels[0].x_limits == (-5.0, 200.5)
    assert cut.gaps == ((20.0, 30.0),)


def unpacked(series: dict[str, Any]) -> FloatArray:
    """The samples back, as the viewer does it; within half a step of the original."""
    planes = np.frombuffer(zlib.decompress(base64.b64decode(series["data"])), dtype=np.uint8)
    n = series["n"]
    codes = np.cumsum(planes[:n].astype(np.int64) + 256 * planes[n:].astype(np.int64)) % 65536
    return np.where(codes == MISSING, np.nan, series["low"] + series["step"] * codes)


def test_packing_is_within_half_a_step_and_small() -> None:
    rng = np.random.default_rng(0)
    y = 0.012 * np.sign(np.sin(np.arange(37_500) / 3000.0)) + 1e-6 * rng.standard_normal(37_500)
    y[100:120] = np.nan
    series = packed(y)
    back = unpacked(series)
    np.testing.assert_array_equal(np.isnan(back), np.isnan(y))
    assert np.nanmax(np.abs(back - y)) <= 0.501 * series["step"]
    assert len(series["data"]) < 1.0 * y.size


def test_long_series_keep_their_extremes() -> None:
    y = np.random.default_rng(0).standard_normal(5 * LONGEST + 7)
    y[:40] = np.nan
    series = packed(y)
    back = unpacked(series)
    assert back.size <= LONGEST
    assert np.nanmax(back) == pytest.approx(np.nanmax(y), abs=series["step"])
    assert np.nanmin(back) == pytest.approx(np.nanmin(y), abs=series["step"])
    places = extreme_places(y, 11)
    assert np.all(np.diff(places) >= 0)
    np.testing.assert_allclose(back, y[places], rtol=0.0, atol=series["step"])


def test_residuals_are_stored_as_differences_and_hold() -> None:
    data = run_data()
    figure = run_figures()["validation-other-residuals"]
    stored = viewer_data([figure], data.model_names)
    for panel, drawn in zip(figure.panels, stored["figures"][figure.name]["panels"], strict=True):
        for line, series in zip(panel.lines, drawn["series"], strict=True):
            if line.parts is None:
                continue
            parts = [stored["packed"][series[key]] for key in ("data", "minus")]
            difference = unpacked(parts[0]) - unpacked(parts[1])
            np.testing.assert_allclose(difference, line.y, rtol=0.0, atol=sum(p["step"] for p in parts))


@pytest.mark.parametrize(
    ("value", "unit", "spread", "text"),
    [
        (-0.011388, "m", 0.00012, "−11.39 ± 0.12 mm"),
        (3.59e-4, "J", 2e-6, "359.0 ± 2.0 µJ"),
        (0.2, "rad", None, "11.5 °"),
        (float("nan"), "m", None, "–"),
        (1.2e-7, "kg", None, "1.20·10⁻⁷ kg"),
        (924311.0, "1/s²", 31965.0, "9.24·10⁵ ± 0.32·10⁵ 1/s²"),
        (21.0, "1/s²", 4510.0, "0 ± 4500 1/s²"),
    ],
)
def test_quantities_have_the_digits_of_their_spread(value: float, unit: str, spread: float | None, text: str) -> None:
    assert quantity(value, unit, spread) == text


@pytest.mark.parametrize(
    ("unit", "largest", "shown", "number"),
    [
        ("m", 0.012, "mm", 12.0),
        ("rad/s² / V²", 8e-5, "10⁻³ °/s² / V²", 4.584),
        ("rad²/s²", 1.0, "°²/s²", 3282.8),
        ("rad/(s²·(rad/s²))", 1.0, "rad/(s²·(rad/s²))", 1.0),
        ("N·m·s/rad", 1.0, "N·m·s/rad", 1.0),
        ("1", 3.2e8, "10⁶", 320.0),
        ("1/s", 250.0, "1/s", 250.0),
    ],
)
def test_an_axis_without_a_prefix_has_a_power_of_ten(unit: str, largest: float, shown: str, number: float) -> None:
    text, factor = axis_scale(unit, largest)
    assert text == shown
    assert factor * largest == pytest.approx(number, rel=1e-3)


def test_the_first_screen_names_the_worst_error_of_every_model() -> None:
    found = headline_table(run_data().scores)
    judged = [row for row in run_data().scores if row["role"] == "validation" and row["model"] == "rbf"]
    assert found.where.startswith("free runs on the validation log")
    assert found.heading[:2] == ("model", "q [%]")
    assert [row[0] for row in found.rows] == ["rbf", "sindy"]
    assert float(found.rows[0][1]) == pytest.approx(100.0 * judged[0]["nrmse"], abs=0.005)
    assert found.rows[1][1] == "diverged"


def test_no_motion_under_voltage_lies_over_the_basins() -> None:
    data = run_data()
    portrait = run_figures()["phase-portrait"]
    logs = (*data.role("validation"), *data.role("train"))
    driven = [np.any(np.abs(voltages(log.kinematics)) > 300.0, axis=1) for log in logs]
    for line, acts in zip(portrait.panels[0].lines, driven, strict=True):
        assert np.isnan(line.x[acts]).all()
        assert np.isfinite(line.x).sum() > 100


@pytest.mark.parametrize(("unseen", "grade"), [(0, "good"), (1, "poor")])
def test_one_excursion_to_the_end_of_the_range_is_no_thin_place(unseen: int, grade: str) -> None:
    data = run_data()
    log = data.logs[0]
    last = data.centres - 1.0  # places in spacings of the centres
    q = np.linspace(0.0, last - unseen - 0.6, len(log.kinematics["q"]))
    q[-1] = last
    seen = replace(data, logs=(replace(log, kinematics={**log.kinematics, "q": 1e-3 * q}),))
    coverage = next(check for check in data_checks(seen, NoWells("not looked for")) if check.name == "coverage")
    assert coverage.grade == grade
