"""The pages of the laboratory's studies, from the table of what a release measures: lab/release/studies.csv.

SPDX-License-Identifier: Apache-2.0
"""

from tools import csv_table
from tools.reports.text_table import Table

COLUMNS = ("name", "report", "command", "page", "question", "takes")


def pages(reports):
    """A row for each study with a page; a variable of its command is for a release, and left out."""
    rows = [row for _, row in csv_table.read(reports.root / "lab" / "release" / "studies.csv", COLUMNS) if row["page"]]
    return Table(["page", "command", "question", "takes"], [
        [f"[{row['name']}]({row['page']})", "`" + " ".join(word for word in row["command"].split() if "=" not in word) + "`",
         row["question"], row["takes"]] for row in rows])


TABLES = {"pages": pages}
