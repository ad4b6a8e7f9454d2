"""Runs the commands of the README and each target of `make help` as the first command of a fresh clone, on a
machine that has nothing: a Debian made by debootstrap in a folder, with git, make and certificates.

    python3 -m tools.checks.fresh_machine [--folder FOLDER] [--also FILE] [NAME ...]

Each command gets a machine of its own, a layer over the bare one, in which a user with sudo, or root, has cloned the
last commit into a path with a blank, or without. The commands are those of
tools/checks/fresh_machine.csv and of the tables given. What runs long is ended at a line that its row names: its first result, or where
that takes too long the first file compiled. At the end a table says how each ended, in how many seconds, what it installed, and which files it left outside of its clone
and PREFIX. After `make hwffd PREFIX=` the clone is moved away, and the README's code is run against what was installed.

It needs root, debootstrap and the package sources of this machine, and takes an hour; packages that it has fetched,
and objects that a compiler has made, where ccache is there, are kept in build/fresh/ for the next command. The exit
status is 1 where a command did not end as it should.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import contextlib
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
from dataclasses import dataclass

from tools import csv_table
from tools.project_root import ROOT

PACKAGES = "git,make,ca-certificates,sudo"
SUITE = "bookworm"
SIGNALS = "command_valid, command_ready, command_last, result_valid, result_ready, result_last"  # of the README's Verilog
CLONES = {"root": "/srv/clone/hwffd", "user": "/home/user/my work/hwffd"}
HOMES = {"root": "/root", "user": "/home/user"}
# Of this machine, to reach the same package sources.
NETWORK = ("/etc/apt/sources.list", "/etc/apt/sources.list.d/debian.sources", "/etc/apt/apt.conf.d", "/etc/pip.conf",
           "/etc/resolv.conf", "/usr/local/share/ca-certificates")
VARIABLES = re.compile(r"(PIP_(?!FIND_LINKS)|SSL_|REQUESTS_CA|CURL_CA).*|.*_proxy", re.IGNORECASE)
# Where packages, as they are installed, write what no list of theirs names; and what programs keep of their own.
OF_PACKAGES = ("etc", "var", "run", "tmp", "usr/share/mime", "usr/share/info", "usr/share/glib-2.0", "usr/share/fonts",
               "usr/share/icons", "usr/share/applications", "usr/lib/x86_64-linux-gnu", "usr/share/man", "usr/share/doc",
               "root/.cache", "home/user/.cache", "usr/sbin/policy-rc.d",
               "root/.yosys_history", "home/user/.yosys_history")


@dataclass(frozen=True)
class Command:
    """One command; `until` is a pattern of the line after which a long one is ended."""

    name: str
    words: str
    until: str = ""
    user: str = "user"
    then: str = ""  # "snippets": those of the README are tried behind it


TABLE = pathlib.Path(__file__).with_name("fresh_machine.csv")
COLUMNS = ("name", "words", "until", "user", "then")


def commands(*more):
    """Those of the product, in the README's order, and of other tables."""
    rows = [cells for path in (TABLE, *more) for _, cells in csv_table.read(path, COLUMNS)]
    return [Command(**{name: cell for name, cell in cells.items() if cell}) for cells in rows]


def run(*words, **more):
    """What it printed. Raises CalledProcessError, whose output says why."""
    return subprocess.run([str(word) for word in words], check=True, text=True, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **more).stdout


