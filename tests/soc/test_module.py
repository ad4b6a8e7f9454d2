"""litex_hwffd: its instance has the ports and parameters of hwffd_axi, and joins a system of LiteX.

SPDX-License-Identifier: Apache-2.0
"""

import logging
import os
import re
import shutil
import subprocess
import sys

import pytest
from litex.build.generic_platform import Pins
from litex.build.io import CRG
from litex.build.sim import SimPlatform
from litex.soc.integration.soc_core import SoCMini

import soc  # noqa: F401  (the way to litex_hwffd)
from litex_hwffd import Hwffd, RtlError, add_hwffd, sources
from tools.project_root import ROOT
from tools.tables import version

RTL = ROOT / "rtl"
TOP = (RTL / "top" / "hwffd_axi.v").read_text(encoding="utf-8")
PARAMETERS = dict(re.findall(r"^  parameter (\w+) += ([^,\n]+)", TOP, re.MULTILINE))
PORTS = {name: way for way, name in
         re.findall(r"^  (input|output) +wire +(?:\[[^\]]+\] )? *(\w+),?$", TOP, re.MULTILINE)}


@pytest.fixture(autouse=True)
def quiet():
    logging.disable(logging.WARNING)


@pytest.fixture
def platform():
    return SimPlatform("SIM", [("sys_clk", 0, Pins(1))])


def test_ports_are_those_of_the_top(platform):
    assert len(PORTS) > 50
    given = Hwffd(platform, RTL).ports()
    ways = {name[2:]: {"i": "input", "o": "output"}[name[0]] for name in given}
    assert ways == PORTS


def test_parameters_are_those_of_the_top(platform):
    core = Hwffd(platform, RTL, ORG=1)
    assert set(core.parameters) <= set(PARAMETERS)
    assert core.parameters["ORG"] == 1


def test_sources_are_those_of_the_list(platform):
    Hwffd(platform, RTL)
    lines = (RTL / "hwffd.f").read_text(encoding="utf-8").splitlines()
    files = [line for line in lines if line.endswith(".v")]
    assert len(files) > 100
    assert [name for name, *_ in platform.sources] == [str(RTL / name) for name in files]
    assert all(os.path.isdir(path) for path in platform.verilog_include_paths)


@pytest.mark.parametrize("fixed", ({"DATA_WIDTH": 128, "ADDRESS_WIDTH": 40, "ID_WIDTH": 3, "MAX_BURST": 256, "BUS_TIMEOUT": 0}, {}))
def test_a_folder_of_one_core_will_do(platform, tmp_path, fixed):
    """As `hwffd core` writes it: what is fixed is no parameter, and the testbench no source."""
    constants = "".join(f"  localparam {name:<13} = {value};\n" for name, value in fixed.items())
    (tmp_path / "core.v").write_text(f"// core\n\nmodule core #(\n  parameter READ_OUTSTANDING = 8\n) (\n);\n{constants}endmodule\n"
                                     "\nmodule core_part (\n);\n  localparam READ_DEPTH = 2;\nendmodule\n")
    (tmp_path / "core_tb.v").write_text("module core_tb;\nendmodule\n")
    assert sources(tmp_path) == ([str(tmp_path / "core.v")], [str(tmp_path)])
    core = Hwffd(platform, tmp_path)
    assert set(core.parameters) == set(Hwffd(platform, RTL).parameters) - set(fixed)
    (instance,) = (special for special in core.get_fragment().specials if special.of == "core")
    assert len(core.dma.r.data) == fixed.get("DATA_WIDTH", 64) and len(core.dma.ar.addr) == fixed.get("ADDRESS_WIDTH", 32)
    assert {item.name for item in instance.items if type(item).__name__ == "Parameter"} == set(core.parameters)


def test_a_top_that_is_not_there_is_one_line(platform):
    with pytest.raises(RtlError, match="^no other.v among the sources of the core$"):
        Hwffd(platform, RTL, top="other")


@pytest.mark.parametrize("folder", (None, "", "absent"))
def test_no_sources_are_one_line(tmp_path, monkeypatch, folder):
    monkeypatch.delenv("HWFFD_RTL", raising=False)
    with pytest.raises(RtlError) as error:
        sources(folder and tmp_path / folder)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("standard", ("wishbone", "axi"))
def test_joins_a_system(platform, tmp_path, standard):
    system = SoCMini(platform, 1e6, bus_standard=standard)
    add_hwffd(system, rtl=RTL, ORG=1, EVALUATOR=1, origin=0x9000_0000)
    system.crg = CRG(platform.request("sys_clk"))
    system.finalize()
    assert system.bus.regions["hwffd"].origin == 0x9000_0000
    assert list(system.bus.masters) == ["hwffd"]
    text = str(platform.get_verilog(system.get_fragment(), name="top"))
    (instance,) = re.findall(r"^hwffd_axi #\(\n(.*?)\n\) hwffd_axi \(\n(.*?)^\);", text,
                             re.MULTILINE | re.DOTALL)
    assert {name for name in re.findall(r"\.(\w+)\s*\(", instance[1])} == set(PORTS)


def test_can_be_installed_by_itself(tmp_path):
    result = subprocess.run(
        [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation", "--no-index",
         "--wheel-dir", str(tmp_path), str(copied(tmp_path))], capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr
    (wheel,) = tmp_path.glob("*.whl")
    assert wheel.name.split("-")[1] == str(version.read(ROOT))
    names = subprocess.run([sys.executable, "-m", "zipfile", "-l", str(wheel)], capture_output=True, text=True,
                           check=True).stdout
    for name in ("__init__", "bridge", "core", "sources"):
        assert f"litex_hwffd/{name}.py" in names


def copied(folder):
    """The package elsewhere: what is built of it lies beside its sources."""
    return shutil.copytree(ROOT / "soc" / "litex_hwffd", folder / "litex_hwffd",
                           ignore=shutil.ignore_patterns("__pycache__"))
