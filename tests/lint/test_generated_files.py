"""Files that are made from tables: what is refused in a table, with its place; that what is
committed is up to date, that it is noticed when it is not, and that a change of a table or of VERSION
reaches all.

SPDX-License-Identifier: Apache-2.0
"""

import re

import pytest

from tools import csv_table
from tools.project_root import ROOT
from tools.rtl import module_header, rtl_sources
from tools.tables import (
    citation, configurations, core_file, formats, generated_files, ip_xact, organizations, registers, stream_words, system_rdl, version)

CORE = (ROOT / core_file.NAME).read_text(encoding="utf-8")
FP32 = "fp32,,0,float,Binary32,Binary32Fused,binary32\n"

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
    "family of a width that is no number": ("fx,12-²,,fixed,Fixed,,fixed\n", 2, "two numbers of 8 to 32 wanted"),
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

# what is wrong -> (text of the table, its replacement, words of the message)
REGISTERS = {
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
    "a description that ends in the next line": ('"Bytes of the result area."', '"Bytes of the result area.',
                                                 "see to its quotes"),
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

# table, (what it says, what it is to say), made file -> words that are then in it
REACHED = (
    (stream_words.TABLE, (("clamped,1,", "nan,1,"), ("nan,2,", "clamped,2,")), {
        stream_words.RTL: "`define FFD_STATUS_CLAMPED   2",
        stream_words.HEADER: "kStatusClamped = 1U << 18;"}),
    (stream_words.TABLE, ((",page,4,", ",pages,4,"),), {
        stream_words.RTL: "`define FFD_PACKET_PAGES     4",
        stream_words.OPCODES: "  kPages = 5,"}),
    (registers.TABLE, (("value,3:0,rw,0", "value,4:0,rw,5"),), {
        "rtl/bus/ffd_bus_registers.v": "ring_log2_size_o <= 5'h5;",
        "cores/include/hwffd/registers.h": "RING_LOG2_SIZE_MASK 0x0000001Fu",
        "docs/registers.md": "| 4:0 | `value` | rw | 0x5 |",
        ip_xact.NAME: "<ipxact:value>'h5</ipxact:value>",
        system_rdl.NAME: "value[4:0] = 5'h5;"}),
    (registers.TABLE, ((",no_lattice,4,", ",without_lattice,4,"),), {
        "rtl/stream/ffd_events.vh": "`define FFD_EVENT_WITHOUT_LATTICE      4\n",
        "golden/include/hwffd/stream/events.hpp": "  kWithoutLattice = 4,\n",
        "cores/include/hwffd/registers.h": "HWFFD_ERROR_STATUS_WITHOUT_LATTICE_SHIFT 4\n",
        "docs/registers.md": "| 4 | `without_lattice` |",
        ip_xact.NAME: "<ipxact:name>without_lattice</ipxact:name>",
        system_rdl.NAME: "without_lattice[4:4] = 1'h0;"}),
    (version.FILE, ((str(version.read(ROOT)), "3.41.59"),), {
        version.HEADER: '#define HWFFD_VERSION "3.41.59"\n',
        "cores/include/hwffd/registers.h": "HWFFD_VERSION_MAJOR_RESET 0x3u",
        "rtl/bus/ffd_bus_registers.v": "{16'h3, 8'h29, 8'h3b}",
        "docs/registers.md": "| `minor` | const | 0x29 |",
        core_file.NAME: 'name: "hwffd:ip:hwffd:3.41.59"',
        ip_xact.NAME: "<ipxact:version>3.41.59</ipxact:version>",
        system_rdl.NAME: "minor[15:8] = 8'h29;",
        version.LITEX: 'VERSION = "3.41.59"\n',
        citation.NAME: "\nversion: 3.41.59\n"}),
)
PATHS = list(generated_files.outputs())


@pytest.fixture
def tree(checkout):
    checkout.copy("rtl", version.FILE, *(name for name in PATHS if not name.startswith("rtl/")))
    return checkout


@pytest.fixture
def write(tree, call):
    return lambda: call(generated_files.main, "--root", tree.root, "write")


@pytest.fixture
def check(tree, call):
    return lambda: call(generated_files.main, "--root", tree.root, "check")


def expect_refused(tree, result, table, line, words):
    """`result` is what writing says."""
    status, _, (message,) = result
    assert status == 1 and words in message
    assert message.startswith(f"generated_files: {tree.root / table}:" + (f"{line}: " if line else " "))
    expect_untouched(tree)


def expect_untouched(tree):
    assert [tree.text(name) for name in PATHS] == [(ROOT / name).read_text() for name in PATHS]


@pytest.mark.parametrize("rows, line, words", FORMATS.values(), ids=FORMATS)
def test_bad_formats(tree, write, rows, line, words):
    tree.put({formats.TABLE: ",".join(formats.COLUMNS) + "\n" + rows})
    expect_refused(tree, write(), formats.TABLE, line, words)


def replace(tree, table, *pairs):
    text = tree.text(table)
    for old, new in pairs:
        assert old in text
        text = text.replace(old, new, 1)
    tree.put({table: text})


@pytest.mark.parametrize("text, other, line, words", WRONG_FIELDS.values(), ids=WRONG_FIELDS)
def test_bad_fields(tree, write, text, other, line, words):
    replace(tree, stream_words.TABLE, (text, other))
    expect_refused(tree, write(), stream_words.TABLE, line, words)


@pytest.mark.parametrize("text, other, words", REGISTERS.values(), ids=REGISTERS)
def test_bad_registers(tree, call, text, other, words):
    replace(tree, registers.TABLE, (text, other))
    status, _, (line,) = call(registers.main, "--root", tree.root, "write")
    assert status == 1 and line.startswith("registers: ") and words in line
    expect_untouched(tree)


@pytest.mark.parametrize("text", ("", "\n", "1.2\n", "1.2.3", "v1.2.3\n", "1.2.3\n\n",
                                  "1.2.3-rc1\n", "01.2.3\n", "1.2.-3\n"))
def test_what_is_no_version(tree, write, text):
    tree.put({version.FILE: text})
    expect_refused(tree, write(), version.FILE, 1, "not a version")


@pytest.mark.parametrize("name, text, words", (
    (version.FILE, "0.256.0\n", "reset '256' is not a number of 8 bits"),
    (version.FILE, None, "VERSION: cannot be read"),
    (registers.TABLE, None, "registers.csv: cannot be read")),
    ids=("too large for its register", "no version", "no table of registers"))
def test_versions_and_tables_that_registers_cannot_take(tree, call, name, text, words):
    if text is None:
        (tree.root / name).unlink()
    else:
        tree.put({name: text})
    status, _, (line,) = call(registers.main, "--root", tree.root, "write")
    assert status == 1 and line.startswith("registers: ") and words in line
    expect_untouched(tree)


def test_formats():
    table = formats.read()
    numbers = {"fp32": 0, "bfp32": 99, **{f"fx{width}": width for width in range(12, 33)}}
    assert {name: member.number for name, member in table.by_name.items()} == numbers
    assert table.summary == "fp32, bfp32, or fx12 to fx32"
    for name in ("bfp18", "fx11", "fx33", "fx018", "", "FP32"):
        with pytest.raises(csv_table.TableError, match="^here: unknown format '.*': fp32, bfp32, or"):
            table.find(name, "here")


def test_what_is_committed_is_up_to_date(call):
    assert len(PATHS) == 23
    assert call(generated_files.main, "check") == (0, [], [])
    assert call(registers.main, "check") == (0, [], [])
    assert call(registers.main, "list")[1][0] == "0x000 ID value(const)"


@pytest.mark.parametrize("names, absent", ((PATHS, False), (PATHS[:1], True), (PATHS[-1:], True)),
                         ids=("changed", "absent first", "absent last"))
def test_what_is_stale_is_noticed(tree, check, write, names, absent):
    texts = {name: tree.text(name) for name in names}
    tree.put({name: None if absent else text + "\n" for name, text in texts.items()})
    status, _, lines = check()
    assert status == 1 and [name for name in names if len([line for line in lines if name in line]) != 1] == []
    assert write() == (0, [], [])
    assert {name: tree.text(name) for name in names} == texts
    assert check() == (0, [], [])


@pytest.mark.parametrize("table, pairs, words", REACHED)
def test_a_change_reaches_all(tree, check, write, table, pairs, words):
    replace(tree, table, *pairs)
    _, _, lines = check()
    assert {line.split(":")[1].strip() for line in lines} == set(words)
    assert write() == (0, [], [])
    for name, part in words.items():
        assert part in tree.text(name)


def test_a_new_source_is_listed(tree, write):
    tree.put({"rtl/number/fixed/ffd_fx_new.v": "module ffd_fx_new; endmodule\n"})
    assert write() == (0, [], [])
    for name in ("rtl/hwffd.f", core_file.NAME):
        assert "number/fixed/ffd_fx_new.v\n" in tree.text(name)


@pytest.mark.parametrize("name, old, new", (
    ("rtl/top/hwffd_axi.v", "parameter AXIS  ", "parameter AXES  "), ("rtl/hwffd.f", "number/ffd_num_add.v\n", "")))
def test_a_parameter_or_a_file_more_makes_the_core_file_stale(tree, check, name, old, new):
    replace(tree, name, (old, new))
    assert (f"generated_files: {core_file.NAME}: not what it is made from says: run python3 -m tools.tables.generated_files write"
            in check()[2])


def test_files_and_parameters_of_the_core_file():
    files = re.findall(r"^      - ([\w/]+\.(?:vh?|vlt|[ch]pp))(?::|$)", CORE, re.MULTILINE)
    assert all((ROOT / name).is_file() for name in files)
    assert {f"rtl/{entry}" for entry in rtl_sources.read_file_list(ROOT / "rtl/hwffd.f")} <= set(files)
    for name in configurations.read()[0].parameters:
        assert re.search(rf"(?m)^  {name}:$", CORE)


def test_boards_are_no_part_of_the_core():
    core, boards = (rtl_sources.read_file_list(ROOT / "rtl" / name) for name in ("hwffd.f", "boards.f"))
    assert len(core) > 100 and len(boards) > 5
    assert not [entry for entry in core if "board" in entry]
    assert "rtl/board" not in CORE
    assert all(entry.startswith("board/") for entry in boards)


def test_n_follows_from_org():
    text = rtl_sources.strip_comments((ROOT / "rtl/evaluator/ffd_organizations.vh").read_text())
    arms = re.search(r"`define FFD_ORG_N\(ORG\)(.*?)\n\n", text, re.DOTALL)[1]
    numbers = {int(org): int(n) for org, n in re.findall(r"\(ORG\) == (\d+) \? (\d+) :", arms)}
    rows = organizations.read().values()
    assert numbers == {row.number: row.n for row in rows if row.n} and len(numbers) > 15
    for top in ("hwffd_stream", "hwffd_stream_bus", "hwffd_axi", "hwffd_wishbone", "hwffd_adjoint"):
        assert module_header.read(rtl_sources.Sources(), top).of_org == ("N",)


def test_headers_of_the_tops():
    sources = rtl_sources.Sources()
    stream = module_header.read(sources, "hwffd_stream")
    assert (stream.parameters["FORMAT"], stream.parameters["SCHEDULE"]) == (18, 0)
    ports = {port.name: (port.direction, port.width) for port in stream.ports}
    assert ports["s_axis_tdata"] == ("input", 128)
    assert ports["m_axis_tlast"] == ("output", 1)
    axi = module_header.read(sources, "hwffd_axi")
    wishbone = module_header.read(sources, "hwffd_wishbone")
    for top, ports in ((axi, 54), (wishbone, 44)):
        source = rtl_sources.strip_comments(sources.files[top.name].read_text())
        assert len(top.ports) == len(re.findall(r"^  (?:in|out)put ", source, re.M)) == ports
        assert len(top.parameters) == len(re.findall(r"^  parameter ", source, re.M))
    assert set(axi.parameters) - set(wishbone.parameters) == {"SECURE_ONLY"}
    for name, complaint in (("nothing", "no module nothing"),
                            ("ffd_org_tree", "ffd_org_tree: not a port")):
        with pytest.raises(module_header.HeaderError, match=complaint):
            module_header.read(sources, name)


def test_cmake_reads_the_version_and_no_other_place_says_it():
    text = (ROOT / "CMakeLists.txt").read_text()
    assert "file(STRINGS VERSION HWFFD_VERSION LIMIT_COUNT 1)" in text
    assert re.search(r"(?m)^project\(hwffd VERSION \$\{HWFFD_VERSION\}", text)
    number = re.escape(str(version.read(ROOT)))
    for pattern in ("CMakeLists.txt", "*/CMakeLists.txt", "cmake/*.cmake", "api/**/*.[ch]pp",
                    "apps/**/*.[ch]pp", "tools/**/*.py", "rtl/bus/registers.csv"):
        for path in ROOT.glob(pattern):
            assert not re.search(rf"\b{number}\b", path.read_text()), path
