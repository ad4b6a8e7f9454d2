"""The pages of docs/organizations, each of which begins with its title, a colon and what it is of, and with its idea in a
line of italics.

SPDX-License-Identifier: Apache-2.0
"""

import re

from tools.reports.results import RequestError
from tools.reports.text_table import Table
from tools.tables import organizations

_BEGIN = re.compile(r"# (?P<title>[^:\n]+): (?P<of>[^\n]+)\n\n\*(?P<idea>[^*\n]+)\.\*\n")


def _pages(folder):
    """(first organization named, page, match) of each page."""
    for path in sorted(folder.glob("*.md")):
        if path.name == "README.md":
            continue
        begin = _BEGIN.match(path.read_text(encoding="utf-8"))
        if begin is None:
            raise RequestError(f"{path.name}: begins with no '# TITLE: `organization`' and '*Idea.*'")
        yield re.search(r"`([^`]+)`", begin["of"])[1], path.name, begin


def of_organizations(reports):
    """A row a page, in the order of the table of organizations; pages of other cores last."""
    order = list(organizations.read(reports.root / "rtl"))
    pages = sorted(_pages(reports.root / "docs" / "organizations"),
                   key=lambda page: order.index(page[0]) if page[0] in order else len(order))
    return Table(["page", "organizations", "idea"], [
        [f"[{begin['title']}]({name})", begin["of"], begin["idea"][0].lower() + begin["idea"][1:]]
        for _, name, begin in pages])


TABLES = {"organizations": of_organizations}
