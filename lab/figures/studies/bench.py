"""Of make compare: whole calls of libraries of Python, from array to array.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import listing


def calls(reports):
    """By number of threads, as fast ones first."""
    rows = sorted(reports.rows("bench"), key=lambda row: (row["threads"], -row["points_per_s"]))
    shown = [{**row, "rate": row["points_per_s"] / 1e6, "seconds": row["points"] / row["points_per_s"]}
             for row in rows]
    return listing(shown, "library | library", "version | version", "called | `what`", "threads | threads",
                   "million points per second | rate:.2f", "seconds | seconds:.1f",
                   "largest memory, MB | peak_mb:,.0f", "max error | max_error:.1e")


def _seconds(what):
    """Of ten million points on all threads that were measured."""
    def figure(reports):
        rows = [row for row in reports.rows("bench") if row["library"] == "hwffd" and row["what"] == what]
        best = max(rows, key=lambda row: row["threads"])
        return best["points"] / best["points_per_s"]
    return figure


def _ahead(reports):
    """Whether the library is ahead of every other at as many threads."""
    rows = [row for row in reports.rows("bench") if row["what"] != "device model, factored, fx18"]
    for threads in {row["threads"] for row in rows}:
        own, other = ([row["points_per_s"] for row in rows if row["threads"] == threads
                       and (row["library"] == "hwffd") == ours] for ours in (True, False))
        if min(own) <= max(other):
            return "no"
    return "yes"


TABLES = {"calls": calls}
FIGURES = {"reference_s": _seconds("device reference"), "model_s": _seconds("device model, factored, fx18"),
           "ahead": _ahead}
