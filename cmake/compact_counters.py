#!/usr/bin/env python3
"""What Verilator writes to count lines, branches and toggles, made exact and a tenth as long.

    python cmake/compact_counters.py CLASS FOLDER

For each bit of each signal Verilator writes a statement, and for each counter of each instance a call
that names it: two hundred megabytes of C++ of a wide core. Here the bits of a signal that stand one
behind the other become one call of hwffd::toggled (tb/coverage/counted.hpp), and what names counters
becomes a table, without the instances, which nobody asks for.

Counters are made those of the class, plain numbers that nothing sets back. Nothing counts while a model
settles for the first time, since its registers come out of a random number generator: a bit must rise
and fall later. A bit that no statement changes later is a constant of these parameters, and no place.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import sys

_COUNT = r"vlSymsp->__Vcoverage\[(\d+)\]\+\+;"
_TOGGLE = re.compile(rf"if \([^;{{}}]*\) \{{\s*{_COUNT}\s*(vlSelf->\w*__Vtogcov__\w+(?:\[\w+\])?)\s*"
                     r"= ([^;{}]*);\s*\}\s*")
_INSERT = re.compile(
    r'vlSelf->__vlCoverInsert\(&\(vlSymsp->__Vcoverage\[(\d+)\]\), first, "[^"]*", (\d+), (\d+), '
    r'"[^"]*", ("[^"]*"), ("[^"]*"), ("[^"]*")\);\s*')
_FUNCTION = re.compile(r"^(?=(?:VL_\w+ )*void \w+\()", re.MULTILINE)

# The new value of a signal: ((others & before) | NEW), its NEW of one of these two forms.
_NUMBER = r"(0x[0-9a-f]+|\d+)U(?:LL)?"
_KEPT = rf"\({_NUMBER} & (?:\(IData\))?\(?(vlSelf->[\w\[\]]+)\)?\)"
_MASKED = re.compile(rf"\({_KEPT} \| (?:\(IData\))*\(+{_NUMBER} & (.*?)\)+")
_SHIFTED = re.compile(rf"\({_KEPT} \| \(\(QData\)\(\(IData\)\(\(1U & \(IData\)\(\((.*) >> {_NUMBER}\)\)\)\)\)"
                      rf" << {_NUMBER}\)\)")
_FIXED = re.compile(rf"\({_NUMBER} [&|] (?:\(IData\))?\(?(vlSelf->[\w\[\]]+)\)?\)|{_NUMBER}")


def _closed(text):
    """Whether brackets that open in the text close in it, and none else."""
    depth = 0
    for letter in text:
        depth += (letter == "(") - (letter == ")")
        if depth < 0:
            return False
    return depth == 0


def _new_bit(value, before):
    """(the signal that the bit is of, its number), or None where the value has another form."""
    form = _SHIFTED.fullmatch(value)
    if form and form[2] == before and form[4] == form[5] and _closed(form[3]):
        return form[3], int(form[4], 0)
    form = _MASKED.fullmatch(value)
    if form and form[2] == before:
        mask = int(form[3], 0)
        now = form[4] + ")" * (form[4].count("(") - form[4].count(")"))
        if mask and not mask & (mask - 1) and _closed(now):
            return now, mask.bit_length() - 1
    return None


class Toggles:
    """The statements of one function that count toggles, in their new form."""

    def __init__(self, settling):
        self.settling = settling
        self.counted = set()  # counters of bits that may change

    def _run(self, bits):
        """The call for bits that follow each other, with counters that do."""
        now, before, first, counter = bits[0]
        if self.settling:
            return f"hwffd::settled({now}, {before}, {first}, {len(bits)});\n    "
        self.counted.update(bit[3] for bit in bits)
        return (f"hwffd::toggled({now}, {before}, {first}, {len(bits)}, "
                f"&vlSymsp->__Vcoverage[{counter}]);\n    ")

    def _single(self, counter, before, value):
        """The statement for a value of any form that differs in one bit at most."""
        form = _FIXED.fullmatch(value)
        if self.settling or form and form[2] in (None, before):
            return f"{before} = {value};\n    "
        self.counted.add(counter)
        return f"hwffd::moved({value}, {before}, &vlSymsp->__Vcoverage[{counter}]);\n    "

    def rewritten(self, text):
        segments, run, end = [], [], 0

        def flush():
            if run:
                segments.append(self._run(run))
                run.clear()

        for match in _TOGGLE.finditer(text):
            counter, before, value = int(match[1]), match[2], " ".join(match[3].split()).replace("( ", "(")
            bit = _new_bit(value, before)
            if not (run and bit and match.start() == end and (*bit, counter) == (
                    run[0][0], run[0][2] + len(run), run[0][3] + len(run)) and before == run[0][1]):
                flush()
                segments.append(text[end:match.start()])
            end = match.end()
            if bit:
                run.append((bit[0], before, bit[1], counter))
            else:
                segments.append(self._single(counter, before, value))
        flush()
        return "".join([*segments, text[end:]])


def _rewritten(text):
    """(text, counters that may move) of one source."""
    functions, live = [], set()
    for function in _FUNCTION.split(text):
        settling = bool(re.match(r"[^(]*___(?:stl_|eval_initial|eval_static|eval_settle)", function))
        toggles = Toggles(settling)
        function = toggles.rewritten(function)
        if re.match(r"[^(]*___(?:stl_|eval_settle)", function):
            function = re.sub(_COUNT, "", function)
        live |= toggles.counted | {int(counter) for counter in re.findall(_COUNT, function)}
        functions.append(function)
    return "".join(functions), live


def _named(text, live):
    """The text with a table in place of the calls that name counters, those that may move."""
    known = set()

    def table(match):
        rows = [f"{{{n}, {line}, {column}, {page}, {comment}, {lines}}}"
                for n, line, column, page, comment, lines in _INSERT.findall(match[0]) if int(n) in live]
        fresh = [row for row in dict.fromkeys(rows) if row not in known]
        known.update(fresh)
        return ("{\n    static const hwffd::Counter named[] = {\n" + ",\n".join(fresh) + "};\n"
                "    hwffd::name_counters(vlSymsp->__Vcoverage, named);\n    }\n    " if fresh else "")

    text = re.sub(r"VL_COVER_INSERT\(.*?\);", "", text, flags=re.DOTALL)
    return re.sub(rf"(?:{_INSERT.pattern})+", table, text)


def _plain(text):
    """Counters of the class, that are no atomic numbers."""
    text = text.replace("std::atomic<uint32_t> __Vcoverage", "static inline uint32_t __Vcoverage")
    text = re.sub(r"(__Vcoverage\[\d+\])\.fetch_add\(1, std::memory_order_relaxed\)", r"\1++", text)
    return text.replace("std::atomic<uint32_t>", "uint32_t")


def main(name, folder):
    symbols = folder / f"{name}__Syms.h"
    live, texts = set(), {}
    for path in sorted([*folder.glob("*.cpp"), *folder.glob("*.h")]):
        texts[path], counters = _rewritten(_plain(path.read_text(encoding="utf-8")))
        live |= counters
    for path, text in texts.items():
        path.write_text(_named(text, live), encoding="utf-8")
    symbols.write_text('#include "counted.hpp"\n' + symbols.read_text(encoding="utf-8"), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]))
