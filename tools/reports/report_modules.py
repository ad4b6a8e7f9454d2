"""What makes tables of reports of the product's own commands, by the name of the report, with

    TABLES            name -> function of Results and arguments that makes a Table
    FIGURES           name -> function of Results: figures that follow from the report
    printed(reports)  what its command prints, where that is not its tables
    missing(reports)  what a report lacks to be whole, '' if nothing

SPDX-License-Identifier: Apache-2.0
"""

import sys

from tools.reports import (
    glapi_tables, organization_tables, page_tables, pnr_tables, rtl_tables, structure_tables, synth_tables, tests_tables,
    web_tables,
)
from tools.reports.text_table import Table, shown

MODULES = {"results": organization_tables, "rtl": rtl_tables, "synth": synth_tables, "pnr": pnr_tables,
           "structure": structure_tables, "glapi": glapi_tables, "web": web_tables, "tests": tests_tables,
           "pages": page_tables}


def printed(module, reports):
    """What the command of a report prints."""
    if hasattr(module, "printed"):
        return module.printed(reports)
    return "\n".join(make(reports).text() for make in module.TABLES.values())


def plain(reports, name):
    """The rows of a report without a module, a column for each field."""
    rows = reports.rows(name)
    return Table(list(rows[0]), [[shown(row.get(field)) for field in rows[0]] for row in rows]).text()


def show(reports, names):
    """Prints them, by the modules that `reports` has."""
    for name in names:
        module = reports.modules.get(name)
        text = printed(module, reports) if module else plain(reports, name)
        sys.stdout.write(text.rstrip("\n") + "\n\n")
    sys.stdout.flush()
