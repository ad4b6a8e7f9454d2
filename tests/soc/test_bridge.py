"""AxiToWishbone in Migen's simulator: words, errors and silence of the bus, whatever the other side waits for.

SPDX-License-Identifier: Apache-2.0
"""

import random

import pytest
from litex.soc.interconnect import axi
from litex.soc.interconnect.axi import RESP_OKAY, RESP_SLVERR
from migen import run_simulation, passive

import soc  # noqa: F401  (the way to litex_hwffd)
from litex_hwffd import AxiToWishbone

TIMEOUT = 20
CLOCKS = 200_000


class Bench:
    """A bridge between a master that makes bursts and a memory of words; some words answer badly."""

    def __init__(self, width, seed, wrong=(), silent=()):
        self.random = random.Random(seed)
        self.axi = axi.AXIInterface(data_width=width, address_width=32, id_width=1)
        self.bridge = AxiToWishbone(self.axi, timeout=TIMEOUT)
        self.bytes, self.words = width // 8, width // 32
        self.memory, self.wrong, self.silent = {}, set(wrong), set(silent)
        self.cycles = 0        # on the bus, that were answered
        self.longest = 0       # clocks for which the bus was held without a break
        self.results = []

    def run(self, *bursts):
        run_simulation(self.bridge, [self.master(bursts), self.slave(), self.watchdog()])
        assert len(self.results) == len(bursts), "it hangs"
        return self.results

    @passive
    def watchdog(self):
        for _ in range(CLOCKS):
            yield
        raise AssertionError("it hangs")

    @passive
    def slave(self):
        bus, held = self.bridge.wishbone, 0
        while True:
            held = held + 1 if (yield bus.cyc) else 0
            self.longest = max(self.longest, held)
            if (yield bus.cyc) and (yield bus.stb) and self.random.random() < 0.7:
                word = (yield bus.adr)
                if word in self.silent:
                    yield
                    continue
                bad = word in self.wrong
                if (yield bus.we) and not bad:
                    assert (yield bus.sel) == 0b1111
                    self.memory[word] = (yield bus.dat_w)
                yield bus.dat_r.eq(self.memory.get(word, 0xDEAD0000 + word))
                yield (bus.err if bad else bus.ack).eq(1)
                self.cycles += 1
                yield
                held += 1
                yield bus.ack.eq(0)
                yield bus.err.eq(0)
            yield

    def pause(self):
        while self.random.random() < 0.3:
            yield

    def master(self, bursts):
        for kind, address, beats in bursts:
            yield from self.pause()
            result = yield from (self.read if kind == "read" else self.write)(address, beats)
            self.results.append(result)

    def ask(self, channel, address, beats):
        for name, value in (("valid", 1), ("addr", address), ("len", beats - 1), ("id", 1)):
            yield getattr(channel, name).eq(value)
        yield
        while not (yield channel.ready):
            yield
        yield channel.valid.eq(0)

    def read(self, address, beats):
        """[(data, response)] of a burst."""
        yield from self.ask(self.axi.ar, address, beats)
        taken = []
        while len(taken) < beats:
            yield from self.pause()
            yield self.axi.r.ready.eq(1)
            yield
            while not (yield self.axi.r.valid):
                yield
            taken.append(((yield self.axi.r.data), (yield self.axi.r.resp)))
            assert (yield self.axi.r.last) == (len(taken) == beats)
            assert (yield self.axi.r.id) == 1
            yield self.axi.r.ready.eq(0)
            yield
        return taken

    def write(self, address, beats):
        """The response of a burst whose words are their own numbers, from its address on."""
        yield from self.ask(self.axi.aw, address, beats)
        inside = address % self.bytes  # of the first beat
        for beat in range(beats):
            yield from self.pause()
            first = (address - inside) // 4 + beat * self.words
            yield self.axi.w.data.eq(sum((first + i) << 32 * i for i in range(self.words)))
            yield self.axi.w.strb.eq(2 ** self.bytes - (1 if beat else 2 ** inside))
            yield self.axi.w.last.eq(beat == beats - 1)
            yield self.axi.w.valid.eq(1)
            yield
            while not (yield self.axi.w.ready):
                yield
            yield self.axi.w.valid.eq(0)
        yield self.axi.b.ready.eq(1)
        yield
        while not (yield self.axi.b.valid):
            yield
        response = (yield self.axi.b.resp)
        assert (yield self.axi.b.id) == 1
        yield self.axi.b.ready.eq(0)
        return response


