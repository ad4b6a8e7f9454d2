"""Stand-ins for the programs that flip bits and for yosys, which counts what HARDENED costs.

SPDX-License-Identifier: Apache-2.0
"""

import sys

GOOD, BAD = ("no_effect", "flagged", "silent"), ("no_effect", "flagged", "hang_stuck")
# So many flips of an outcome that depends on the core, the kind of bits and the seed.
_PROGRAM = """#!{python}
import sys, zlib
words = dict(zip(sys.argv[1::2], sys.argv[2::2]))
open(words["--design"]).close()
with open(words["--out"], "w") as out:
    print("# clocks 100 registers 8 memory_bits 64", file=out)
    print("clock,module,name,word,bit,outcome,recovered,restarted,outside_read", file=out)
    for flip in range(int(words["--flips"])):
        draw = zlib.crc32(f"{{sys.argv[0][-9:]}} {{words['--kind']}} {{words['--seed']}} {{flip}}".encode()) % 3
        print(f"{{flip}},ffd_{{draw}},u_x.q[{{flip}}],0,0,{{{outcomes}[draw]}},1,1,0", file=out)
"""
_YOSYS = """#!{python}
import json, re, sys
if sys.argv[1] == "-V":
    sys.exit(print("Yosys 1"))
flip_flop = {{"type": "TRELLIS_FF", "parameters": {{}}, "port_directions": {{}}, "connections": {{}}}}
hardened = "HARDENED 1" in sys.argv[-1]
top = re.search(r"-top (\\w+)", sys.argv[-1])[1]
json.dump({{"modules": {{top: {{"cells": {{str(n): flip_flop for n in range(2 + hardened)}}}}}}}},
          open(re.search(r"json -o (\\S+)", sys.argv[-1])[1], "w"))
"""


def programs(folder, designs, outcomes=GOOD):
    """{name: text} of those that flip bits, and of what they read."""
    text = _PROGRAM.format(python=sys.executable, outcomes=outcomes)
    return {path: content for name in ("stream", "stream-hardened", "axi", "axi-hardened")
            for path, content in ((f"{folder}/hwffd-upsets-{name}", text), (f"{designs}/{name}.json", "{}\n"))}


def yosys():
    return _YOSYS.format(python=sys.executable)
