"""The test programs of a build, run with their counters on.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import subprocess
import sys

from lab.rtl_coverage.counts import CoverageError
from tools import job_pool

# Tests of the OpenGL calls, of the command and of the devices that it takes: no programs of GoogleTest.
CALLS = r"^(gl\.|boards\.serial_device$|hwffd\.(command|gltf|refusals|socket_device)$)"


def listed(build):
    """Test programs of the label test, each once."""
    answer = subprocess.run(["ctest", "--test-dir", str(build), "-L", "^test$", "--show-only=json-v1"],
                            capture_output=True, text=True, check=False)
    if answer.returncode:
        raise CoverageError(f"{build}: ctest lists no tests: make -C lab coverage builds them")
    commands = {test["command"][0] for test in json.loads(answer.stdout)["tests"]
                if any("--gtest_filter" in word for word in test.get("command", []))}
    return sorted(map(pathlib.Path, commands))


def run_calls(build, folder):
    """The tests that call what is built: they add to the counts of the C++."""
    command = ["ctest", "--test-dir", str(build), "-L", "^test$", "-R", CALLS, "--no-tests=error", "--output-on-failure"]
    with (folder / "calls.log").open("w", encoding="utf-8") as log:
        if subprocess.run(command, stdout=log, stderr=log, check=False).returncode:
            raise CoverageError(f"tests that call it fail: see {folder / 'calls.log'}")


def _key(program, build):
    return "-".join(program.relative_to(build).parts[1:])


def _is_counted(program, path):
    return path.exists() and path.stat().st_mtime > program.stat().st_mtime


def _path(program, build, folder, share):
    """Of its counts: those of all its tests, where they are there, serve for a part."""
    whole = folder / f"{_key(program, build)}-1.tsv"
    return whole if _is_counted(program, whole) else whole.with_name(f"{_key(program, build)}-{share}.tsv")


def run(programs, build, folder, jobs, share):
    """Runs each, or the first of `share` parts of its tests; the files of counts. What was counted of a
    program that is as it was is not counted again."""
    folder.mkdir(parents=True, exist_ok=True)
    paths, failed = {program: _path(program, build, folder, share) for program in programs}, []

    def work(program):
        path = paths[program]
        if _is_counted(program, path):
            return 0
        new = path.with_suffix(".new")
        settings = {"HWFFD_COVERAGE": str(new), "GTEST_TOTAL_SHARDS": str(share), "GTEST_SHARD_INDEX": "0"}
        with path.with_suffix(".log").open("w") as log:
            status = subprocess.run([program, "--gtest_brief=1"], stdout=log, stderr=log, check=False,
                                    cwd=program.parent, env={**os.environ, **settings}).returncode
        if status == 0 and new.exists():
            new.replace(path)
        return status

    def ended(program, future):
        if future.result():
            failed.append(program)
            print(f"coverage: {program.name} fails: see {paths[program].with_suffix('.log')}",
                  file=sys.stderr)

    # Large ones first: they have most models and run longest, and at the end no core waits for one of them.
    largest_first = sorted(programs, key=lambda program: -program.stat().st_size)
    job_pool.run(work, largest_first, jobs, ended, name=lambda program: program.name)
    if failed:
        raise CoverageError(f"{len(failed)} of {len(programs)} programs fail")
    return [path for path in paths.values() if path.exists()]
