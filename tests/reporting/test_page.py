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

from pipeline.device_facts.data_quality import data_checks
from pipeline.device_facts.datasheet import FORMAT, Datasheet, make_datasheet
from pipeline.device_facts.grades import THRESHOLDS, Threshold
from pipeline.device_facts.run_data import RunData, Study
from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.canvas import page_chart
from pipeline.reporting.datasheet_rows import described, sheet_rows, structure_summary
from pipeline.reporting.device_figures import _curves
from pipeline.reporting.figure import Figure, Line, Panel, extreme_places, thinned, window, x_range
from pipeline.reporting.fleet_report import LISTED, fleet_report, outliers
from pipeline.reporting.fleet_table import FleetColumn, distribution, failed, summary
from pipeline.reporting.log_figures import differentiation, fit_note, overlay
from pipeline.reporting.page import LONGEST, MISSING, json_for_script, packed, viewer_data
from pipeline.reporting.run_report import figures_of, run_report
from pipeline.reporting.short_tables import headline_table
from pipeline.scoring.wells import NoWells
from pipeline.si_prefix import axis_scale, grouped, interval, moment, percent, quantity, scale, short, significant
from pipeline.signals.trajectory import voltages
from pipeline.units import ALPHA_UNIT
from tests.reporting.synthetic import HOSTILE, figures_of_one_log, run_data, run_figures, run_sheet, without_models

MEGABYTE = 1_000_000


def report_of(data: RunData) -> tuple[str, Datasheet]:
    sheet = make_datasheet(data)
    return run_report(data, sheet, figures_of(data, sheet)), sheet


@cache
def report_page() -> str:
    return run_report(run_data(), run_sheet(), run_figures())


def figures_of_logs() -> dict[str, Figure]:
    """Those without which there is no page."""
    return {name: figure for name, figure in run_figures().items() if name.startswith(("train-", "validation-"))}


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


def _fleet_document() -> dict[str, Any]:
    document: dict[str, Any] = json.loads(json.dumps(run_sheet().to_json(run_data())))
    return document


def test_scores_of_training_are_marked_and_in_no_distribution() -> None:
    document = _fleet_document()
    trained = document | {"scores": [s | {"nrmse": 0.5} for s in document["scores"] if s["role"] == "train"]}
    members = [summary(f"P{i}", _varied(document, i), None) for i in range(7)] + [summary("T", trained, None)]
    page = fleet_report(members, "fleet")
    marked = re.findall(r"([\d.]+) \(training\)", page)
    assert len(marked) == 2 and marked[0] == "50.0"  # its error and its switches
    (drawn,) = re.findall(r'<figure id="NRMSE-of-q".*?</figure>', page, flags=re.DOTALL)
    assert ">50" not in drawn
    assert "▲" not in page.split("50.0 (training)")[0].rsplit("<td", 1)[1]
    alone = fleet_report([summary(name, trained, None) for name in "ab"], "fleet")
    assert "<figure" not in alone
    assert alone.count("50.0 (training)") == 2


def test_a_log_without_pulses_takes_no_share_of_switches_away() -> None:
    document = _fleet_document()
    of_q = [s for s in document["scores"] if s["model"] == document["judged_model"] and s["signal"] == "q"]
    one = next(s for s in of_q if s["role"] == "validation")
    more = one | {"log": "still", "switch_accuracy": None}
    known = [s | {"switch_accuracy": 0.75} if s["signal"] == "q" else s for s in document["scores"]]
    found = summary("P", document | {"scores": [*known, more]}, None)
    assert found.switches == 0.75
    undefined = summary("P", document | {"scores": [*known, more | {"nrmse": None}]}, None)
    assert np.isnan(undefined.error)


def test_a_large_fleet_shows_what_failed_is_odd_or_has_the_largest_errors() -> None:
    page = large_fleet_page()
    assert f"Shown are {LISTED} of {LISTED + 97}" in page
    rows = page.split('<table class="sortable stacked" id="fleet">')[1].split("</tbody>")[0]
    names = re.findall(r"/(P\d{4})/report", rows)
    assert rows.count("<tr>") - 1 == LISTED and rows.count(">failed<") == 6
    odd = {f"P{i:04}" for i in range(LISTED + 100) if i % 50 and i % 12 == 5}
    assert odd <= set(names), "every odd prototype is there"
    largest = {f"P{i:04}" for i in range(LISTED + 100) if i % 50 and (7 * i) % 12 >= 6}
    assert largest <= set(names)


