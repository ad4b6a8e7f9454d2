"""The cores whose bits flip.

SPDX-License-Identifier: Apache-2.0
"""

# The programs, the top of each and whether it is hardened.
CORES = {"stream": ("hwffd_stream", False), "stream-hardened": ("hwffd_stream", True),
         "axi": ("hwffd_axi", False), "axi-hardened": ("hwffd_axi", True)}
KINDS = ("registers", "memories")


def tops():
    """The names of the cores of each top: a part of the campaign."""
    by_top = {}
    for name, (top, _) in CORES.items():
        by_top.setdefault(top, []).append(name)
    return by_top
