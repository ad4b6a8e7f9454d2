"""The table of registers: what is wrong with it is said in one line; what is made from it is up to
date, and is noticed when it is not.

SPDX-License-Identifier: Apache-2.0
"""

import contextlib
import io
import unittest

from workspace import ROOT, Workspace

import registers
import version
from made_files import expect_stale_is_noticed

TEXT = (ROOT / registers.TABLE).read_text()
OF_TABLE = ("rtl/bus/ffd_axil_registers.v", "driver/include/hwffd/registers.h", "docs/registers.md")
OF_EVENTS = ("rtl/stream/ffd_events.vh", "golden/include/hwffd/stream/events.hpp")
MADE = (*OF_TABLE, *OF_EVENTS, version.HEADER)

# what -> (text of the table, its replacement, words of the message)
FAULTS = {
    "another header": ("offset,register", "address,register", ":1: the first line must be"),
    "a column too few": ('0x048,RING_LOG2_SIZE,value,3:0,rw,0,,',
                         "0x048,RING_LOG2_SIZE,value,3:0,rw,0,",
                         "7 columns, 8 wanted"),
    "an offset off the words": ("0x048,RING_LOG2_SIZE", "0x04A,RING_LOG2_SIZE", "offset '0x04A'"),
    "an offset that is no number": ("0x048,RING_LOG2_SIZE", "72,RING_LOG2_SIZE", "offset '72'"),
    "an offset below the one before": ("0x048,RING_LOG2_SIZE", "0x040,RING_LOG2_SIZE",
                                       "RING_LOG2_SIZE is not above"),
    "a register at two offsets": ("0x048,RING_LOG2_SIZE", "0x048,STATUS",
                                  "STATUS has another offset"),
    "a register in small letters": ("0x048,RING_LOG2_SIZE", "0x048,ring_log2_size",
                                    "bad register 'ring_log2_size'"),
    "a field in capitals": ("RING_LOG2_SIZE,value", "RING_LOG2_SIZE,VALUE", "bad field 'VALUE'"),
    "bits the wrong way": ("value,3:0", "value,0:3", "bits '0:3'"),
    "a bit too high": ("value,3:0", "value,32", "bits '32'"),
    "an unknown access": ("3:0,rw,0", "3:0,rx,0", "unknown access 'rx'"),
    "a reset value too large": ("3:0,rw,0", "3:0,rw,16", "reset '16' is not a number of 4 bits"),
    "a reset value that is none": ("3:0,rw,0", "3:0,rw,a", "reset 'a'"),
    "a reset value of the hardware's": ("busy,0,ro,,", "busy,0,ro,0,", "has no reset value"),
    "a wide pulse": ("soft_reset,1,w1", "soft_reset,4:3,w1", "has one bit"),
    "no description": ('"Bytes of the result area."', "", "no description"),
    "bits taken twice": ("soft_reset,1,w1", "soft_reset,0,w1", "CONTROL.soft_reset: its bits"),
    "a field twice": ("CONTROL,soft_reset", "CONTROL,start", "CONTROL.start is there twice"),
    "a link to nothing": ("with:STATUS.done", "with:STATUS.gone", "does not name a field"),
    "a link to the wrong access": ("with:STATUS.done", "with:STATUS.busy", "of access w1c"),
    "a link that the access has not": ("with:STATUS.done", "locked:WINDOW_LOCK.windows",
                                       "is not one of a field of access w1c"),
    "a lock on half a register": ("IRQ_ENABLE,done,0,rw,0,",
                                  "IRQ_ENABLE,done,0,rw,0,locked:WINDOW_LOCK.windows",
                                  "IRQ_ENABLE: one lock"),
    "a refusal without a bit": (" refused:STATUS.start_refused", "",
                                "unless and needs want refused"),
    "a hole in the events": ("packet_long,2,event", "packet_long,31,event", "events take"),
    "a version that the field is no part of": ("3:0,rw,0", "3:0,rw,version", "reset 'version'"),
    "no record": ("ERROR_PACKET", "ERROR_PLACE", "no ERROR_PACKET.value"),
    "another interrupt": ("IRQ_ENABLE,refused", "IRQ_ENABLE,denied", "fields of IRQ_STATE"),
}


def run(*arguments):
    out = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
        status = registers.main([str(argument) for argument in arguments])
    return status, out.getvalue().splitlines()


class Registers(Workspace):
    def setUp(self):
        super().setUp()
        for name in (registers.TABLE, registers.PREAMBLE, version.FILE, *MADE):
            self.copy(name)

    def test_faults_of_the_table(self):
        refused = 0
        for what, (text, other, words) in FAULTS.items():
            with self.subTest(what):
                self.assertIn(text, TEXT)
                (self.root / registers.TABLE).write_text(TEXT.replace(text, other, 1))
                before = {name: (self.root / name).read_text() for name in MADE}
                status, lines = run("--root", self.root, "write")
                self.assertEqual((status, len(lines)), (1, 1), lines)
                self.assertIn(words, lines[0])
                self.assertTrue(lines[0].startswith("registers.py: "), lines)
                self.assertEqual(before, {name: (self.root / name).read_text() for name in MADE})
                refused += 1
        print(f"registers: {refused} of {len(FAULTS)} bad tables refused")

    def test_no_table(self):
        (self.root / registers.TABLE).unlink()
        status, lines = run("--root", self.root, "list")
        self.assertEqual((status, len(lines)), (1, 1), lines)

    def test_what_is_committed_is_up_to_date(self):
        self.assertEqual(registers.stale(ROOT), [])
        self.assertEqual(run("check"), (0, []))

    def test_what_is_stale_is_noticed(self):
        expect_stale_is_noticed(self, self.root, MADE, run)

    def test_a_change_of_the_table_reaches_all(self):
        (self.root / registers.TABLE).write_text(TEXT.replace("value,3:0,rw,0", "value,4:0,rw,5"))
        self.assertEqual(len(registers.stale(self.root)), len(OF_TABLE))
        self.assertEqual(run("--root", self.root, "write"), (0, []))
        for name, words in zip(OF_TABLE, ("ring_log2_size_o <= 5'h5;",
                               "RING_LOG2_SIZE_MASK 0x0000001Fu",
                                      "| 4:0 | `value` | rw | 0x5 |")):
            self.assertIn(words, (self.root / name).read_text())

    def test_an_event_renamed_reaches_rtl_and_model(self):
        (self.root / registers.TABLE).write_text(TEXT.replace(",no_lattice,4,", ",without_lattice,4,"))
        self.assertEqual(run("--root", self.root, "write"), (0, []))
        for name, words in zip(OF_EVENTS, ("`define FFD_EVENT_WITHOUT_LATTICE      4\n",
                                           "  kWithoutLattice = 4,\n")):
            self.assertIn(words, (self.root / name).read_text())

    def test_list(self):
        status, lines = run("list")
        self.assertEqual((status, lines[0]), (0, "0x000 ID value(const)"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
