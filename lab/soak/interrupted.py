"""What a soak had counted when it was interrupted: the next one of the same programs goes on from there.

SPDX-License-Identifier: Apache-2.0
"""

import hashlib
import json

from tools import whole_file


class Interrupted:
    """A file of these programs that is there from a soak's first seed to its end."""

    def __init__(self, folder, programs):
        key = hashlib.sha256(b"".join(path.read_bytes() for path in programs if path.is_file())).hexdigest()
        self.path = folder / f"interrupted-{key[:16]}.json"

    def read(self):
        """(hours, rows of counts); (0, []) where there is nothing."""
        saved = json.loads(self.path.read_text(encoding="utf-8")) if self.path.exists() else {"hours": 0.0, "rows": []}
        return saved["hours"], saved["rows"]

    def write(self, hours, rows):
        whole_file.write(self.path, json.dumps({"hours": hours, "rows": rows}))

    def end(self):
        self.path.unlink(missing_ok=True)
