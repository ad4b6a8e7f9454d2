"""make structure: the module hierarchy of the tops, and what each module costs on ECP5.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import Table, shown

# (top, row, whether documents show it)
DESIGNS = (
    ("hwffd_stream", "basic-fp32-overlapped", True),
    ("hwffd_stream", "factored-fx18-overlapped", True),
    ("hwffd_axi", "basic-fx18-overlapped", True),
    ("hwffd_stream", "basic-fx18-overlapped", True),
    ("ffd_org_select", "cg3-fx18-overlapped", False),
    ("ffd_org_select", "tree8-fx18-overlapped", False),
    ("ffd_org_select", "factored3-fx18-overlapped", False),
)
FIELDS = {"lut": "LUT", "ff": "FF", "dsp": "MULT18", "bram": "DP16KD"}


def modules(reports, top, row):
    """The modules of a design, those below others after them."""
    (design,) = reports.rows("structure", top=top, row=row)
    return Table(["module", "instances", *FIELDS.values()], [
        [". " * module["depth"] + f"`{module['module']}`", shown(module["instances"]),
         *(shown(module[field]) for field in FIELDS)] for module in design["modules"]])


def printed(reports):
    return "\n\n".join(f"{design['top']}, {design['row']}\n"
                       + modules(reports, design["top"], design["row"]).text()
                       for design in reports.rows("structure"))


def missing(reports):
    measured = {(design["top"], design["row"]) for design in reports.rows("structure")}
    return ", ".join(f"{top} of {row}" for top, row, _ in DESIGNS if (top, row) not in measured)


TABLES = {"modules": modules}
