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

from pipeline.diagnostics.datasheet import Datasheet, make_datasheet
from pipeline.diagnostics.run_data import RunData
from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.figure import extreme_places
from pipeline.reporting.fleet_report import LISTED, Summary, fleet_report, summary
from pipeline.reporting.page import LONGEST, MISSING, json_for_script, packed
from pipeline.reporting.plotted import page_chart
from pipeline.reporting.run_report import figures_of, run_report
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
    members.append(Summary(f"bad{HOSTILE}", f"no log {HOSTILE}"))
    return fleet_report(members, f"fleet{HOSTILE}")


@cache
def large_fleet_page() -> str:
    document = json.loads(json.dumps(run_sheet().to_json(run_data())))
    varied = [_varied(document, i) for i in range(12)]
    names = [f"P{i:04}" for i in range(LISTED + 100)]
    members = [summary(n, varied[i % 12], f"{n}/report.html") for i, n in enumerate(names) if i % 50]
    members += [Summary(f"bad{i}{HOSTILE}", f"no log {i} {HOSTILE}") for i in range(3)]
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


def test_the_page_does_not_depend_on_the_number_of_processes() -> None:
    assert run_report(run_data(), run_sheet(), run_figures(), jobs=3) == report_page()


def test_a_run_without_models_or_notes_still_has_a_page() -> None:
    page, sheet = report_of(without_models(run_data()))
    assert "Characteristic curves" not in page
    assert "Phase portrait" not in page
    assert sheet.model is None
    assert sheet.main_model == "rbf"


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


@pytest.mark.parametrize(
    ("value", "unit", "spread", "text"),
    [
        (-0.011388, "m", 0.00012, "−11.39 ± 0.12 mm"),
        (3.59e-4, "J", 2e-6, "359.0 ± 2.0 µJ"),
        (0.2, "rad", None, "11.5 °"),
        (float("nan"), "m", None, "–"),
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
    ],
)
def test_an_axis_without_a_prefix_has_a_power_of_ten(unit: str, largest: float, shown: str, number: float) -> None:
    text, factor = axis_scale(unit, largest)
    assert text == shown
    assert factor * largest == pytest.approx(number, rel=1e-3)


def test_no_motion_under_voltage_lies_over_the_basins() -> None:
    data = run_data()
    portrait = run_figures()["phase-portrait"]
    logs = (*data.role("validation"), *data.role("train"))
    driven = [np.any(np.abs(log.motion.v) > 300.0, axis=1) for log in logs]
    for line, acts in zip(portrait.panels[0].lines, driven, strict=True):
        assert np.isnan(line.x[acts]).all()
        assert np.isfinite(line.x).sum() > 100
