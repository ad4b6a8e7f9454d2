"""make glapi: calls of the OpenGL extension, and its error tables beside Mesa's.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import listing


def commands(reports):
    rows = reports.rows("glapi")
    total = {field: sum(row[field] for row in rows) for field in ("cases", "compared", "failed")}
    lines = [*({**row, "command": f"`{row['command']}`"} for row in rows),
             {"command": "all", **total}]
    return listing(lines, "error table of | command",
                   "error cases | cases", "compared with Mesa | compared", "failed | failed")


def printed(reports):
    report = reports.get("glapi")
    return (f"{report['calls']} calls checked by their values, {report['failed_checks']} checks "
            f"failed\n\n{commands(reports).text()}")


TABLES = {"commands": commands}
