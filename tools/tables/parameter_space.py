"""What the parameters of the tops may be: the range of each, and the rules between them.

    python3 -m tools.tables.parameter_space TOP     prints the rules of a top

This is the one description of the legal space. The data sheet's table of parameters is made of it, random configurations are drawn from it (tests/random), and the guards of the RTL are held to it: what it
refuses stops elaboration at a guard of the name that stands here, and what it takes passes (tests/lint).

SPDX-License-Identifier: Apache-2.0
"""

import sys
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Callable

from tools.tables import features, formats, organizations, parameter_values as values
from tools.tables.configurations import EVALUATORS, SCHEDULES
from tools.tables.parameter_values import Between, Powers

PIPELINED, ITERATIVE, POWERS = EVALUATORS.values()
OVERLAPPED = SCHEDULES.index("overlapped")
FP32 = 0
TIMEOUT_MOST = 1 << 30
WIDEST_TRANSPOSED = 18  # bits of a word of gradients


@dataclass(frozen=True)
class Parameter:
    """A parameter of a top: its values, and the guard that refuses all others, a pattern of what follows
    ERROR_. `without` are values that pass without a guard and are no part of the space."""

    name: str
    values: values.Values
    guard: str
    without: frozenset = frozenset()

    def beyond(self):
        """Values next to its ends that must be refused."""
        return [value for value in self.values.beyond() if value not in self.without]


RESET_REGISTER = Parameter("RESET_REGISTER", values.of(0, 1), "ffd_reset_register_registered_must_be_0_or_1")


@dataclass(frozen=True)
class Rule:
    """What parameters are bound to together, in words; whether a configuration keeps to it; and the
    guard that refuses one that does not."""

    text: str
    names: tuple
    holds: Callable
    guard: str
    needs: tuple = field(default=())  # parameters that make it hold at all: those of a top without them keep it


def _names(members):
    return values.listed(member.name for member in members)


