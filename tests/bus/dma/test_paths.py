"""No combinational path leads from an input of the bus to an output of the bus or of a stream, in the
netlist that yosys makes of the engine.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2] / "scripts"))
sys.dont_write_bytecode = True

import rtl  # noqa: E402

OUTPUTS = ["m_axi_arvalid", "m_axi_araddr", "m_axi_arlen", "m_axi_rready", "m_axi_awvalid",
           "m_axi_awaddr", "m_axi_awlen", "m_axi_wvalid", "m_axi_wdata", "m_axi_wlast",
           "m_axi_bready", "m_packet_valid", "m_packet_data", "m_packet_last", "s_result_ready"]
INPUTS = ["m_axi_arready", "m_axi_rvalid", "m_axi_rdata", "m_axi_rresp", "m_axi_rlast",
          "m_axi_awready", "m_axi_wready", "m_axi_bvalid", "m_axi_bresp", "m_packet_ready",
          "s_result_valid", "s_result_data", "s_result_last", "soft_reset_i"]


def cone(*assertions):
    """(status, output) of yosys, which backs up from outputs to registers and judges what it met."""
    sources = rtl.Sources()
    files = " ".join(sources.needed("ffd_dma_engine"))
    script = [f"read_verilog {files}", "hierarchy -check -top ffd_dma_engine", "proc", "flatten",
              "opt_clean"] + list(assertions)
    return rtl.run(["yosys", "-Q", "-T", "-q", "-p", "; ".join(script)])


def paths(outputs, inputs, verdict):
    ends = " ".join(f"o:{name}" for name in outputs)
    starts = " ".join(f"i:{name}" for name in inputs)
    return [f"select -set outputs {ends}", "select -set cone @outputs %ci*:-$dff",
            f"select -set inputs {starts}", f"select {verdict} @cone @inputs %i"]


class Paths(unittest.TestCase):
    def test_every_port_exists(self):
        ports = [f"select -assert-count 1 o:{name}" for name in OUTPUTS]
        ports += [f"select -assert-count 1 i:{name}" for name in INPUTS]
        self.assertEqual(cone(*ports), (0, ""))

    def test_none(self):
        self.assertEqual(cone(*paths(OUTPUTS, INPUTS, "-assert-none")), (0, ""))

    def test_a_path_would_be_seen(self):
        """idle_o follows ring_head_i within the clock."""
        self.assertEqual(cone(*paths(["idle_o"], ["ring_head_i"], "-assert-any")), (0, ""))
        status, _ = cone(*paths(["idle_o"], ["ring_head_i"], "-assert-none"))
        self.assertNotEqual(status, 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
