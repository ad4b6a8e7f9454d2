"""Chromium without a window for the tests of the live page: how it is started, and what is read off the page.

SPDX-License-Identifier: Apache-2.0
"""

import contextlib
import io
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy
import pytest
from PIL import Image
from playwright.sync_api import sync_playwright

ROOT = pathlib.Path(__file__).resolve().parents[2]
SWITCHES = ["--headless=new", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox"]
POINT = (0xC0, 0x40, 0x00)  # the colour of control points on a light ground
CORE_WAIT = 20_000  # ms

# Notes what the worker says and when, and when pictures are due. The page knows nothing of it.
WATCH = """
  window.runs = []; window.pictures = [];
  const Plain = window.Worker;
  window.Worker = class extends Plain {
    constructor(...all) {
      super(...all);
      this.addEventListener("message", ({ data }) => {
        if (data.type === "deformed") runs.push([performance.now(), data.vertices, data.seconds, data.mismatches]);
      });
    }
  };
  const tick = (now) => { pictures.push(now); requestAnimationFrame(tick); };
  requestAnimationFrame(tick);
"""
NO_WEBASSEMBLY = "delete window.WebAssembly;"
NO_WEBGL = """
  const plain = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
    return /webgl/.test(kind) ? null : plain.call(this, kind, ...more);
  };
"""


def program(name):
    """Where a program is; without it the tests are skipped."""
    path = shutil.which(name)
    if not path:
        pytest.exit(f"skipped: {name} is not there: tools/install web", returncode=77)
    return path


@contextlib.contextmanager
def started():
    """A browser without a window, which keeps nothing in the user's home."""
    path = program("chromium")
    with tempfile.TemporaryDirectory() as home, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=SWITCHES,
                                             env={**os.environ, "XDG_CONFIG_HOME": home, "XDG_CACHE_HOME": home})
        yield browser
        browser.close()


def stub_page(folder):
    """The page with a worker that needs no build of the core."""
    program("esbuild")
    page = folder / "index.html"
    result = subprocess.run([sys.executable, "-B", "-m", "apps.web.bundle", "--worker",
                             ROOT / "tests/web/stub_worker.js", "--output", page],
                            capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr
    return page


class Open:
    """The page in a tab: what went wrong in it, and what a test asks of it."""

    def __init__(self, context, address, scripts=(WATCH,), has_core=True):
        self.errors = []
        self.page = context.new_page()
        self.page.on("console", lambda message: message.type == "error" and self.errors.append(message.text))
        self.page.on("pageerror", lambda error: self.errors.append(str(error)))
        for script in scripts:
            self.page.add_init_script(script)
        self.page.goto(address)
        if has_core:
            self.page.wait_for_function("document.getElementById('vertices').textContent !== '-'",
                                        timeout=CORE_WAIT)

    def text(self, name):
        return self.page.inner_text(f"#{name}")

    def number(self, name):
        return float(self.text(name).replace(",", ""))

    def quiet(self):
        """Waits until the worker has nothing more to answer."""
        for _ in range(2):
            self.page.wait_for_timeout(100)
            self.until("!document.querySelector('[aria-busy=true]')")

    def until(self, script):
        self.page.wait_for_function(script, timeout=CORE_WAIT)

    def notice(self):
        self.page.wait_for_selector("#notice:not([hidden])", timeout=CORE_WAIT)
        return self.page.inner_text("#notice p")

    def load(self, name, content, field="#mesh-file"):
        content = content.encode() if isinstance(content, str) else content
        self.page.set_input_files(field, {"name": name, "mimeType": "text/plain", "buffer": content})

    def place(self):
        """x, y and z of the chosen control point, as its fields have them."""
        return [float(self.page.input_value(f"#place-{axis}")) for axis in range(3)]

    def points_on_screen(self):
        """Where control points are seen, in pixels of the page: those of their colour."""
        self.page.evaluate("scrollTo({ top: 0, behavior: 'instant' })")
        box = self.page.locator("#view").bounding_box()
        picture = Image.open(io.BytesIO(self.page.screenshot(clip=box))).convert("RGB")
        seen = numpy.asarray(picture) == numpy.array(POINT)
        return [(box["x"] + float(x), box["y"] + float(y)) for y, x in numpy.argwhere(seen.all(axis=2))]
