"""The pages in a real browser: no console errors, zoom and sorting work, hostile names run nothing."""

import os
import shutil
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from pipeline.reporting.page import packed
from tests.reporting.synthetic import run_data
from tests.reporting.test_page import fleet_page, report_of, report_page

selenium = pytest.importorskip("selenium", reason="selenium is not installed")

PATIENCE = 20.0  # s, for a busy machine
WIDTHS = (1280, 420)


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    program = shutil.which("chromium") or shutil.which("google-chrome") or shutil.which("chromium-browser")
    driver = shutil.which("chromedriver")
    if program is None or driver is None:
        pytest.skip("no Chromium with chromedriver on this machine (Debian: apt-get install chromium chromium-driver)")
    options = webdriver.ChromeOptions()
    options.binary_location = program
    for argument in ("--headless=new", "--disable-gpu", "--disable-dev-shm-usage", "--window-size=1280,1000"):
        options.add_argument(argument)
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        options.add_argument("--no-sandbox")  # Chromium has none for root
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    running = webdriver.Chrome(options=options, service=Service(driver))
    yield running
    running.quit()


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    folder = tmp_path_factory.mktemp("pages")
    found = {}
    for name, text in (("report", report_page()), ("fleet", fleet_page())):
        path: Path = folder / f"{name}.html"
        path.write_text(text, encoding="utf-8")
        found[name] = path.as_uri()
    return found


def _until(condition: Callable[[], Any]) -> Any:
    deadline = time.monotonic() + PATIENCE
    while not (found := condition()) and time.monotonic() < deadline:
        time.sleep(0.05)
    return found


def _open(browser: Any, address: str, width: int = 1280, scheme: str = "light") -> None:
    # Without smooth scrolling an element is where it is when it is clicked.
    features = [
        {"name": "prefers-color-scheme", "value": scheme},
        {"name": "prefers-reduced-motion", "value": "reduce"},
    ]
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
    metrics = {"width": width, "height": 1000, "deviceScaleFactor": 1, "mobile": width < 600}
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
    browser.get_log("browser")
    browser.get(address)
    if "report" in address:
        assert _until(lambda: browser.execute_script("return document.documentElement.dataset.ready")) == "7"


def _view(browser: Any, number: int = 0) -> tuple[float, float]:
    text = browser.execute_script(f"return document.querySelectorAll('.viewer')[{number}].dataset.view")
    start, stop = text.split(" ")
    return float(start), float(stop)


def _zoomed(browser: Any, before: tuple[float, float], number: int = 0) -> tuple[float, float]:
    assert _until(lambda: _view(browser, number) != before)
    return _view(browser, number)


@pytest.mark.parametrize(
    ("width", "scheme"),
    [
        (WIDTHS[0], "light"),
        (WIDTHS[1], "dark"),
        *(pytest.param(*each, marks=pytest.mark.long) for each in ((WIDTHS[0], "dark"), (WIDTHS[1], "light"))),
    ],
)
@pytest.mark.parametrize("name", ["report", "fleet"])
def test_a_page_renders_without_complaint(
    browser: Any, pages: dict[str, str], name: str, width: int, scheme: str
) -> None:
    _open(browser, pages[name], width, scheme)
    assert browser.get_log("browser") == []
    assert browser.execute_script("return window.pwned === undefined")
    assert browser.execute_script("return document.documentElement.scrollWidth") <= width
    back = browser.execute_script("return getComputedStyle(document.body).backgroundColor")
    assert (back == "rgb(255, 255, 255)") == (scheme == "light")


def test_every_figure_is_drawn(browser: Any, pages: dict[str, str]) -> None:
    _open(browser, pages["report"])
    browser.execute_script("document.querySelectorAll('details').forEach((each) => { each.open = true; })")
    assert _until(
        lambda: browser.execute_script(
            "return [...document.querySelectorAll('.uplot')].every((u) => u.clientWidth > 700)"
        )
    )
    inked = browser.execute_script(
        """return [...document.querySelectorAll('.viewer')].map((viewer) => {
             const canvas = viewer.querySelector('canvas');
             const pixels = canvas.getContext('2d').getImageData(80, 10, canvas.width - 100, 130).data;
             return new Set(new Uint32Array(pixels.buffer)).size; });"""
    )
    assert len(inked) == 7
    assert min(inked) > 10


def test_buttons_zoom_all_figures_of_a_log_and_no_others(browser: Any, pages: dict[str, str]) -> None:
    from selenium.webdriver.common.by import By

    _open(browser, pages["report"])
    whole, other = _view(browser, 0), _view(browser, 2)
    browser.find_elements(By.CSS_SELECTOR, ".viewer button[data-do=in]")[0].click()
    start, stop = _zoomed(browser, whole)
    assert stop - start == pytest.approx((whole[1] - whole[0]) / 2.0)
    assert _view(browser, 1) == (start, stop)  # signals of the same log
    assert _view(browser, 2) == other  # signals of the other log
    browser.find_elements(By.CSS_SELECTOR, ".viewer button[data-do=whole]")[0].click()
    assert _zoomed(browser, (start, stop)) == whole


