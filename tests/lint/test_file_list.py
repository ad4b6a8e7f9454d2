"""The file list as users take it: in Verilator and Icarus, from any folder, beside files of their own which
have a time unit or none.

SPDX-License-Identifier: Apache-2.0
"""

import shutil
import subprocess

import pytest

from tools.project_root import ROOT
from tools.rtl import rtl_sources

USER = """{unit}
module user_top (input wire clk, input wire rst, output wire idle);
  hwffd_stream u_ffd (
    .aclk(clk), .aresetn(!rst), .s_axis_tvalid(1'b0), .s_axis_tready(), .s_axis_tdata(128'd0),
    .s_axis_tlast(1'b0), .m_axis_tvalid(), .m_axis_tready(1'b1), .m_axis_tdata(), .m_axis_tlast(),
    .m_axis_tuser(), .grid_stop_i(1'b0), .event_o(), .event_packet_o(), .event_beat_o(), .vertex_o(),
    .second_o(), .wait_o(), .idle_o(idle), .upset_o()
  );
endmodule
"""
UNITS = {"none": "", "timescale": "`timescale 1ns/1ps", "another": "`timescale 100ps/10fs"}


@pytest.fixture(params=("as it is", "copied"))
def folder(request, checkout):
    """The folder of the list: that of the checkout, or a copy of it, as one that is installed."""
    if request.param == "as it is":
        return ROOT / "rtl"
    return shutil.copytree(ROOT / "rtl", checkout.root / "share" / "hwffd" / "rtl")


def verilated(checkout, *files):
    return checkout.run("verilator", "--lint-only", "-Wall", "-Wno-PINCONNECTEMPTY", "-Wno-DECLFILENAME",
                        "--top-module", "user_top", *map(str, files))


# make test takes a user's file with a time unit; test-all one without, and one with another, too.
EACH_UNIT = [unit if unit == "timescale" else pytest.param(unit, marks=pytest.mark.whole) for unit in UNITS]


@pytest.mark.parametrize("unit", EACH_UNIT)
def test_a_users_time_unit_is_no_warning(checkout, folder, unit):
    checkout.put({"user.v": USER.format(unit=UNITS[unit])})
    sources = ("-F", folder / "hwffd.f")
    assert verilated(checkout, *sources, "user.v") == (0, "", "")
    assert verilated(checkout, "user.v", *sources) == (0, "", "")


def test_other_warnings_are_heard(checkout):
    """In a source of the core, and in the user's own, of time units too."""
    checkout.put({"user.v": USER.format(unit=UNITS["timescale"])})
    folder = shutil.copytree(ROOT / "rtl", checkout.root / "rtl")
    source = folder / "stream" / "ffd_stream_marks.v"
    source.write_text(source.read_text().replace("endmodule", "  wire [3:0] wide = 5'd17;\nendmodule"))
    status, _, errors = verilated(checkout, "-F", folder / "hwffd.f", "user.v")
    assert status == 1 and "WIDTH" in errors and "TIMESCALEMOD" not in errors
    checkout.put({"other.v": "module other (input wire a_i); wire unused = a_i; endmodule\n"})
    status, _, errors = verilated(checkout, "-F", ROOT / "rtl" / "hwffd.f", "other.v", "user.v")
    assert status == 1 and "TIMESCALEMOD" in errors and "other.v" in errors and "ffd_" not in errors


@pytest.mark.parametrize("unit", EACH_UNIT)
def test_icarus_takes_what_file_list_prints(checkout, folder, unit):
    checkout.put({"user.v": USER.format(unit=UNITS[unit])})
    listed = subprocess.run([folder / "file_list"], cwd="/", text=True, stdout=subprocess.PIPE, check=True)
    checkout.put({"core.f": listed.stdout})
    outcome = checkout.run("iverilog", "-g2005", "-t", "null", "-s", "user_top", "-c", "core.f", "user.v")
    assert outcome == (0, "", "")


def test_what_file_list_prints_is_the_list():
    process = subprocess.run([ROOT / "rtl" / "file_list"], cwd="/", text=True, stdout=subprocess.PIPE, check=True)
    wanted = [f"+incdir+{ROOT}/rtl/{name}" for name in rtl_sources.read_include_folders(ROOT / "rtl" / "hwffd.f")]
    wanted += [f"{ROOT}/rtl/{name}" for name in rtl_sources.read_file_list(ROOT / "rtl" / "hwffd.f")]
    assert len(wanted) > 100
    assert process.stdout.splitlines() == wanted


def test_file_list_of_what_is_linked_or_called_from_elsewhere(checkout):
    """By a link, by a relative path, in a folder whose name has a blank."""
    folder = shutil.copytree(ROOT / "rtl", checkout.root / "a folder" / "rtl")
    (checkout.root / "list").symlink_to(folder / "file_list")
    _, plain, _ = checkout.run("a folder/rtl/file_list")
    assert plain.splitlines()[0].startswith(f"+incdir+{folder}/")
    assert checkout.run("./list")[1] == plain