def data(words, memory):
    return sum(memory(word) << 32 * place for place, word in enumerate(words))


@pytest.mark.parametrize("width", (64, 128, 256))
@pytest.mark.parametrize("seed", range(5))
def test_what_is_written_is_read(width, seed):
    bench = Bench(width, seed)
    beats = bench.random.randint(1, 16)
    at = 0x40000000
    results = bench.run(("write", at, beats), ("read", at, beats + 1), ("write", at + 4096, 1), ("read", at + 4096, 1))
    first = at // 4
    written = beats * bench.words
    words = [range(first + i * bench.words, first + (i + 1) * bench.words) for i in range(beats + 1)]
    assert results[0] == results[2] == RESP_OKAY
    assert results[1] == [(data(group, lambda word: word if word < first + written else 0xDEAD0000 + word),
                           RESP_OKAY) for group in words]
    assert bench.cycles == written + (beats + 1) * bench.words + 2 * bench.words


@pytest.mark.parametrize("seed", range(5))
def test_a_wide_burst_begins_in_the_middle_of_a_beat(seed):
    """As the DMA's may at 256 bits: at an odd multiple of 16."""
    bench = Bench(256, seed)
    at, beats = 0x40000010, bench.random.randint(1, 16)
    first, end = at // 4, at // 4 + 8 * beats - 4
    written, ((half, response), *whole) = bench.run(("write", at, beats), ("read", at, beats))
    assert (written, response) == (RESP_OKAY, RESP_OKAY)
    assert bench.memory == {word: word for word in range(first, end)}
    assert half >> 128 == data(range(first, first + 4), int)
    assert whole == [(data(range(word, word + 8), int), RESP_OKAY) for word in range(first + 4, end, 8)]
    assert bench.cycles == 2 * (end - first)


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize("kind", ("wrong", "silent"))
def test_a_word_that_fails_is_an_error_of_its_beat(seed, kind):
    at, beats = 0x40000100, 8
    bad = at // 4 + random.Random(seed).randrange(2 * beats)
    bench = Bench(64, seed, **{kind: [bad]})
    read, after = bench.run(("read", at, beats), ("read", at + 0x400, 2))
    assert [response for _, response in read] == [
        RESP_SLVERR if bad in (at // 4 + 2 * beat, at // 4 + 2 * beat + 1) else RESP_OKAY for beat in range(beats)]
    assert [response for _, response in after] == [RESP_OKAY, RESP_OKAY]


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize("kind", ("wrong", "silent"))
def test_a_word_that_fails_is_an_error_of_its_write(seed, kind):
    at, beats = 0x40000100, 8
    bad = at // 4 + random.Random(seed).randrange(2 * beats)
    bench = Bench(64, seed, **{kind: [bad]})
    assert bench.run(("write", at, beats), ("write", at + 0x400, 2)) == [RESP_SLVERR, RESP_OKAY]
    assert bad not in bench.memory
    assert len(bench.memory) == 2 * beats - 1 + 4  # the others were written


def test_a_slave_that_does_not_answer_does_not_keep_the_bus():
    at = 0x40000000
    silent = range(at // 4, at // 4 + 8)
    bench = Bench(64, 1, silent=silent)
    bench.run(("read", at, 4))
    assert TIMEOUT < bench.longest <= 2 * TIMEOUT + 6  # both words of a beat
