"""hwffd_axi between the bus models of cocotbext-axi: another reading of the AXI specification.

Coefficients, a lattice, vertices of it, a packet of an unknown kind and interleaved vertices lie in
memory; the results must be the model's, with and without pauses on every channel, and nothing but
the result area may be written.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import itertools
import os
import pathlib
import random
import struct

import cocotb
from cocotb.clock import Clock
from cocotb.regression import TestFactory
from cocotb.triggers import ClockCycles, RisingEdge, with_timeout
from cocotbext.axi import AxiBus, AxiLiteBus, AxiLiteMaster, AxiRam, AxiResp

ROOT = pathlib.Path(__file__).resolve().parents[2]
BEAT = 16
RING, RING_LOG2, PACKETS, RESULTS, AREA = 0x1000, 4, 0x2000, 0x40000, 0x4000
MEMORY = 1 << 20
GUARD = 0xA5
ID = 0x48464644


def registers():
    with open(ROOT / "rtl" / "bus" / "registers.csv", newline="") as table:
        return {row["register"]: int(row["offset"], 16) for row in csv.DictReader(table)}


def vectors():
    """Packets as bytes, and the results of all of them."""
    packets, results = [], []
    for line in pathlib.Path(os.environ["VECTORS"]).read_text().splitlines():
        kind, *beats = line.split()
        data = b"".join(bytes.fromhex(beat)[::-1] for beat in beats)
        (packets if kind == "packet" else results).append(data)
    return packets, b"".join(results)


class System:
    """The core, its memory and the bus of its registers."""

    def __init__(self, dut):
        self.dut = dut
        self.offset = registers()
        cocotb.start_soon(Clock(dut.aclk, 10, units="ns").start())
        reset = {"reset": dut.aresetn, "reset_active_level": False}
        self.ram = AxiRam(AxiBus.from_prefix(dut, "m_axi"), dut.aclk, size=MEMORY, **reset)
        self.bus = AxiLiteMaster(AxiLiteBus.from_prefix(dut, "s_axil"), dut.aclk, **reset)

    async def reset(self):
        self.dut.aresetn.value = 0
        await ClockCycles(self.dut.aclk, 5)
        self.dut.aresetn.value = 1
        await ClockCycles(self.dut.aclk, 2)

    def pause(self, seed):
        """Pauses at random on every channel of both buses."""
        for number, channel in enumerate((
                self.ram.write_if.aw_channel, self.ram.write_if.w_channel,
                self.ram.write_if.b_channel, self.ram.read_if.ar_channel,
                self.ram.read_if.r_channel, self.bus.write_if.aw_channel,
                self.bus.write_if.w_channel, self.bus.write_if.b_channel,
                self.bus.read_if.ar_channel, self.bus.read_if.r_channel)):
            chance = random.Random(seed * 100 + number)
            channel.set_pause_generator(chance.random() < 0.5 for _ in itertools.count())

    async def write(self, register, value):
        answer = await self.bus.write(self.offset[register], struct.pack("<I", value))
        assert answer.resp == AxiResp.OKAY, register

    async def read(self, register):
        answer = await self.bus.read(self.offset[register], 4)
        assert answer.resp == AxiResp.OKAY, register
        return struct.unpack("<I", answer.data)[0]

    async def prepare(self):
        for window, limit in (("READ_WINDOW", RESULTS - 1), ("WRITE_WINDOW", RESULTS + AREA - 1)):
            base = RESULTS if window == "WRITE_WINDOW" else 0
            for name, value in (("BASE", base), ("LIMIT", limit)):
                await self.write(f"{window}_{name}_LO", value)
                await self.write(f"{window}_{name}_HI", 0)
        await self.write("WINDOW_LOCK", 1)
        for name, value in (("RING_BASE_LO", RING), ("RING_BASE_HI", 0),
                            ("RING_LOG2_SIZE", RING_LOG2), ("RESULT_BASE_LO", RESULTS),
                            ("RESULT_BASE_HI", 0), ("RESULT_SIZE", AREA), ("IRQ_ENABLE", 1)):
            await self.write(name, value)

    def place(self, packets):
        self.ram.write(0, bytes([GUARD]) * MEMORY)
        address = PACKETS
        for index, packet in enumerate(packets):
            self.ram.write(address, packet)
            descriptor = struct.pack("<QII", address, len(packet), 0)
            self.ram.write(RING + BEAT * index, descriptor)
            address += len(packet)
        return self.ram.read(0, MEMORY)

    async def run(self, packets):
        before = self.place(packets)
        await self.write("RING_HEAD", len(packets))
        await self.write("CONTROL", 1)
        await with_timeout(RisingEdge(self.dut.irq_o), 2, "ms")
        return before


async def expect_results(dut, seed):
    """Pauses everywhere with that seed; none: none."""
    packets, wanted = vectors()
    system = System(dut)
    await system.reset()
    if seed is not None:
        system.pause(seed)
    assert await system.read("ID") == ID
    await system.prepare()
    before = await system.run(packets)
    count = await system.read("RESULT_COUNT")
    assert count * BEAT == len(wanted)
    assert await system.read("ERROR_STATUS") & 1, "the unknown packet is not flagged"
    assert await system.read("COUNTER_VERTICES_LO") == count
    got = system.ram.read(RESULTS, len(wanted))
    differing = sum(got[i:i + BEAT] != wanted[i:i + BEAT] for i in range(0, len(wanted), BEAT))
    assert differing == 0, f"{differing} of {count} results differ"
    after = system.ram.read(0, MEMORY)
    assert after[:RESULTS] == before[:RESULTS]
    assert after[RESULTS + len(wanted):] == before[RESULTS + len(wanted):]
    dut._log.info("compared %d results with the model", count)


results = TestFactory(expect_results)
results.add_option("seed", [None, 1, 2, 3])
results.generate_tests(prefix="model_")


@cocotb.test()
async def unmapped_and_read_only_registers_answer_slverr(dut):
    system = System(dut)
    await system.reset()
    assert (await system.bus.read(0xFFC, 4)).resp == AxiResp.SLVERR
    assert (await system.bus.write(0xFFC, b"\1\0\0\0")).resp == AxiResp.SLVERR
    assert (await system.bus.write(system.offset["ID"], b"\1\0\0\0")).resp == AxiResp.SLVERR
    await system.write("WINDOW_LOCK", 1)
    locked = system.offset["READ_WINDOW_BASE_LO"]
    assert (await system.bus.write(locked, b"\1\0\0\0")).resp == AxiResp.SLVERR
    assert await system.read("READ_WINDOW_BASE_LO") == 0
