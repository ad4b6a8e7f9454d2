"""A system with the core in it, by LiteX: `python3 -m soc.simulate`, `python3 -m soc.route`.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import sys

# The package that users install by itself.
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "litex_hwffd"))
