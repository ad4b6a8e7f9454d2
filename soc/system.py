"""The system that `make soc` simulates and routes: VexRiscv, memories and the core, by LiteX.

SPDX-License-Identifier: Apache-2.0
"""

from litex.gen import LiteXModule
from litex.soc.integration.soc_core import SoCCore
from litex.soc.interconnect import wishbone
from litex.soc.interconnect.csr import CSRStorage
from litex_hwffd import add_hwffd
from migen import Signal

ROM = 0x8000   # bytes: the program
SRAM = 0x4000  # its data and stack
CPU = "VexRiscv"


class Faults(LiteXModule):
    """Between a master and the bus: one word that is answered with an error, or not at all."""

    def __init__(self, inner):
        self.outer = outer = wishbone.Interface(data_width=32, address_width=32, addressing="word")
        self.address = CSRStorage(32, description="Of the word, in bytes.")
        self.kind = CSRStorage(2, description="0 no fault, 1 an error, 2 no answer.")
        hit = Signal()
        error = Signal()
        self.comb += [
            hit.eq((self.kind.storage != 0) & (inner.adr == self.address.storage[2:])),
            inner.connect(outer, omit={"cyc", "ack", "err"}),
            outer.cyc.eq(inner.cyc & ~hit),
            inner.ack.eq(outer.ack & ~hit),
            inner.err.eq(outer.err & ~hit | error),
        ]
        self.sync += error.eq(inner.cyc & inner.stb & hit & (self.kind.storage == 1) & ~error)


class System(SoCCore):
    """A processor, `memory` bytes for meshes, and the core with the parameters `core`."""

    def __init__(self, platform, clock_hz, rtl, core, memory, faults=False, **more):
        SoCCore.__init__(
            self, platform, clk_freq=clock_hz, cpu_type="vexriscv", cpu_variant="standard",
            integrated_rom_size=ROM, integrated_sram_size=SRAM, integrated_main_ram_size=memory,
            ident="hwffd", ident_version=False, timer_uptime=True, **more)
        add_hwffd(self, rtl=rtl, **core)
        if faults:
            self.faults = Faults(self.bus.masters["hwffd"])
            self.bus.masters["hwffd"] = self.faults.outer
