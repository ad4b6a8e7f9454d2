#!/usr/bin/env -S python3 -B
"""Makes what the live page knows of its cores' designs: drawings, blocks, ports.

    python3 -m apps.web.engine.design FOLDER C++-FILE ROW...

Elaborates each row, keeps of blocks.csv what it has, and writes drawings.js into the folder and the
same blocks, with ports.csv, as C++.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib
import sys
from collections import Counter
from dataclasses import dataclass

from apps.web.engine import drawing, elaborated
from tools import csv_table
from tools.tables import configurations

HERE = pathlib.Path(__file__).resolve().parent

COLUMNS = ("id", "group", "module", "title", "from", "busy")
GENERATED = "Made by apps/web/engine/design.py from tables and elaborated designs; changes here are lost."


@dataclass(frozen=True)
class Block:
    id: str
    group: str
    module: str
    title: str
    busy: str
    sources: tuple  # the blocks that it gets something of
    count: int  # instances of the module, 1 where blocks share it

    @property
    def described(self):
        return f"{self.title}: {self.module}" + (f", {self.count} of them" if self.count > 1 else "")


def _sources(text, there):
    """Of "a|b c": the first of a and b that is there, and c if it is."""
    existing = ([name for name in alternatives.split("|") if name in there][:1] for alternatives in text.split())
    return tuple(name for names in existing for name in names)


def blocks_of(tree):
    """The blocks that a design has."""
    rows = [fields for _, fields in csv_table.read(HERE / "blocks.csv", COLUMNS)
            if tree.counts[fields["module"]] > 0]
    there = [fields["id"] for fields in rows]
    share = Counter(fields["module"] for fields in rows)
    return [Block(fields["id"], fields["group"], fields["module"], fields["title"], fields["busy"],
                  _sources(fields["from"], there),
                  tree.counts[fields["module"]] if share[fields["module"]] == 1 else 1)
            for fields in rows]


def drawn(row, blocks):
    groups = {}
    for block in blocks:
        name = f"{block.group}: {row.org}" if block.group == "Organization" else block.group
        groups.setdefault(name, []).append(block)
    return drawing.svg(f"The blocks of {row.name}", list(groups.items()))


def _strings(*texts):
    return ", ".join(json.dumps(text) for text in texts)


def cpp_text(designs):
    """C++ of [(row, tree, blocks)]."""
    lines = [f"// {GENERATED}", '#include "design.hpp"', "", "namespace hwffd::web {", "",
             "const std::vector<Design>& designs() {", "  static const std::vector<Design> all = {"]
    for row, tree, blocks in designs:
        lines.append(f"      {{{_strings(row.name)}, {tree.counts['ffd_eval_poly']}, {{")
        lines += [f"          {{{_strings(b.id, b.title, b.module, b.busy)}}}," for b in blocks]
        lines.append("      }},")
    lines += ["  };", "  return all;", "}", "", "const std::vector<Port>& ports() {",
              "  static const std::vector<Port> all = {"]
    for _, fields in csv_table.read(HERE / "ports.csv", ("name", "signal", "description")):
        lines.append(f"      {{{_strings(*fields.values())}}},")
    lines += ["  };", "  return all;", "}", "", "}  // namespace hwffd::web"]
    return "\n".join(lines) + "\n"


def main(arguments):
    folder, cpp, *names = arguments
    try:
        known = configurations.read()
        rows = [configurations.find(known, name) for name in names]
        designs = [(row, tree, blocks_of(tree)) for row in rows
                   for tree in [elaborated.tree_of(row)]]
        drawings = {row.name: drawn(row, blocks) for row, _, blocks in designs}
        pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
        (pathlib.Path(folder) / "drawings.js").write_text(
            f"self.HWFFD_DRAWINGS = {json.dumps(drawings)};\n", encoding="utf-8")
        pathlib.Path(cpp).write_text(cpp_text(designs), encoding="utf-8")
    except (csv_table.TableError, elaborated.ElaborationError, OSError) as error:
        print(f"design: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