def test_the_bars_of_a_distribution_count_every_prototype_and_mark_the_odd_ones() -> None:
    values = np.r_[np.linspace(1.0, 2.0, 20), 9.0]
    (panel,) = distribution(FleetColumn("rest left", "mm", values, values > 8.0)).panels
    (bars,) = panel.bands
    assert bars.high[::2].sum() == 21 and (bars.x[0], bars.x[-1]) == (1.0, 9.0)
    assert panel.points[0].x.tolist() == [9.0] and panel.lines[0].x[0] == np.median(values)
    assert distribution(FleetColumn("error", "%", np.geomspace(0.1, 10.0, 9), np.zeros(9, dtype=bool))).x_log


def test_a_device_of_another_kind_takes_no_value_from_the_others() -> None:
    """A unit that comes first in the alphabet is not that of the fleet."""
    document = _fleet_document()
    other = document | {
        "facts": [f | {"unit": "1", "value": 0.5} if f["key"].startswith("switch_v1") else f for f in document["facts"]]
    }
    joints = [summary(f"P{i}", _varied(document, i), None) for i in range(3)]
    heading = "switching v1, to right"
    assert heading in fleet_report(joints, "fleet")
    assert f"{heading} in kV" in fleet_report([summary("other", other, None), *joints], "fleet")


def test_the_fleet_says_why_a_verdict_is_not_good() -> None:
    document = _fleet_document()
    first, *others = document["verdict"]["checks"]
    worst = first | {"grade": "fair", "statement": "a tenth of the rows are masked"}
    document["verdict"] = {"data": "fair", "model": "good", "checks": [*others, worst]}
    page = fleet_report([summary("P1", document, None)], "fleet")
    assert worst["statement"] in html.unescape(page)
    assert "no log" in fleet_report([summary("P1", document, None), failed("P2", "no log")], "fleet")


def test_phi_which_is_computed_from_q_is_in_no_table_of_errors() -> None:
    scores = [row | {"signal": signal} for row in run_data().scores if row["signal"] == "q" for signal in ("q", "phi")]
    assert headline_table(scores).signals == ("q",)
    page = run_report(replace(run_data(), scores=tuple(scores)), run_sheet(), figures_of_logs())
    assert "φ [%]" not in page and "q [%]" in page


def test_the_fleet_says_why_verdicts_are_missing() -> None:
    document = json.loads(json.dumps(run_sheet().to_json(run_data())))
    bare = {**document, "facts": [], "verdict": {"data": "", "model": ""}}
    assert "--no-report" not in fleet_report([summary("P1", document, None)], "fleet")
    page = fleet_report([summary("P1", document, None), summary("P2", bare, None)], "fleet")
    assert "Without a report there are neither verdict nor facts (1 of 2)" in page


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


@pytest.mark.parametrize("unit", ["rad", *(pytest.param(unit, marks=pytest.mark.long) for unit in ("m", "V"))])
def test_one_input_an_angle_and_no_validation_log(unit: str) -> None:
    data = run_data()
    log = data.logs[0]

    def single(columns: Any) -> dict[str, Any]:
        return {name: column for name, column in columns.items() if name != "v2"}

    log = replace(log, record=single(log.record), kinematics=single(log.kinematics))
    alone = replace(
        data, displacement=unit, voltage="N", mass_known=False, logs=(log,), models={}, scores=data.scores[:2]
    )
    page, sheet = report_of(alone)
    assert {"rad": "q in °", "m": "q in mm", "V": "q in mV"}[unit] in page
    assert f" {ALPHA_UNIT[unit][0].replace('deg', '°')}·s³" in differentiation(alone, log)
    assert "no validation log" in page
    assert any(check.grade == "fair" and check.name == "validation" for check in sheet.checks)


