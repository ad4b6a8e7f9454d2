"""Long work: Snakemake makes the files that a command wants, by the rules of synth/Snakefile.

The name of a result has the key of all that it depends on (digest.py), so what is there is good,
and what is not there is made.

SPDX-License-Identifier: Apache-2.0
"""

import os
import re
import shutil
import signal
import subprocess

from tools import project_root, venv_packages
from tools.progress import Progress
from tools.project_root import ROOT

_JOB = re.compile(r"Job (\d+): (.*)")
_DONE = re.compile(r"Finished jobid: (\d+)")
_STEPS = re.compile(r"(\d+) of (\d+) steps")
# What `check` of yosys warns of before it fails, the worst first.
_PROBLEMS = ("multiple conflicting drivers", "has no driver", "logic loop")


class EngineError(Exception):
    """Snakemake cannot do anything, in one line."""


def program():
    """Snakemake, of build/venv or of the system. Raises EngineError."""
    own = venv_packages.FOLDER / "bin"
    path = shutil.which("snakemake", path=f"{own}{os.pathsep}{os.environ.get('PATH', '')}")
    if not path:
        raise EngineError("snakemake not found: run tools/install engine")
    return path


def run(root, name, wanted, jobs, config=(), items="rows", rules="synth/Snakefile"):
    """Makes the files that are not there, by a Snakefile, `jobs` at a time. `wanted` says which files each item needs;
    {item: complaint} of those that could not be made. An interrupt ends everything and is passed on.
    Raises EngineError.
    """
    waiting = {item: [path for path in paths if not path.is_file()]
               for item, paths in wanted.items()}
    waiting = {item: paths for item, paths in waiting.items() if paths}
    print(f"{name}: {len(wanted)} {items}, {len(wanted) - len(waiting)} of them unchanged", flush=True)
    if not waiting:
        return {}
    build = root / "build"
    build.mkdir(parents=True, exist_ok=True)
    output = _follow([
        program(), "--snakefile", str(ROOT / rules), "--directory", str(build),
        "--cores", str(max(1, jobs)), "--jobs", str(max(1, jobs)),
        "--config", f"root={root}", *config, "--",
        *(os.path.relpath(path, build) for paths in waiting.values() for path in paths)])
    absent = {item: [path for path in paths if not path.is_file()]
              for item, paths in waiting.items()}
    return {item: complaint(root, paths[0], output) for item, paths in absent.items() if paths}


def start(command):
    """The process."""
    return subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            errors="replace", start_new_session=True, env=project_root.environment())


def _follow(command):
    """Runs Snakemake and shows how far it is: all that it said."""
    lines, words, name, progress = [], {}, "", Progress()
    process = start(command)
    try:
        for line in process.stdout:
            lines.append(line.strip())
            if job := _JOB.match(line):
                words[job[1]] = job[2]
            elif finished := _DONE.match(line):
                name = words.get(finished[1], "")
            elif steps := _STEPS.match(line):
                progress.step(*steps.groups(), name)
        process.wait()
    except KeyboardInterrupt:
        _end(process)
        raise
    finally:
        progress.end()
    return lines


def _end(process):
    """Snakemake and all that it runs are one group. What it cannot put in order any more is marked as
    incomplete, and is made again."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)
    for number in (signal.SIGINT, signal.SIGKILL):
        try:
            os.killpg(process.pid, number)
            process.communicate(timeout=5)
        except ProcessLookupError:
            return
        except subprocess.TimeoutExpired:
            continue


def complaint(root, path, output):
    """Why a file is not there, and where more of it stands: the last log with an error, of those of
    its steps, which begin with its name and key."""
    stem = re.match(r".*\.[0-9a-f]{16}", path.name)[0]
    logs = sorted(path.parent.glob(f"{stem}.*log"), key=lambda log: log.stat().st_mtime)
    texts = {log: log.read_text(errors="replace") for log in logs}
    broken = [log for log in logs if "ERROR: " in texts[log]] or logs
    if not broken:
        errors = [line for line in output if re.search(r"Error|error", line)]
        return f"snakemake: {' '.join(errors[:2]) or 'ended without a word'}"
    return f"{in_words(texts[broken[-1]])}: see {os.path.relpath(broken[-1], root)}"


def in_words(log):
    """The first error of a log; of the problems that `check` of yosys found, the worst."""
    errors = re.findall(r"^.*?ERROR: (.*)$", log, re.MULTILINE)
    if not errors:
        last = log.strip().splitlines()[-1:]
        return f"ended without an error, after '{last[0]}'" if last else "ended without a word"
    if "problems in 'check" in errors[0]:
        warnings = re.findall(r"^Warning: (.*)$", log, re.MULTILINE)
        for problem in _PROBLEMS:
            for warning in warnings:
                if problem in warning:
                    return warning.rstrip(":.")
    return errors[0]


def seconds(path):
    """Of a file in which Snakemake has written how long a step took."""
    return round(float(path.read_text().splitlines()[1].split()[0]), 1)
