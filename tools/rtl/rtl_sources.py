"""The RTL as its tools see it: the file list, which file needs which, and how each tool is run.

SPDX-License-Identifier: Apache-2.0
"""

import functools
import pathlib
import re
import shutil
import subprocess
from dataclasses import dataclass

from tools.project_root import ROOT


_COMMENT = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*|/\*.*?\*/', re.DOTALL)
_MODULE = re.compile(r"^\s*module\s+([A-Za-z_]\w*)", re.MULTILINE)
_WORD = re.compile(r"[A-Za-z_]\w*")
_INCLUDE = re.compile(r'^[ \t]*`include[ \t]+"([^"\n]+)"', re.MULTILINE)
_FOLDER = "+incdir+"

# What Verilator is told of the sources, in the folder of the list: an empty file to other tools.
WAIVERS = "lint/hwffd.vlt"

# The file lists, and the folder whose sources are not the core's.
CORE_LIST = "hwffd.f"
BOARD_LIST = "boards.f"
BOARDS = "board"

# What a simulator defines so that memories show reads whose word is undefined.
SIMULATION = "FFD_SIMULATION"
# And so that it ends where something happens that cannot happen.
ASSERTIONS = "FFD_ASSERTIONS"


@functools.cache
def strip_comments(text):
    """Verilog without comments and strings; every line keeps its number and its columns."""

    def blank(match):
        return re.sub(r"[^\n]", " ", match.group(0))

    return _COMMENT.sub(blank, text)


# Steps of yosys by which all becomes one module, also what synthesis keeps apart.
FLATTEN = ("setattr -mod -unset keep_hierarchy *", "setattr -unset keep_hierarchy */t:*", "flatten")


def changed(text, original, mutant, where):
    """The text with a bug planted. Raises ValueError unless what it replaces is there exactly once."""
    count = text.count(original)
    if count != 1:
        raise ValueError(f"the text that the planted bug replaces is {count} times in {where}, not once")
    return text.replace(original, mutant)


def line_of(text, offset):
    """Number of the line in which a character stands."""
    return text.count("\n", 0, offset) + 1


def _entries(path):
    """What a file list says, one a line; // comments and blank lines are allowed."""
    lines = (line.split("//")[0].strip() for line in path.read_text().splitlines())
    return [line for line in lines if line]


def read_file_list(path):
    """The sources of a file list, as written."""
    return [entry for entry in _entries(path) if not entry.startswith(_FOLDER)]


def read_include_folders(path):
    """The folders with headers of a file list, as written."""
    return [entry[len(_FOLDER):] for entry in _entries(path) if entry.startswith(_FOLDER)]


def _list_text(about, lines):
    return f"""{about}
// Made by tools/tables/generated_files.py from what is there; changes here are lost.
""" + "\n".join(lines) + "\n"


def file_list_texts(folder):
    """Name of each file list -> what it must be. The core's: what Verilator is told, every source in the folders of
    rtl/ but that of the boards, and the folders with headers."""
    folder = pathlib.Path(folder)
    sources = [path.relative_to(folder) for path in sorted(folder.glob("*/**/*.v"))]
    folders = sorted({path.parent for path in folder.glob("*/**/*.vh")})
    lines = [_FOLDER + str(path.relative_to(folder)) for path in folders]
    lines += [WAIVERS] if (folder / WAIVERS).is_file() else []
    lines += [str(path) for path in sources if path.parts[0] != BOARDS]
    texts = {CORE_LIST: _list_text("""\
// Every source of the core and every folder with headers, one a line, relative to this folder:
// `verilator -F rtl/hwffd.f` takes it as it is; rtl/file_list prints it with whole paths. Order does
// not matter, but for the first one, which is Verilator's.""", lines)}
    boards = [str(path) for path in sources if path.parts[0] == BOARDS]
    if boards:
        texts[BOARD_LIST] = _list_text("""\
// The tops of boards and what only they use, relative to this folder, beside hwffd.f.""", boards)
    return texts


def listed(folder):
    """The sources of all file lists of a folder, in their order."""
    return [entry for name in (CORE_LIST, BOARD_LIST) if (folder / name).is_file() for entry in read_file_list(folder / name)]


