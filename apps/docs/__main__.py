"""make docs: the site of the project's texts, with search and the reference of its libraries.

    python apps/docs [--build FOLDER]

Writes FOLDER/docs/index.html. A link to a page, file or heading that is not there fails the build.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(1, str(ROOT / "apps"))

from docs import doxygen, python_reference, reference, staging  # noqa: E402  pylint: disable=wrong-import-position

HERE = ROOT / "apps" / "docs"
LIVE = "# The live page\n\nThe simulated hardware in the browser: drag a control point, and the mesh follows.\n\n"
LIVE_HERE = ('[The page by itself](live-page.html){target=_blank}\n\n<iframe class="live" src="../live-page.html" '
             'title="The live page"></iframe>\n')
LIVE_ABSENT = "It is not part of this build: `make web` makes it, and `make docs` then takes it in.\n"


def write_live_page(build, target):
    """The page of `make web`, one file, if it has been made."""
    made = build / "web" / "index.html"
    if made.is_file():
        shutil.copyfile(made, target / "docs" / "live-page.html")
    (target / "docs" / "live.md").write_text(LIVE + (LIVE_HERE if made.is_file() else LIVE_ABSENT), encoding="utf-8")


def write_reference(build, target):
    folder = target / "docs" / "reference"
    folder.mkdir()
    written = reference.pages(doxygen.headers(doxygen.run(ROOT, build / "docs-doxygen")))
    written["python"] = python_reference.page(ROOT)
    for name, text in written.items():
        (folder / f"{name}.md").write_text(text, encoding="utf-8")
    return len(written)


def make(build):
    target = build / "docs-source"
    pages = len(staging.stage(ROOT, target)) + write_reference(build, target) + 1
    write_live_page(build, target)
    for name in ("site.css", "iframe-worker.js"):
        shutil.copyfile(HERE / name, target / name)
    done = subprocess.run([sys.executable, "-B", "-m", "mkdocs", "build", "--quiet", "--strict",
                           "--config-file", HERE / "mkdocs.yml", "--site-dir", build / "docs"],
                          env={**os.environ, "NO_MKDOCS_2_WARNING": "1"}, check=False)
    if done.returncode == 0:
        print(f"made {pages} pages: open {(build / 'docs' / 'index.html')}")
    return done.returncode


def main():
    parser = argparse.ArgumentParser(description="Makes the site of the project's texts.")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build", help="build folder")
    try:
        return make(parser.parse_args().build.resolve())
    except (staging.PageError, doxygen.DoxygenError, reference.HeaderError, OSError) as error:
        print(f"docs: {error}", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
