"""The program `hwffd` of a wheel: the programs of the package by their names. The command of an installed prefix has
more, and these too.

SPDX-License-Identifier: Apache-2.0
"""

import importlib
import signal
import sys

from hwffd import __version__

_PROGRAMS = {
    "core": ("hwffd.core_command", "write a core of one configuration as a folder by itself"),
    "warp": ("hwffd.volumes.warp_command", "resample an image volume"),
    "register": ("hwffd.volumes.register_command", "align two image volumes"),
}
USAGE = 2


def main() -> int:
    """The program; its exit status."""
    word = sys.argv[1] if len(sys.argv) > 1 else ""
    if word in ("-h", "--help"):
        print("usage: hwffd COMMAND ...\n\n" + "\n".join(f"  {name:<9} {text}" for name, (_, text) in _PROGRAMS.items())
              + "\n\nhwffd COMMAND --help shows the options of a command.")
        return 0
    if word == "--version":
        print(__version__)
        return 0
    if word not in _PROGRAMS:
        print(f"hwffd: {f'{word}: no such command' if word else 'a command is wanted'}: one of {', '.join(_PROGRAMS)}",
              file=sys.stderr)
        return USAGE
    del sys.argv[1]
    before = signal.signal(signal.SIGINT, signal.SIG_DFL)  # an interrupt of the imports ends it without a traceback
    module = importlib.import_module(_PROGRAMS[word][0])
    signal.signal(signal.SIGINT, before)
    return module.main()
