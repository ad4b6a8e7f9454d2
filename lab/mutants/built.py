"""What a build made, and how: the model of a library, and the program that links it.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import shlex
import subprocess
from dataclasses import dataclass


class MutantError(Exception):
    """A campaign that cannot be run, or measured nothing."""


@dataclass(frozen=True)
class Model:
    """A Verilated model as its build makes it."""

    name: str        # of its class
    top: str
    parameters: tuple  # of (name, value)
    sources: tuple   # beyond those that are found by their names
    control: tuple   # files that tell Verilator what tests reach into
    flags: tuple     # for the compiler


def commands(build, target):
    answer = subprocess.run(["ninja", "-C", str(build), "-t", "commands", target], check=False,
                            capture_output=True, text=True)
    if answer.returncode:
        raise MutantError(f"{build} has no {target}: make -C lab mutants builds it")
    return answer.stdout.splitlines()


def model(build, library):
    """The model in a library."""
    lines = [line for line in commands(build, library) if "verilate.sh" in line]
    if not lines:
        raise MutantError(f"{library} is not verilated")
    words = shlex.split(lines[-1].split("&&")[1])
    parameters = tuple(tuple(word[2:].split("=")) for word in words if re.match(r"-G\w+=", word))
    sources, control = (tuple(word for word in words if word.endswith(end)) for end in (".v", ".vlt"))
    return Model(words[1], words[words.index("--top-module") + 1], parameters, sources, control,
                 ("-O1", "-w", "-std=c++17", "-fPIC"))


def link(build, program, library, other, out):
    """Links a program once more, with another library in place of one."""
    line = commands(build, program)[-1]
    step = next((part for part in line.split("&&") if f" -o {program}" in part), "")
    if f" {library}" not in step:
        raise MutantError(f"{program} does not link {library}")
    words = shlex.split(step.replace(f" -o {program}", f" -o {out}"))
    result = subprocess.run([str(other) if word == library else word for word in words], cwd=build,
                            check=False, capture_output=True, text=True)
    if result.returncode:
        raise MutantError(f"{out}: {result.stderr.strip().splitlines()[-1]}")
    return pathlib.Path(out)
