"""What a soak had counted when it was interrupted: the next one of the same programs goes on from there.

SPDX-License-Identifier: Apache-2.0
"""

import hashlib
import json

from tools import whole_file


class Interrupted:
    """A file that is there from a soak's first seed to its end."""

    def __init__(self, folder, programs):
        self.path = folder / "interrupted.json"
        self.key = hashlib.sha256(b"".join(path.read_bytes() for path in programs if path.is_file())).hexdigest()

    def read(self):
        """(hours, rows of counts); (0, []) where there is nothing, or it is of other programs."""
        saved = json.loads(self.path.read_text(encoding="utf-8")) if self.path.exists() else {}
        return (saved["hours"], saved["rows"]) if saved.get("key") == self.key else (0.0, [])

    def write(self, hours, rows):
        whole_file.write(self.path, json.dumps({"key": self.key, "hours": hours, "rows": rows}))

    def end(self):
        self.path.unlink(missing_ok=True)
