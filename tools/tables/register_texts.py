"""C header and document that follow from the table of registers (registers.py).

SPDX-License-Identifier: Apache-2.0
"""

from tools.tables.register_rtl import GENERATED


def header_text(registers):
    lines = [f"/* {GENERATED}", " * Registers, and how to use them: docs/registers.md.",
             " * SPDX-License-Identifier: Apache-2.0 */", "#ifndef HWFFD_REGISTERS_H",
             "#define HWFFD_REGISTERS_H", ""]
    for register in registers:
        prefix = f"HWFFD_{register.name}"
        lines.append(f"#define {prefix}_OFFSET 0x{register.offset:03X}u")
        for field in register.fields:
            name = prefix if field.name == "value" else f"{prefix}_{field.name.upper()}"
            lines.append(f"#define {name}_SHIFT {field.low}")
            lines.append(f"#define {name}_MASK 0x{field.mask:08X}u")
            if field.access in ("const", "rw"):
                lines.append(f"#define {name}_RESET 0x{field.reset:X}u")
        lines.append("")
    return "\n".join(lines + ["#endif"]) + "\n"


def events(registers):
    """[Field] of the register of events, in the order of their bits."""
    return next(register.fields for register in registers if register.fields[0].access == "event")


def events_rtl_text(registers):
    lines = [f"`define FFD_EVENT_{field.name.upper():<20} {field.low}" for field in events(registers)]
    return "\n".join([f"// {GENERATED}",
                      "// Events of the core and of its buses: bits of ERROR_STATUS (docs/registers.md).",
                      "// SPDX-License-Identifier: Apache-2.0", "`ifndef FFD_EVENTS_VH",
                      "`define FFD_EVENTS_VH", *lines, "`endif"]) + "\n"


def events_header_text(registers):
    def constant(field):
        return "k" + "".join(word.capitalize() for word in field.name.split("_"))

    lines = ",\n".join(f"  {constant(field)} = {field.low}" for field in events(registers))
    last = constant(events(registers)[-1])
    return "\n".join([f"// {GENERATED}", "#pragma once", "", "namespace hwffd::event {", "",
                      "/// What may go wrong in the core and on its buses: bits of ERROR_STATUS",
                      "/// (docs/registers.md). Those up to kSaturated and from kPagePoints on are",
                      "/// events of the stream.",
                      "enum Code : unsigned {", lines, "};", "",
                      "}  // namespace hwffd::event", "", "namespace hwffd {", "",
                      "/// The bit of event_o: those of the DMA lie between in ERROR_STATUS.",
                      "constexpr unsigned stream_event(event::Code code) {",
                      "  return code <= event::kSaturated ? code : code - event::kPagePoints + 1 + "
                      "event::kSaturated;",
                      "}", "",
                      "/// Kinds of events of the stream.",
                      f"constexpr int kStreamEvents = stream_event(event::{last}) + 1;", "",
                      "}  // namespace hwffd"]) + "\n"


def _bits(field):
    high = field.low + field.width - 1
    return f"{high}" if high == field.low else f"{high}:{field.low}"


def _markdown_link(field):
    words = {"locked": "locked by", "unless": "refused while", "needs": "needs",
             "refused": "refused: sets",
             "with": "set with", "sets": "sets", "if": "there with parameter"}
    return "; ".join(f"{words[kind]} `{target}`" for kind, target in field.links
                     if kind != "sets")


def docs_text(registers, preamble):
    """The page: the preamble, then one table, in which a register's first field has its offset and name."""
    lines = [preamble.rstrip("\n"), "", "| offset | register | bits | field | access | reset | meaning |",
             "|---|---|---|---|---|---|---|"]
    offsets = {register.name: register.offset for register in registers}
    for register in registers:
        if register.name.endswith("_HI") and register.name[:-3] + "_LO" in offsets:
            continue
        place = f"0x{register.offset:03X} | `{register.name}`"
        high = offsets.get(register.name[:-3] + "_HI") if register.name.endswith("_LO") else None
        if high is not None:
            place = f"0x{register.offset:03X}, 0x{high:03X} | `{register.name}`, `_HI`"
        for field in register.fields:
            reset = "-" if field.access in ("ro", "w1") else f"0x{field.reset:X}"
            link = _markdown_link(field)
            meaning = field.description.replace(", bits 31:0", "") + (f" ({link})" if link else "")
            lines.append(f"| {place} | {_bits(field)} | `{field.name}` | {field.access} | {reset} | {meaning} |")
            place = " | "
    return "\n".join(lines) + "\n"
