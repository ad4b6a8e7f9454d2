"""C header and document that follow from the table of registers (registers.py).

SPDX-License-Identifier: Apache-2.0
"""

import textwrap

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


# Events of the stream are those up to the first of these and from the second on; the DMA's lie between.
LAST_BEFORE_DMA, FIRST_AFTER_DMA = "saturated", "page_points"


def _between(registers):
    """How many bits of ERROR_STATUS are no events of the stream."""
    names = [field.name for field in events(registers)]
    return names.index(FIRST_AFTER_DMA) - names.index(LAST_BEFORE_DMA) - 1


def events_rtl_text(registers):
    count, between = len(events(registers)), _between(registers)
    lines = [f"`define FFD_EVENT_{field.name.upper():<20} {field.low}" for field in events(registers)]
    return "\n".join([f"// {GENERATED}",
                      "// Events of the core and of its buses: bits of ERROR_STATUS (docs/registers.md).",
                      "// SPDX-License-Identifier: Apache-2.0", "`ifndef FFD_EVENTS_VH",
                      "`define FFD_EVENTS_VH", *lines, "",
                      "// How many these are; how many of them are events of the stream, and which of those one is: a",
                      "// pulse of event_o each (docs/interface.md section 5).",
                      f"`define FFD_ERRORS                     {count}",
                      f"`define FFD_EVENTS                     {count - between}",
                      "`define FFD_STREAM_EVENT(BIT) \\",
                      f"  ((BIT) > `FFD_EVENT_{LAST_BEFORE_DMA.upper()} ? (BIT) - {between} : (BIT))", "`endif"]) + "\n"


def events_header_text(registers):
    def constant(name):
        return "k" + "".join(word.capitalize() for word in name.split("_"))

    lines = ",\n".join(f"  {constant(field.name)} = {field.low}" for field in events(registers))
    before, after = constant(LAST_BEFORE_DMA), constant(FIRST_AFTER_DMA)
    last = constant(events(registers)[-1].name)
    return "\n".join([f"// {GENERATED}", "#pragma once", "", "namespace hwffd::event {", "",
                      "/// What may go wrong in the core and on its buses: bits of ERROR_STATUS",
                      f"/// (docs/registers.md). Those up to {before} and from {after} on are",
                      "/// events of the stream.",
                      "enum Code : unsigned {", lines, "};", "",
                      "}  // namespace hwffd::event", "", "namespace hwffd {", "",
                      "/// The bit of event_o: those of the DMA lie between in ERROR_STATUS.",
                      "constexpr unsigned stream_event(event::Code code) {",
                      f"  return code <= event::{before} ? code : code - event::{after} + 1 + event::{before};",
                      "}", "",
                      "/// Kinds of all of them.",
                      f"constexpr int kErrors = event::{last} + 1;", "",
                      "/// Kinds of events of the stream.",
                      f"constexpr int kStreamEvents = stream_event(event::{last}) + 1;", "",
                      "}  // namespace hwffd"]) + "\n"


def features(registers):
    """[Field] of the register FEATURES, whose bits are those of the parameter; none where there is no such register."""
    return [field for register in registers if register.name == "FEATURES" for field in register.fields]


# Features that follow from a parameter: where it is above a number.
FOLLOWS = {"large": ("AXIS", 32), "spans": ("SPANS", 1)}


def parameter(feature):
    """The parameter of the tops, 0 or 1, that is a feature which follows from no other."""
    return "PAGED" if feature == "pages" else feature.upper()


def condition(feature):
    """When a core has a feature, of its parameters."""
    return "{} > {}".format(*FOLLOWS[feature]) if feature in FOLLOWS else f"{parameter(feature)} != 0"


def features_rtl_text(registers):
    lines = [f"`define {f'FFD_FEATURE_{field.name.upper()}(FEATURES)':<33} (((FEATURES) >> {field.low}) % 2)"
             for field in features(registers)]
    # A term of the sum stays on one line.
    terms = [f"({condition(field.name)} ? {field.mask} : 0)".replace(" ", "~") for field in features(registers)]
    word = textwrap.wrap(f"`define FFD_FEATURES_NAMED ({' + '.join(terms)})", 94)
    return "\n".join([f"// {GENERATED}", "// What a core has, bits of FEATURES; docs/registers.md section 5.",
                      "// SPDX-License-Identifier: Apache-2.0", "`ifndef FFD_FEATURES_VH", "`define FFD_FEATURES_VH", *lines,
                      "// FEATURES of a module with the parameters of hwffd_stream.",
                      " \\\n  ".join(word).replace("~", " "), "`endif"]) + "\n"


def features_header_text(registers):
    lines = [f"  k{field.name.capitalize()}Feature = 1U << {field.low}," for field in features(registers)]
    return "\n".join([f"// {GENERATED}", "#pragma once", "", "#include <cstdint>", "", "namespace hwffd::model {", "",
                      "/// What a core has, as the register FEATURES says it.",
                      "enum Feature : std::uint32_t {", *lines, "};", "", "}  // namespace hwffd::model"]) + "\n"


def _bits(field):
    high = field.low + field.width - 1
    return f"{high}" if high == field.low else f"{high}:{field.low}"


# What the tops call a parameter of the registers.
_PARAMETERS = {"WAITS": "COUNT_WIDTH"}


def _markdown_link(field):
    words = {"locked": "locked by", "unless": "refused while", "needs": "needs",
             "refused": "refused: sets",
             "with": "set with", "sets": "sets", "if": "with"}
    return "; ".join(f"{words[kind]} `{_PARAMETERS.get(target, target)}`" for kind, target in field.links
                     if kind != "sets")


def docs_text(registers, preamble):
    """The page: the preamble, then one table, in which a register's first field has its offset and name."""
    lines = [preamble.rstrip("\n"), "", "| register | bits | field | access | reset | meaning |",
             "|---|---|---|---|---|---|"]
    offsets = {register.name: register.offset for register in registers}
    for register in registers:
        if register.name.endswith("_HI") and register.name[:-3] + "_LO" in offsets:
            continue
        place = f"0x{register.offset:03X} `{register.name}`"
        high = offsets.get(register.name[:-3] + "_HI") if register.name.endswith("_LO") else None
        if high is not None:
            place = f"0x{register.offset:03X}, 0x{high:03X} `{register.name}`, `_HI`"
        for field in register.fields:
            reset = "-" if field.access in ("ro", "w1") else f"0x{field.reset:X}"
            link = _markdown_link(field)
            meaning = field.description.replace(", bits 31:0", "") + (f" ({link})" if link else "")
            lines.append(f"| {place} | {_bits(field)} | `{field.name}` | {field.access} | {reset} | {meaning} |")
            place = ""
    return "\n".join(lines) + "\n"