def test_the_page_of_another_device_has_no_words_of_the_joint() -> None:
    """One input that is no voltage, one well in which the device swings freely, and a model that was no choice."""
    t = np.arange(0.0, 30.0, 0.01)
    push = np.where((t % 10.0 > 2.0) & (t % 10.0 < 4.0), 3.0, 0.0)
    swing = 1e-3 * (push + np.exp(-(t % 10.0)) * np.sin(9.0 * t))
    table = {"t": t, "q": swing, "v1": push, "segment": np.zeros(t.size, dtype=np.int32)}
    rates = {"qdot": np.gradient(swing, t), "qddot": np.gradient(np.gradient(swing, t), t)}
    free = {"rbf": {"t": t, "q": 0.99 * swing} | rates}
    ok = {"rbf": {"status": "ok", "diverged_at_s": None}}
    log = replace(
        run_data().logs[1], record=table, kinematics=table | rates, predictions=free, outcomes=ok,
        record_notes={}, source="logs/other.csv",
    )  # fmt: skip
    score = {"well_agreement": None, "switch_accuracy": None}
    reason = "hybrid is no candidate: the joint has a displacement and two squared voltages; this device has others"
    told = {"basis_functions": 8, "chosen because": reason}
    other = replace(
        run_data(), name="other", voltage="N", squared=False, mass_known=False, logs=(replace(log, role="train"), log),
        models={}, descriptions={"rbf": told}, choice={"chosen": "rbf", "reason": reason, "held_out_error": {}},
        scores=tuple(row | score for row in run_data().scores if row["model"] == "rbf"),
        provenance=run_data().provenance | {"prototype": {}, "prototype_file": "other.toml"},
    )  # fmt: skip
    page, _ = report_of(other)
    text = re.sub(r"<(script|style).*?</\1>", "", page, flags=re.DOTALL).lower()
    for word in ("well", "joint", "hybrid", "bistable", "voltage", "(left)", "ambiguous", "settling", "snap"):
        assert not re.search(rf"\b{re.escape(word)}", text), re.findall(rf".{{60}}{re.escape(word)}.{{60}}", text)
    assert "input steps" in text and "next event" in text
    quiet = replace(other, logs=tuple(replace(each, kinematics=each.kinematics | {"v1": t}) for each in other.logs))
    assert "next event" not in report_of(quiet)[0] and "from event to event" not in report_of(quiet)[0]


def test_curves_of_other_models_are_in_the_frame_or_named_below() -> None:
    sheet = run_sheet()
    own = sheet.curves["rbf"]
    near, far = replace(own, force=1.8 * own.force), replace(own, force=own.force + 1e3 * np.ptp(own.force))
    compared = replace(sheet, curves={"rbf": own, "sindy": near, "narx": far}, draws={})
    figure = _curves(replace(run_data(), voltage="N"), compared)
    drawn = {line.label: np.mean(np.isfinite(line.y)) for line in figure.panels[0].lines}
    assert drawn["sindy"] > 0.5
    assert drawn["narx"] == 0.0
    assert "Mostly outside the frame: restoring force F of narx." in figure.caption


def test_studies_are_drawn_where_they_are() -> None:
    alpha, names = np.logspace(-12, -2, 9), run_data().model_names[:2]
    columns = {"alpha": alpha, "misfit": np.sqrt(alpha), "roughness": 1.0 / alpha}
    study = Study("alpha", columns, {"alpha": "m·s^order", "misfit": "m", "roughness": "m/s²"})
    columns = {"model": np.repeat(np.array(names, dtype=object), 3), "fold": np.tile(np.arange(3), 2)}
    columns |= {key: np.linspace(0.01, 0.6, 6) for key in ("nrmse", "nrmse_qdot", "nrmse_qddot")}
    data = replace(run_data(), studies=(study, Study("folds", columns, dict.fromkeys(columns, "1"))))
    figures = figures_of(data, run_sheet())
    others = {"excitation", "energy", "curves", "phase-portrait"}  # which stand on `report_page`
    assert others <= figures.keys()
    page = run_report(data, run_sheet(), {name: figures[name] for name in figures if name not in others})
    assert "Hyperparameter studies" in page
    assert 'id="study-alpha"' in page and 'id="study-folds"' in page
    assert "α in mm·s³" in page
    marks = figures["study-alpha"].marks
    assert marks["chosen for the logs"] == pytest.approx([1e-6 * 1e-3])  # that of the logs, for q in mm
    assert "debist study alpha RUN" in page
    assert "Hyperparameter studies" not in report_page()


