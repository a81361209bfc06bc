"""The pages in a real browser: no console errors, zoom and sorting work, hostile names run nothing."""

import os
import shutil
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.reporting.test_page import fleet_page, report_page

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
