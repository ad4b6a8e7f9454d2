"""What is known of mutants, by their numbers, kept in a file as long as its sources are the same.

SPDX-License-Identifier: Apache-2.0
"""

import hashlib
import json

from tools import job_pool


class Known:
    """The answers of a file; none of those of other sources or of another text."""

    def __init__(self, path, *sources, text=""):
        self.path = path
        self.key = hashlib.sha256(text.encode() + b"".join(path.read_bytes() for path in sources)).hexdigest()
        saved = json.loads(path.read_text()) if path.exists() else {}
        self.known = saved["answers"] if saved.get("key") == self.key else {}

    def of(self, numbers, work, jobs, what):
        """The answer to each number: work(number) where it is not known."""
        def ended(number, future):
            self.known[str(number)] = future.result()
            self.path.write_text(json.dumps({"key": self.key, "answers": self.known}))

        job_pool.run(work, [number for number in numbers if str(number) not in self.known], jobs, ended,
                     name=lambda number: f"{what} {number}")
        return {number: self.known[str(number)] for number in numbers}
