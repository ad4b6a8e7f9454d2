"""From the AXI4 of the core's DMA to a Wishbone bus of 32 bits.

SPDX-License-Identifier: Apache-2.0
"""

from litex.gen import LiteXModule
from litex.soc.interconnect import wishbone
from litex.soc.interconnect.axi import RESP_OKAY, RESP_SLVERR
from migen import FSM, Array, Cat, If, NextState, NextValue, Signal, log2_int


class AxiToWishbone(LiteXModule):
    """Bursts of the DMA as classic cycles, with their errors.

    LiteX's own bridge answers OKAY whatever the bus says. This one answers SLVERR for a word whose
    cycle ended with `err`, and for one that was not answered in `timeout` clocks: then it gives up
    the cycle, so a slave that does not answer holds neither this master nor the bus. Between two
    beats it leaves the bus to the others for a clock. Reads and writes take turns, burst by burst.

    The DMA sends INCR bursts of whole beats at multiples of 16 (docs/interface.md section 8), and
    this takes no others. At 256 bits a burst may begin in the middle of its first beat, of which the
    lower half is then not on the bus; a half of a beat whose strobes are 0 is not written.
    """

    def __init__(self, axi, timeout=1024):
        self.wishbone = bus = wishbone.Interface(data_width=32, address_width=axi.address_width,
                                                 addressing="word")
        words = axi.data_width // 32
        assert words in (2, 4, 8)

        address = Signal(len(bus.adr))
        beats = Signal(9)          # of the burst, that are left
        word = Signal(max=words)   # of the beat
        writing = Signal()
        wrote = Signal()           # the burst before was one of writes
        late = Signal(max=timeout + 1)
        failed = Signal()          # of the beat that is read, of the burst that is written
        data = Array(Signal(32) for _ in range(words))
        strobes = Array(Signal(4) for _ in range(words))
        ended = Signal()
        wrong = Signal()

        self.comb += [
            bus.adr.eq(address),
            bus.dat_w.eq(data[word]),
            bus.sel.eq(strobes[word]),
            bus.we.eq(writing),
            wrong.eq(bus.err | (late == timeout)),
            ended.eq(bus.ack | wrong),
            axi.r.data.eq(Cat(*data)),
            axi.r.resp.eq(RESP_OKAY),
            axi.b.resp.eq(RESP_OKAY),
            If(failed, axi.r.resp.eq(RESP_SLVERR), axi.b.resp.eq(RESP_SLVERR)),
            axi.r.last.eq(beats == 1),
        ]
        shift = 2  # bits of an address inside a word
        places = slice(shift, shift + log2_int(words))  # of a word in its beat

        self.fsm = fsm = FSM(reset_state="IDLE")
        fsm.act("IDLE",
            NextValue(failed, 0),
            NextValue(late, 0),
            If(axi.aw.valid & (~axi.ar.valid | ~wrote),
                axi.aw.ready.eq(1),
                NextValue(address, axi.aw.addr[shift:]),
                NextValue(word, axi.aw.addr[places]),
                NextValue(beats, axi.aw.len + 1),
                NextValue(axi.b.id, axi.aw.id),
                NextValue(writing, 1),
                NextValue(wrote, 1),
                NextState("DATA"),
            ).Elif(axi.ar.valid,
                axi.ar.ready.eq(1),
                NextValue(address, axi.ar.addr[shift:]),
                NextValue(word, axi.ar.addr[places]),
                NextValue(beats, axi.ar.len + 1),
                NextValue(axi.r.id, axi.ar.id),
                *[NextValue(strobe, 0b1111) for strobe in strobes],
                NextValue(writing, 0),
                NextValue(wrote, 0),
                NextState("CYCLE"),
            )
        )
        # A beat to be written.
        fsm.act("DATA",
            axi.w.ready.eq(1),
            If(axi.w.valid,
                *[NextValue(data[i], axi.w.data[32*i:32*i + 32]) for i in range(words)],
                *[NextValue(strobes[i], axi.w.strb[4*i:4*i + 4]) for i in range(words)],
                NextState("CYCLE"),
            )
        )
        # A word on the bus.
        fsm.act("CYCLE",
            bus.cyc.eq(1),
            bus.stb.eq(late != timeout),
            NextValue(late, late + 1),
            If(ended,
                NextValue(late, 0),
                NextValue(failed, failed | wrong),
                NextValue(word, word + 1),
                NextValue(address, address + 1),
                If(~writing, NextValue(data[word], bus.dat_r)),
                If(word == words - 1,
                    NextValue(word, 0),
                    If(~writing,
                        NextState("READ"),
                    ).Else(
                        NextValue(beats, beats - 1),
                        If(beats == 1, NextState("WRITTEN")).Else(NextState("DATA")),
                    )
                )
            )
        )
        # A beat that has been read.
        fsm.act("READ",
            axi.r.valid.eq(1),
            If(axi.r.ready,
                NextValue(failed, 0),
                NextValue(beats, beats - 1),
                If(beats == 1, NextState("IDLE")).Else(NextState("CYCLE")),
            )
        )
        fsm.act("WRITTEN",
            axi.b.valid.eq(1),
            If(axi.b.ready, NextState("IDLE")),
        )
