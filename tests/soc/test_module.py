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


def test_a_folder_of_one_core_will_do(tmp_path):
    (tmp_path / "core.v").write_text("")
    assert sources(tmp_path) == ([str(tmp_path / "core.v")], [str(tmp_path)])


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