def test_the_datasheet_document_is_json_with_si_units() -> None:
    document = json.loads(json.dumps(run_sheet().to_json(run_data()), allow_nan=False))
    assert document["format"] == FORMAT
    units = {fact["key"]: fact["unit"] for fact in document["facts"]}
    assert units["well_left"] == "m"
    assert units["barrier_left"] == "J"
    assert document["verdict"]["model"] == "good"


def test_every_check_has_its_threshold_and_every_threshold_its_reason() -> None:
    sheet = run_sheet()
    named = {check.name for check in sheet.checks} - {"validation", "divergence"}
    assert named <= THRESHOLDS.keys()
    assert len(named) >= 8
    assert all(len(limit.reason) > 20 for limit in THRESHOLDS.values())


@pytest.mark.parametrize(("value", "grade"), [(0.01, "good"), (0.02, "fair"), (0.06, "poor")])
def test_a_threshold_grades(value: float, grade: str) -> None:
    assert Threshold(0.01, 0.05, "").grade(value) == grade
    assert Threshold(-0.01, -0.05, "", more_is_better=True).grade(-value) == grade


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


def test_thinned_samples_stay_at_their_places() -> None:
    x = np.arange(10_000) * 1e-3
    y = np.sin(x * 7.0)
    thin = thinned(Line("", "measured", x, y), 500)
    assert np.all(np.diff(thin.x) >= 0.0)
    np.testing.assert_allclose(thin.y, np.sin(thin.x * 7.0), atol=1e-12)


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


def test_a_constant_and_an_empty_series_survive() -> None:
    np.testing.assert_array_equal(unpacked(packed(np.full(5, 3.0))), 3.0)
    assert np.isnan(unpacked(packed(np.full(5, np.nan)))).all()


@pytest.mark.parametrize(
    ("value", "unit", "spread", "text"),
    [
        (0.01234, "m", None, "12.3 mm"),
        (-0.011388, "m", 0.00012, "−11.39 ± 0.12 mm"),
        (2040.0, "V", None, "2.04 kV"),
        (3.59e-4, "J", 2e-6, "359.0 ± 2.0 µJ"),
        (0.2, "rad", None, "11.5 °"),
        (None, "m", None, "–"),
        (float("nan"), "m", None, "–"),
        (0.0721, "1", None, "0.0721"),
        (12.5, "kg", None, "12.5 kg"),
        (1.2e-7, "kg", None, "1.20·10⁻⁷ kg"),
        (-0.012000239, "m", 1e-9, "−12.000 mm"),
        (4.5e-5, "1", 7e-3, "0.0000 ± 0.0070"),
        (924311.0, "1/s²", 31965.0, "9.24·10⁵ ± 0.32·10⁵ 1/s²"),
        (184031.0, "1/s²", 286.0, "1.8403·10⁵ ± 0.0029·10⁵ 1/s²"),
        (1396.0, "1/s", 235.0, "1400 ± 240 1/s"),
        (21.0, "1/s²", 4510.0, "0 ± 4500 1/s²"),
        (763039.0, "1/s", None, "7.63·10⁵ 1/s"),
        (17283.0, "1/s", None, "17280 1/s"),
        (1.2e-7, "kg", 1e-8, "1.20·10⁻⁷ ± 0.10·10⁻⁷ kg"),
    ],
)
def test_quantities_read_well(value: float | None, unit: str, spread: float | None, text: str) -> None:
    assert quantity(value, unit, spread) == text


def test_powers_of_ten_on_an_axis_are_raised() -> None:
    assert [significant(v, 1) for v in (1e-12, 1e-3, 10.0, 2e7)] == ["10⁻¹²", "0.001", "10", "2·10⁷"]


