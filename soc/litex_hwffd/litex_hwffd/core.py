"""The core as a module of LiteX, and how it joins a system.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
from types import SimpleNamespace

from litex.gen import LiteXModule
from litex.soc.integration.soc import SoCRegion
from litex.soc.interconnect import axi
from migen import ClockSignal, Instance, ResetSignal, Signal

from litex_hwffd.bridge import AxiToWishbone
from litex_hwffd.sources import RtlError, sources

REGISTERS = 0x1000  # bytes

# What suits a bus of 32 bits that a processor shares: short bursts, small queues. A parameter that
# is given replaces it, and one that `hwffd core` has fixed; all are those of docs/datasheet.md section 6.
PARAMETERS = {"MAX_BURST": 16, "READ_DEPTH": 64, "WRITE_DEPTH": 64, "READ_OUTSTANDING": 2,
              "WRITE_OUTSTANDING": 2, "BUS_TIMEOUT": 65536, "DATA_WIDTH": 64,
              "ADDRESS_WIDTH": 32, "ID_WIDTH": 1}


def _fixed(files, top):
    """name -> value of what a core that `hwffd core` wrote has as constants in place of parameters.
    Raises RtlError."""
    path = next((path for path in map(pathlib.Path, files) if path.stem == top), None)
    if path is None:
        raise RtlError(f"no {top}.v among the sources of the core")
    module = path.read_text(encoding="utf-8").partition(f"\nmodule {top} ")[2].partition("\nendmodule")[0]
    return {name: int(value) for name, value in
            re.findall(r"^  localparam (\w+) += (\d+);", module, re.MULTILINE)}


class Hwffd(LiteXModule):
    """`hwffd_axi` with the buses of LiteX; the top of a folder of `hwffd core` is its one file.

    registers: AXI4-Lite, a slave; docs/registers.md
    dma:       AXI4, a master of DATA_WIDTH bits
    ev.irq:    high while an interrupt is enabled and set
    """

    def __init__(self, platform, rtl=None, top=None, **parameters):
        files, headers = sources(rtl)
        top = top or (pathlib.Path(files[0]).stem if len(files) == 1 else "hwffd_axi")
        for name in files:
            platform.add_source(name)
        for name in headers:
            platform.add_verilog_include_path(name)
        fixed = _fixed(files, top)
        self.parameters = {**{name: value for name, value in PARAMETERS.items() if name not in fixed},
                           **parameters}
        values = {**fixed, **self.parameters}
        self.registers = axi.AXILiteInterface(data_width=32, address_width=32)
        self.dma = axi.AXIInterface(data_width=values["DATA_WIDTH"], id_width=values["ID_WIDTH"],
                                    address_width=values["ADDRESS_WIDTH"])
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
