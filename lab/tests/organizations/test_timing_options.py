"""Speeds that are compared are those of code compiled alike: the models of the evaluators and eq. (1)
in C++ beside them have the same options of optimization and processor, and no threads. And the program reads
the count of operators that this build makes.

Called with the build folder and the name of a model.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib
import re
import shlex
import subprocess

REFERENCE = "organizations/reference.cpp"
# On speed, here: a model has no floating point that could be contracted.
WITHOUT_EFFECT = ("-fPIC", "-fmacro", "-fdebug", "-ffp-contract")


def effective(words):
    """What of a compiler's options decides on speed; of several of a kind the last counts."""
    options = {}
    for word in words:
        if re.match("-[Ofm]", word) and not word.startswith(WITHOUT_EFFECT):
            name, _, value = word.partition("=")
            options["-O" if name.startswith("-O") else name] = value or name
    return options


def words(build, file):
    """Those with which a file is compiled."""
    commands = json.loads((pathlib.Path(build) / "compile_commands.json").read_text())
    (command,) = (entry["command"] for entry in commands if entry["file"].endswith(file))
    return shlex.split(command)


def options(build, file):
    return effective(words(build, file))


def test_same_for_model_and_reference(arguments):
    build, model = arguments
    assert options(build, REFERENCE) == options(build, f"/V{model}.cpp")


def test_models_have_one_thread(arguments):
    """How a model is made from the RTL."""
    build, model = arguments
    result = subprocess.run(["ninja", "-C", build, "-t", "commands", model],
                            stdout=subprocess.PIPE, text=True, check=True)
    (line,) = (line for line in result.stdout.splitlines() if f"--prefix V{model} " in line)
    assert "--threads" not in shlex.split(line)


def test_operators_are_those_that_the_build_counts(arguments):
    build, _ = arguments
    (path,) = (word.partition("=")[2].strip('"') for word in words(build, "organizations/main.cpp")
               if word.startswith("-DHWFFD_OPERATORS="))
    result = subprocess.run(["ninja", "-C", build, "-t", "query", path], stdout=subprocess.PIPE, text=True, check=True)
    assert "configurations.csv" in result.stdout