def test_a_small_value_shares_the_decimals_of_its_neighbours() -> None:
    assert quantity(-2e-8, "m", like=0.012) == "0.0 mm"


@pytest.mark.parametrize("power", range(-11, 9))
def test_a_prefix_leaves_one_to_three_digits_before_the_point(power: int) -> None:
    unit, factor = scale("V", 3.0 * 10.0**power)
    assert 0.5 <= 3.0 * 10.0**power * factor < 1000.0
    assert unit.endswith("V")


def test_outliers_are_marked_only_among_enough_values() -> None:
    values = np.array([1.0, 1.1, 0.9, 1.05, 0.95, 1.02, 5.0, np.nan])
    assert outliers(values).tolist() == [False] * 6 + [True, False]
    assert not outliers(values[2:]).any()


@pytest.mark.parametrize(
    ("fraction", "text"), [(0.0, "0.00 %"), (0.006, "0.60 %"), (0.857142, "85.7 %"), (1.0, "100 %"), (None, "–")]
)
def test_percentages_have_three_digits_at_most(fraction: float | None, text: str) -> None:
    assert percent(fraction) == text


@pytest.mark.parametrize(
    ("value", "low", "high", "like", "texts"),
    [
        (-0.011392, -0.011412, -0.011377, 0.0, ("−11.392 mm", "−11.412 … −11.377 mm")),
        (3.37e-4, 3.27e-4, 3.52e-4, 5.12e-4, ("0.337 mJ", "0.327 … 0.352 mJ")),
        (-3.59e-4, -3.83e-4, -3.2e-4, 0.012, ("−0.359 mm", "−0.383 … −0.320 mm")),
        (-0.012, -0.0120000001, -0.0119999999, 0.0, ("−12.000 mm", "−12.000 … −12.000 mm")),
        (-1e-9, -1.2e-7, 1e-7, 0.012, ("0.000 mm", "0.000 … 0.000 mm")),
        (0.2, 0.1, 0.3, 0.0, ("0.20", "0.10 … 0.30")),
    ],
)
def test_an_interval_shares_unit_and_digits(
    value: float, low: float, high: float, like: float, texts: tuple[str, str]
) -> None:
    unit = "1" if value == 0.2 else "J" if value > 0.0 else "m"
    assert interval(value, low, high, unit, like) == texts


@pytest.mark.parametrize(
    ("unit", "largest", "shown", "number"),
    [
        ("m", 0.012, "mm", 12.0),
        ("rad/s² / V²", 8e-5, "10⁻³ °/s² / V²", 4.584),
        ("rad/(s²·V)", 1.0, "°/(s²·V)", 57.30),
        ("rad²/s²", 1.0, "°²/s²", 3282.8),
        ("rad/(s²·(rad/s²))", 1.0, "rad/(s²·(rad/s²))", 1.0),
        ("N·m·s/rad", 1.0, "N·m·s/rad", 1.0),
        ("1", 3.2e8, "10⁶", 320.0),
        ("rad/s²", 4e3, "10³ °/s²", 229.2),
        ("1/s", 250.0, "1/s", 250.0),
        ("1/s", 0.0, "1/s", 0.0),
    ],
)
def test_an_axis_without_a_prefix_has_a_power_of_ten(unit: str, largest: float, shown: str, number: float) -> None:
    text, factor = axis_scale(unit, largest)
    assert text == shown
    assert factor * largest == pytest.approx(number, rel=1e-3)


def test_a_model_of_an_angle_is_described_in_degrees() -> None:
    told = {"mass_kg": 1.0, "training_rms_m": 0.1, "done": [True, False], "chosen": ["a, b", "c"]}
    rows = dict(described("m", told, "rad", mass_known=False).rows)
    assert rows == {"training rms": "5.73 °", "done": "yes; no", "chosen": "a, b; c"}


