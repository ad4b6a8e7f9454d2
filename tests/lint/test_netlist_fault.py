"""scripts/netlist_fault.py: one LUT of the unit is inverted, nothing else; where there is none it says so.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parent.parent.parent / "scripts" / "netlist_fault.py"
LUT = "  LUT4 #(\n    .INIT(16'h{})\n  ) a (.A(x), .Z(y));\n"


def module(name, *tables):
    return f"module {name} (x, y);\n" + "".join(LUT.format(table) for table in tables) + "endmodule\n"


class Fault(unittest.TestCase):
    def spoil(self, text):
        """Exit status, complaints, the copy or None."""
        with tempfile.TemporaryDirectory() as folder:
            good, out = pathlib.Path(folder) / "good.v", pathlib.Path(folder) / "fault.v"
            if text is not None:
                good.write_text(text)
            done = subprocess.run([sys.executable, "-B", str(SCRIPT), str(good), str(out)],
                                  capture_output=True, text=True, check=False)
            return (done.returncode, done.stderr.splitlines(),
                    out.read_text() if out.exists() else None)

    def test_the_first_lut_of_the_unit_is_inverted(self):
        term = r"\$paramod$61b70be1\ffd_num_term"
        others = module("other", "1234"), module("last", "ffff")
        status, errors, copy = self.spoil(others[0] + module(term, "00fe", "8001") + others[1])
        self.assertEqual((status, errors), (0, []))
        self.assertEqual(copy, others[0] + module(term, "ff01", "8001") + others[1])

    def test_the_lut_of_another_module_is_left_alone(self):
        status, errors, copy = self.spoil(module("ffd_num_term") + module("other", "1234"))
        self.assertEqual((status, copy), (1, None))
        self.assertEqual(len(errors), 1)
        self.assertRegex(errors[0], "no LUT4 in ffd_num_term")

    def test_a_netlist_that_is_not_there_is_one_line(self):
        status, errors, copy = self.spoil(None)
        self.assertEqual((status, len(errors), copy), (1, 1, None))


if __name__ == "__main__":
    unittest.main(verbosity=2)
