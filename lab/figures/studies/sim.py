"""make sim: a mesh through the simulated core.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import Console, listing

DEFAULT = {"model": "cat.3ds", "deform": {"twist:90", "random:1"}, "runs": 12}


def runs(reports):
    return listing(
        reports.rows("sim"), "org | org", "format | format", "schedule | schedule",
        "stream | stream", "deform | deform", "checked | checked:d", "mismatches | mismatches:d",
        "clocks/vertex | clocks_per_vertex:.2f", "max error | max_error:.2e",
        "rms error | rms_error:.2e")


def console(reports):
    """The same as the program prints it."""
    form = "{:<10} {:<6} {:<11} {:<12} {:<10} {:>8} {:>10} {:>13} {:>10} {:>10}"
    table = runs(reports)
    return Console([form.format(*line) for line in [table.heads, *table.rows]])


def missing(reports):
    """What is committed is of `make sim` without variables."""
    report, rows = reports.get("sim"), reports.rows("sim")
    default = (report["model"] == DEFAULT["model"] and len(rows) == DEFAULT["runs"]
               and {row["deform"] for row in rows} == DEFAULT["deform"])
    return "" if default else "runs of make sim without variables"


TABLES = {"runs": runs, "console": console}
