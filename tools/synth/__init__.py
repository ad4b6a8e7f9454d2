"""What yosys, routers and OpenSTA make of the RTL: `python3 -m tools.synth` maps rows.

SPDX-License-Identifier: Apache-2.0
"""
