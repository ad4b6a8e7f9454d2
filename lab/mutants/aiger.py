"""And-inverter graphs in AIGER's binary form, as yosys writes them with symbols; and the graph of a step
of two designs.

A literal is twice the number of a variable, and one more where it is inverted; 0 is false. Variables are
inputs, then registers, then gates.

SPDX-License-Identifier: Apache-2.0
"""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Graph:
    """A design. All registers are zero at first."""

    inputs: list     # the names of each, as one set
    registers: list
    following: list  # of each register, the literal of its next value
    outputs: dict    # literals by name
    gates: list      # pairs of literals


def _number(data, place):
    """(a number of as many bytes as have their highest bit set, and one more; the place behind it)."""
    number = shift = 0
    while True:
        byte = data[place]
        number |= (byte & 0x7F) << shift
        place, shift = place + 1, shift + 7
        if byte < 0x80:
            return number, place


def _bytes(number):
    """The same the other way round."""
    out = bytearray()
    while number >= 0x80:
        out.append(number & 0x7F | 0x80)
        number >>= 7
    return bytes([*out, number])


def read(path):
    data = path.read_bytes()
    place = data.index(b"\n")
    _, inputs, registers, outputs, gates = map(int, data[:place].split()[1:6])
    lines = data.split(b"\n", registers + outputs + 1)
    place += 1 + sum(len(line) + 1 for line in lines[1:1 + registers + outputs])
    values = [int(line.split()[0]) for line in lines[1:1 + registers + outputs]]
    pairs = []
    for number in range(inputs + registers + 1, inputs + registers + gates + 1):
        first, place = _number(data, place)
        second, place = _number(data, place)
        pairs.append((2 * number - first, 2 * number - first - second))
    names = {"i": [set() for _ in range(inputs)], "l": [set() for _ in range(registers)],
             "o": [set() for _ in range(outputs)]}
    for line in data[place:].decode().split("\nc\n")[0].splitlines():
        if line[:1] in names:
            which, *aliases = line.split(" ")
            names[which[0]][int(which[1:])].update(aliases)
    return Graph(names["i"], names["l"], values[:registers],
                 {name: values[registers + number] for number, all_of in enumerate(names["o"]) for name in all_of},
                 pairs)


class _Gates:
    """Gates behind so many variables, each once."""

    def __init__(self, variables):
        self.first = variables + 1
        self.known = {}

    def both(self, one, other):
        low, high = sorted((one, other))
        if low == 0 or low ^ 1 == high:
            return 0
        if low in (1, high):
            return high
        return self.known.setdefault((high, low), 2 * (self.first + len(self.known)))

    def differ(self, one, other):
        return self.both(self.both(one, other) ^ 1, self.both(one ^ 1, other ^ 1) ^ 1)

    def added(self, graph, variables):
        """The literal of each literal of a graph, of whose inputs and registers these are the literals."""
        mine = [0, *variables]

        def literal(its):
            return mine[its >> 1] ^ its & 1

        for one, other in graph.gates:
            mine.append(self.both(literal(one), literal(other)))
        return literal


def _matched(names, others):
    """Of each set of names, the number of that of the others with one of them; None if there is none, or
    two have the same."""
    numbers = {name: number for number, some in enumerate(others) for name in some}
    matches = [next((numbers[name] for name in sorted(some) if name in numbers), None) for some in names]
    return matches if None not in matches and len(set(matches)) == len(matches) else None


def step(one, other, path):
    """Writes a graph with the registers of one design, whose output tells that the other, from the same
    state and with the same inputs, would come to another state or give another output. If that never is,
    both are equal. False where names do not tell which register is which."""
    inputs, registers = _matched(other.inputs, one.inputs), _matched(other.registers, one.registers)
    if inputs is None or registers is None or len(registers) != len(one.registers):
        return False
    if one.outputs.keys() != other.outputs.keys():
        return False
    count = len(one.inputs)
    variables = [2 * number for number in range(1, count + len(one.registers) + 1)]
    gates = _Gates(len(variables))
    mine = gates.added(one, variables)
    its = gates.added(other, [*(variables[number] for number in inputs),
                              *(variables[count + number] for number in registers)])
    pairs = [(mine(one.following[number]), its(other.following[place])) for place, number in enumerate(registers)]
    pairs += [(mine(value), its(other.outputs[name])) for name, value in one.outputs.items()]
    same = 1
    for first, second in pairs:
        same = gates.both(same, gates.differ(first, second) ^ 1)
    _write(path, count, [mine(value) for value in one.following], same ^ 1, gates)
    return True


def _write(path, inputs, following, output, gates):
    head = f"aig {gates.first - 1 + len(gates.known)} {inputs} {len(following)} 1 {len(gates.known)}\n"
    body = b"".join(_bytes(2 * (gates.first + place) - high) + _bytes(high - low)
                    for place, (high, low) in enumerate(gates.known))
    path.write_bytes((head + "".join(f"{value}\n" for value in [*following, output])).encode() + body)