def test_keys_move_zoom_and_find_events(browser: Any, pages: dict[str, str]) -> None:
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys

    _open(browser, pages["report"])
    canvas = browser.find_elements(By.CSS_SELECTOR, ".viewer .plots")[0]
    whole = _view(browser)
    canvas.send_keys("+")
    near = _zoomed(browser, whole)
    canvas.send_keys(Keys.ARROW_RIGHT)
    moved = _zoomed(browser, near)
    assert moved[0] > near[0]
    assert moved[1] - moved[0] == pytest.approx(near[1] - near[0])
    canvas.send_keys("0")
    assert _zoomed(browser, moved) == whole
    canvas.send_keys(Keys.PAGE_DOWN)
    first = _zoomed(browser, whole)
    assert first[0] < 1.0 < first[1] < 3.0  # the first pulse starts at 1 s
    canvas.send_keys(Keys.PAGE_DOWN)
    assert _zoomed(browser, first)[0] > first[0]


def test_dragging_selects_a_stretch_and_double_click_shows_all(browser: Any, pages: dict[str, str]) -> None:
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By

    _open(browser, pages["report"])
    canvas = browser.find_elements(By.CSS_SELECTOR, ".viewer .plots")[0]
    whole = _view(browser)
    browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", canvas)
    chain = ActionChains(browser).move_to_element_with_offset(canvas, -100, 0).click_and_hold()
    chain.move_by_offset(200, 0).release().perform()
    start, stop = _zoomed(browser, whole)
    assert 0.1 < (stop - start) / (whole[1] - whole[0]) < 0.3
    ActionChains(browser).double_click(canvas).perform()
    assert _zoomed(browser, (start, stop)) == whole


def test_one_finger_pans_and_two_fingers_zoom(browser: Any, pages: dict[str, str]) -> None:
    from selenium.webdriver.common.by import By

    browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True, "maxTouchPoints": 2})
    try:
        _open(browser, pages["report"])
        canvas = browser.find_elements(By.CSS_SELECTOR, ".viewer .plots")[0]
        browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", canvas)
        box = browser.execute_script("return arguments[0].getBoundingClientRect().toJSON()", canvas)
        middle, height = box["left"] + box["width"] / 2, box["top"] + box["height"] / 2
        whole = _view(browser)

        def fingers(kind: str, *offsets: float) -> None:
            points = [{"x": middle + offset, "y": height, "id": number} for number, offset in enumerate(offsets)]
            browser.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

        fingers("touchStart", -50.0, 50.0)
        for spread in (70.0, 85.0, 100.0):
            fingers("touchMove", -spread, spread)
        fingers("touchEnd")
        near = _zoomed(browser, whole)
        assert near[1] - near[0] == pytest.approx((whole[1] - whole[0]) / 2.0, rel=0.1)  # fingers twice as far apart

        fingers("touchStart", 0.0)
        for offset in (-40.0, -80.0, -120.0):
            fingers("touchMove", offset)
        fingers("touchEnd")
        moved = _zoomed(browser, near)
        assert moved[0] > near[0]
        assert moved[1] - moved[0] == pytest.approx(near[1] - near[0])
    finally:
        browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": False})


