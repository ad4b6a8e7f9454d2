"""The energy of a clock, from how often each net toggles: by OpenSTA, and of what ports drive.

OpenSTA counts a net for the cell that drives it. Nets that ports drive, the clock among them, are
charged by whoever drives those; their share is added here from the capacitances of the pins.

SPDX-License-Identifier: Apache-2.0
"""

import re
from dataclasses import dataclass

from lab.energy import flat, library
from tools.rtl import rtl_sources
from tools.synth import timing

PERIOD_NS = timing.PERIOD_NS
CLOCK = "clk"
_TOTAL = re.compile(r"^Total((?:\s+[\d.e+-]+){4})\s", re.MULTILINE)
_FAULT = re.compile(r"^(?:Error:? .*|Warning:? .*|.*invalid command name.*)$", re.MULTILINE)
_SET = re.compile(r"^annotated (\d+) of (\d+)$", re.MULTILINE)


class PowerError(Exception):
    """OpenSTA did not say what power there is, in one line."""


@dataclass(frozen=True)
class Power:
    """Watts: inside cells, of the nets that they drive, and what leaks."""

    internal: float
    switching: float
    leakage: float


def script(netlist, toggles, files):
    """What OpenSTA reads. It finds ports by their names in no time only where it lists them itself.

    toggles: port -> (changes a clock, share of the time for which it is 1), of the inputs and of what
             flat.port() names
    files:   library and netlist
    """
    ports = [*(net for net in netlist.inputs if net != CLOCK), *map(flat.port, netlist.cells)]
    lines = [f"read_liberty {files[0]}", f"read_verilog {files[1]}", f"link_design {flat.MODULE}",
             "foreach port [all_inputs] { set named([get_property $port full_name]) $port }",
             f"create_clock -name clk -period {PERIOD_NS} $named({CLOCK})",
             *(f"set_input_delay 0 -clock clk $named({net})" for net in netlist.inputs if net != CLOCK),
             "set_output_delay 0 -clock clk [all_outputs]", "set_load 0.02 [all_outputs]",
             f"set_input_transition {library.SLEW_NS} $named({CLOCK})",
             "proc toggles {port activity duty} {", "  global annotated named",
             "  if {[info exists named($port)]} {",
             "    sta::set_power_input_port_activity $named($port) $activity $duty",
             "    incr annotated", "  }", "}", "set annotated 0"]
    lines += [f"toggles {{{port}}} {toggles[port][0]:.6g} {toggles[port][1]:.4g}" for port in ports]
    return "\n".join([*lines, f'puts "annotated $annotated of {len(ports)}"',
                      "report_power -digits 9", ""])


def parse(output):
    """The Power. Raises PowerError where it is not that of every cell."""
    fault = _FAULT.search(output)
    if fault:
        raise PowerError(f"OpenSTA: {fault.group(0)}")
    total, annotated = _TOTAL.search(output), _SET.search(output)
    if not total or not annotated:
        raise PowerError("OpenSTA reported no power")
    if annotated.group(1) != annotated.group(2):
        raise PowerError(f"OpenSTA was told the toggles of {annotated.group(1)} of {annotated.group(2)} nets")
    return Power(*(float(word) for word in total.group(1).split()[:3]))


def run(netlist, toggles, files, folder):
    """The Power for some toggles."""
    path = folder / "power.tcl"
    path.write_text(script(netlist, toggles, files), encoding="utf-8")
    status, output = rtl_sources.run([timing.PROGRAM, "-no_init", "-no_splash", "-exit", str(path)])
    if status:
        raise PowerError(f"{timing.PROGRAM} ended with {status}")
    return parse(output)


def charged_pj(netlist, kinds, toggles):
    """(of the clock, of the other inputs): energy of a clock in the pins that ports drive.

    toggles: input -> changes a clock
    """
    load = netlist.load_pf(kinds)
    energy = {net: load.get(net, 0) * library.VOLTS ** 2 / 2 * toggles[net] for net in netlist.inputs}
    return energy[CLOCK], sum(value for net, value in energy.items() if net != CLOCK)
