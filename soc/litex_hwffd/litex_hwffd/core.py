"""The core as a module of LiteX, and how it joins a system.

SPDX-License-Identifier: Apache-2.0
"""

from types import SimpleNamespace

from litex.gen import LiteXModule
from litex.soc.integration.soc import SoCRegion
from litex.soc.interconnect import axi
from migen import ClockSignal, Instance, ResetSignal, Signal

from litex_hwffd.bridge import AxiToWishbone
from litex_hwffd.sources import sources

REGISTERS = 0x1000  # bytes

# What suits a bus of 32 bits that a processor shares: short bursts, small queues. A parameter that
# is given replaces it; all are those of docs/datasheet.md section 6.
PARAMETERS = {"MAX_BURST": 16, "READ_DEPTH": 64, "WRITE_DEPTH": 64, "READ_OUTSTANDING": 2,
              "WRITE_OUTSTANDING": 2, "BUS_TIMEOUT": 65536, "DATA_WIDTH": 64,
              "ADDRESS_WIDTH": 32, "ID_WIDTH": 1}


class Hwffd(LiteXModule):
    """`hwffd_axi` with the buses of LiteX.

    registers: AXI4-Lite, a slave; docs/registers.md
    dma:       AXI4, a master of DATA_WIDTH bits
    ev.irq:    high while an interrupt is enabled and set
    """

    def __init__(self, platform, rtl=None, top="hwffd_axi", **parameters):
        files, headers = sources(rtl)
        for name in files:
            platform.add_source(name)
        for name in headers:
            platform.add_verilog_include_path(name)
        self.parameters = {**PARAMETERS, **parameters}
        width = self.parameters["ADDRESS_WIDTH"]
        self.registers = axi.AXILiteInterface(data_width=32, address_width=32)
        self.dma = axi.AXIInterface(data_width=self.parameters["DATA_WIDTH"], address_width=width,
                                    id_width=self.parameters["ID_WIDTH"])
        self.ev = SimpleNamespace(irq=Signal())
        self.sleep = Signal()
        self.specials += Instance(top, **self.ports(), **{
            f"p_{name}": value for name, value in self.parameters.items()})

    def ports(self):
        """Of the instance, by their names there."""
        ports = {"i_aclk": ClockSignal("sys"), "i_aresetn": ~ResetSignal("sys"),
                 "o_irq_o": self.ev.irq, "o_sleep_o": self.sleep}
        slave, master = self.registers, self.dma
        for channel, names in (("aw", ("addr", "prot")), ("w", ("data", "strb")),
                               ("ar", ("addr", "prot"))):
            port = getattr(slave, channel)
            ports[f"i_s_axil_{channel}valid"] = port.valid
            ports[f"o_s_axil_{channel}ready"] = port.ready
            for name in names:
                signal = getattr(port, name)
                ports[f"i_s_axil_{channel}{name}"] = signal[:12] if name == "addr" else signal
        for channel, names in (("b", ("resp",)), ("r", ("data", "resp"))):
            port = getattr(slave, channel)
            ports[f"o_s_axil_{channel}valid"] = port.valid
            ports[f"i_s_axil_{channel}ready"] = port.ready
            for name in names:
                ports[f"o_s_axil_{channel}{name}"] = getattr(port, name)
        address = ("id", "addr", "len", "size", "burst", "cache", "prot")
        for channel, names in (("ar", address), ("aw", address), ("w", ("data", "strb", "last"))):
            port = getattr(master, channel)
            ports[f"o_m_axi_{channel}valid"] = port.valid
            ports[f"i_m_axi_{channel}ready"] = port.ready
            for name in names:
                ports[f"o_m_axi_{channel}{name}"] = getattr(port, name)
        for channel, names in (("r", ("data", "resp", "last")), ("b", ("resp",))):
            port = getattr(master, channel)
            ports[f"i_m_axi_{channel}valid"] = port.valid
            ports[f"o_m_axi_{channel}ready"] = port.ready
            for name in names:
                ports[f"i_m_axi_{channel}{name}"] = getattr(port, name)
        return ports


def add_hwffd(soc, name="hwffd", origin=None, rtl=None, **parameters):
    """Adds the core to a system: registers, DMA and interrupt, all by that name.

    The registers lie at `origin`, or where LiteX finds room for devices. The DMA is a master of the
    system's bus, as the processor is, and reaches what that reaches; caches of the processor do not
    know what it writes. Returns the core.
    """
    core = Hwffd(soc.platform, rtl, **parameters)
    setattr(soc, name, core)
    soc.bus.add_slave(name, core.registers,
                      SoCRegion(origin=origin, size=REGISTERS, cached=False))
    if soc.bus.standard == "wishbone":
        bridge = AxiToWishbone(core.dma)
        setattr(soc, f"{name}_bridge", bridge)
        soc.bus.add_master(name, bridge.wishbone)
    else:
        soc.bus.add_master(name, core.dma)
    if soc.irq.enabled:
        soc.irq.add(name, use_loc_if_exists=True)
    return core