@pytest.mark.long
def test_a_long_record_is_drawn_from_its_extremes(
    browser: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("pipeline.reporting.page.packed", partial(packed, longest=1000))
    monkeypatch.setattr("pipeline.reporting.page.LONGEST", 1000)
    path = tmp_path / "report.html"
    path.write_text(report_of(run_data())[0], encoding="utf-8")
    _open(browser, path.as_uri())
    assert browser.get_log("browser") == []
    stored = browser.execute_script(
        """const {figures, packed} = JSON.parse(document.getElementById('debist-data').textContent);
           const line = figures['train-train-1-signals'].panels[0].series[0];
           return samples(packed[line.data]).then((values) => values.map((value) => value * line.factor));"""
    )
    q = run_data().logs[0].record["q"] * 1e3
    assert 900 < len(stored) <= 1000
    assert [min(stored), max(stored)] == pytest.approx([q.min(), q.max()], rel=1e-3)


def test_the_pointer_shows_time_and_values(browser: Any, pages: dict[str, str]) -> None:
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By

    _open(browser, pages["report"])
    viewer = browser.find_elements(By.CSS_SELECTOR, ".viewer")[1]
    over = viewer.find_elements(By.CSS_SELECTOR, ".u-over")[0]
    browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", over)
    ActionChains(browser).move_to_element(over).perform()
    assert _until(lambda: [each.text for each in viewer.find_elements(By.CSS_SELECTOR, ".values span")])
    shown = [each.text for each in viewer.find_elements(By.CSS_SELECTOR, ".values span")]
    assert [text.rpartition(" ")[0] for text in shown] == ["plain differences", "regularised"] * 2
    start, stop = _view(browser, 1)
    middle = float(viewer.find_element(By.CSS_SELECTOR, "output").text.split()[2])
    assert middle == pytest.approx((start + stop) / 2.0, abs=0.02 * (stop - start))


def test_a_line_is_hidden_by_its_button(browser: Any, pages: dict[str, str]) -> None:
    from selenium.webdriver.common.by import By

    _open(browser, pages["report"])
    viewer = browser.find_element(By.CSS_SELECTOR, "#validation-other-models .viewer")
    picture = "return arguments[0].querySelector('canvas').toDataURL()"
    buttons = viewer.find_elements(By.CSS_SELECTOR, "button[data-series]")
    pressed = {b.get_attribute("data-series"): b.get_attribute("aria-pressed") for b in buttons}
    assert pressed == {"measured": "true", "rbf": "true", "sindy": "false"}  # sindy diverged
    before = browser.execute_script(picture, viewer)
    browser.execute_script("arguments[0].click()", buttons[0])
    assert _until(lambda: browser.execute_script(picture, viewer) != before)
    assert buttons[0].get_attribute("aria-pressed") == "false"
    events = viewer.find_element(By.CSS_SELECTOR, "button[data-mark]")
    assert events.get_attribute("aria-pressed") == "false"
    before = browser.execute_script(picture, viewer)
    browser.execute_script("arguments[0].click()", events)
    assert _until(lambda: browser.execute_script(picture, viewer) != before)


def test_tables_sort_by_click_and_by_key(browser: Any, pages: dict[str, str]) -> None:
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys

    _open(browser, pages["fleet"])
    headings = browser.find_elements(By.CSS_SELECTOR, "#fleet thead th")
    column = next(i for i, heading in enumerate(headings) if heading.text.startswith("barrier left"))
    cells = f"return [...document.querySelectorAll('#fleet tbody tr')].map((r) => r.cells[{column}].dataset.value)"

    headings[column].find_element(By.TAG_NAME, "button").click()
    rising = browser.execute_script(cells)
    assert headings[column].get_attribute("aria-sort") == "ascending"
    numbers = [float(text) for text in rising if text]
    assert numbers == sorted(numbers)
    assert rising[-1] == ""  # the failed prototype stays at the end
    headings[column].find_element(By.TAG_NAME, "button").send_keys(Keys.ENTER)
    falling = browser.execute_script(cells)
    assert [float(text) for text in falling if text] == numbers[::-1]
    assert falling[-1] == ""


def test_paper_is_light_whatever_the_screen(browser: Any, pages: dict[str, str]) -> None:
    _open(browser, pages["report"], scheme="dark")
    browser.execute_script("window.dispatchEvent(new Event('beforeprint'))")
    assert browser.execute_script("return getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
    browser.execute_script("window.dispatchEvent(new Event('afterprint'))")
    assert browser.execute_script("return getComputedStyle(document.body).backgroundColor") != "rgb(255, 255, 255)"
    printed = browser.execute_cdp_cmd("Page.printToPDF", {"printBackground": False})
    assert len(printed["data"]) > 50_000
    assert browser.get_log("browser") == []


def test_on_paper_no_table_is_wider_than_the_sheet(browser: Any, pages: dict[str, str]) -> None:
    _open(browser, pages["report"], width=718)  # A4 with margins
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    try:
        wide = browser.execute_script(
            """return [...document.querySelectorAll('.scroll')].filter((e) => e.scrollWidth > e.clientWidth + 1)
                     .map((e) => e.textContent.slice(0, 60));"""
        )
        assert wide == []
        hidden = browser.execute_script("return getComputedStyle(document.querySelector('.gestures')).display")
        assert hidden == "none"
    finally:
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})


@pytest.mark.parametrize(
    ("name", "part"), [("fleet", "body *"), ("report", "#datasheet *, #overview figcaption, .help")]
)
def test_on_a_phone_nothing_is_cut(browser: Any, pages: dict[str, str], name: str, part: str) -> None:
    _open(browser, pages[name], width=390)
    cut = f"""return [...document.querySelectorAll('{part}')].filter((e) =>
                    !e.closest('nav, svg, .uplot, details:not([open])') &&
                    (e.scrollWidth > e.clientWidth + 1 && e.clientWidth || e.getBoundingClientRect().right > 391))
                 .map((e) => e.outerHTML.slice(0, 90));"""
    assert browser.execute_script(cut) == []
