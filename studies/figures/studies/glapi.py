"""make glapi: calls of the OpenGL extension, and its error tables beside Mesa's.

SPDX-License-Identifier: Apache-2.0
"""

from figures.expressions import shown
from figures.table import Table


def commands(reports):
    rows = reports.rows("glapi")
    fields = ("cases", "compared", "failed")
    lines = [[f"`{row['command']}`", *(shown(row[field]) for field in fields)] for row in rows]
    total = ["all", *(shown(sum(row[field] for row in rows)) for field in fields)]
    return Table(["error table of", "error cases", "compared with Mesa", "failed"],
                 [*lines, total])


def printed(reports):
    report = reports.get("glapi")
    return (f"{report['calls']} calls checked by their values, {report['failed_checks']} checks "
            f"failed\n\n{commands(reports).text()}")


def missing(reports):
    return "" if reports.rows("glapi") else "commands"


TABLES = {"commands": commands}
