#!/usr/bin/env python3
"""Gives a reader of text mutations of valid inputs. An input fails that is neither valid nor
refused with one printable line of at most 200 characters, or that ends the program or takes it over
20 seconds.

    fuzz.py PROGRAM TARGET

HWFFD_FUZZ_SEED chooses other inputs, HWFFD_FUZZ_INPUT one of them, HWFFD_FUZZ_TIMES times as many: 0.1 is a tenth.

SPDX-License-Identifier: Apache-2.0
"""

import contextlib
import itertools
import os
import random
import re
import subprocess
import sys
import threading

INPUTS = {"lattice": 60000, "deformation": 20000, "outside": 5000, "stages": 10000, "points": 5000,
          "edit-obj": 4000, "edit-ply": 4000, "edit-off": 4000, "edit-stl": 4000,
          "edit-gltf": 4000, "edit-glb": 4000, "obj": 2000, "ply": 2000, "stl": 2000,
          "gltf": 2000, "glb": 2000}
FEW = 50  # of each other format of meshes
LONGEST_INPUT = 1 << 20
LONGEST_MESSAGE = 200
MOST_FAILURES = 20
# Numbers at and beyond the ends of integers, of binary32 and binary64, and what is not a number.
NUMBERS = [text.encode() for text in (
    "0 -0 -1 3 16 17 255 2147483648 -2147483649 4294967295 1e9 4294967300 1e-320 1e38 3.5e38 1e308"
    " -1e308 1e999 nan -inf 0x7f 1e 9223372036854775808 18446744073709551616").split()]
SPECIAL = b"\0\n\r\t \"'\\[]{}:,.-/#\x7f\xff"  # bytes that mean something to a reader of text
NUMBER = re.compile(rb"[0-9.+eE-]+")
WORD = re.compile(rb"[A-Za-z_]+")


def part(draw, text, longest):
    """Start and end of up to so many bytes, or in one of eight cases of any number."""
    start = draw.randrange(len(text))
    most = len(text) - start
    return start, start + draw.randint(1, min(longest, most) if draw.randrange(8) else most)


def change_byte(draw, text, _):
    at = draw.randrange(len(text))
    byte = draw.choice((text[at] ^ 1 << draw.randrange(8), draw.randrange(256),
                        draw.choice(SPECIAL)))
    return text[:at] + bytes([byte]) + text[at + 1:]


def cut(draw, text, _):
    start, end = part(draw, text, 20)
    return text[:start] + text[end:]


def copy(draw, text, corpus):
    """A part of this input or of another valid one, inserted or written over what is there."""
    source = draw.choice((text, draw.choice(corpus)))
    start, end = part(draw, source, 40)
    at = draw.randrange(len(text) + 1)
    return text[:at] + source[start:end] + text[at + draw.choice((0, end - start)):]


def change_number(draw, text, corpus):
    numbers = list(NUMBER.finditer(text))
    if not numbers:
        return change_byte(draw, text, corpus)
    number = draw.choice(numbers)
    return text[:number.start()] + draw.choice(NUMBERS) + text[number.end():]


def swap_words(draw, text, corpus):
    """Two words change places, or one takes that of the other."""
    words = list(WORD.finditer(text))
    if len(words) < 2:
        return change_byte(draw, text, corpus)
    first, second = sorted(draw.sample(words, 2), key=re.Match.start)
    new = draw.choice(((second, first), (first, first), (second, second)))
    return (text[:first.start()] + new[0].group() + text[first.end():second.start()] + new[1].group()
            + text[second.end():])


def nest(draw, text, _):
    start, end = part(draw, text, 20)
    before, behind = draw.choice(((b"[", b"]"), (b"[", b"]"), (b'{"a":', b"}")))
    depth = 1 << draw.randrange(17)
    return (text[:start] + before * depth + text[start:end]
            + behind * draw.choice((0, depth)) + text[end:])


def repeat(draw, text, _):
    start = draw.randrange(len(text))
    piece = text[start:start + draw.randint(1, 8)]
    return text[:start] + piece * (1 << draw.randrange(16)) + text[start:]


