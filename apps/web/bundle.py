"""Makes the live page one file, build/web/index.html, that opens from any server and without one.

    python3 -m apps.web.bundle [--engine DIR | --worker FILE] [--plates FILE] [--output FILE]

Scripts are joined by esbuild, with three.js of the package libjs-three; the engine's WebAssembly goes in as gzip in
base64. Figures come from the newest of docs/results/.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import base64
import gzip
import json
import pathlib
import re
import subprocess
import sys

from apps.web import figures_data
from tools.reports import results

ROOT = pathlib.Path(__file__).resolve().parents[2]

PAGE = ROOT / "apps" / "web" / "page"
THREE = pathlib.Path("/usr/share/javascript/three")
MODULES = {"three": THREE / "build/three.module.js", "three-orbit": THREE / "examples/jsm/controls/OrbitControls.js"}
# Debian packages of which parts are in the page, with what they are there for.
BUNDLED = {
    "libjs-three": "three.js, which draws the 3-D pictures",
    "emscripten": "the compiler's runtime and C library, in the simulated core",
    "verilator": "Verilator's runtime, in the simulated core",
    "libfmt-dev": "fmt, in the simulated core",
    "libeigen3-dev": "Eigen, in the simulated core",
    "nlohmann-json3-dev": "JSON for Modern C++, in the simulated core",
    "glmark2-data": "the cat of plates 1 to 4",
}
ENGINE_PACKAGES = ("emscripten", "verilator", "libfmt-dev", "libeigen3-dev", "nlohmann-json3-dev")
COMMON = pathlib.Path("/usr/share/common-licenses")
MOST_BYTES = 8_000_000


class BundleError(Exception):
    """Why there is no page, in one line."""


def script_of_page():
    """The page's modules and the library as one classic script."""
    missing = [str(path) for path in MODULES.values() if not path.is_file()]
    if missing:
        raise BundleError(f"{missing[0]} is not there: apt-get install libjs-three")
    aliases = [f"--alias:{name}={path}" for name, path in MODULES.items()]
    command = ["esbuild", str(PAGE / "main.js"), "--bundle", "--minify", "--format=iife", "--target=es2022",
               "--charset=utf8", "--log-level=warning", *aliases]
    try:
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout
    except FileNotFoundError:
        raise BundleError("esbuild is not there: apt-get install esbuild") from None
    except subprocess.CalledProcessError as error:
        raise BundleError(f"esbuild: {error.stderr.strip().splitlines()[0]}") from None


def licences(packages):
    """The whole text of each package's copyright file, and of the licences that these name by their file."""
    texts = []
    for package in packages:
        path = pathlib.Path("/usr/share/doc") / package / "copyright"
        if not path.is_file():
            raise BundleError(f"{path} is not there: the page carries the licence of {package}")
        texts.append(f"{package}: {BUNDLED[package]}\n\n{path.read_text(encoding='utf-8')}")
    named = sorted(set(re.findall(rf"{COMMON}/([\w.-]*\w)", "".join(texts))))
    return texts + [f"{name}\n\n{(COMMON / name).read_text(encoding='utf-8')}" for name in named
                    if (COMMON / name).is_file()]


def data(packages):
    """What the page reads as JSON, by name."""
    released = results.released(ROOT)
    return {"organizations": figures_data.organizations(released), "pareto": figures_data.pareto(released),
            "licences": licences(packages)}


def in_data(value):
    """JSON that cannot end the element that it stands in."""
    return json.dumps(value, separators=(",", ":")).replace("<", "\\u003c")


def in_script(text):
    """A script that cannot end the element that it stands in."""
    return text.replace("</", "<\\/").replace("<!--", "<\\!--")


def packed(name, path):
    """An element with a file, as gzip in base64."""
    if not path.is_file():
        raise BundleError(f"{path} is not there: build hwffd-web-engine and hwffd-web-plates")
    content = base64.b64encode(gzip.compress(path.read_bytes(), mtime=0)).decode()
    return f'<script id="packed-{name}" type="text/plain">{content}</script>'


def engine_elements(engine, worker):
    """The worker's script, and the WebAssembly that it is handed."""
    scripts = [worker] if worker else [engine / name for name in ("engine.js", "drawings.js", "worker.js")]
    for path in scripts:
        if not path.is_file():
            raise BundleError(f"{path} is not there: build the target hwffd-web-engine")
    text = "\n".join(path.read_text(encoding="utf-8") for path in scripts)
    elements = [f'<script id="worker-script" type="text/plain">{in_script(text)}</script>']
    return elements if worker else [*elements, packed("engine", engine / "engine.wasm")]


def page(engine, worker, plates):
    packages = ["libjs-three"]
    if not worker:
        packages += ENGINE_PACKAGES
    if plates and "cat.3ds" in plates.read_text(encoding="utf-8"):
        packages.append("glmark2-data")
    elements = [f'<script id="data-{name}" type="application/json">{in_data(value)}</script>'
                for name, value in data(packages).items()]
    elements += engine_elements(engine, worker)
    if plates:
        elements.append(packed("plates", plates))
    elements.append(f"<script>{in_script(script_of_page())}</script>")
    style = "\n".join(path.read_text(encoding="utf-8") for path in sorted(PAGE.glob("*.css")))
    text = (PAGE / "index.html").read_text(encoding="utf-8")
    return text.replace("<!--style-->", f"<style>{style}</style>").replace("<!--scripts-->", "\n".join(elements))


def parse(words):
    parser = argparse.ArgumentParser(description="Makes the live page one file.")
    source = parser.add_mutually_exclusive_group()
    source.add_argument("--engine", type=pathlib.Path, default=ROOT / "build/web/engine",
                        help="folder with engine.js, drawings.js, worker.js and engine.wasm")
    source.add_argument("--worker", type=pathlib.Path, help="a worker of one script in the engine's place")
    parser.add_argument("--plates", type=pathlib.Path, help="the plates as JSON")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build/web/index.html")
    return parser.parse_args(words)


def main(words=None):
    options = parse(words)
    try:
        text = page(options.engine, options.worker, options.plates).encode()
        if len(text) > MOST_BYTES:
            raise BundleError(f"the page has {len(text):,} bytes, and is to have {MOST_BYTES:,} at most")
    except BundleError as error:
        print(f"bundle: {error}", file=sys.stderr)
        return 1
    options.output.parent.mkdir(parents=True, exist_ok=True)
    options.output.write_bytes(text)
    print(f"{options.output}: {len(text):,} bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
