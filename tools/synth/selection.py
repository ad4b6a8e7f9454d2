"""Which of the rows that yosys can map are asked for on a command line.

SPDX-License-Identifier: Apache-2.0
"""

from tools import command_line
from tools.synth import synthesis


class Parser(command_line.Parser):
    """Options that choose rows."""

    def __init__(self, **more):
        super().__init__(**more)
        self.add_argument("--target", help=", ".join(synthesis.TARGETS))
        self.add_argument("--org", help="rows of this organization only; unit: binary32 units")
        self.add_argument("--n", help="rows of so many units only")
        self.add_argument("--format", help="rows of this format only")


def columns(options):
    """What is asked for, None where anything is, and which of a subject's columns that is."""
    return {
        "TARGET": (options.target, lambda s: s.target),
        "ORG": (options.org, lambda s: s.row.org),
        "N": (options.n, lambda s: str(s.row.n)),
        "FORMAT": (options.format, lambda s: s.row.format),
    }


def chosen(subjects, name, options):
    """The subjects asked for, of the set `name`. Raises Request."""
    if name not in synthesis.SETS:
        raise command_line.Request(f"unknown SET '{name}': one of {', '.join(synthesis.SETS)}")
    left = synthesis.of_set(subjects, name)
    for word, (value, column) in columns(options).items():
        if value is None:
            continue
        values = list(dict.fromkeys(column(subject) for subject in subjects))
        if word == "TARGET":
            values = list(synthesis.TARGETS)
        if value not in values:
            raise command_line.Request(f"unknown {word} '{value}': one of {', '.join(values)}")
        left = [subject for subject in left if column(subject) == value]
    if not left:
        asked = ", ".join(f"{word}={value}" for word, (value, _) in columns(options).items()
                          if value)
        raise command_line.Request(f"no row is mapped for {asked} in the set '{name}'")
    return left
