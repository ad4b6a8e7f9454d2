"""make web: what the browser measured on the live page.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import Table, shown

_LINES = (
    ("bytes of the page", "bytes", ""),
    ("seconds until the first mesh is compared", "load_s", ".2f"),
    ("vertices of that mesh", "vertices", ""),
    ("words that differ from the model", "mismatches", ""),
    ("the planted fault is seen", "fault_seen", ""),
    ("vertices per second through the RTL", "vertices_per_s", ""),
    ("runs of the mesh per second while a point is dragged", "runs_per_s", ".1f"),
    ("pictures per second meanwhile", "frames_per_s", ".1f"),
    ("errors in the console", "console_errors", ""),
)


def page(reports):
    report = reports.get("web")
    return Table(["figure", "measured"],
                 [[name, shown(report[field], form)] for name, field, form in _LINES])


def missing(reports):
    return ", ".join(field for _, field, _ in _LINES if field not in reports.get("web"))


TABLES = {"page": page}
