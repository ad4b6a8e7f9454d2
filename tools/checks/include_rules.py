"""The rooms of the project: arrows between them run one way only.

Of C++ a table says which may include headers of which. The laboratory may use all of the product; the product stands
without it, and so no file names it but texts, which may link, and those of MAY_NAME.

SPDX-License-Identifier: Apache-2.0
"""

import re

# folder -> those whose headers it may include, beside its own
ROOMS = {
    "golden": (),
    "geometry": ("golden",),
    "registration": ("golden", "geometry"),
    "cores": ("golden",),
    "api": ("golden", "geometry", "registration", "cores"),
    "apps": ("golden", "geometry", "registration", "cores", "api"),
    "tb": ("golden", "geometry", "registration", "cores", "api", "apps"),
    "examples": ("golden", "geometry", "registration", "cores", "api", "apps"),
    "soc": ("golden", "geometry", "registration", "cores", "api", "apps"),
}
LABORATORY = "lab"
# What calls it, and the checks of this.
MAY_NAME = ("Makefile", ".ci/run", "tools/checks/include_rules.py", "tests/lint/test_text_rules.py", "tests/lint/test_commands.py")

_NAMED = re.compile(rf"""(?<![\w/.-]){LABORATORY}/|["'/]{LABORATORY}["'/]|\b(?:from|import) {LABORATORY}\b""")

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)


def of_product(tree):
    """The files that must not name the laboratory."""
    return [path for path in tree.all if path.suffix != ".md" and tree.name(path) not in MAY_NAME
            and not tree.name(path).startswith((f"{LABORATORY}/", "docs/results/"))]


def laboratory(tree, path):
    for number, line in tree.lines(path):
        if _NAMED.search(line):
            yield number, f"names {LABORATORY}/, which the product must stand without"


def headers(tree):
    """Name behind include/, or within a folder without one, -> folder."""
    rooms = {}
    for path in tree.cpp:
        room, *rest = path.relative_to(tree.root).parts
        if path.suffix == ".cpp" or room not in ROOMS:
            continue
        if "include" in rest:
            rest = rest[rest.index("include") + 1:]
        rooms.setdefault("/".join(rest), set()).add(room)
    return rooms


def arrows(tree):
    """(file, line, message) where a folder includes what it must not."""
    rooms = headers(tree)
    for path in tree.cpp:
        room = path.relative_to(tree.root).parts[0]
        if room not in ROOMS:
            continue
        text = tree.text(path)
        for match in _INCLUDE.finditer(text):
            owners = rooms.get(match.group(1), {room})
            if owners & {room, *ROOMS[room]}:
                continue
            line = text.count("\n", 0, match.start()) + 1
            yield (tree.name(path), line,
                   f"{room}/ must not include {match.group(1)} of {', '.join(sorted(owners))}/")