class Space:
    """The space of one checkout: parameters by top, and rules."""

    def __init__(self):
        self.organizations = {organization.number: organization for organization in organizations.read().values()}
        self.formats = {member.number: member for member in formats.read().by_name.values()}
        stream = self._stream()
        inside = _table([
            Parameter("BESIDE", values.of(0, 1), "ffd_stream_framer_beside_must_be_0_or_1"),
            Parameter("RESULT_WIDTH", values.of(128, 256), "hwffd_stream_result_width_must_be_128_or_256"),
        ])
        bus = self._bus()
        self.parameters = {
            "hwffd_stream": {**stream, **inside},
            "hwffd_stream_bus": {**stream, **_table([Parameter(
                "DATA_WIDTH", values.of(64, 128, 256), "hwffd_stream_bus_data_width_.*")])},
            "hwffd_scatter": self._scatter(),
            "hwffd_adjoint": self._adjoint(stream, self._scatter()),
            "hwffd_wishbone": bus,
            "hwffd_axi": {**bus, **_table([Parameter(
                "SECURE_ONLY", values.of(0, 1), "ffd_axil_slave_secure_only_.*")])},
        }
        self.rules = [*self._row_rules(), *self._latency_rules(), *self._store_rules(), *_bus_rules()]

    def form(self, p):
        return self.organizations[p.ORG].form

    def words(self, p):
        return self.formats[p.FORMAT].words

    def faults(self, top, configuration):
        """The parameters and rules that a configuration, {name: value}, of all parameters of the top,
        breaks; rules are looked at where each parameter is in its range."""
        known = self.parameters[top]
        wrong = [known[name] for name, value in configuration.items() if value not in known[name].values]
        p = SimpleNamespace(**configuration)
        return wrong or [rule for rule in self.rules_of(top) if not rule.holds(p)]

    def rules_of(self, top):
        return [rule for rule in self.rules if set(rule.names) | set(rule.needs) <= set(self.parameters[top])]

    def _stream(self):
        # Formats that are no rows of rtl/formats.csv have neither a name nor a model.
        unnamed = frozenset(set(range(8, 33)) | set(range(72, 100))) - set(self.formats)
        return _table([
            Parameter("ORG", values.of(*self.organizations), "ffd_org_select_org_is_unknown"),
            Parameter("N", values.of(Powers(1, 64)), "ffd_(org_tree|org_select|org_affine|cache_points)_n_.*"),
            Parameter("FORMAT", values.of(*self.formats), "ffd_num_\\w+_format_is_unknown", unnamed),
            Parameter("SCHEDULE", values.of(*range(len(SCHEDULES))), "ffd_org_\\w+_schedule_must_be_.*"),
            Parameter("EVALUATOR", values.of(*EVALUATORS.values()),
                      "ffd_eval_poly_evaluator_must_be_.*"),
            Parameter("MUL_LATENCY", values.of(Between(1)), "ffd_num_\\w*latenc(y|ies)_must_be_at_least_1"),
            Parameter("ADD_LATENCY", values.of(Between(1)), "ffd_num_\\w*latenc(y|ies)_must_be_at_least_1"),
            Parameter("FMA_LATENCY", values.of(Between(0)), "\\w+_fused_needs_fp32"),
            Parameter("CONVERT_LATENCY", values.of(Between(0)),
                      "ffd_num_(delay|latencies_convert)_latency_must_not_be_negative"),
            Parameter("AXIS", values.of(Between(4, 64)), "ffd_(stream_header|cache_points)_axis_.*"),
            Parameter("PAGES", values.of(Between(1, 256)),
                      "ffd_stream_(pages_pages_must_be_1_to_256|resident_has_two_buffers_without_pages)"),
            Parameter("IN_FLIGHT", values.of(0, Powers(4)),
                      "ffd_(eval_stream_in_flight_.*|stream_fifo_depth_must_be_a_power_of_two)"),
            Parameter("WAITING", values.of(Powers(2)), "ffd_stream_fifo_depth_must_be_a_power_of_two"),
            *(Parameter(name, values.of(0, 1), "hwffd_stream_features_must_be_0_or_1")
              for name in features.PARAMETERS.values()),
            Parameter("SPANS", values.of(Between(1, 128)), "ffd_eval_stream_spans_must_be_1_to_128"),
            Parameter("GRID_LIMIT", values.of(Between(0, 48)), "ffd_stream_(ingress_)?grid_limit_must_be_0_to_48"),
            Parameter("HARDENED", values.of(0, 1), "ffd_cache_stores_hardened_must_be_0_or_1"),
            RESET_REGISTER,
        ])

    def _scatter(self):
        """Of the transpose, which is of fixed point."""
        widths = [number for number, member in self.formats.items() if member.words == "fixed" and number <= WIDEST_TRANSPOSED]
        return _table([
            Parameter("FORMAT", values.of(*widths), "ffd_num_cumulate_format_must_be_.*"),
            Parameter("EVALUATOR", values.of(PIPELINED, POWERS), "ffd_scatter_decoder_evaluator_must_be_.*"),
            Parameter("MUL_LATENCY", values.of(Between(1)), "ffd_num_\\w*latenc(y|ies)_must_be_at_least_1"),
            Parameter("ADD_LATENCY", values.of(Between(1)), "ffd_num_\\w*latenc(y|ies)_must_be_at_least_1"),
            Parameter("AXIS", values.of(Between(4, 32)), "ffd_scatter_header_axis_must_be_4_to_32"),
            Parameter("PAGES", values.of(Between(1, 256)), "ffd_scatter_pages_pages_must_be_1_to_256"),
            Parameter("WAITING", values.of(Powers(2)), "ffd_stream_fifo_depth_must_be_a_power_of_two"),
            Parameter("BESIDE", values.of(0, 1), "ffd_scatter_decoder_beside_must_be_0_or_1"),
            Parameter("ROWS", values.of(0, 1), "ffd_scatter_(core|decoder)_rows_must_be_0_or_1"),
            RESET_REGISTER,
        ])

    @staticmethod
    def _adjoint(stream, scatter):
        """Of both on one stream: what one half refuses, it does."""
        pages = scatter["PAGES"]
        return {**{name: parameter for name, parameter in stream.items() if name != "SPANS"},
                **{name: scatter[name] for name in ("FORMAT", "EVALUATOR", "AXIS", "ROWS")},
                **_table([Parameter("SCATTER_PAGES", pages.values, pages.guard)])}

    def _bus(self):
        """Of ffd_bus_core, which both tops with registers have."""
        return {**self._stream(), **_table([
            Parameter("MAX_BURST", values.of(Powers(2, 256)), "ffd_dma_address_max_burst_.*"),
            Parameter("READ_DEPTH", values.of(Powers(4)),
                      "ffd_(dma_read_fifo_depth_.*|stream_deep_fifo_depth_.*)"),
            Parameter("WRITE_DEPTH", values.of(Powers(4)),
                      "ffd_(dma_write_fifo_depth_.*|stream_deep_fifo_depth_.*)"),
            Parameter("READ_OUTSTANDING", values.of(Powers(2, 32768)),
                      "ffd_(dma_read_outstanding_.*|stream_fifo_depth_.*|bus_waits_open_.*)"),
            Parameter("WRITE_OUTSTANDING", values.of(Powers(2, 32768)),
                      "ffd_(dma_write_outstanding_.*|stream_fifo_depth_.*|bus_waits_open_.*)"),
            Parameter("FLUSH_CLOCKS", values.of(Between(1, 65535)), "ffd_dma_write_flush_clocks_.*"),
            Parameter("COUNT_WIDTH", values.of(0, Between(8, 32)), "ffd_bus_waits_count_width_.*"),
            Parameter("BUS_TIMEOUT", values.of(0, Between(2, TIMEOUT_MOST)), "ffd_dma_watch_timeout_.*"),
            Parameter("AXI_PROT", values.of(*range(8)), "ffd_bus_core_axi_prot_.*"),
            Parameter("AXI_CACHE", values.of(0, 1, 2, 3, 6, 7, 10, 11, 14, 15), "ffd_bus_core_axi_cache_.*"),
            Parameter("ADDRESS_WIDTH", values.of(Between(32, 64)), "ffd_bus_core_address_width_.*"),
            Parameter("DATA_WIDTH", values.of(64, 128, 256), "ffd_dma_width_read_data_width_.*"),
            Parameter("ID_WIDTH", values.of(Between(1, 16)), "ffd_bus_core_id_.*"),
            Parameter("ID", values.of(Between(0, 65535)), "ffd_bus_core_id_.*"),
        ])}

    def _those(self, kind):
        return [organization for organization in self.organizations.values() if kind(organization)]

    def _row_rules(self):
        """Of organization, format, schedule and evaluator."""
        chosen = self._those(lambda organization: organization.n is None)
        paper = self._those(lambda organization: organization.formulas["paper"])
        axes = self._those(lambda organization: organization.weighs_axes)
        fixed = self._those(lambda organization: organization.of_form.words == ("fixed",))
        of = self.organizations
        return [
            Rule(f"N is that of the organization; of {_names(chosen)} it may be any", ("ORG", "N"),
                 lambda p: of[p.ORG].n in (None, p.N), "ffd_org_select_n_is_not_that_of_the_organization"),
            Rule(f"the paper's schedule is of {_names(paper)}", ("ORG", "SCHEDULE"),
                 lambda p: p.SCHEDULE == OVERLAPPED or of[p.ORG] in paper,
                 "ffd_org_\\w+_schedule_must_be_overlapped"),
            Rule(f"EVALUATOR {ITERATIVE} is not of {_names(axes)}", ("ORG", "EVALUATOR"),
                 lambda p: of[p.ORG] not in axes or p.EVALUATOR != ITERATIVE,
                 "ffd_eval_axis_weights_evaluator_must_not_be_iterative"),
            Rule(f"EVALUATOR {POWERS} is of {_names(axes)} only", ("ORG", "EVALUATOR"),
                 lambda p: of[p.ORG] in axes or p.EVALUATOR != POWERS,
                 "ffd_eval_poly_evaluator_must_be_0_or_1"),
            Rule(f"EVALUATOR {POWERS} wants fixed point", ("ORG", "EVALUATOR", "FORMAT"),
                 lambda p: of[p.ORG] not in axes or p.EVALUATOR != POWERS or self.words(p) == "fixed",
                 "ffd_num_\\w+_needs_fixed_point"),
            Rule(f"{_names(fixed)} want fixed point", ("ORG", "FORMAT"),
                 lambda p: of[p.ORG] not in fixed or self.words(p) == "fixed", "ffd_num_\\w+_needs_fixed_point"),
        ]

    def _latency_rules(self):
        serial = self._those(lambda organization: organization.in_sequence)
        of = self.organizations
        return [
            Rule("FMA_LATENCY is 0 but in binary32", ("FORMAT", "FMA_LATENCY"),
                 lambda p: p.FMA_LATENCY == 0 or p.FORMAT == FP32, "\\w+_(fused_needs_fp32|mac_needs_fp32)"),
            Rule(f"of {_names(serial)} ADD_LATENCY is 1", ("ORG", "ADD_LATENCY"),
                 lambda p: of[p.ORG] not in serial or p.ADD_LATENCY == 1,
                 "ffd_eval_serial_add_latency_must_be_1"),
            Rule(f"of {_names(serial)} MUL_LATENCY is 1 to 3, and 2 at least without CONVERT_LATENCY",
                 ("ORG", "MUL_LATENCY", "CONVERT_LATENCY"),
                 lambda p: of[p.ORG] not in serial or (
                     p.MUL_LATENCY <= 3 and p.MUL_LATENCY + p.CONVERT_LATENCY >= 2),
                 "ffd_eval_serial_mul_latency_.*"),
            Rule(f"of {_names(serial)} MUL_LATENCY and CONVERT_LATENCY are 11 together at most",
                 ("ORG", "MUL_LATENCY", "CONVERT_LATENCY"),
                 lambda p: of[p.ORG] not in serial or p.MUL_LATENCY + p.CONVERT_LATENCY <= 11,
                 "ffd_eval_serial_latencies_are_too_long"),
        ]

    def _store_rules(self):
        """Of what is built around the evaluator."""
        of = self.organizations
        return [
            Rule("RESIDENT or INTERLEAVED is 1", ("RESIDENT", "INTERLEAVED"),
                 lambda p: p.RESIDENT or p.INTERLEAVED, "ffd_stream_header_features_do_not_go_together"),
            Rule("DETERMINANT wants DERIVATIVES", ("DETERMINANT", "DERIVATIVES"),
                 lambda p: p.DERIVATIVES or not p.DETERMINANT, "ffd_stream_header_features_do_not_go_together"),
            Rule("PAGED, GRIDS and PACKED want RESIDENT", ("PAGED", "GRIDS", "PACKED", "RESIDENT"),
                 lambda p: p.RESIDENT or not (p.PAGED or p.GRIDS or p.PACKED), "ffd_stream_header_features_do_not_go_together"),
            Rule("AXIS above 32, FOURTH, MARKS and HALVES want PAGED", ("AXIS", "FOURTH", "MARKS", "HALVES", "PAGED"),
                 lambda p: p.PAGED or not (p.AXIS > 32 or p.FOURTH or p.MARKS or p.HALVES),
                 "ffd_stream_header_features_do_not_go_together"),
            Rule("HALVES wants fixed point", ("HALVES", "FORMAT"),
                 lambda p: not p.HALVES or self.words(p) == "fixed", "ffd_num_half_needs_fixed_point"),
            Rule("PAGES is 2 without PAGED", ("PAGED", "PAGES"),
                 lambda p: p.PAGED or p.PAGES == 2, "ffd_stream_resident_has_two_buffers_without_pages"),
            Rule("SPANS above 1 wants the overlapped schedule", ("SPANS", "SCHEDULE"),
                 lambda p: p.SPANS == 1 or p.SCHEDULE == OVERLAPPED,
                 "ffd_eval_stream_spans_want_the_overlapped_schedule"),
            Rule(f"SPANS above 1 wants EVALUATOR {PIPELINED} or {ITERATIVE}", ("SPANS", "EVALUATOR"),
                 lambda p: p.SPANS == 1 or p.EVALUATOR != POWERS,
                 "ffd_eval_stream_spans_want_functions_that_are_loaded"),
            Rule("with INTERLEAVED, PAGES and AXIS give a place to each interleaved vertex inside: five, or of "
                 "organizations that accumulate four more than ADD_LATENCY or FMA_LATENCY",
                 ("ORG", "N", "ADD_LATENCY", "FMA_LATENCY", "INTERLEAVED", "AXIS", "PAGES"),
                 lambda p: not p.INTERLEAVED or _slot_bits(p, of[p.ORG]) <= _place_bits(p),
                 "ffd_cache_points_has_more_slots_than_places"),
        ]