def test_only_fitted_values_have_a_deviation_and_the_drag_has_its_unit() -> None:
    told = {"drag_1_per_m": 0.0433, "end_stops_m": [5.672, 9.774], "slip_length_m": [0.1, 0.2]}
    told |= {"relaxation_rates_1_per_s": [6.0, 0.2], "deviations": {"part [m]": [0.1, 0.01]}}
    rows = dict(described("rbf", told, "rad").rows)
    assert rows["drag"] == "0.0433 1/rad"
    assert rows["end stops"] == "325 … 560 °"
    assert (rows["slip length"], rows["relaxation rates"]) == ("5.73, 11.5 °", "6.00, 0.200 1/s")
    assert rows["deviations: part"] == "5.73 ± 0.57 °"


def test_moments_and_lengths_have_the_digits_that_they_need() -> None:
    assert [moment(s) for s in (5.494, 0.66, 0.0021, 0.0, 9358.0)] == ["5.49 s", "0.66 s", "2.10 ms", "0 s", "9358 s"]
    assert [short(n, 4) for n in (60.0, 59.98, 17283.0)] == ["60", "59.98", "17280"]
    assert fit_note(np.arange(9.0), -np.arange(9.0)).startswith("fit −")


def test_thousands_are_grouped() -> None:
    assert grouped(1_125_000) == "1\u202f125\u202f000"


def test_the_first_screen_names_the_worst_error_of_every_model() -> None:
    found = headline_table(run_data().scores)
    judged = [row for row in run_data().scores if row["role"] == "validation" and row["model"] == "rbf"]
    assert found.where.startswith("free runs on the validation log")
    assert found.heading[:2] == ("model", "q [%]")
    assert [row[0] for row in found.rows] == ["rbf", "sindy"]
    assert float(found.rows[0][1]) == pytest.approx(100.0 * judged[0]["nrmse"], abs=0.005)
    assert found.rows[1][1] == "diverged"


def test_a_model_is_described_in_units_with_long_parts_apart() -> None:
    long = {f"part {i} [m]": [1e-3 * i, 2e-4] for i in range(20)}
    told = {"mass_kg": 0.04, "levels": {"pole_1_per_s": [30.0, 5.0, 1.0]}, "converged": True, "deviations": long}
    told |= {"fitted": ["E [Pa]"], "values": [1.7e9], "standard_errors": [1e7], "correlation": [[1.0] * 3] * 3}
    found = described("m", told | {"equations": "q̈ = +2 s^-2·q -3.5e-05 m·x"})
    rows = dict(found.rows)
    assert rows["mass"] == "0.0400 kg"
    assert rows["levels: pole"] == "30.0, 5.00, 1.00 1/s"
    assert rows["converged"] == "yes"
    assert rows["correlation"] == "3 × 3 numbers, in the model's file"
    assert dict(found.tables)["fitted"] == [("E", "1.700 ± 0.010 GPa")]
    assert dict(found.tables)["deviations"][3] == ("part 3", "3.00 ± 0.20 mm")
    assert found.equations == [["q̈ = 2 s⁻²·q", "− 3.5·10⁻⁵ m·x"]]


def test_both_wells_of_a_row_have_one_unit() -> None:
    sheet = run_sheet()
    unlike = {"barrier_left": 4e-5, "barrier_right": 9e-4}
    facts = tuple(
        replace(fact, value=unlike[fact.key], low=None, high=None) if fact.key in unlike else fact
        for fact in sheet.facts
    )
    row = next(r for r in sheet_rows(replace(sheet, facts=facts)) if r.title.startswith("energy barrier"))
    assert [cell.value for cell in row.cells] == ["0.040\u00a0mJ", "0.900\u00a0mJ"]


def test_the_first_screen_is_verdict_overlay_and_headline_table() -> None:
    page = report_page()
    places = [
        page.index(text) for text in ('class="verdict"', "-overlay", 'id="worst"', 'id="datasheet"', 'id="errors"')
    ]
    assert places == sorted(places)
    overlay = run_figures()["validation-other-overlay"]
    lines = {line.role: line for line in overlay.panels[0].lines}
    measured, free = lines["measured"].y, lines["rbf"].y
    seen = np.isfinite(measured)
    error = np.linalg.norm((free - measured)[seen]) / np.linalg.norm(measured[seen] - measured[seen].mean())
    assert overlay.hidden == ("sindy",)
    assert lines["rbf"].label == f"{run_data().model_names[0]}: fit {100 * (1 - error):.1f} %"


