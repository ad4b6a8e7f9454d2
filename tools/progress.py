"""How far a long command is.

SPDX-License-Identifier: Apache-2.0
"""

import shutil
import sys
import time


class Progress:
    """One line that is overwritten on a terminal; elsewhere a line every few seconds."""

    def __init__(self):
        self.last = time.monotonic()
        self.terminal = sys.stdout.isatty()

    def step(self, done, total, name):
        line = f"[{done}/{total}] {name}"
        if self.terminal:
            print("\r\033[K" + line[: shutil.get_terminal_size().columns - 1], end="", flush=True)
        elif time.monotonic() - self.last > 5:
            self.last = time.monotonic()
            print(line, flush=True)

    def end(self):
        if self.terminal:
            print("\r\033[K", end="", flush=True)
