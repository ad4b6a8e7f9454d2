"""What the sources themselves say of the project.

SPDX-License-Identifier: Apache-2.0
"""

import configurations
import module_header
import organizations
import rtl
import version


def _slave_ports(reports):
    """Name -> width of the AXI4-Lite ports of hwffd_axi, without their prefix."""
    ports = module_header.read(rtl.Sources(reports.root), "hwffd_axi").ports
    prefix = "s_axil_"
    return {port.name[len(prefix):]: port.width for port in ports if port.name.startswith(prefix)}


def _protection(reports):
    return " and ".join(f"`{name}`" for name in _slave_ports(reports) if name.endswith("prot"))


def _events(reports):
    """Of the stream, as many as bits of event_o."""
    ports = module_header.read(rtl.Sources(reports.root), "hwffd_stream").ports
    return next(port.width for port in ports if port.name == "event_o")


TABLES = {}
FIGURES = {
    "version": lambda reports: str(version.read(reports.root)),
    "configurations": lambda reports: len(
        configurations.read(reports.root / "rtl" / "configurations.csv")),
    "organizations": lambda reports: len(organizations.read(reports.root / "rtl")),
    "events": _events,
    "axil_address_bits": lambda reports: _slave_ports(reports)["awaddr"],
    "axil_data_bits": lambda reports: _slave_ports(reports)["wdata"],
    "axil_protection": _protection,
    "modules": lambda reports: len(rtl.Sources(reports.root).modules()),
}