# Numbers count double; deep and long texts, which take long to read, are rare.
CHANGES = {change_byte: 8, cut: 8, copy: 8, change_number: 16, swap_words: 8, nest: 1, repeat: 1}


def mutated(seed, number, corpus):
    """One to four changes to a valid input; about one in 64 is unchanged."""
    draw = random.Random(f"{seed} {number}")
    text = draw.choice(corpus)
    for _ in range(draw.randint(1, 4) if draw.randrange(64) else 0):
        (change,) = draw.choices(list(CHANGES), list(CHANGES.values()))
        text = change(draw, text or draw.choice(corpus), corpus)
    return text[:LONGEST_INPUT]


def fault_of(verdict, message):
    """What is wrong with an answer; empty if nothing."""
    if verdict == "valid":
        return ""
    text = message.decode("ascii", "replace")
    if verdict == "fault":
        return text
    if not message:
        return "the message is empty"
    if len(message) > LONGEST_MESSAGE:
        return f"the message has {len(message)} characters"
    printable = text.isascii() and text.isprintable()
    return "" if printable else f"the message is not one printable line: {message}"


class Reader:
    """The program that reads, with its corpus; ends with the block that uses it."""

    def __init__(self, program, target):
        self.process = subprocess.Popen([program, target], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE)
        self.corpus = [self._block(self._line()) for _ in range(int(self._line() or 0))]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()

    def _line(self):
        return self.process.stdout.readline().strip()

    def _block(self, size):
        return self.process.stdout.read(int(size))

    def answers(self, inputs):
        """(verdict, message) for each input; none after one that ends the program."""
        threading.Thread(target=self._feed, args=(inputs,), daemon=True).start()
        while line := self._line():
            verdict, size = line.split()
            yield verdict.decode(), self._block(size)
        if self.process.wait() != 0:
            yield "fault", f"the program ended: {self.process.returncode}".encode()

    def _feed(self, inputs):
        with contextlib.suppress(BrokenPipeError), self.process.stdin as pipe:
            for text in inputs:
                pipe.write(b"%d\n%b" % (len(text), text))


def tried(program, target, seed, numbers):
    """How many inputs were valid, how many refused, and the failures, each with what repeats it."""
    counts, failures = {"valid": 0, "refused": 0}, []
    with Reader(program, target) as reader:
        inputs = (mutated(seed, number, reader.corpus) for number in numbers)
        answers = reader.answers(itertools.chain(reader.corpus, inputs))
        for text, (verdict, message) in zip(reader.corpus, answers):
            if verdict != "valid":
                failures.append(f"{verdict}: {message}, a valid input: {text[:300]}")
        for number, (verdict, message) in zip(numbers, answers):
            fault = fault_of(verdict, message)
            if fault:
                text = mutated(seed, number, reader.corpus)
                failures.append(f"HWFFD_FUZZ_SEED={seed} HWFFD_FUZZ_INPUT={number} target {target}:"
                                f" {fault}; {len(text)} bytes: {text[:300]}")
                if len(failures) >= MOST_FAILURES:
                    break
            else:
                counts[verdict] += 1
        else:  # all were answered: how the reader ends, leaks included
            failures += [f"target {target}: {message}" for _, message in answers]
    return counts["valid"], counts["refused"], failures


def main():
    program, target = sys.argv[1:]
    seed = int(os.environ.get("HWFFD_FUZZ_SEED", 1))
    count = max(FEW, int(INPUTS.get(target, FEW) * float(os.environ.get("HWFFD_FUZZ_TIMES", 1))))
    replayed = int(os.environ.get("HWFFD_FUZZ_INPUT", -1))
    numbers = range(count) if replayed < 0 else [replayed]
    valid, refused, failures = tried(program, target, seed, numbers)
    print(f"{target}: {valid + refused} inputs, {valid} valid, {refused} refused", *failures,
          sep="\n")
    few = replayed < 0 and (refused <= count / 100 or (count >= 1000 and valid <= count / 100)
                            or valid + refused < count)
    if few:
        print("too few of a kind")
    return 1 if few or failures else 0


if __name__ == "__main__":
    sys.exit(main())
