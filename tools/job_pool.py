"""Short jobs side by side, with a line that tells how far they are.

SPDX-License-Identifier: Apache-2.0
"""

import concurrent.futures

from tools.progress import Progress


def run(work, items, jobs, ended, name=str):
    """Calls work(item) for every item, `jobs` at a time, and ended(item, future) for each that has
    ended. An interrupt begins no other job and is passed on.
    """
    progress = Progress()
    with concurrent.futures.ThreadPoolExecutor(max(1, jobs)) as pool:
        try:
            running = {pool.submit(work, item): item for item in items}
            for number, future in enumerate(concurrent.futures.as_completed(running), 1):
                progress.step(number, len(running), name(running[future]))
                ended(running[future], future)
        except KeyboardInterrupt:
            pool.shutdown(cancel_futures=True)
            raise
        finally:
            progress.end()