def _bits(count):
    return (count - 1).bit_length()


def _slot_bits(p, organization):
    """Of a slot for the points of an interleaved vertex."""
    return _bits((max(p.ADD_LATENCY, p.FMA_LATENCY) if organization.in_turn else 1) + 4)


def _place_bits(p):
    """Of a place in a lane of the point store, without a page's where there is but one."""
    axis = 6 if p.AXIS > 32 else 5 if p.AXIS > 16 else 4
    page = _bits(p.PAGES) if p.PAGES > 2 else 1
    return page + 3 * (axis - 2 if p.AXIS > 8 else 1) - (p.PAGES == 1)


def _units(p):
    """Units of 16 bytes in a burst: a burst of AXI has 256 beats at most."""
    return min(p.MAX_BURST, 128 if p.DATA_WIDTH == 64 else 256)


def _bus_rules():
    return [
        *(Rule(f"{name} holds two bursts, which with DATA_WIDTH 64 have 128 units of 16 bytes at most",
               (name, "MAX_BURST", "DATA_WIDTH"),
               lambda p, name=name: getattr(p, name) >= 2 * _units(p), f"ffd_dma_{side}_fifo_depth_.*")
          for name, side in (("READ_DEPTH", "read"), ("WRITE_DEPTH", "write"))),
        Rule("ID has ID_WIDTH bits at most", ("ID", "ID_WIDTH"), lambda p: p.ID < 1 << p.ID_WIDTH,
             "ffd_bus_core_id_.*"),
        Rule("IN_FLIGHT is at most 32768 behind a bus", ("IN_FLIGHT",), lambda p: p.IN_FLIGHT <= 32768,
             "ffd_bus_core_in_flight_must_be_below_65536", needs=("MAX_BURST",)),
    ]


def _table(parameters):
    return {parameter.name: parameter for parameter in parameters}


def main(arguments):
    """What binds parameters of a top to each other, a line each; the exit status."""
    known = Space()
    if len(arguments) != 1 or arguments[0] not in known.parameters:
        print(f"parameter_space: a top is wanted, one of {', '.join(known.parameters)}", file=sys.stderr)
        return 2
    print("\n".join(rule.text for rule in known.rules_of(arguments[0])))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