class Machine:
    """The bare one, and layers over it."""

    def __init__(self, folder):
        self.folder = folder
        self.bare, self.cache = folder / "bare", folder / "kept"
        self.environment = {name: value for name, value in os.environ.items() if VARIABLES.fullmatch(name)}

    def make(self):
        """Made once; what a run that was ended has left is made anew."""
        stamp = self.folder / "made"
        for part in ("archives/partial", "pip", "ccache"):
            (self.cache / part).mkdir(parents=True, exist_ok=True)
            os.chmod(self.cache / part, 0o777)
        if stamp.is_file():
            return
        print(f"fresh: a bare Debian in {self.bare}", flush=True)
        shutil.rmtree(self.bare, ignore_errors=True)
        mirror = run("apt-get", "indextargets", "--format", "$(REPO_URI)", "Created-By: Packages",
                     f"Codename: {SUITE}").split()[0]
        run("debootstrap", "--variant=minbase", f"--include={PACKAGES}", SUITE, self.bare, mirror)
        for path in NETWORK:
            source, target = pathlib.Path(path), self.bare / path[1:]
            if source.is_dir():
                shutil.copytree(source, target, symlinks=False, dirs_exist_ok=True, ignore_dangling_symlinks=True)
            elif source.is_file():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(source, target)
            else:
                target.unlink(missing_ok=True)
        run("chroot", self.bare, "update-ca-certificates")
        for name in ("docker-clean", "docker-no-languages", "docker-gzip-indexes", "docker-autoremove-suggests"):
            (self.bare / "etc/apt/apt.conf.d" / name).unlink(missing_ok=True)
        run("chroot", self.bare, "useradd", "--create-home", "--shell", "/bin/bash", "user")
        (self.bare / "etc/sudoers.d/user").write_text("user ALL=(ALL) NOPASSWD: ALL\n")
        # A layer is thrown away: nothing has to reach the disk.
        (self.bare / "etc/dpkg/dpkg.cfg.d/layer").write_text("force-unsafe-io\n")
        self._bring_ccache()
        stamp.touch()

    def _bring_ccache(self):
        """This machine's, in a folder of its own, so that no package is there that a bare machine lacks."""
        program = shutil.which("ccache")
        if not program:
            return
        there = self.bare / "opt/ccache"
        there.mkdir(parents=True)
        libraries = re.findall(r"(/\S+\.so\S*) \(0x", run("ldd", program))
        for path in (program, *libraries):
            shutil.copy(path, there)
        loader = next(pathlib.Path(path).name for path in libraries if "/ld-" in path)
        (there / "ccache").rename(there / "ccache.bin")
        (there / "launch").write_text(
            f'#!/bin/sh\nexec /opt/ccache/{loader} --library-path /opt/ccache /opt/ccache/ccache.bin "$@"\n')
        (there / "launch").chmod(0o755)

    @contextlib.contextmanager
    def layer(self, user):
        """A machine to be used once, with a clone: (its root, the folder with all that has changed)."""
        folder = self.folder / "layer"
        if (folder / "root").is_dir():
            subprocess.run(["umount", "--recursive", folder / "root"], check=False, stderr=subprocess.DEVNULL)
        shutil.rmtree(folder, ignore_errors=True)
        upper, work, root = (folder / name for name in ("changed", "work", "root"))
        for path in (upper, work, root):
            path.mkdir(parents=True)
        run("mount", "-t", "overlay", "overlay", "-o", f"lowerdir={self.bare},upperdir={upper},workdir={work}", root)
        try:
            for source, target in ((self.cache / "archives", "var/cache/apt/archives"), (self.cache / "pip", "opt/pip"),
                                   (self.cache / "ccache", "opt/objects"), ("/dev", "dev")):
                (root / target).mkdir(parents=True, exist_ok=True)
                run("mount", "--rbind" if target == "dev" else "--bind", source, root / target)
            run("mount", "--make-rslave", root / "dev")
            clone = root / CLONES[user][1:]
            clone.parent.mkdir(parents=True, exist_ok=True)
            run("git", "clone", "--quiet", "--depth", "1", f"file://{ROOT}", clone)
            run("chroot", root, "chown", "-R", f"{user}:", pathlib.Path(CLONES[user]).parent)
            yield root, upper
        finally:
            subprocess.run(["umount", "--recursive", root], check=False)

    def start(self, root, user, words, log, cwd=None):
        """The process of a command on that machine."""
        environment = {
            "HOME": HOMES[user], "USER": user, "PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin",
            "LANG": "C.UTF-8", "PIP_CACHE_DIR": "/opt/pip", **self.environment}
        if (root / "opt/ccache/launch").is_file():
            environment |= {"CMAKE_CXX_COMPILER_LAUNCHER": "/opt/ccache/launch", "CCACHE_DIR": "/opt/objects",
                            "CMAKE_C_COMPILER_LAUNCHER": "/opt/ccache/launch", "CCACHE_UMASK": "000",
                            "CCACHE_SLOPPINESS": "pch_defines,time_macros,include_file_mtime,include_file_ctime"}
        assigned = [f"{name}={value}" for name, value in environment.items()]
        script = f'cd "{cwd or CLONES[user]}" && {words}'
        return subprocess.Popen(
            ["unshare", "--mount", "--pid", "--fork", "--kill-child", f"--mount-proc={root}/proc",
             "chroot", f"--userspec={user}:{user}", root, "env", "-i", *assigned, "bash", "-c", script],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE if log is None else log, stderr=subprocess.STDOUT, text=True)

    def installed(self, root):
        """How many packages have come, and their size."""
        def packages(place):
            return {path.stem.split(":")[0] for path in (place / "var/lib/dpkg/info").glob("*.list")}
        came = packages(root) - packages(self.bare)
        size = sum(path.stat().st_size for path in (self.cache / "archives").glob("*.deb")
                   if path.name.split("_")[0] in came)
        return f"{len(came)} ({size / 1e6:.0f} MB)" if came else "0"


