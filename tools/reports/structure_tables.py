"""make structure: the module hierarchy of the tops, and what each module costs on ECP5.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import Table, shown

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
    return "" if all(design["modules"] for design in reports.rows("structure")) else "designs"


TABLES = {"modules": modules}
