"""make -C lab packages: what a release hands out, built of one commit and tried where nothing is prepared.

    python3 -m lab.release.packages [--root FOLDER]

Makes in build/packages/ the archive of the sources as git has them, and of that archive the wheels: `pyhwffd`, with the
libraries that it needs, and `hwffd_rtl`, the simulated hardware. Each is tried in a new folder or in a new environment of
Python, which see nothing of this checkout: TRIALS. The exit status is 1 where something cannot be built or a trial fails,
and then there is nothing; 2 where the request makes no sense.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import gzip
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile

from lab.release import clean_tree
from tools import command_line, venv_packages
from tools.project_root import ROOT
from tools.tables import version

SCENE = """
import hwffd, numpy as np
points = np.random.default_rng(1).random((1000, 3))
lattice = hwffd.Lattice.around("sphere", points)
lattice.deform("twist:90")
exact = hwffd.deform(lattice, points)
lattice.set_device("model")
model = hwffd.deform(lattice, points)
assert 0 < abs(exact - model).max() < 1e-5
"""
RTL = """
lattice.set_device("rtl")
assert (hwffd.deform(lattice, points) == model).all()
"""


class Broken(Exception):
    """Something that cannot be built, or does not do what it should, in one line."""


def run(log, *words, folder=None, **variables):
    """What a command prints; it has no Python package but those of its own interpreter. Raises Broken."""
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("PYTHON", "MAKE", "MFLAGS", "HWFFD_")) and name != "VIRTUAL_ENV"}
    result = subprocess.run([str(word) for word in words], cwd=folder, env={**environment, **variables}, text=True, check=False,
                            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    with log.open("a", encoding="utf-8") as file:
        file.write(f"$ {' '.join(map(str, words))}\n{result.stdout}\n")
    if result.returncode:
        raise Broken(f"{pathlib.Path(words[0]).name} {words[1]} ended with {result.returncode}: see {log}")
    return result.stdout


class Packages:
    """Those of one commit."""

    def __init__(self, root, work):
        self.root, self.work = root, work
        self.commit = clean_tree.commit(root)
        self.version = str(version.read(root))
        self.made = work / "made"
        self.made.mkdir()
        self.log = root / "build" / "packages.log"
        self.log.unlink(missing_ok=True)
        self.sources = work / f"hwffd-{self.version}"
        self.tools = pathlib.Path(sys.executable).parent

    def run(self, *words, **more):
        return run(self.log, *words, **more)

    def archive(self):
        """The sources, the same bytes whenever they are packed."""
        path, packed = self.made / f"{self.sources.name}.tar.gz", self.work / "sources.tar"
        clean_tree.git(self.root, "archive", "--format=tar", f"--prefix={self.sources.name}/", f"--output={packed}",
                       self.commit)
        path.write_bytes(gzip.compress(packed.read_bytes(), mtime=0))
        with tarfile.open(path) as file:
            file.extractall(self.work)
        return path

    def wheel(self):
        """The Python package."""
        return self._wheel(self.sources, "pyhwffd-*.whl")

    def hardware(self):
        """The simulated hardware, of the cores of tier `sim`."""
        return self._wheel(self.sources / "api" / "python" / "rtl", "hwffd_rtl-*.whl")

    def _wheel(self, source, pattern):
        """With the shared libraries that it needs."""
        built, path = self.work / "built", f"{self.tools}{os.pathsep}{os.environ['PATH']}"
        self.run(self.tools / "pip", "wheel", "--no-deps", "--no-build-isolation", "--wheel-dir", built, source, PATH=path)
        self.run(self.tools / "auditwheel", "repair", "--wheel-dir", self.made, *built.glob(pattern), PATH=path)
        return self._only(pattern)

    def _only(self, pattern):
        paths = list(self.made.glob(pattern))
        if len(paths) != 1:
            raise Broken(f"{len(paths)} files {pattern} are made, not one")
        return paths[0]

    def environment(self, *packages):
        """A new one of Python with these packages; its folder of programs."""
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.work))
        self.run(sys.executable, "-m", "venv", folder, folder=folder)
        self.run(folder / "bin" / "python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *packages,
                 folder=folder)
        return folder / "bin"

    def try_make_sim(self):
        """`make sim` in the unpacked archive"""
        said = self.run("make", "sim", "FORMAT=fx18", folder=self.sources, HWFFD_NO_INSTALL="1")
        if not re.search(r"^basic +fx18 .* [1-9]\d* +0 +\d", said, re.MULTILINE):
            raise Broken("make sim in the archive: no row without a mismatch")

    def try_fusesoc(self):
        """FuseSoC lints the core of the unpacked archive"""
        wanted = (self.sources / "tools" / "requirements-test-all.txt").read_text(encoding="utf-8")
        programs = self.environment(*re.findall(r"^(?:fusesoc|edalize)==\S+", wanted, re.MULTILINE))
        self.run(programs / "fusesoc", "--cores-root", self.sources, "run", "--target=lint", f"hwffd:ip:hwffd:{self.version}",
                 folder=programs.parent, HOME=str(programs.parent))

    def try_wheel(self):
        """the devices `reference` and `model`, and a standalone core"""
        programs = self.environment(f"pyhwffd[core] @ {self._only('pyhwffd-*.whl').as_uri()}")
        self.run(programs / "python", "-W", "error", "-c", SCENE, folder=programs.parent)
        self.run(programs / "hwffd", "core", "--org", "cg1", "--format", "fx18", "-o", "core", folder=programs.parent,
                 PATH=f"{programs}{os.pathsep}{os.environ['PATH']}")

    def try_hardware(self):
        """the bits of the device `model` from the device `rtl`"""
        programs = self.environment(self._only("pyhwffd-*.whl"), self._only("hwffd_rtl-*.whl"))
        self.run(programs / "python", "-W", "error", "-c", SCENE + RTL, folder=programs.parent)


# What is made, and what is tried with it.
TRIALS = ((Packages.archive, (Packages.try_make_sim, Packages.try_fusesoc)), (Packages.wheel, (Packages.try_wheel,)),
          (Packages.hardware, (Packages.try_hardware,)))


def work(root):
    notes = f"docs/releases/{version.read(root)}.md"
    if not (root / notes).is_file():
        raise Broken(f"{notes} is not there: a release has a page of notes")
    target, sums = root / "build" / "packages", []
    shutil.rmtree(target, ignore_errors=True)
    (root / "build").mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory(dir=root / "build") as folder:
        packages = Packages(root, pathlib.Path(folder))
        for made, trials in TRIALS:
            path = made(packages)
            for trial in trials:
                print(f"packages: {path.name}: {trial.__doc__}", flush=True)
                trial(packages)
            sums.append(f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n")
        (packages.made / "SHA256SUMS").write_text("".join(sums), encoding="utf-8")
        packages.made.rename(target)
    for path in sorted(target.iterdir()):
        print(f"packages: build/packages/{path.name}, {path.stat().st_size:,} bytes")
    return 0


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="packages", description="Builds what a release hands out, and tries it.")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="checkout to build of")
    options = parser.parse_args(arguments)
    return command_line.ended(parser.prog, lambda: work(options.root.absolute()), (Broken,))


if __name__ == "__main__":
    venv_packages.enter("requirements-python.txt")
    sys.exit(main())
