"""What committed reports have measured, by key: who clones the sources need not measure again what
took hours, and long work goes on where it stopped on another machine.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib

FOLDER = "docs/reports"


class Kept:
    """The rows of one report that have a key; none where `again` says that all is to be measured."""

    def __init__(self, root, name, field="rows", again=False):
        path = pathlib.Path(root) / FOLDER / f"{name}.json"
        rows = json.loads(path.read_text(encoding="utf-8"))[field] if path.is_file() else []
        self._by_key = {}
        for row in () if again else rows:
            if row.get("key"):
                self._by_key.setdefault(row["key"], []).append(row)

    def __bool__(self):
        return bool(self._by_key)

    def get(self, key):
        """The row, or None."""
        return next(iter(self.rows(key)), None)

    def rows(self, key):
        """All rows of what has several."""
        return self._by_key.get(key, [])
