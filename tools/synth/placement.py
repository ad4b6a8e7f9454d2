"""What `make pnr` places and routes: rows of synth/clocks.csv, several seeds each.

Every row's netlist is the one that `make synth` counts, flattened. The measure of a target is one
registered multiplier, routed by the same programs with the same seeds: a row's share is its median
clock in parts of the multiplier's. Results lie in build/pnr/, one file a seed.

SPDX-License-Identifier: Apache-2.0
"""

import functools
import json
import statistics
from dataclasses import dataclass

from tools import csv_table
from tools.rtl import digest
from tools.synth import chips, nextpnr, scan_chain, synthesis

COLUMNS, TABLE = synthesis.CLOCK_COLUMNS, synthesis.CLOCKS
AIMS = COLUMNS[4:]
MULTIPLIER, SOURCE = "ffd_clock_multiplier", "synth/ffd_clock_multiplier.v"
CHAINED, PINNED = "ffd_clock_chain", "ffd_clock_pins"
UNKNOWN = "multiplier delays not modelled"


@dataclass(frozen=True)
class Device:
    name: str
    options: tuple
    placers: dict   # options of each; the first is that of the measure
    freq: int       # MHz that the router is asked for: more than it reaches
    width: int      # bits of the multiplier that is the measure
    chained: bool   # every port takes a pin, so the block's are on a chain (scan_chain.py)
    pinned: bool = False  # the chain lies in synth/TARGET/ffd_clock_pins.v
    unknown: str = ""     # what the router does not know, so that the measure means nothing
    seeds: tuple = nextpnr.SEEDS


DEVICES = {
    "ecp5": Device("LFE5U-85F, grade 6",
                   ("--85k", "--package", "CABGA381", "--speed", "6", "--out-of-context"),
                   {"heap": ("--placer-heap-timingweight", "20"),
                    "static": ("--placer", "static")}, 150, 18, False),
    "up5k": Device("iCE40 UP5K", ("--up5k", "--package", "sg48"), {"heap": ()}, 60, 16, True),
    "nexus": Device("LIFCL-40, grade 9", ("--device", "LIFCL-40-9BG400C"), {"heap": ()}, 250, 18,
                    True, True),
    "gowin": Device("GW2AR-18C, QN88, C8/I7",
                    ("--device", "GW2AR-LV18QN88C8/I7", "--vopt", "family=GW2A-18C"), {"heap": ()},
                    250, 18, True, True, UNKNOWN),
    # One seed: it takes the router a good part of an hour, for a clock that promises nothing.
    "gw5a": Device("GW5AST-138C, PG484A, C1/I0", ("--device", "GW5AST-LV138PG484AC1/I0"),
                   {"heap": ()}, 250, 18, True, True, UNKNOWN, (1,)),
    "gatemate": Device("CCGM1A1, speed mode, worst case",
                       ("--device", "CCGM1A1", "--vopt", "no-bridges", "--vopt", "no-cpe-cp"),
                       {"heap": ()}, 100, 18, True, True),
}


def unknown(target):
    """What the router of a target does not know, in words, or nothing."""
    return DEVICES[target].unknown if target in DEVICES else ""


def pins(target):
    """The module around a chain that has the clock and the pads of a chip."""
    return f"synth/{target}/{PINNED}.v"


@dataclass(frozen=True)
class Measure:
    """The multiplier of a target; it stands where a subject stands."""

    target: str
    top = MULTIPLIER

    @property
    def name(self):
        return f"{MULTIPLIER}.{self.target}"


@dataclass(frozen=True)
class Aim:
    """A line of the table: what is placed, and the clock to be reached, if one is set."""

    subject: synthesis.Subject
    share: float  # of the multiplier's clock; None where none is set
    mhz: float    # by itself; None where none is set

    def reached(self, clock):
        """Whether a clock, as Placement.clock gives it, is the one to be reached; None if none is
        set or the measure has not been routed."""
        pairs = ((self.share, clock["fmax_share"]), (self.mhz, clock["fmax_mhz"]))
        judged = [is_ >= aim for aim, is_ in pairs if None not in (aim, is_)]
        return all(judged) if judged else None


def read(path, subjects):
    """The lines of synth/clocks.csv, as subjects among these. Raises TableError."""
    by_key = {(s.row.name, s.top, s.target): s for s in subjects}
    aims = []
    for where, fields in csv_table.read(path, COLUMNS):
        subject = by_key.get((fields["name"], fields["top"], fields["target"]))
        if subject is None or subject.target not in DEVICES:
            raise csv_table.TableError(f"{where}: {fields['name']}, {fields['top']}, "
                                       f"{fields['target']} is not mapped by make synth, or has no "
                                       "router")
        csv_table.word(fields, "placer", where, tuple(DEVICES[subject.target].placers))
        try:
            wanted = [float(fields[column]) if fields[column] else None for column in AIMS]
        except ValueError as error:
            raise csv_table.TableError(f"{where}: {' and '.join(AIMS)} are numbers or empty"
                                       ) from error
        aims.append(Aim(subject, *wanted))
    return aims


