"""A row of the report: what its nets did, and what OpenSTA made of it, per vertex.

SPDX-License-Identifier: Apache-2.0
"""

from lab.energy import flat, power, simulation


class EnergyError(Exception):
    """A row that has no figure, in one line."""


def counts(netlist, kinds, activity):
    """Changes of each port for OpenSTA: all of them, those without glitches, none."""
    clocks = activity.clocks(simulation.PERIOD_PS)
    nets = {net: net for net in netlist.inputs if net != power.CLOCK}
    nets.update({flat.port(cell): netlist.output(cell, kinds)[1] for cell in netlist.cells})
    absent = [net for net in nets.values() if net not in activity.nets]
    if absent or activity.unknown():
        raise EnergyError(f"{len(absent)} nets were not written, {activity.unknown()} had no value")
    every, settled, none = {}, {}, {}
    for port, name in nets.items():
        net = activity.nets[name]
        duty = net.high / activity.time
        every[port], settled[port] = (net.toggles / clocks, duty), (net.settled / clocks, duty)
        none[port] = (0, duty)
    return every, settled, none


def report(netlist, kinds, activity, powers, run):
    """What was measured of a row, energies in nJ per vertex."""
    clocks = activity.clocks(simulation.PERIOD_PS)
    per_vertex = clocks / run.counted
    every, settled, none = powers
    clock, inputs = (1e-3 * per_vertex * energy for energy in power.charged_pj(
        netlist, kinds, {net: activity.nets[net].toggles / clocks for net in netlist.inputs}))
    inside, driven, settled_, idle, leaks = (
        watts * power.PERIOD_NS * per_vertex for watts in (
            every.internal, every.switching, settled.internal + settled.switching,
            none.internal, every.leakage))
    driven_nets = [activity.nets[netlist.output(cell, kinds)[1]].toggles for cell in netlist.cells]
    return {
        "cells": len(netlist.cells), "ff": sum(kinds[cell.kind].is_register for cell in netlist.cells),
        "annotated": len(netlist.cells) + len(netlist.inputs), "vertices": run.counted,
        "clocks_per_vertex": per_vertex,
        "toggles_per_clock": sum(driven_nets) / clocks / len(driven_nets),
        "energy_nj_per_vertex": inside + driven + clock + inputs + leaks,
        "inside_cells_nj": inside, "nets_nj": driven + clock + inputs, "leakage_nj": leaks,
        "clock_nj": idle + clock, "glitches_nj": inside + driven - settled_}