class Sources:
    """The modules of the file lists and what each of them instantiates, directly or not."""

    def __init__(self, root=ROOT):
        self.root = pathlib.Path(root)
        self.rtl = self.root / "rtl"
        self.files = {}  # module -> path
        self._words, self._needed = {}, {}
        for entry in listed(self.rtl):
            path = self.rtl / entry
            if not path.is_file():
                continue  # the text rules say so
            code = strip_comments(path.read_text())
            for module in _MODULE.findall(code):
                self.files[module] = path
                self._words[module] = set(_WORD.findall(code))

    def modules(self):
        return list(self.files)

    def needed(self, module):
        """The files that `module` needs, its own last."""
        if module in self._needed:
            return list(self._needed[module])
        order, seen = [], set()

        def visit(name):
            seen.add(name)
            for other in sorted(self._words[name] & self.files.keys()):
                if other not in seen:
                    visit(other)
            if self.files[name] not in order:
                order.append(self.files[name])

        visit(module)
        self._needed[module] = [str(path) for path in order]
        return list(self._needed[module])

    def whole(self, module):
        """The source of a module without comments, and with the lists of ports that it includes."""

        def included(match):
            paths = [path for folder in self.includes
                     if (path := pathlib.Path(folder) / match.group(1)).is_file()]
            return text_of(paths[0]) if paths else match.group(0)

        def text_of(path):
            return strip_comments(_INCLUDE.sub(included, path.read_text()))

        return text_of(self.files[module])

    @property
    def includes(self):
        """The folders with headers."""
        return [str(self.rtl / name) for name in read_include_folders(self.rtl / "hwffd.f")]


@dataclass(frozen=True)
class Language:
    """A language that the sources are read as, and how each tool is told so."""

    verilator: tuple
    icarus: str
    yosys: str


VERILOG = Language(("--default-language", "1364-2005"), "-g2005", "")
# What Verilator takes sources for if not told, as do vendors' tools where a project mixes the two.
SYSTEMVERILOG = Language((), "-g2012", "-sv ")


@functools.lru_cache(maxsize=None)
def _verilator():
    """The program behind the script `verilator`, which takes five times as long to start."""
    return shutil.which("verilator_bin") or "verilator"


def verilator(sources, top, files, parameters=(), language=VERILOG):
    waivers = sources.rtl / WAIVERS
    return (
        [_verilator(), "--lint-only", *language.verilator, "-Wall"]
        + ["-I" + folder for folder in sources.includes]
        + ["--top-module", top]
        + ["-G" + parameter for parameter in parameters]
        + ([str(waivers)] if waivers.is_file() else [])
        + files
    )


def verilator_list(sources, top):
    """The file list as an integrator hands it over, without a word about folders or language."""
    return [_verilator(), "--lint-only", "-Wall", "-F", str(sources.rtl / "hwffd.f"),
            "--top-module", top]


def icarus(sources, top, files, parameters=(), language=VERILOG):
    return (
        ["iverilog", language.icarus, "-Wall", "-t", "null", "-s", top]
        + ["-I" + folder for folder in sources.includes]
        + [f"-P{top}.{parameter}" for parameter in parameters]
        + files
    )


def yosys(sources, jobs, language=VERILOG):
    """One process for several (top, files, parameters), each from the sources as read."""
    files = []
    for _, needed, _ in jobs:
        files += [path for path in needed if path not in files]
    folders = "".join(f"-I {folder} " for folder in sources.includes)
    script = [f"read_verilog {language.yosys}{folders}" + " ".join(f'"{path}"' for path in files)]
    script.append("design -save sources")
    for top, _, parameters in jobs:
        values = (parameter.split("=", 1) for parameter in parameters)
        script += [
            "design -load sources",
            f"hierarchy -check -top {top}"
            + "".join(f" -chparam {name} {value}" for name, value in values),
        ]
        if language is VERILOG:  # nothing is left of the language behind `hierarchy`
            script += ["proc", "check -assert"]
    return ["yosys", "-Q", "-T", "-q", "-p", "; ".join(script)]


def elaboration(sources, top, parameters):
    """The steps of yosys that read a top with what it needs, and give its parameters, {name: number}, these values."""
    folders = "".join(f" -I {folder}" for folder in sources.includes)
    values = "".join(f" -chparam {name} {value}" for name, value in parameters.items())
    return [f"read_verilog{folders} {' '.join(sources.needed(top))}", f"hierarchy -check -top {top}{values}"]


def module_of(name):
    """The module's own name, of which yosys makes $paramod$HASH\\name or $paramod\\name\\W=..., and RTLIL \\name."""
    return name.split("\\")[1] if "\\" in name else name


def run(command, folder=None):
    """(exit status, everything it printed), run in that folder."""
    result = subprocess.run(
        command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        text=True, errors="replace", check=False,
    )
    return result.returncode, result.stdout
