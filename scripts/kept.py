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
        self._by_key = {} if again else {row["key"]: row for row in rows if row.get("key")}

    def __bool__(self):
        return bool(self._by_key)

    def get(self, key):
        """The row, or None."""
        return self._by_key.get(key)
