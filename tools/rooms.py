"""The folders of C++ and which of them may include headers of which: arrows run one way only.

SPDX-License-Identifier: Apache-2.0
"""

import re

# folder -> those whose headers it may include, beside its own
ROOMS = {
    "golden": (),
    "geometry": ("golden",),
    "driver": ("golden",),
    "cores": ("golden",),
    "api": ("golden", "geometry", "driver", "cores"),
    "tb": ("golden", "driver", "cores"),
    "program": ("golden", "geometry"),
    "studies": ("golden", "geometry", "driver", "cores", "api", "tb", "program"),
    "apps": ("golden", "geometry", "driver", "cores", "api", "tb", "program", "studies"),
    "examples": ("golden", "geometry", "driver", "cores", "api", "program", "apps"),
}
TESTS = "tests"  # may include all

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)


def headers(tree):
    """Name behind include/, or within a folder without one, -> folder."""
    found = {}
    for path in tree.cpp:
        room, *rest = path.relative_to(tree.root).parts
        if path.suffix == ".cpp" or room not in ROOMS:
            continue
        if "include" in rest:
            rest = rest[rest.index("include") + 1:]
        found.setdefault("/".join(rest), set()).add(room)
    return found


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
