"""Keys of designs as yosys elaborates them: of the modules that a top really has, with their values.

A module that is read but not instantiated, an arm of a generate that is not taken, a macro that
nobody uses change nothing, so a row whose circuit a change does not reach keeps its results. An
elaboration is kept in build/elaborated/, under the key of all that was read for it.

SPDX-License-Identifier: Apache-2.0
"""

import concurrent.futures
import pathlib
import re
import tempfile
from dataclasses import dataclass

from tools.progress import Progress
from tools.rtl import digest, rtl_sources

# Where a thing stands in the sources, and what yosys therefore calls it.
_PLACE = re.compile(r"^(?:\s*attribute \\src .*|autoidx .*|#.*)\n", re.MULTILINE)
_NAMED = re.compile(r"[\w./-]+\.vh?:\d+(?:\.\d+-\d+\.\d+)?\$\d+|(?<=\$)\d+\b")


@dataclass(frozen=True)
class Design:
    """What is elaborated: the step that reads it, the one that takes its top, and the key of all that
    these read."""

    read: str
    hierarchy: str
    sources: str


def normal(text):
    """RTLIL without places in the sources; things that are called by theirs are numbered as they
    come, in each module anew."""
    modules = re.split(r"(?m)^(?=module )", _PLACE.sub("", text))

    def numbered(module):
        known = {}
        return _NAMED.sub(lambda match: f"#{known.setdefault(match[0], len(known))}", module)

    return "".join(map(numbered, modules))


class Elaborations:
    """Those of one checkout."""

    def __init__(self, root, version):
        self.root, self.version = pathlib.Path(root), version
        self.folder = self.root / "build" / "elaborated"

    def _path(self, design):
        return self.folder / digest.of(self.version, design.read, design.hierarchy, design.sources)

    def _elaborate(self, design):
        """What cannot be elaborated counts as all that was read: whoever maps it will complain."""
        self.folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=self.folder) as folder:
            circuit = pathlib.Path(folder) / "circuit"
            rtl_sources.run(["yosys", "-q", "-p", "; ".join((
                design.read, design.hierarchy, f"write_rtlil {circuit}"))], self.root)
            key = (digest.of(normal(circuit.read_text(encoding="utf-8")))
                   if circuit.is_file() else design.sources)
            draft = pathlib.Path(folder) / "key"
            draft.write_text(key, encoding="utf-8")
            draft.replace(self._path(design))
        return key

    def has(self, design):
        return self._path(design).is_file()

    def key(self, design):
        path = self._path(design)
        return path.read_text(encoding="utf-8") if path.is_file() else self._elaborate(design)

    def prepare(self, designs, jobs):
        """Elaborates those that are not known, `jobs` at a time."""
        left = [design for design in dict.fromkeys(designs) if not self.has(design)]
        progress = Progress()
        with concurrent.futures.ThreadPoolExecutor(max(1, jobs)) as pool:
            for finished, _ in enumerate(pool.map(self._elaborate, left), 1):
                progress.step(finished, len(left), "elaborated")
        progress.end()
