"""hwffd.core against the sources that it describes, and headers of modules as scripts read them.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from workspace import ROOT

import configurations
import core_file
import module_header
import rtl

CORE = (ROOT / "hwffd.core").read_text(encoding="utf-8")


class CoreFile(unittest.TestCase):
    def test_it_is_what_the_sources_say(self):
        self.assertEqual(core_file.stale(), [])

    def test_its_files_are_there(self):
        files = re.findall(r"^      - ([\w/]+\.(?:vh?|[ch]pp))(?::|$)", CORE, re.MULTILINE)
        for name in files:
            self.assertTrue((ROOT / name).is_file(), name)
        for entry in rtl.read_file_list(ROOT / "rtl/hwffd.f"):
            self.assertIn(f"rtl/{entry}", files)
        print(f"core file: {len(files)} files are there")

    def test_every_parameter_of_a_row_can_be_given(self):
        for name in configurations.read()[0].parameters:
            self.assertRegex(CORE, rf"(?m)^  {name}:$")

    def test_a_file_or_a_parameter_more_makes_it_stale(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            shutil.copytree(ROOT / "rtl", root / "rtl")
            for name in ("hwffd.core", "VERSION"):
                shutil.copy(ROOT / name, root)
            self.assertEqual(core_file.stale(root), [])
            top = root / "rtl/top/hwffd_axi.v"
            source = top.read_text()
            for what, change in (
                    ("parameter", lambda: top.write_text(source.replace("AXIS  ", "AXES  "))),
                    ("file", lambda: (root / "rtl/hwffd.f").write_text("+incdir+bus\ntop/hwffd_axi.v\n"
                                                                     "top/hwffd_stream.v\n"))):
                with self.subTest(what):
                    change()
                    done = subprocess.run(
                        [sys.executable, "-B", ROOT / "scripts/core_file.py", "--root", root,
                         "check"], stderr=subprocess.PIPE, text=True, check=False)
                    self.assertEqual((done.returncode, done.stderr), (
                        1, "core_file.py: hwffd.core: not what the sources say: run "
                           "scripts/core_file.py write\n"))
                    top.write_text(source)


class Header(unittest.TestCase):
    def test_tops(self):
        sources = rtl.Sources()
        stream = module_header.read(sources, "hwffd_stream")
        self.assertEqual(stream.parameters["FORMAT"], 18)
        self.assertEqual(stream.parameters["SCHEDULE"], 0)
        ports = {port.name: port for port in stream.ports}
        self.assertEqual((ports["s_axis_tdata"].direction, ports["s_axis_tdata"].width),
                         ("input", 128))
        self.assertEqual((ports["m_axis_tlast"].direction, ports["m_axis_tlast"].width),
                         ("output", 1))
        axi = module_header.read(sources, "hwffd_axi")
        source = rtl.strip_comments(sources.files["hwffd_axi"].read_text())
        lists = "".join((ROOT / f"rtl/bus/ffd_{bus}_ports.vh").read_text() for bus in ("axil", "axi"))
        self.assertEqual(len(axi.ports), len(re.findall(r"^ *(?:in|out)put ", source + lists, re.M)))
        self.assertEqual(len(axi.ports), 51)
        self.assertEqual(len(axi.parameters), len(re.findall(r"^  parameter ", source, re.M)))

    def test_complaints_name_the_module(self):
        with self.assertRaisesRegex(module_header.HeaderError, "no module nothing"):
            module_header.read(rtl.Sources(), "nothing")
        with self.assertRaisesRegex(module_header.HeaderError, "ffd_org_select: not a port"):
            module_header.read(rtl.Sources(), "ffd_org_select")


if __name__ == "__main__":
    unittest.main(verbosity=2)
