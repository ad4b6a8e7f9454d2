"""Long jobs side by side, with a line that tells how far they are.

SPDX-License-Identifier: Apache-2.0
"""

import concurrent.futures

from progress import Progress


def run(work, items, jobs, processes, ended, name=str):
    """Calls work(item) for every item, `jobs` at a time, and ended(item, future) for each that has
    ended. An interrupt ends the running `processes`, if they are given, begins no other job and
    is passed on.
    """
    progress = Progress(len(items))
    with concurrent.futures.ThreadPoolExecutor(max(1, jobs)) as pool:
        try:
            running = {pool.submit(work, item): item for item in items}
            for done in concurrent.futures.as_completed(running):
                progress.step(name(running[done]))
                ended(running[done], done)
        except KeyboardInterrupt:
            if processes:
                processes.stop()
            pool.shutdown(cancel_futures=True)
            raise
        finally:
            progress.end()


def complaints(work, items, jobs, processes, errors, name=str):
    """The same for work whose results are kept elsewhere: [(item, complaint)] of those that raised
    one of `errors`."""
    failed = []

    def ended(item, done):
        try:
            done.result()
        except errors as error:
            failed.append((item, str(error)))

    run(work, items, jobs, processes, ended, name)
    return failed
