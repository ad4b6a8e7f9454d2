"""Maps, places and routes the system on the board ULX3S with an ECP5-85F, and reports its clock.

LiteX writes the design, its pins and its program, in build/soc/ulx3s/; yosys and nextpnr are those of `make pnr`.
Writes build/reports/soc_route.json. The exit status is 1 if a step fails or the board's clock is not met.

SPDX-License-Identifier: Apache-2.0
"""

import json
import logging
import os
import re
import statistics
import subprocess
import sys

from litex.gen import LiteXModule
from litex.soc.cores.clock import ECP5PLL
from litex_boards.platforms import radiona_ulx3s
from migen import ClockDomain

from soc import program
from soc.simulate import ROW, parameters
from soc.system import CPU, System
from tools import command_line, whole_file
from tools.synth import nextpnr

DEVICE = "LFE5U-85F"
CLOCK = int(50e6)  # that of the board in LiteX
MEMORY = 0x10000  # bytes for meshes, of block memory
VERTICES = 900    # of the mesh that fit into it
RESETS = 1000
# The multiplier with the registers that are inside the chip's block (synth/README.md).
BLOCK, BLOCK_HERE = "rtl/number/fixed/ffd_fx_block.v", "synth/ecp5/ffd_fx_block.v"


class RouteError(Exception):
    """A step has failed, in one line."""


class Clocks(LiteXModule):
    """The system's clock from the board's 25 MHz."""

    def __init__(self, platform):
        self.cd_sys = ClockDomain()
        self.pll = ECP5PLL()
        self.pll.register_clkin(platform.request("clk25"), 25e6)
        self.pll.create_clkout(self.cd_sys, CLOCK)
        self.comb += self.pll.reset.eq(platform.request("rst"))
        self.comb += platform.request("wifi_gpio0").eq(1)  # else the board resets the chip


def make_system(root):
    platform = radiona_ulx3s.Platform(device=DEVICE, revision="2.0", toolchain="trellis")
    system = System(platform, CLOCK, root / "rtl", parameters(root), MEMORY, uart_name="serial")
    system.crg = Clocks(platform)
    platform.sources[:] = [(str(root / BLOCK_HERE), *rest) if name.endswith(BLOCK) else (name, *rest)
                           for name, *rest in platform.sources]
    system.finalize()
    return system


def step(name, words, folder):
    """Runs a program with its log in the folder. Raises RouteError."""
    log = folder / f"{name}.log"
    print(f"soc: {name}", flush=True)
    with log.open("w", encoding="utf-8") as out:
        result = subprocess.run(words, cwd=folder, stdout=out, stderr=subprocess.STDOUT, check=False)
    if result.returncode != 0:
        raise RouteError(f"{name} has failed: {log}")


def write_design(root, folder, scene):
    """Design, pins, memories and scripts, by LiteX; the options of its router."""
    system = make_system(root)
    system.init_rom("rom", program.build(system, folder, RESETS=RESETS), auto_size=False)
    system.init_ram("main_ram", scene)
    gateware = folder / "gateware"
    system.build(build_dir=str(gateware), build_name="ulx3s", run=False)
    script = (gateware / "build_ulx3s.sh").read_text(encoding="utf-8")
    options = re.search(r"^nextpnr-ecp5 .*--lpf ulx3s\.lpf\s+--textcfg \S+\s+(.*)$", script, re.M)
    if not options:
        raise RouteError(f"no nextpnr-ecp5 in {gateware / 'build_ulx3s.sh'}")
    return gateware, [word for word in re.sub(r"--seed \d+", "", options[1]).split() if word != "||"]


def route(root, gateware, options, seed):
    """The router's report of a seed."""
    router = nextpnr.find(root, nextpnr.ECP5.route, nextpnr.ECP5)
    report = gateware / f"report{seed}.json"
    step(f"nextpnr{seed}",
         [router, "--json", "ulx3s.json", "--lpf", "ulx3s.lpf", "--textcfg", f"ulx3s.{seed}.config",
          "--report", report.name, "--seed", str(seed), *options], gateware)
    return json.loads(report.read_text(encoding="utf-8"))


def work(options, root):
    logging.disable(logging.WARNING)
    folder = root / "build" / "soc" / "ulx3s"
    scene = program.scene(options, ROW, folder, vertices=VERTICES)
    gateware, router = write_design(root, folder, scene)
    step("yosys", ["yosys", "-q", "-l", "ulx3s.rpt", "ulx3s.ys"], gateware)
    seeds = (options.seed,) if options.seed else nextpnr.SEEDS
    reports = {seed: route(root, gateware, router, seed) for seed in seeds}
    clocks = {seed: nextpnr.clock(report) for seed, report in reports.items()}
    best = max(clocks, key=clocks.get)
    packer = nextpnr.find(root, nextpnr.ECP5.pack, nextpnr.ECP5)
    step("ecppack", [packer, "--compress", f"ulx3s.{best}.config", "--bit", "ulx3s.bit"], gateware)
    result = {
        "board": "ulx3s", "device": DEVICE, "cpu": CPU, "row": ROW, "clock_mhz": CLOCK / 1e6,
        "fmax_mhz": round(clocks[best], 2), "median_mhz": round(statistics.median(clocks.values()), 2),
        "seeds": [{"seed": seed, "fmax_mhz": round(clock, 2)} for seed, clock in clocks.items()],
        "critical_path": nextpnr.path_in_words(reports[best]), "met": clocks[best] >= CLOCK / 1e6,
        "used": {name: [about["used"], about["available"]]
                 for name, about in reports[best]["utilization"].items() if about["used"]},
        "bitstream": os.path.relpath(gateware / "ulx3s.bit", root),
    }
    whole_file.write(root / "build" / "reports" / "soc_route.json",
                     json.dumps({"rows": [result], "short": [] if result["met"] else ["the clock is not met"]},
                                indent=1) + "\n")
    print(f"ulx3s: {result['fmax_mhz']:.1f} MHz after routing, {result['clock_mhz']:g} wanted: "
          f"{'met' if result['met'] else 'NOT MET'}; median of {len(seeds)} seeds {result['median_mhz']:.1f}")
    print(f"  {result['critical_path']}")
    for name, (used, available) in result["used"].items():
        print(f"  {name:<14}{used:>7,} of {available:>6,}  {100 * used / available:5.1f} %")
    print(f"  wrote {result['bitstream']}")
    print("wrote build/reports/soc_route.json")
    return 0 if result["met"] else 1


if __name__ == "__main__":
    parser = command_line.Parser(prog="soc", description="Routes a system with the core.")
    program.arguments(parser)
    parser.add_argument("--board", choices=("ulx3s",), default="ulx3s")
    parser.add_argument("--seed", type=int, help="of the placement; the fastest of several")
    sys.exit(command_line.run(parser, work, (RouteError, program.ProgramError, nextpnr.NextpnrError)))