def end(process):
    """Ends all that a command has started: the first process of its name space, and so the others."""
    for child in pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split():
        os.kill(int(child), signal.SIGKILL)


def left_outside(root, upper, user):
    """Files that have appeared, but for those of packages, of the clone, of PREFIX, and caches."""
    owned = set()
    for names in (root / "var/lib/dpkg/info").glob("*.list"):
        owned |= {line.strip("/") for line in names.read_text(errors="replace").splitlines()}
    owned |= {re.sub(r"^(bin|sbin|lib|lib64)/", r"usr/\1/", name) for name in owned}
    mine = (*OF_PACKAGES, CLONES[user][1:], str(pathlib.Path(CLONES[user]).with_name("moved"))[1:],
            HOMES[user][1:] + "/hwffd", HOMES[user][1:] + "/work", "opt", "dev", "proc")
    paths = []
    for folder, _, files in os.walk(upper):
        place = str(pathlib.Path(folder).relative_to(upper))
        for name in files:
            path = f"{place}/{name}".removeprefix("./")
            real = upper / path
            if real.is_symlink() and os.readlink(real).startswith("/etc/alternatives/"):
                continue
            if path in owned or "__pycache__" in path or any(path == folder or path.startswith(folder + "/")
                                                             for folder in mine):
                continue
            paths.append("/" + path)
    return paths


def snippets(machine, root, user, log):
    """The code of the README against $HOME/hwffd, the clone moved away; a complaint, or nothing."""
    clone, work = root / CLONES[user][1:], root / HOMES[user][1:] / "work"
    text = (clone / "README.md").read_text()
    blocks = {language: re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
              for language in ("sh", "python", "cpp", "verilog")}
    clone.rename(clone.with_name("moved"))
    work.mkdir()
    for name, language in (("deform.py", "python"), ("deform.cpp", "cpp")):
        (work / name).write_text(blocks[language][-1])
    (work / "readme.v").write_text(f"module readme;\n  wire clk, rst, {SIGNALS};\n  wire [127:0] command, result;\n"
                                   f"{blocks['verilog'][-1]}endmodule\n")
    lines = [line.split("  #")[0] for line in blocks["sh"][-1].splitlines() if not line.startswith("hwffd view")]
    lines.append("verilator --lint-only --top-module readme -F $HOME/hwffd/share/hwffd/rtl/hwffd.f readme.v")
    (work / "commands").write_text("set -ex\n" + "\n".join(lines) + "\n")
    run("chroot", root, "chown", "-R", f"{user}:", f"{HOMES[user]}/work")
    packages = "python3-numpy pkg-config"  # which the README asks for
    process = machine.start(root, user, f"sudo apt-get install -qq --no-install-recommends {packages} >/dev/null && "
                            "bash commands", log, f"{HOMES[user]}/work")
    return "" if process.wait() == 0 else "the README's code fails"


