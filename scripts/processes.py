"""Programs that run side by side and can be ended together.

SPDX-License-Identifier: Apache-2.0
"""

import subprocess
import threading


class Interrupted(Exception):
    """Everything has been ended; nothing more begins."""


class Processes:
    """All programs of one run, from any thread."""

    def __init__(self, folder):
        self.folder = folder  # in which they run
        self._running, self._lock, self._stopped = set(), threading.Lock(), False

    def call(self, command, out):
        """Runs a program, its output in the file `out`: its exit status. Raises Interrupted."""
        with self._lock:
            if self._stopped:
                raise Interrupted("not run: interrupted")
            process = subprocess.Popen(command, cwd=self.folder, stdin=subprocess.DEVNULL,
                                       stdout=out, stderr=subprocess.STDOUT)
            self._running.add(process)
        try:
            return process.wait()
        finally:
            with self._lock:
                self._running.discard(process)

    def stop(self):
        """Ends what is running and lets nothing more begin."""
        with self._lock:
            self._stopped = True
            for process in self._running:
                process.terminate()
