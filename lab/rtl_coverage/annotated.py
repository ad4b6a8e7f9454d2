"""Sources with the count of each line in front, and below a line what of it was not run.

SPDX-License-Identifier: Apache-2.0
"""

import collections


def text(source, places, counts, left_out):
    """The annotated source of a module."""
    lines = {place.line: counts[place] for place in places["line"]}
    missed = collections.defaultdict(list)
    for kind in ("branch", "toggle"):
        for place in places[kind]:
            if not counts[place]:
                missed[place.line].append(
                    f"{'excluded' if place in left_out else 'MISSED'} {kind} {place.what}")
    shown = []
    for number, line in enumerate(source, 1):
        count = f"{lines[number]:>12}" if number in lines else " " * 12
        shown.append(f"{count}  {line}".rstrip())
        shown += [f"{'':12}  ^ {what}" for what in missed[number]]
    return "\n".join(shown) + "\n"
