"""make docs: the site of the project's texts, with search and the reference of its libraries.

    python3 -m apps.docs [--build FOLDER] [--source FOLDER]

Writes FOLDER/docs/index.html. A link to a page, file or heading that is not there fails the build.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys

from apps.docs import doxygen, python_reference, staging

ROOT = pathlib.Path(__file__).resolve().parents[2]

HERE = ROOT / "apps" / "docs"
LIVE = "---\nhide: [navigation, toc]\n---\n# The live page\n\nThe simulated hardware in the browser: drag a control point, and the mesh follows.\n\n"
LIVE_HERE = ('[The page by itself](live-page.html){target=_blank}\n\n<iframe class="live" src="live-page.html" '
             'title="The live page"></iframe>\n')
CPP = "# C and C++\n\n[The reference of the C and C++ libraries](cpp/index.html) has pages and a search of its own.\n"
LIVE_ABSENT = "It is not part of this build: `make web` makes it, and `make docs` then takes it in.\n"


def write_live_page(build, target):
    """The page of `make web`, one file, if it has been made."""
    page = build / "web" / "index.html"
    if page.is_file():
        shutil.copyfile(page, target / "docs" / "live-page.html")
    (target / "docs" / "live.md").write_text(LIVE + (LIVE_HERE if page.is_file() else LIVE_ABSENT), encoding="utf-8")


def write_reference(target):
    """That of C and C++ is pages of Doxygen, with a search of their own."""
    folder = target / "docs" / "reference"
    doxygen.run(ROOT, folder / "cpp")
    (folder / "cpp.md").write_text(CPP, encoding="utf-8")
    (folder / "python.md").write_text(python_reference.PAGE, encoding="utf-8")
    python_reference.stage(ROOT, target)
    return 2


def write_pages(build, target):
    pages = len(staging.stage(ROOT, target)) + write_reference(target) + 1
    write_live_page(build, target)
    for name in ("site.css", "iframe-worker.js"):
        shutil.copyfile(HERE / name, target / name)
    print(f"wrote {pages} pages")


def make_site(source, target):
    """MkDocs; its exit status. Quiet it would not count warnings, which strict makes errors."""
    settings = {**os.environ, "NO_MKDOCS_2_WARNING": "1", "HWFFD_DOCS_SOURCE": str(source)}
    result = subprocess.run([sys.executable, "-B", "-m", "mkdocs", "build", "--strict",
                             "--config-file", HERE / "mkdocs.yml", "--site-dir", target], env=settings, check=False,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if result.returncode == 0:
        print(f"made the site: open {target / 'index.html'}")
    else:
        messages = [line for line in result.stdout.splitlines() if line.strip() and not line.startswith("INFO ")]
        print("\n".join(f"docs: {line}" for line in messages), file=sys.stderr)
    return result.returncode


def main():
    parser = argparse.ArgumentParser(description="Makes the site of the project's texts.")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build", help="build folder")
    parser.add_argument("--source", type=pathlib.Path, help="pages as written before, in place of those of today")
    options = parser.parse_args()
    build = options.build.resolve()
    source = (options.source or build / "docs-source").resolve()
    if not importlib.util.find_spec("mkdocs"):
        print("docs: mkdocs not found: run tools/install docs", file=sys.stderr)
        return 1
    try:
        if not options.source:
            write_pages(build, source)
        return make_site(source, build / "docs")
    except (staging.PageError, doxygen.DoxygenError, OSError) as error:
        print(f"docs: {error}", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
