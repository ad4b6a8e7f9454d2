"""Draws docs/web.png from the live page: wide in light colours, and beside it narrow in dark ones.

    build/venv/bin/python -B apps/web/picture.py [PAGE [PICTURE]]

SPDX-License-Identifier: Apache-2.0
"""

import io
import pathlib
import shutil
import sys

from PIL import Image
from playwright.sync_api import sync_playwright

ROOT = pathlib.Path(__file__).resolve().parents[2]
SWITCHES = ["--headless=new", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox"]
HEIGHT, WIDE, NARROW, GAP = 900, 1200, 375, 16
COLOURS = 200  # of the palette
ANSWERED = "document.getElementById('vertices').textContent !== '-'"


def settle(tab):
    tab.wait_for_function(ANSWERED, timeout=30_000)
    tab.wait_for_timeout(1500)


def deform(tab):
    tab.select_option("#kind", "twist")
    tab.evaluate("amount.value = 70; amount.dispatchEvent(new Event('input'))")
    tab.wait_for_timeout(1500)


def look_inside(tab):
    """Some hundred clocks on, with the drawing and the lanes in view."""
    tab.evaluate("speed.value = 6; speed.dispatchEvent(new Event('input'))")
    tab.click("#run")
    tab.wait_for_timeout(2500)
    tab.click("#run")
    tab.wait_for_timeout(1000)
    tab.evaluate("document.getElementById('inside').scrollIntoView({ behavior: 'instant' })")
    tab.wait_for_timeout(500)


def shot(browser, page, width, scheme, act):
    tab = browser.new_page(viewport={"width": width, "height": HEIGHT}, color_scheme=scheme)
    tab.goto(page.as_uri())
    settle(tab)
    act(tab)
    picture = Image.open(io.BytesIO(tab.screenshot())).convert("RGB")
    tab.close()
    return picture


def main(page=ROOT / "build/web/index.html", picture=ROOT / "docs/web.png"):
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=SWITCHES)
        shots = [shot(browser, pathlib.Path(page).resolve(), *view)
                 for view in ((WIDE, "light", deform), (NARROW, "dark", look_inside))]
        browser.close()
    joined = Image.new("RGB", (sum(image.width for image in shots) + GAP, HEIGHT), "white")
    joined.paste(shots[0], (0, 0))
    joined.paste(shots[1], (shots[0].width + GAP, 0))
    joined.quantize(COLOURS, dither=Image.Dither.NONE).save(picture, optimize=True)
    print(f"{picture}: {pathlib.Path(picture).stat().st_size:,} bytes")


if __name__ == "__main__":
    main(*sys.argv[1:])
