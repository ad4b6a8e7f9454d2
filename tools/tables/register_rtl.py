"""ffd_bus_registers.v, made from the table of registers (registers.py).

How a field becomes Verilog is in _Rtl: ports, declarations, what a write does, what a read gives,
each by access. The parts around the fields (words, error record, interrupt) are text as it stands.

SPDX-License-Identifier: Apache-2.0
"""

import re
import textwrap

from tools.tables import register_frame

GENERATED = "Made from rtl/bus/registers.csv by tools/tables/registers.py; changes here are lost."

# Fields by whose names the error record, the counters' clear and the interrupt are wired.
_LOG = {"ERROR_COUNT.value": "count", "ERROR_FIRST.code": "code", "ERROR_PACKET.value": "packet",
        "ERROR_BEAT.value": "beat", "ERROR_ADDRESS_LO.value": "address[31:0]",
        "ERROR_ADDRESS_HI.value": "address[63:32]"}
_NEEDED = [*_LOG, "ERROR_FIRST.valid", "CONTROL.clear_counters"]


def missing_fields(registers):
    fields = {field.path: field for register in registers for field in register.fields}
    missing = [path for path in _NEEDED if path not in fields]
    missing += [f"{path} in the error record" for path, field in fields.items()
                if field.access == "log" and path not in _LOG]
    names = {register.name: [field.name for field in register.fields] for register in registers}
    if not [r for r in registers if r.name == "ERROR_STATUS" and r.fields[0].access == "event"]:
        missing.append("ERROR_STATUS of events")
    if "IRQ_STATE" not in names or names.get("IRQ_ENABLE") != names["IRQ_STATE"]:
        missing.append("IRQ_ENABLE with the fields of IRQ_STATE")
    return missing


def _bits(high, low):
    return f"[{high}]" if high == low else f"[{high}:{low}]"


def _range(width):
    return "" if width == 1 else f"[{width - 1}:0]"


def _word(register):
    return f"10'h{register.offset // 4:03x}"


def signal_name(field):
    """Name in the RTL, and which bits of it: value fields of X_LO and X_HI are the halves of x."""
    register = field.register.lower()
    if field.name != "value":
        return f"{register}_{field.name}", ""
    half = re.fullmatch(r"(.*)_(lo|hi)", register)
    if half:
        return half.group(1), "[31:0]" if half.group(2) == "lo" else "[63:32]"
    return register, ""


