"""Vertices a second of the overlapped rows, as whole cores or as evaluators: clocks of `make
organizations` joined with the areas and clocks of `make synth` and `make pnr`.

SPDX-License-Identifier: Apache-2.0
"""

from dataclasses import dataclass

from tools.reports.text_table import Table, shown
from tools.tables import organizations

# What a target counts first, and the unit of that.
SIZES = (("lut", "LUTs"), ("area_um2", "um2"), ("cells", "cells"))
EVALUATOR, CORE = "ffd_org_select", "hwffd_stream"


@dataclass(frozen=True)
class Throughput:
    """One row on one target."""

    name: str
    label: str
    target: str
    size: float
    unit: str
    multipliers: object  # None where the target counts none
    clock_mhz: object  # None where the clock is not known
    interval: float  # clocks from a vertex to the next

    @property
    def per_second(self):
        return None if self.clock_mhz is None else self.clock_mhz * 1e6 / self.interval

    @property
    def rate(self):
        """Vertices per second, or per clock where the clock is not known."""
        return 1 / self.interval if self.per_second is None else self.per_second

    @property
    def per_size(self):
        return self.rate / self.size

    @property
    def per_multiplier(self):
        return self.rate / self.multipliers if self.multipliers else None

    def beats(self, other):
        """At least as small and as fast, and better in one; with and without a clock are not
        compared.
        """
        if (self.per_second is None) != (other.per_second is None):
            return False
        return (self.size <= other.size and self.rate >= other.rate
                and (self.size < other.size or self.rate > other.rate))


def label(row):
    """Organization, what its name has behind the schedule, and format: "basic deep fp32"."""
    more = row["name"].split(row["schedule"], 1)[1].replace("-", " ")
    return f"{organizations.label(row)}{more} {row['format']}"


def _size(mapped):
    """The first size that the target counts; None if it counts none."""
    return next(((mapped[field], unit) for field, unit in SIZES if mapped.get(field)), None)


def throughputs(reports, top=EVALUATOR):
    """One for each overlapped row on each target on which it has been mapped with this top."""
    areas = {}
    for mapped in reports.rows("synth", top=top):
        if _size(mapped):
            areas.setdefault(mapped["name"], []).append(mapped)
    entries = []
    for row in reports.rows("organizations", schedule="overlapped"):
        if organizations.is_second_name(row):
            continue
        for mapped in areas.get(row["name"], ()):
            size, unit = _size(mapped)
            # A clock of which the router does not know everything is none here.
            clock = None if mapped.get("remark") else mapped.get("fmax_mhz")
            entries.append(Throughput(row["name"], label(row), mapped["target"], size, unit,
                                      mapped.get("dsp"), clock, row["interval_overlapped"]))
    return entries


def by_row(reports):
    """Row -> target -> figures, as build/reports/organizations.json has them."""
    rates = {}
    for entry in throughputs(reports):
        rates.setdefault(entry.name, {})[entry.target] = {
            "size": entry.size, "unit": entry.unit, "multipliers": entry.multipliers,
            "fmax_mhz": entry.clock_mhz, "vertices_per_clock": 1 / entry.interval,
            "vertices_per_s": entry.per_second, "per_size": entry.per_size,
            "per_multiplier": entry.per_multiplier}
    return rates


def unbeaten(entries):
    """Those that no other beats, by size."""
    best = [entry for entry in entries if not any(other.beats(entry) for other in entries)]
    return sorted(best, key=lambda entry: entry.size)


def table(reports):
    """Whole cores first, then evaluators."""
    entries = [(top, entry) for top in (CORE, EVALUATOR) for entry in throughputs(reports, top)]
    return Table(
        ["top", "target", "row", "size", "", "multipliers", "MHz", "vertex/clock", "vertex/s",
         "per size", "per multiplier"],
        [[top, entry.target, entry.name, shown(entry.size, ".0f"), entry.unit, shown(entry.multipliers, "d"),
          shown(entry.clock_mhz, ".1f"), shown(1 / entry.interval, ".4f"),
          shown(entry.per_second, ".4g"), shown(entry.per_size, ".4g"),
          shown(entry.per_multiplier, ".4g")]
         for top, entry in entries])
