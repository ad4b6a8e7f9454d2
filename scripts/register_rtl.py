"""ffd_axil_registers.v, made from the table of registers (registers.py).

How a field becomes Verilog is in _Rtl: ports, declarations, what a write does, what a read gives,
each by access. The parts around the fields (bus, error record, interrupt) are text as it stands.

SPDX-License-Identifier: Apache-2.0
"""

import re
import textwrap

import register_frame

GENERATED = "Made from rtl/bus/registers.csv by scripts/registers.py; changes here are lost."

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
    """The lines of ffd_axil_registers, collected field by field."""

    def __init__(self, registers):
        self.registers = registers
        self.fields = {f.path: f for register in registers for f in register.fields}
        self.ports, self.blocks, self.counters = [], [], []
        # Declarations, each before its use.
        self.hits, self.states, self.refusals, self.sets, self.more_sets = [], [], [], [], []
        self.named = []  # registers of the clock before a write, which say what it writes
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
        found = []
        for target in field.linked("with"):
            if target in self.fields:
                found.append(f"{signal_name(self.fields[target])[0]}_set")
            else:
                found.append("error_any")
        for other in self.fields.values():
            if field.path in other.linked("refused"):
                found.append(f"{signal_name(other)[0]}_refused")
            if field.path in other.linked("sets"):
                found.append(f"({self.written(other)})")
        return found or [f"{name}_set_i"]

    def register(self, register):
        name = register.name.lower()
        if register.writable:
            lock = self.lock(register)
            self.hits += [f"  reg write_{name}_q;",
                          textwrap.fill(f"  wire write_{name} = write && write_{name}_q"
                                        f"{' && !' + lock if lock else ''};", 100,
                                        subsequent_indent=" " * 4)]
            self.named.append(f"      write_{name}_q <= write_next_word == {_word(register)};")
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
        lines += [*[f"      {line};" for line in self.lines], "    end", "  end"]
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

    def merge(self, field):
        """A statement a byte: that keeps its bits where it has no strobe."""
        name, bits = signal_name(field)
        base, high, lines = 32 if bits == "[63:32]" else 0, field.low + field.width, []
        for byte in range(field.low // 8, (high + 7) // 8):
            low, top = max(8 * byte, field.low), min(8 * byte + 8, high) - 1
            part = _bits(base + top - field.low, base + low - field.low) if field.width > 1 else ""
            data = "high_data" if base else "write_data"
            lines.append(f"if (write_strobe[{byte}]) {name}_o{part} <= {data}{_bits(top, low)}")
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
        if setters == [f"{name}_set_i"]:
            self.port("input  wire", 1, f"{name}_set_i")
        self.states.append(f"  reg {name}_q;")
        found = self.more_sets if field.linked("with") else self.sets
        found += [f"  wire {name}_set = {' || '.join(setters)};",
                  f"  wire {name}_held = {name}_q && !({self.written(field)});"]
        self.resets.append(f"{name}_q <= 1'b{field.reset}")
        self.lines.append(f"{name}_q <= {name}_set || {name}_held")

    def counter(self, field):
        name, bits = signal_name(field)
        if bits != "[31:0]":
            return
        self.port("input  wire", 1, f"{name}_event_i")
        register = next(r for r in self.registers if r.name == field.register)
        self.states.append(f"  wire [63:0] {name};")
        self.counters.append(f"""\
  ffd_axil_counter u_{name} (
    .clk    (clk),
    .rst    (rst),
    .event_i({name}_event_i),
    .clear_i(control_clear_counters_o),
    .latch_i(read && read_of_q[{self.read_place(register)}]),
    .low_o  ({name}[31:0]),
    .high_o ({name}[63:32])
  );""")

    def events(self, register):
        name, width = register.name.lower(), len(register.fields)
        for port, bits in (("event", width), ("packet", 32), ("beat", 32), ("address_valid", 1),
                           ("address", 64)):
            self.port("input  wire", bits, f"error_{port}_i")
        self.states.append(f"  reg {_range(width)} {name}_q;")
        self.sets += [
            "  wire error_any = |error_event_i;",
            f"  wire {_range(width)} {name}_held = {name}_q"
            f" & ~(ones{_bits(width - 1, 0)} & {{{width} {{write_{name}}}}});"]
        self.resets.append(f"{name}_q <= {width}'h0")
        self.lines.append(f"{name}_q <= error_event_i | {name}_held")

    def read_value(self, register):
        parts, at = [], 32
        for field in sorted(register.fields, key=lambda field: -field.low):
            high = field.low + field.width
            if high < at:
                parts.append(f"{at - high}'h0")
            parts.append(self.value(field))
            at = field.low
        if at:
            parts.append(f"{at}'h0")
        if register.fields[0].access == "event":
            width = len(register.fields)
            parts = [f"{32 - width}'h0"] * (width < 32) + [f"{register.name.lower()}_q"]
        return parts[0] if len(parts) == 1 else "{" + ", ".join(parts) + "}"

    def block_case(self, name, word):
        blocks = self.stored()[0]
        width = max(len(blocks) - 1, 1).bit_length()
        arms = [f"        8'h{block:02x}: {name} <= {width}'d{number};"
                for block, number in blocks.items() if number]
        return "\n".join([f"      case ({word}[9:2])", *arms,
                          f"        default: {name} <= {width}'d0;", "      endcase"])

    def stored_text(self):
        blocks, words = self.stored()
        width = max(len(blocks) - 1, 1).bit_length()
        return register_frame.STORED.format(
            width=_range(width), words=4 << width,
            write_case=self.block_case("write_block_q", "write_next_word"),
            read_case=self.block_case("read_block_q", "read_next_word"),
            write_words=self.word_case("write", "stored_q", words, "1'b1", "1'b0"),
            write_highs=self.word_case(
                "write", "high_q", [r for r in words if r.name.endswith("_HI")], "1'b1", "1'b0"),
            read_words=self.word_case("read", "stored_q", words, "1'b1", "1'b0"))

    @staticmethod
    def word_case(side, name, registers, inside, outside):
        words = ", ".join(map(_word, registers))
        return "\n".join([
            f"      case ({side}_next_word)",
            textwrap.fill(f"{words}: {side}_{name} <= {inside};", 100,
                          initial_indent=" " * 8, subsequent_indent=" " * 8),
            f"        default: {side}_{name} <= {outside};", "      endcase"])

    def read_apart(self):
        """The registers that are not read from the memory, in the order of read_of_q."""
        stored = self.stored()[1]
        return [register for register in self.registers if register not in stored]

    def read_place(self, register):
        return self.read_apart().index(register)

    def reads(self):
        """What the read at hand names, a bit a register, and the words that they choose from."""
        words, decoded = ["(stored_word & {32 {read_stored_q}})"], []
        for place, register in enumerate(self.read_apart()):
            decoded.append(f"      read_of_q[{place}] <= read_next_word == {_word(register)};")
            if register.fields[0].access != "w1":
                words.append(textwrap.fill(
                    f"({self.read_value(register)} & {{32{{read_of_q[{place}]}}}})", 94,
                    subsequent_indent=" " * 4, tabsize=1).replace("\n", "\n    "))
        return {"declared": f"  reg {_range(len(decoded))} read_of_q;",
                "decoded": "\n".join(decoded), "words": " |\n    ".join(words),
                "unknown": self.word_case("read", "unknown_q", self.registers, "1'b0", "1'b1")}

    def refusals_of_writes(self):
        """Unknown words, and those under a lock: declarations, cases, and the error."""
        locks = {}
        for register in self.registers:
            if register.writable:
                locks.setdefault(self.lock(register), []).append(register)
        open_ones = locks.pop(None, [])
        every = open_ones + [register for group in locks.values() for register in group]
        names = [(lock, f"locked{number or ''}", group)
                 for number, (lock, group) in enumerate(locks.items())]
        declared = ["  reg write_unknown_q;", *[f"  reg write_{name}_q;" for _, name, _ in names]]
        cases = [self.word_case("write", "unknown_q", every, "1'b0", "1'b1")]
        cases += [self.word_case("write", f"{name}_q", group, "1'b1", "1'b0")
                  for _, name, group in names]
        error = " || ".join(["write_unknown_q"]
                            + [f"(write_{name}_q && {lock})" for lock, name, _ in names])
        return {"declared": "\n".join(declared), "cases": "\n".join(cases), "error": error}

    def interrupts(self):
        names = [f.name for r in self.registers if r.name == "IRQ_STATE" for f in r.fields]
        return " ||\n        ".join(f"(irq_state_{n}_q && irq_enable_{n}_o)" for n in names)


def _log_wires():
    return "\n".join(f"  wire {_range(width):<6} log_{name};" for name, width in (
        ("count", 32), ("code", 5), ("packet", 32), ("beat", 32), ("address", 64)))


def rtl_text(registers):
    rtl = _Rtl(registers)
    codes = next(len(r.fields) for r in registers if r.name == "ERROR_STATUS")
    ports = ",\n".join(rtl.ports + ["  output reg         irq_o"])
    blocks = "\n\n".join(rtl.blocks)
    counters = "\n\n".join(rtl.counters)
    reads, refusals = rtl.reads(), rtl.refusals_of_writes()
    return f"""{register_frame.HEADER.format(generated=GENERATED)}`default_nettype none

module ffd_axil_registers #(
  parameter SECURE_ONLY   = 0,
  parameter ADDRESS_WIDTH = 64
) (
{register_frame.BUS}{ports}
);
{register_frame.SLAVE}
{refusals["declared"]}
  reg read_unknown_q;
{reads["declared"]}
{chr(10).join(rtl.wires)}

{_log_wires()}

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

  wire unused_ok = &{{1'b0, ones, write_mask, write_word[9:2], read_word[9:2], read_of_q}};

  // What the request of the next clock names.
  always @(posedge clk) begin
    if (write_next) begin
{chr(10).join(rtl.named)}
{refusals["cases"]}
    end
    if (read_next) begin
{reads["decoded"]}
{reads["unknown"]}
    end
  end

  assign write_error = {refusals["error"]};
  assign read_error  = read_unknown_q;
  assign read_data   =
    {reads["words"]};
endmodule

`default_nettype wire
"""
