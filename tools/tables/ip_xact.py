"""rtl/component.xml, hwffd_axi for tools that read IP-XACT (IEEE 1685-2014): buses, registers, parameters, ports, files.

Ports and parameters are those of the source, registers those of rtl/bus/registers.csv, ranges those of
tools/tables/parameter_space.py. Names of buses are those that Arm has published for AMBA.

SPDX-License-Identifier: Apache-2.0
"""

import re
import xml.etree.ElementTree as xml

from tools.rtl import module_header, rtl_sources
from tools.tables import registers, version

NAME = "rtl/component.xml"
TOP = "hwffd_axi"
NAMESPACE = "http://www.accellera.org/XMLSchema/IPXACT/1685-2014"
GENERATED = "Made by python3 -m tools.tables.generated_files write; changes here are lost. SPDX-License-Identifier: Apache-2.0"
MAP, SPACE, MODEL, SOURCES = "registers", "memory", "rtl", "sources"

# Interface: prefix of its ports, the bus's name in the library AMBA4, what it is connected to.
BUSES = (
    ("s_axil", "AXI4Lite", "slave", ("memoryMapRef", {"memoryMapRef": MAP})),
    ("m_axi", "AXI4", "master", ("addressSpaceRef", {"addressSpaceRef": SPACE})),
)
# Access of the table -> (access, what a 1 that is written does)
ACCESS = {
    "const": ("read-only", None), "ro": ("read-only", None), "log": ("read-only", None), "counter": ("read-only", None),
    "rw": ("read-write", None), "w1": ("write-only", None), "w1s": ("read-write", "oneToSet"),
    "w1c": ("read-write", "oneToClear"), "event": ("read-write", "oneToClear"),
}


def _add(parent, tag, text=None, **attributes):
    element = xml.SubElement(parent, f"ipxact:{tag}", attributes)
    if text is not None:
        element.text = str(text)
    return element


def _library(parent, tag, library, name, of_version, vendor):
    _add(parent, tag, vendor=vendor, library=library, name=name, version=of_version)


def _bus(parent, prefix, bus, side, reference, ports):
    interface = _add(parent, "busInterface")
    _add(interface, "name", prefix)
    _library(interface, "busType", "AMBA4", bus, "r0p0_0", "amba.com")
    types = _add(interface, "abstractionTypes")
    kind = _add(types, "abstractionType")
    _library(kind, "abstractionRef", "AMBA4", f"{bus}_rtl", "r0p0_0", "amba.com")
    maps = _add(kind, "portMaps")
    logical = {"ACLK": "aclk", "ARESETn": "aresetn"}
    logical.update((port.name[len(prefix) + 1:].upper(), port.name) for port in ports if port.name.startswith(f"{prefix}_"))
    for name, port in logical.items():
        one = _add(maps, "portMap")
        _add(_add(one, "logicalPort"), "name", name)
        _add(_add(one, "physicalPort"), "name", port)
    tag, attributes = reference
    _add(_add(interface, side), tag, **attributes)


def _register(block, register):
    element = _add(block, "register")
    _add(element, "name", register.name)
    _add(element, "addressOffset", f"'h{register.offset:03X}")
    _add(element, "size", 32)
    for field in register.fields:
        access, written = ACCESS[field.access]
        one = _add(element, "field")
        _add(one, "name", field.name)
        _add(one, "description", field.description)
        _add(one, "bitOffset", field.low)
        if field.access not in registers.RESETLESS:
            _add(_add(_add(one, "resets"), "reset"), "value", f"'h{field.reset:X}")
        _add(one, "bitWidth", field.width)
        if access == "read-only" and field.access != "const":
            _add(one, "volatile", "true")
        _add(one, "access", access)
        if written:
            _add(one, "modifiedWriteValue", written)


def _memory(component, table):
    space = _add(_add(component, "addressSpaces"), "addressSpace")
    _add(space, "name", SPACE)
    _add(space, "range", "2 ** ADDRESS_WIDTH")
    _add(space, "width", "DATA_WIDTH")
    memory = _add(_add(component, "memoryMaps"), "memoryMap")
    _add(memory, "name", MAP)
    block = _add(memory, "addressBlock")
    _add(block, "name", MAP)
    _add(block, "baseAddress", "'h0")
    _add(block, "range", "'h1000")
    _add(block, "width", 32)
    _add(block, "usage", "register")
    for register in table:
        _register(block, register)
    _add(memory, "addressUnitBits", 8)


def _model(component, header):
    model = _add(component, "model")
    view = _add(_add(model, "views"), "view")
    _add(view, "name", MODEL)
    _add(view, "envIdentifier", ":*:")
    _add(view, "componentInstantiationRef", MODEL)
    instantiation = _add(_add(model, "instantiations"), "componentInstantiation")
    _add(instantiation, "name", MODEL)
    _add(instantiation, "language", "verilog")
    _add(instantiation, "moduleName", header.name)
    parameters = _add(instantiation, "moduleParameters")
    for name in header.parameters:
        one = _add(parameters, "moduleParameter", dataType="integer")
        _add(one, "name", name)
        _add(one, "value", name)
    _add(_add(instantiation, "fileSetRef"), "localName", SOURCES)
    ports = _add(model, "ports")
    for port in header.ports:
        one = _add(ports, "port")
        _add(one, "name", port.name)
        wire = _add(one, "wire")
        _add(wire, "direction", {"input": "in", "output": "out"}[port.direction])
        if port.width > 1 or port.high:
            vector = _add(_add(wire, "vectors"), "vector")
            _add(vector, "left", re.sub(r"([-/])", r" \1 ", port.high))
            _add(vector, "right", 0)


def _files(component, rtl):
    files = _add(_add(component, "fileSets"), "fileSet")
    _add(files, "name", SOURCES)
    headers = sorted(path.relative_to(rtl) for path in rtl.glob("*/*.vh"))
    for name in (*headers, *rtl_sources.read_file_list(rtl / rtl_sources.CORE_LIST)):
        if str(name) == rtl_sources.WAIVERS:
            continue
        one = _add(files, "file")
        _add(one, "name", name)
        _add(one, "fileType", "verilogSource")
        if str(name).endswith(".vh"):
            _add(one, "isIncludeFile", "true")


def _parameters(component, header):
    """Their identifiers, by which widths and values refer to them, are their names."""
    parameters = _add(component, "parameters")
    for name, value in header.parameters.items():
        one = _add(parameters, "parameter", parameterId=name, resolve="user", type="longint")
        _add(one, "name", name)
        if name in header.of_org:
            _add(one, "description", f"that of ORG: {value} for the default")
        _add(one, "value", value)


def text(root):
    """What rtl/component.xml must be."""
    header = module_header.read(rtl_sources.Sources(root), TOP)
    component = xml.Element("ipxact:component", {"xmlns:ipxact": NAMESPACE})
    component.append(xml.Comment(f" {GENERATED} "))
    for tag, value in (("vendor", "hwffd"), ("library", "ip"), ("name", TOP), ("version", version.read(root))):
        _add(component, tag, value)
    interfaces = _add(component, "busInterfaces")
    for prefix, bus, side, reference in BUSES:
        _bus(interfaces, prefix, bus, side, reference, header.ports)
    _memory(component, registers.read(root))
    _model(component, header)
    _files(component, root / "rtl")
    _add(component, "description", "Free-form deformation of vertices by a lattice of 64 control points a cell: "
                                   "docs/datasheet.md")
    _parameters(component, header)
    xml.indent(component)
    return "<?xml version='1.0' encoding='UTF-8'?>\n" + xml.tostring(component, encoding="unicode") + "\n"