def measure(machine, command, logs):
    """(how it ended, seconds, what it installed, files outside, whether that is right)"""
    log = logs / f"{re.sub('[^a-z]+', '-', command.name)}.log"
    with machine.layer(command.user) as (root, upper), open(log, "w", encoding="utf-8") as text:
        begin = time.monotonic()
        process = machine.start(root, command.user, command.words, None)
        limit = threading.Timer(3600, end, (process,))
        limit.start()
        ended = ""
        for line in process.stdout:
            text.write(line)
            text.flush()
            if command.until and not ended and re.search(command.until, line):
                ended = "first row"
                end(process)
        status = process.wait()
        limit.cancel()
        seconds = time.monotonic() - begin
        ended = ended or ("done" if status == 0 else f"status {status}")
        right = ended in ("done", "first row")
        if right and command.then:
            text.flush()
            complaint = snippets(machine, root, command.user, text)
            ended, right = complaint or f"{ended}, README's code too", not complaint
        outside = left_outside(root, upper, command.user)
        installed = machine.installed(root)
    return ended, seconds, installed, outside, right and not outside


def targets():
    """Those of the Makefile."""
    return set(re.search(r"^\.PHONY: (.*)$", (ROOT / "Makefile").read_text(), re.MULTILINE)[1].split()) - {"help"}


def main():
    parser = argparse.ArgumentParser(description="Each command as the first of a fresh clone on a bare machine.")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build" / "fresh", help="where machines lie")
    parser.add_argument("--also", type=pathlib.Path, action="append", default=[], metavar="FILE",
                        help="a table of commands like tools/checks/fresh_machine.csv")
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {TABLE.name}, or of the tables given; all")
    options = parser.parse_args()
    known = commands(*options.also)
    wanted = [command for command in known if not options.names or command.name in options.names]
    tried = {word for command in known for word in re.findall(r"\bmake ([a-z-]+)", command.words)}
    unknown = set(options.names) - {command.name for command in known}
    if unknown or targets() - tried:
        print(f"fresh: not known here: {', '.join(sorted(unknown | (targets() - tried)))}", file=sys.stderr)
        return 2
    if os.getuid() != 0 or not shutil.which("debootstrap"):
        print("fresh: it needs root, and debootstrap: apt-get install debootstrap", file=sys.stderr)
        return 2
    options.folder.mkdir(parents=True, exist_ok=True)
    logs = options.folder / "logs"
    logs.mkdir(exist_ok=True)
    machine = Machine(options.folder.resolve())
    try:
        machine.make()
    except subprocess.CalledProcessError as error:
        print(f"fresh: no bare machine: {error.output.strip().splitlines()[-1]}", file=sys.stderr)
        return 1
    wrong = 0
    print("| command | as | status | seconds | Debian packages | files outside |\n|---|---|---|--:|--:|---|", flush=True)
    for command in wanted:
        ended, seconds, installed, outside, right = measure(machine, command, logs)
        wrong += not right
        print(f"| `{command.words}` | {command.user} | {ended} | {seconds:.0f} | {installed} "
                     f"| {', '.join(outside[:3]) + (' ...' if len(outside) > 3 else '') or '0'} |", flush=True)
    print(f"fresh: {len(wanted)} commands, {wrong} not as they should be; what they said: {logs}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