class _Rtl:
    """The lines of ffd_bus_registers, collected field by field."""

    def __init__(self, registers):
        self.registers = registers
        self.fields = {f.path: f for register in registers for f in register.fields}
        self.ports, self.blocks, self.counters = [], [], []
        # Declarations, each before its use.
        self.hits, self.states, self.refusals, self.sets, self.more_sets = [], [], [], [], []
        self.resets, self.lines = [], []  # of the register at hand
        for register in registers:
            self.register(register)

    @property
    def wires(self):
        return self.hits + self.states + self.refusals + self.sets + self.more_sets

    def value(self, field):
        """What a read of the field gives, as an expression of its width."""
        name, bits = signal_name(field)
        if field.access == "const":
            return f"{field.width}'h{field.reset:x}"
        if field.access == "w1":
            return "1'b0"
        if field.access == "log":
            return f"log_{_LOG[field.path]}"
        if field.access == "event":
            return f"{field.register.lower()}_q[{field.low}]"
        suffix = {"ro": "_i", "rw": "_o", "w1s": "_o", "w1c": "_q", "counter": ""}[field.access]
        return f"{name}{suffix}{bits}"

    def port(self, direction, width, name):
        text = f"  {direction:<11} {_range(width):<6} {name}"
        if text not in self.ports:
            self.ports.append(text)

    def written(self, field):
        return f"write_{field.register.lower()} && ones[{field.low}]"

    def setters(self, field):
        """Expressions that set a w1c field."""
        name = signal_name(field)[0]
        expressions = []
        for target in field.linked("with"):
            if target in self.fields:
                expressions.append(f"{signal_name(self.fields[target])[0]}_set")
            else:
                expressions.append("error_any_i")
        others = self.fields.values()
        expressions += [f"{signal_name(other)[0]}_refused" for other in others
                        if field.path in other.linked("refused")]
        return (expressions or [f"{name}_set_i"]) + [f"({self.written(other)})" for other in others
                                                     if field.path in other.linked("sets")]

    def register(self, register):
        name = register.name.lower()
        if register.writable:
            lock = self.lock(register)
            self.hits.append(textwrap.fill(
                f"  wire write_{name} = s_write_valid && to_{name}_q"
                f"{' && !' + lock if lock else ''};", 100, subsequent_indent=" " * 4))
        self.resets, self.lines = [], []
        if register.fields[0].access == "event":
            self.events(register)
        else:
            for field in register.fields:
                if field.access not in ("const", "log"):  # no storage, no port
                    getattr(self, field.access)(field)
        if self.resets:
            self.block(register)

    def block(self, register):
        lines = [f"  // 0x{register.offset:03X} {register.name}", "  always @(posedge clk) begin",
                 "    if (rst) begin", *[f"      {line};" for line in self.resets],
                 "    end else begin"]
        stored = [field for field in register.fields if field.access == "rw"]
        if stored:
            lines += [f"      if (write_{register.name.lower()}) begin",
                      *[f"        {line};" for field in stored for line in self.merge(field)],
                      "      end"]
        lines += [*[textwrap.fill(f"{line};", 100, initial_indent=" " * 6, subsequent_indent=" " * 8)
                    for line in self.lines], "    end", "  end"]
        self.blocks.append("\n".join(lines))

    def lock(self, register):
        return self.value(self.fields[register.lock]) if register.lock else None

    def ro(self, field):
        name, bits = signal_name(field)
        self.port("input  wire", 64 if bits else field.width, f"{name}_i")

    def rw(self, field):
        name, bits = signal_name(field)
        self.port("output reg", 64 if bits else field.width, f"{name}_o")
        self.resets.append(f"{name}_o{bits} <= {field.width}'h{field.reset:x}")

    @staticmethod
    def needs(field):
        """Without its parameter a field stays 0."""
        return "".join(f"{target} != 0 && " for target in field.linked("if"))

    def merge(self, field):
        """A statement a byte: that keeps its bits where it has no strobe."""
        name, bits = signal_name(field)
        base, high, lines = 32 if bits == "[63:32]" else 0, field.low + field.width, []
        needs = self.needs(field)
        for byte in range(field.low // 8, (high + 7) // 8):
            low, top = max(8 * byte, field.low), min(8 * byte + 8, high) - 1
            part = _bits(base + top - field.low, base + low - field.low) if field.width > 1 else ""
            data = "high_data" if base else "s_write_data"
            lines.append(f"if ({needs}s_write_strobe[{byte}]) {name}_o{part} <= {data}{_bits(top, low)}")
        return lines

    def stored(self):
        """Blocks of four registers with one that is a single rw field of 32 bits: what is read of
        these registers is read from a memory."""
        blocks, words = {}, []
        for register in self.registers:
            field = register.fields[0]
            if field.access == "rw" and field.width == 32:
                blocks.setdefault(register.offset // 16, len(blocks))
                words.append(register)
        return blocks, words

    def w1s(self, field):
        name = signal_name(field)[0]
        self.port("output reg", 1, f"{name}_o")
        self.resets.append(f"{name}_o <= 1'b{field.reset}")
        self.lines.append(f"if ({self.written(field)}) {name}_o <= 1'b1")

    def w1(self, field):
        if field.linked("sets"):
            return
        name = signal_name(field)[0]
        self.port("output reg", 1, f"{name}_o")
        self.resets.append(f"{name}_o <= 1'b0")
        blocks = [self.value(self.fields[path]) for path in field.linked("unless")]
        blocks += [f"!{self.value(self.fields[path])}" for path in field.linked("needs")]
        if not blocks:
            self.lines.append(f"{name}_o <= {self.written(field)}")
            return
        self.refusals += [
            f"  wire {name}_asked = {self.written(field)};",
            textwrap.fill(f"  wire {name}_blocked = {' || '.join(blocks)} || {name}_o;", 100,
                          subsequent_indent=" " * 4),
            f"  wire {name}_refused = {name}_asked && {name}_blocked;"]
        self.lines.append(f"{name}_o <= {name}_asked && !{name}_blocked")

    def w1c(self, field):
        name = signal_name(field)[0]
        setters = self.setters(field)
        if f"{name}_set_i" in setters:
            self.port("input  wire", 1, f"{name}_set_i")
        self.states.append(f"  reg {name}_q;")
        lines = self.more_sets if field.linked("with") else self.sets
        lines += [f"  wire {name}_set = {' || '.join(setters)};",
                  f"  wire {name}_held = {name}_q && !({self.written(field)});"]
        self.resets.append(f"{name}_q <= 1'b{field.reset}")
        needs = self.needs(field)
        held = f"{name}_set || {name}_held"
        self.lines.append(f"{name}_q <= {needs}({held})" if needs else f"{name}_q <= {held}")

    def counter(self, field):
        name, bits = signal_name(field)
        if bits != "[31:0]":
            return
        self.port("input  wire", 1, f"{name}_event_i")
        self.port("input  wire", 1, f"{name}_second_i")
        register = next(r for r in self.registers if r.name == field.register)
        self.states.append(f"  wire [63:0] {name};")
        self.counters.append(f"""\
  ffd_bus_counter u_{name} (
    .clk     (clk),
    .rst     (rst),
    .event_i ({name}_event_i),
    .second_i({name}_second_i),
    .clear_i (control_clear_counters_o),
    .latch_i (s_read_valid && at_{register.name.lower()}_q),
    .low_o   ({name}[31:0]),
    .high_o  ({name}[63:32])
  );""")

    def events(self, register):
        name, width = register.name.lower(), len(register.fields)
        for port, bits in (("any", 1), ("event", width), ("packet", 32), ("beat", 32), ("address_valid", 1),
                           ("address", 64)):
            self.port("input  wire", bits, f"error_{port}_i")
        self.states.append(f"  reg {_range(width)} {name}_q;")
        self.sets += [
            f"  wire {_range(width)} {name}_held = {name}_q"
            f" & ~(ones{_bits(width - 1, 0)} & {{{width} {{write_{name}}}}});"]
        self.resets.append(f"{name}_q <= {width}'h0")
        self.lines.append(f"{name}_q <= error_event_i | {name}_held")

    def read_value(self, register):
        pieces, at = [], 32
        for field in sorted(register.fields, key=lambda field: -field.low):
            high = field.low + field.width
            if high < at:
                pieces.append(f"{at - high}'h0")
            pieces.append(self.value(field))
            at = field.low
        if at:
            pieces.append(f"{at}'h0")
        if register.fields[0].access == "event":
            width = len(register.fields)
            pieces = [f"{32 - width}'h0"] * (width < 32) + [f"{register.name.lower()}_q"]
        return pieces[0] if len(pieces) == 1 else "{" + ", ".join(pieces) + "}"

    def block_case(self, name, word):
        blocks = self.stored()[0]
        width = max(len(blocks) - 1, 1).bit_length()
        arms = [f"      8'h{block:02x}: {name} = {width}'d{number};"
                for block, number in blocks.items() if number]
        return "\n".join([f"    case ({word}[9:2])", *arms,
                          f"      default: {name} = {width}'d0;", "    endcase"])

    def stored_text(self):
        blocks, words = self.stored()
        width = max(len(blocks) - 1, 1).bit_length()
        hits = {name: textwrap.fill(
            f"  wire write_{name} = " + " || ".join(f"write_{register.name.lower()}" for register in own) + ";",
            100, subsequent_indent=" " * 4) for name, own in (
                ("stored", words), ("high", [register for register in words if register.name.endswith("_HI")]))}
        return register_frame.STORED.format(
            width=_range(width), slot=_range(width + 2), words=4 << width,
            write_case=self.block_case("write_block", "s_write_word"),
            read_case=self.block_case("read_block", "s_read_word"),
            hits=hits["stored"], high_hits=hits["high"])

    def read_parts(self):
        """(Name of the register that says so, words at which it is 1, value read there.)"""
        stored = self.stored()[1]
        reads = [("at_stored_q", stored, "stored_word")]
        return reads + [(f"at_{register.name.lower()}_q", [register], self.read_value(register))
                        for register in self.registers if register not in stored]

    def write_parts(self):
        """The same of writes, and the lock; one for all registers that share a lock, or have none."""
        groups = {}
        for register in self.registers:
            if register.writable:
                groups.setdefault(self.lock(register), []).append(register)
        return [(f"to_{'locked' if lock else 'open'}_q" if at < 2 else f"to_locked{at}_q", group,
                 lock) for at, (lock, group) in enumerate(groups.items())]

    @staticmethod
    def all_need(register):
        """Parameters without which there is no field of it."""
        return set.intersection(*({f"{target} != 0 && " for target in field.linked("if")}
                                  for field in register.fields))

    def hit(self, word, register, unread):
        """That it is asked for; parameters that are said already are not said again."""
        own = "".join(sorted(self.all_need(register) - unread))
        compared = f"{own}{word} == {_word(register)}"
        return (f"({compared})" if own else compared).replace(" ", "~")

    def decoded(self):
        """Registers that say which word is asked for, from the clock before."""
        reads = [(name, words) for name, words, _ in self.read_parts()]
        writes = [(name, words) for name, words, _ in self.write_parts()]
        writes += [(f"to_{register.name.lower()}_q", [register]) for register in self.registers
                   if register.writable]
        lines = [f"  reg {name};" for name, _ in writes + reads]
        lines += ["", "  always @(posedge clk) begin"]
        for items, word in ((writes, "s_write_word"), (reads, "s_read_word")):
            for name, words in items:
                needs = set.intersection(*map(self.all_need, words))
                # A comparison stays on a line.
                hits = " || ".join(self.hit(word, register, needs) for register in words)
                lines.append(textwrap.fill(f"    {name} <= {''.join(sorted(needs))}{hits};", 100,
                                           subsequent_indent=" " * 6).replace("~", " "))
        return "\n".join([*lines, "  end"])

    def write_error(self):
        known = [f"({name} && !{lock})" if lock else name for name, _, lock in self.write_parts()]
        return f"  assign s_write_error = !({' || '.join(known)});"

    def read_data(self):
        """What an unknown word reads is 0."""
        terms = [textwrap.fill(f"({{32 {{{name}}}}} & {value})", 98, initial_indent=" " * 4,
                               subsequent_indent=" " * 6) for name, _, value in self.read_parts()]
        names = " || ".join(name for name, _, _ in self.read_parts())
        error = textwrap.fill(f"  assign s_read_error = !({names});", 100,
                              subsequent_indent=" " * 4)
        return "\n".join(["  assign s_read_data =", " |\n".join(terms) + ";", error])

    def interrupts(self):
        names = [f.name for r in self.registers if r.name == "IRQ_STATE" for f in r.fields]
        return " ||\n        ".join(f"(irq_state_{n}_q && irq_enable_{n}_o)" for n in names)


def rtl_text(registers):
    rtl = _Rtl(registers)
    codes = next(len(r.fields) for r in registers if r.name == "ERROR_STATUS")
    log = "\n".join(f"  wire {_range(width):<6} log_{name};" for name, width in (
        ("count", 32), ("code", 5), ("packet", 32), ("beat", 32), ("address", 64)))
    ports = ",\n".join(rtl.ports + ["  output reg         irq_o"])
    blocks = "\n\n".join(rtl.blocks)
    counters = "\n\n".join(rtl.counters)
    return f"""{register_frame.HEADER.format(generated=GENERATED)}`default_nettype none

module ffd_bus_registers #(
  parameter WAITS         = 1,
  parameter MARKS         = 1,
  parameter HARDENED      = 0,
  parameter ADDRESS_WIDTH = 64
) (
{register_frame.BUS}{ports}
);
{register_frame.WORDS}
{rtl.decoded()}

{chr(10).join(rtl.wires)}

{log}

{rtl.stored_text()}
{register_frame.ERRORS.format(codes=codes)}
{counters}

{blocks}

  always @(posedge clk) begin
    if (rst) begin
      irq_o <= 1'b0;
    end else begin
      irq_o <=
        {rtl.interrupts()};
    end
  end

  wire unused_ok = &{{1'b0, ones}};

{rtl.write_error()}

{rtl.read_data()}
endmodule

`default_nettype wire
"""
