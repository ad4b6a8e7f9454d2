"""A block's ports on a chain of registers, for routers that give every port a pin.

One pin shifts the inputs in, one shows what the outputs have been folded into, a bit a clock. No
path of the chain has more than one LUT, so that the block's own paths set the clock; those from
and to its ports, which the chain begins and ends, are among them.

SPDX-License-Identifier: Apache-2.0
"""

CLOCKS = ("clk", "aclk")


def _connections(ports, direction, net):
    """[(port, bits of the net)] and how many bits there are."""
    pairs, at = [], 0
    for name, port in ports.items():
        if port["direction"] != direction or name in CLOCKS:
            continue
        width = len(port["bits"])
        pairs.append(f"    .{name}({net}[{at} +: {width}])")
        at += width
    return pairs, at


def verilog(name, block, ports):
    """The module `name` around `block`, of whose ports a netlist says direction and bits."""
    clock = next(port for port in CLOCKS if port in ports)
    inputs, taken = _connections(ports, "input", "in_q")
    outputs, given = _connections(ports, "output", "out")
    return "\n".join([
        f"module {name} (input clk, input scan_i, output scan_o);",
        f"  reg  [{taken - 1}:0] in_q;",
        f"  reg  [{given - 1}:0] fold_q;",
        f"  wire [{given - 1}:0] out;",
        "  always @(posedge clk) begin",
        "    in_q   <= {in_q, scan_i};",
        "    fold_q <= {fold_q, 1'b0} ^ out;",
        "  end",
        f"  assign scan_o = fold_q[{given - 1}];",
        f"  {block} u_block (",
        ",\n".join([f"    .{clock}(clk)", *inputs, *outputs]),
        "  );",
        "endmodule", ""])
