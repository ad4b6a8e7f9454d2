"""Tables of formats and of the stream's fields: what is refused; and the files made from tables: that
they are up to date, and that it is noticed when they are not.

SPDX-License-Identifier: Apache-2.0
"""

import contextlib
import io
import unittest

from workspace import ROOT, Workspace

import formats
import made
import stream_words
import version
from made_files import expect_stale_is_noticed
from tables import TableError

FP32 = "fp32,,0,float,Binary32,Binary32Fused,binary32\n"
FIELDS = (ROOT / stream_words.TABLE).read_text()

# what is wrong -> (rows, line or None, words of the message)
FORMATS = {
    "no rows": ("", None, "no formats"),
    "column missing": ("fp32,,0\n", 2, "3 columns, 7 wanted"),
    "name in capitals": (FP32.replace("fp32", "FP32"), 2, "bad format 'FP32'"),
    "unknown words": (FP32.replace("float", "posit"), 2, "one of float, block, fixed"),
    "no number": (FP32.replace(",0,", ",,"), 2, "number is '', 0 to 255 wanted"),
    "number too large": (FP32.replace(",0,", ",256,"), 2, "number is '256', 0 to 255 wanted"),
    "number of a family": ("fx,12-32,4,fixed,Fixed,,fixed\n", 2, "the width is it"),
    "family of odd widths": ("fx,12-40,,fixed,Fixed,,fixed\n", 2, "two numbers of 8 to 32 wanted"),
    "no class": (FP32.replace("Binary32,", ",", 1), 2, "bad model ''"),
    "twice": (FP32 + FP32, 3, "format 'fp32' is there twice"),
    "number twice": (FP32 + FP32.replace("fp32", "fp16"), 3, "number 0 is that of 'fp32'"),
}

# what is wrong -> (text of the table, its replacement, line or None, words of the message)
WRONG_FIELDS = {
    "unknown word": ("user,tag", "vertex,tag", 2, "one of user, retire, status"),
    "field in capitals": ("user,tag", "user,TAG", 2, "bad field 'TAG'"),
    "field twice": ("user,status", "user,tag", 3, "is there twice"),
    "no bits": ("15:0", "", 2, "bits is ''"),
    "bits the wrong way": ("15:0", "0:15", 2, "from bit 0 on wanted"),
    "a gap": ("user,blank,22", "user,blank,23", 4, "from bit 22 on wanted"),
    "no description": (",of the last vertex of its packet", ",", 5, "no description"),
    "no status": ("user,status", "user,state", None, "no status in user"),
}


def run(*arguments):
    """(exit status, complaints)"""
    errors = io.StringIO()
    with contextlib.redirect_stderr(errors):
        status = made.main([str(argument) for argument in arguments])
    return status, errors.getvalue().splitlines()


class Made(Workspace):
    def setUp(self):
        super().setUp()
        self.copy("rtl")
        self.copy(version.FILE)
        for name in made.outputs(ROOT):
            self.copy(name)

    def refused(self, table, read, text, line, words):
        path = self.root / table
        path.write_text(text)
        with self.assertRaises(TableError) as caught:
            read(self.root)
        message = str(caught.exception)
        self.assertIn(words, message)
        self.assertTrue(message.startswith(f"{path}:{line}: " if line else f"{path}: "), message)
        status, lines = run("--root", self.root, "write")
        self.assertEqual((status, len(lines)), (1, 1), lines)

    def test_bad_formats(self):
        for what, (rows, line, words) in FORMATS.items():
            with self.subTest(what):
                self.refused(formats.TABLE, formats.read,
                             ",".join(formats.COLUMNS) + "\n" + rows, line, words)
        print(f"formats: {len(FORMATS)} bad tables refused")

    def test_formats(self):
        found = formats.read()
        numbers = {"fp32": 0, "bfp32": 99, **{f"fx{width}": width for width in range(12, 33)}}
        self.assertEqual({name: one.number for name, one in found.by_name.items()}, numbers)
        self.assertEqual(found.summary, "fp32, bfp32, or fx12 to fx32")
        for name in ("bfp18", "fx11", "fx33", "fx018", "", "FP32"):
            with self.assertRaisesRegex(TableError, "^here: unknown format '.*': fp32, bfp32, or"):
                found.find(name, "here")

    def test_bad_fields(self):
        for what, (text, other, line, words) in WRONG_FIELDS.items():
            with self.subTest(what):
                self.assertIn(text, FIELDS)
                self.refused(stream_words.TABLE, stream_words.read,
                             FIELDS.replace(text, other, 1), line, words)
        print(f"fields: {len(WRONG_FIELDS)} bad tables refused")

    def test_a_field_moved_reaches_rtl_and_model(self):
        moved = FIELDS.replace("clamped,1,", "nan,1,").replace("nan,2,", "clamped,2,")
        (self.root / stream_words.TABLE).write_text(moved)
        self.assertEqual(run("--root", self.root, "write"), (0, []))
        self.assertIn("`define FFD_STATUS_CLAMPED   2", (self.root / stream_words.RTL).read_text())
        self.assertIn("kStatusClamped = 1U << 18;", (self.root / stream_words.HEADER).read_text())

    def test_what_is_committed_is_up_to_date(self):
        self.assertEqual(run("check"), (0, []))

    def test_what_is_stale_is_noticed(self):
        names = list(made.outputs(self.root))
        self.assertEqual(len(names), 6)
        expect_stale_is_noticed(self, self.root, names, run)

    def test_a_new_source_is_listed(self):
        (self.root / "rtl/number/fixed/ffd_fx_new.v").write_text("module ffd_fx_new; endmodule\n")
        self.assertEqual(run("--root", self.root, "write"), (0, []))
        for name in ("rtl/hwffd.f", "hwffd.core"):
            self.assertIn("number/fixed/ffd_fx_new.v\n", (self.root / name).read_text())


if __name__ == "__main__":
    unittest.main(verbosity=2)
