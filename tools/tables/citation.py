"""CITATION.cff, with the version of the file VERSION.

SPDX-License-Identifier: Apache-2.0
"""

from tools.tables import version

NAME = "CITATION.cff"
_TEXT = """\
# Made by python3 -m tools.tables.generated_files write; changes here are lost.
cff-version: 1.2.0
message: "If you use hwffd, please cite it, and the paper whose organizations it implements."
title: "hwffd: an open hardware evaluator for free-form deformation"
type: software
authors:
  - name: "The hwffd developers"
license: Apache-2.0
version: {version}
keywords: [free-form deformation, hardware, Verilog, FPGA, B-splines, fixed point, computer graphics]
references:
  - type: conference-paper
    title: "Hardware-Accelerated Free-Form Deformation"
    year: 2000
    authors:
      - family-names: Chua
        given-names: Clint
      - family-names: Neumann
        given-names: Ulrich
    conference:
      name: "ACM SIGGRAPH/Eurographics Workshop on Graphics Hardware"
"""


def text(root):
    return _TEXT.format(version=version.read(root))