class Placement:
    """What is routed in one checkout; results lie in build/pnr/, one file a seed, their keys in their
    names."""

    def __init__(self, work):
        self.work, self.root = work, work.root
        self.folder = self.root / "build" / "pnr"
        self.key = functools.lru_cache(maxsize=None)(self._key)

    @functools.cached_property
    def placers(self):
        """{name of a subject: its placer}. Raises TableError."""
        return {f"{fields['name']}.{fields['top']}.{fields['target']}": fields["placer"]
                for _, fields in csv_table.read(self.root / TABLE, COLUMNS)}

    @functools.cached_property
    def packed(self):
        """Names of the subjects of which a bitstream is packed: whole cores with pins, which those on
        ECP5 have not; none where there is no table, as for proofs. Raises TableError."""
        if not (self.root / TABLE).is_file():
            return []
        fields = [name.split(".") for name in self.placers]
        return [".".join(words) for words in fields
                if words[1] == synthesis.CORE and words[2] in synthesis.CORE_TARGETS]

    def options(self, subject):
        """Of the router, but for netlist, seed and report."""
        device = DEVICES[subject.target]
        placer = self.placers.get(subject.name, next(iter(device.placers)))
        return [*device.options, *device.placers[placer], "--freq", device.freq]

    def script(self, subject):
        """The steps of yosys from the sources of a subject or a measure to its flat netlist."""
        if isinstance(subject, Measure):
            steps = [f"read_verilog {SOURCE}",
                     f"hierarchy -check -top {MULTIPLIER} "
                     f"-chparam WIDTH {DEVICES[subject.target].width}",
                     f"script synth/{subject.target}.ys"]
        else:
            steps = self.work.script(subject)
        return [*steps, "flatten", "opt_clean"]

    def chain(self, subject, netlist, source):
        """The steps that put the chain of a source around a flat netlist. The cells of the library are
        read again, with their parameters, by the target's script."""
        target = subject.target
        around = [f"read_verilog {pins(target)}"] if DEVICES[target].pinned else []
        return [f"read_json {netlist}", "delete =A:blackbox", f"read_verilog {source}", *around,
                f"hierarchy -top {PINNED if around else CHAINED}", f"script synth/{target}.ys"]

    def _key(self, subject):
        """Of its netlist, the router and how that is asked."""
        if isinstance(subject, Measure):
            design = digest.of(
                self.work.version, *self.script(subject)[1:],
                digest.lines(self.root / f"synth/{subject.target}.ys",
                             *(chips.files(self.root, subject.target)
                               if subject.target in chips.TARGETS else ())),
                digest.tokens((str(self.root / SOURCE),), (), "YOSYS", "SYNTHESIS"))
        else:
            design = self.work.netlist_key(subject)
        device = DEVICES[subject.target]
        chain = [digest.statements(scan_chain) if device.chained else ""]
        if device.pinned:
            chain.append(digest.tokens((str(self.root / pins(subject.target)),), (), "YOSYS"))
        return digest.of(design, nextpnr.version(self.root, subject.target),
                         *map(str, self.options(subject)), *chain)

    def files(self, subject):
        """What the router reports, a file a seed. Raises NextpnrError."""
        return [self.folder / f"{subject.name}.{self.key(subject)}.{seed}.report"
                for seed in DEVICES[subject.target].seeds]

    def wanted(self, aims):
        """{subject: its files} of these aims and of the measures of their targets."""
        targets = dict.fromkeys(aim.subject.target for aim in aims
                                if not unknown(aim.subject.target))
        measures = [*map(Measure, targets), *(aim.subject for aim in aims)]
        files = {subject: [path for path, result in zip(self.files(subject), self._seeds(subject))
                           if result is None] for subject in measures}
        for subject in measures:
            if self.is_packed(subject) is False:
                files[subject].append(self.bitstream(subject))
        return files

    def bitstream(self, subject):
        """Of the fastest of the seeds."""
        return self.folder / f"{subject.name}.{self.key(subject)}.bitstream"

    def is_packed(self, subject):
        """Whether there is a bitstream; None where none is made."""
        if subject.name not in self.packed:
            return None
        return self.bitstream(subject).is_file()

    def remarks(self, subject):
        """Fields that only some rows have: whether there is a bitstream, where these are made, and
        what the router does not know."""
        there, unknown = self.is_packed(subject), DEVICES[subject.target].unknown
        return {**({} if there is None else {"bitstream": there}),
                **({"remark": unknown} if unknown else {})}

    def pack(self, target):
        """The packer with its options. Raises NextpnrError."""
        family = nextpnr.FAMILIES[target]
        return [nextpnr.find(self.root, family.pack, family), *family.pack_options]

    def results(self, subject):
        """Clock and critical path of all seeds that are there, in order."""
        if not any(self.folder.glob(f"{subject.name}.*.report")):
            return []
        try:
            return [result for result in self._seeds(subject) if result is not None]
        except nextpnr.NextpnrError:
            return []

    def _seeds(self, subject):
        """A result or None for each seed."""
        def result(seed, path):
            if not path.is_file():
                return None
            report = json.loads(path.read_text())
            return {"seed": seed, "fmax_mhz": round(nextpnr.clock(report), 2),
                    "critical_path": nextpnr.path_in_words(report)}

        return [result(*run) for run in zip(DEVICES[subject.target].seeds, self.files(subject))]

    def median(self, subject):
        """MHz, or None."""
        results = self.results(subject)
        return statistics.median(result["fmax_mhz"] for result in results) if results else None

    def clock(self, subject):
        """What is known of a subject's clock after routing, as in synth.json; None if nothing."""
        if subject.target not in DEVICES:
            return None
        results = self.results(subject)
        if not results:
            return None
        unknown = DEVICES[subject.target].unknown
        fmax = self.median(subject)
        measure = None if unknown else self.median(Measure(subject.target))
        return {"fmax_mhz": fmax, "fmax_share": round(fmax / measure, 3) if measure else None,
                "routed": True,
                "seeds": [{"seed": r["seed"], "fmax_mhz": r["fmax_mhz"]} for r in results]}
