"""Gappa and Coq: a script is proved by the one, and what that prints is accepted by the other.

SPDX-License-Identifier: Apache-2.0
"""

import fractions
import hashlib
import pathlib
import re
import shutil
import subprocess

THEORY = pathlib.Path(__file__).with_name("coq")
MODULES = ("Sums", "Fixed", "Float", "Programs", "Certified", "Scatter")
# What Coq's real numbers and classical logic rest on. A proof that rests on more is none.
AXIOMS = {"sig_forall_dec", "sig_not_dec", "functional_extensionality_dep", "classic"}


class BoundsError(Exception):
    """Something without which nothing can be said of bounds."""


def require(*programs):
    absent = [name for name in programs if not shutil.which(name)]
    if absent:
        raise BoundsError(f"not found: {', '.join(absent)} (make -C lab bounds installs them)")


def gappa(script, *options):
    """The exit status of Gappa on a script, and all that it prints. It splits what the script says and
    nothing else: what is false it would split for minutes."""
    result = subprocess.run(["gappa", "-Eno-auto-dichotomy", *options], input=script, capture_output=True,
                            text=True, check=False)
    return result.returncode, result.stdout + result.stderr if not options else result.stdout


def proves(script):
    status, _ = gappa(script)
    return status == 0


def certifies(script):
    """Whether Gappa proves it with the rules that it can write for Coq, which are fewer."""
    status, _ = gappa(script, "-Bcoq")
    return status == 0


def upper_bound(script, name):
    """The upper end that Gappa finds for |name| where the script asks `in ?`, as a fraction."""
    status, text = gappa(script)
    plain = re.sub(r" \{[^}]*\}", "", text)  # without the values in decimals
    match = re.search(r"\|" + re.escape(name) + r"\| in \[[^,]*, (\d+)(?:b(-?\d+))?\]", plain)
    if status != 0 or not match:
        raise BoundsError(f"Gappa finds no bound of {name}:\n{text}")
    return int(match[1]) * fractions.Fraction(2) ** int(match[2] or 0)


def coq_of(script, ending=""):
    """Gappa's proof for Coq. Rewriting rules that the script gives are proved, not assumed; the last
    theorem says what the script does."""
    status, text = gappa(script, "-Bcoq")
    if status != 0:
        raise BoundsError("Gappa does not prove it:\n" + gappa(script)[1])
    text = re.sub(r"^Hypothesis (\w+) : (.*)\.$",
                  r"Lemma \1 : \2.\nProof. first [ring | unfold Float1; ring]. Qed.", text, flags=re.MULTILINE)
    goal = re.search(r"^Definition s1 := \((\w+) /\\ (\w+)\)\.$", text, re.MULTILINE)
    refuted = goal and re.search(rf"^Definition {goal[2]} := \(not (\w+)\)\.$", text, re.MULTILINE)
    if not refuted or "Hypothesis" in text:
        raise BoundsError("Gappa's proof has another shape than expected")
    theorem = (f"Theorem certificate : {goal[1]} -> {refuted[1]}.\n"
               "Proof. intro H; apply Classical_Prop.NNPP; intro N; exact (l1 (conj H N)). Qed.\n")
    end = "End Generated_by_Gappa."
    if text.count(end) != 1:
        raise BoundsError("Gappa's proof has another end than expected")
    text = "Require Import Reals Lra Classical_Prop.\n" + text.replace(end, theorem + end + "\n" + ending)
    return text + f"Print Assumptions {re.findall('^Theorem ([a-z]+)', text, re.MULTILINE)[-1]}.\n"


class Theory:
    """Modules of lab/bounds/coq, compiled in a folder, and certificates beside them."""

    def __init__(self, folder, modules=MODULES):
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)
        texts = "".join((THEORY / f"{name}.v").read_text() for name in modules)
        self.key = hashlib.sha256(texts.encode()).hexdigest()[:16]
        marker = folder / f"{self.key}.done"
        if marker.exists():
            return
        for name in modules:
            shutil.copy(THEORY / f"{name}.v", folder)
            self.compile(name)
        marker.touch()

    def compile(self, name):
        result = subprocess.run(["coqc", "-q", f"{name}.v"], cwd=self.folder, capture_output=True, text=True,
                                check=False)
        if result.returncode != 0:
            raise BoundsError(f"Coq refuses {name}.v:\n{result.stdout}{result.stderr}")
        return result.stdout

    def certified(self, name, script, ending=""):
        """Whether Coq accepts Gappa's proof of a script with this ending: None, or why not. One that has been
        accepted before is not looked at again. Gappa's text does not say whether it is the same: its order
        differs from run to run."""
        marker = self.folder / f"{name}.accepted"
        key = hashlib.sha256("\0".join((self.key if ending else "", script, ending)).encode()).hexdigest()
        if marker.exists() and marker.read_text() == key:
            return None
        complaint = self.accepts(name, coq_of(script, ending))
        if not complaint:
            marker.write_text(key)
        return complaint

    def accepts(self, name, text):
        """Whether Coq accepts a text that rests on nothing but real numbers: None, or why not."""
        source, marker = self.folder / f"{name}.v", self.folder / f"{name}.accepted"
        marker.unlink(missing_ok=True)
        source.write_text(text)
        try:
            printed = self.compile(name)
        except BoundsError as error:
            return str(error)
        if "Axioms:" not in printed and "Closed under the global context" not in printed:
            return f"{name}.v does not say what it rests on"
        used = {name.split(".")[-1] for name in re.findall(r"^([\w.]+)(?= :|$)", printed.split("Axioms:")[-1],
                                                           re.MULTILINE)}
        if used - AXIOMS:
            return f"{name}.v rests on {', '.join(sorted(used - AXIOMS))}"
        return None