def test_q_is_drawn_at_the_top_and_with_the_residuals_and_captions_are_short() -> None:
    data = run_data()
    page = report_page()
    document = json.loads(re.search(r'id="debist-data">(.*?)</script>', page, re.S)[1])
    panels = {
        name: [panel["label"].split(" in ")[0] for panel in f["panels"]] for name, f in document["figures"].items()
    }
    assert {name.partition("-other-")[2] for name, shown in panels.items() if "q" in shown and "-other-" in name} == {
        "overlay", "residuals",
    }  # fmt: skip
    assert 'data-mark="device snaps over"' in page and "Upright lines" not in page
    assert max(len(figure.caption) for figure in run_figures().values()) < 200  # two lines
    assert f"<summary>{sum(c.grade == 'good' and c.about == 'data' for c in run_sheet().checks)} good</summary>" in page
    assert set(data.model_names) <= {line.role for line in run_figures()["validation-other-overlay"].panels[0].lines}


@pytest.mark.parametrize(("wide", "clipped"), [(1e-3, False), (1.0, True)])
def test_the_first_axis_follows_measurement_and_run_and_tubes_are_clipped(wide: float, clipped: bool) -> None:
    data = run_data()
    log = data.role("validation")[0]
    run = log.predictions["rbf"]
    nothing = np.full_like(run["q"], np.nan)
    tubes = {"q_low": run["q"] - wide, "q_high": run["q"] + wide, "q_other_low": nothing, "q_other_high": nothing}
    figure = overlay(data, replace(log, predictions={"rbf": {**run, **tubes}}), run_sheet().wells)
    low, high = figure.panels[0].y_limits
    span = np.ptp(log.kinematics["q"][np.isfinite(log.kinematics["q"])])
    assert low <= np.nanmin(log.kinematics["q"]) and high >= np.nanmax(log.kinematics["q"])
    assert high - low < 2.2 * span
    assert ("beyond the axis" in figure.caption) == clipped
    assert (high >= np.nanmax(tubes["q_high"])) != clipped


def test_logs_and_angles_are_called_what_they_are() -> None:
    page = report_page()
    assert "train/train" not in page and "validation/validation" not in page
    assert "φ measured" not in page
    figures = run_figures().values()
    names = {panel.name for figure in figures for panel in figure.panels}
    assert "φ" not in names


def test_no_motion_under_voltage_lies_over_the_basins() -> None:
    data = run_data()
    portrait = run_figures()["phase-portrait"]
    logs = (*data.role("validation"), *data.role("train"))
    driven = [np.any(np.abs(voltages(log.kinematics)) > 300.0, axis=1) for log in logs]
    for line, acts in zip(portrait.panels[0].lines, driven, strict=True):
        assert np.isnan(line.x[acts]).all()
        assert np.isfinite(line.x).sum() > 100


def test_the_headline_says_what_acts_and_what_it_changes() -> None:
    data = run_data()
    data = replace(
        data,
        descriptions={**data.descriptions, "rbf": {"basis_functions": 14}},
        choice={
            "chosen": "rbf",
            "reason": "it predicts the held-out data better",
            "ablation": {"equations_alone": 0.031, "equations_with_rbf": None, "rbf_alone": 0.0125},
        },
    )
    text = structure_summary(data, run_sheet())
    assert text == (
        "rbf is identified from data alone, with 14 basis functions in each curve. Why this model: it predicts the "
        "held-out data better. Errors over the last quarters of the training logs, of the operating range: equations "
        "alone 3.10 %, rbf from data alone 1.25 %."
    )
    assert text in html.unescape(run_report(data, run_sheet(), figures_of_logs()))


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


def test_a_spread_far_beyond_its_value_decides_the_prefix():
    assert quantity(54e-6, "V", 0.758) == "0.00 ± 0.76 V"
    assert quantity(3e-6, "m", 2e-6) == "3.0 ± 2.0 µm"
