"""The program of the system: headers and linker's regions from LiteX, then the compiler.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import shutil
import subprocess

import litex
from litex.soc.integration import export
from litex.soc.integration.common import get_mem_data

from tools import whole_file
from tools.project_root import ROOT

COMPILER = "riscv64-unknown-elf-gcc"
OBJCOPY = "riscv64-unknown-elf-objcopy"
# Multiplier and divider, as VexRiscv's variant has them; CSR instructions belong to I up to that version.
FLAGS = ("-march=rv32im", "-mabi=ilp32", "-misa-spec=2.2", "--specs=picolibc.specs", "-nostartfiles",
         "-DPICOLIBC_INTEGER_PRINTF_SCANF", "-std=gnu11", "-O2", "-Wall", "-Wextra", "-Werror",
         "-ffunction-sections", "-fdata-sections")
SOURCES = ROOT / "soc" / "firmware"
DRIVER = ROOT / "cores" / "src" / "driver" / "core_driver.c"


class ProgramError(Exception):
    """Program or scene was not made, in one line."""


def describe(system, folder):
    """Writes what the program must know of a finalized system."""
    whole_file.write(folder / "generated" / "csr.h", export.get_csr_header(
        system.csr_regions, system.constants, system.mem_regions["csr"].origin))
    whole_file.write(folder / "generated" / "mem.h", export.get_mem_header(system.mem_regions))
    whole_file.write(folder / "generated" / "soc.h", export.get_soc_header(system.constants))
    whole_file.write(folder / "regions.ld", export.get_linker_regions(system.mem_regions))


def build(system, folder, **defined):
    """The program as words. Raises ProgramError."""
    if shutil.which(COMPILER) is None:
        raise ProgramError(f"{COMPILER} not found: run tools/install soc")
    describe(system, folder)
    home = pathlib.Path(litex.__file__).resolve().parent / "soc"
    include = (folder, ROOT / "cores" / "include", home / "software" / "include",
               home / "cores" / "cpu" / system.cpu.name)
    program = folder / "program.elf"
    words = [COMPILER, *FLAGS, *[f"-D{name}={value}" for name, value in defined.items()],
             *[word for path in include for word in ("-isystem", str(path))],
             f"-L{folder}", f"-T{SOURCES / 'link.ld'}", *map(str, sorted(SOURCES.glob("*.[cS]"))),
             str(DRIVER), "-o", str(program)]
    for command in (words, [OBJCOPY, "-O", "binary", str(program), f"{program}.bin"]):
        result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              check=False)
        if result.returncode != 0:
            whole_file.write(folder / "program.log", result.stdout)
            raise ProgramError(f"the program does not compile: {folder / 'program.log'}")
    return words_of(f"{program}.bin")


def arguments(parser):
    """Those that say what the scene is."""
    parser.add_argument("--maker", required=True, help="the program hwffd-soc-scene")
    for name, what in (("model", "a mesh"), ("deform", "of its lattice"),
                       ("lattice", "control points an axis")):
        parser.add_argument(f"--{name}", help=what)


def scene(options, row, folder, **more):
    """What the memory holds at the start, as words. Raises ProgramError, with the line of its maker."""
    path = folder / "scene.bin"
    folder.mkdir(parents=True, exist_ok=True)
    given = {name: getattr(options, name) for name in ("model", "deform", "lattice")}
    words = [word for name, value in {"row": row, **given, **more, "output": path}.items()
             if value is not None for word in (f"--{name}", str(value))]
    result = subprocess.run([options.maker, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True, check=False)
    if result.returncode != 0:
        raise ProgramError(result.stderr.strip())
    print(f"soc: {result.stdout.strip()}", flush=True)
    return words_of(path)


def words_of(path):
    """A file as words of 32 bits, as memories of LiteX take them."""
    return get_mem_data(str(path), data_width=32, endianness="little")
