"""Whether every arm of a generate construct has a name, gen_...

SPDX-License-Identifier: Apache-2.0
"""

import re

from rtl import line_of


class GenerateArms:
    """Walks module items far enough to tell a generate construct from a statement."""

    TOKEN = re.compile(r"`?[A-Za-z_$][\w$]*|\\\S+|\d[\w.']*|[()\[\]{};:@#]|\S")

    def __init__(self, code):
        code = re.sub(r"^\s*`(default_nettype|timescale|include|define|undef)\b[^\n]*",
                      lambda m: " " * len(m.group(0)), code, flags=re.MULTILINE)
        self.tokens = [(m.group(0), m.start()) for m in self.TOKEN.finditer(code)]
        self.code = code
        self.at = 0
        self.found = []

    def problems(self):
        while self.at < len(self.tokens):
            if self.peek() == "module":
                self.skip_past(";")
                self.items("endmodule")
            else:
                self.at += 1
        return self.found

    def peek(self, ahead=0):
        at = self.at + ahead
        return self.tokens[at][0] if at < len(self.tokens) else ""

    def report(self, message):
        offset = self.tokens[min(self.at, len(self.tokens) - 1)][1]
        self.found.append((line_of(self.code, offset), message))

    def skip_past(self, word):
        while self.peek() and self.peek() != word:
            self.at += 1
        self.at += 1

    def skip_parentheses(self):
        depth = 0
        while self.peek():
            depth += {"(": 1, ")": -1}.get(self.peek(), 0)
            self.at += 1
            if depth == 0:
                return

    def items(self, end):
        while self.peek() and self.peek() != end:
            self.item()
        self.at += 1

    def item(self):
        word = self.peek()
        if word in ("generate", "endgenerate"):
            self.at += 1
        elif word in ("if", "for"):
            self.at += 1
            self.skip_parentheses()
            self.arm()
            if word == "if" and self.peek() == "else":
                self.at += 1
                if self.peek() == "if":
                    self.item()
                else:
                    self.arm()
        elif word == "case":
            self.at += 1
            self.skip_parentheses()
            while self.peek() and self.peek() != "endcase":
                self.skip_label()
                self.arm()
            self.at += 1
        elif word == "begin":
            self.arm()
        elif word in ("always", "initial"):
            self.at += 1
            self.statement()
        elif word in ("function", "task", "specify"):
            self.skip_past("end" + word)
        else:
            self.skip_past(";")

    def skip_label(self):
        if self.peek() == "default" and self.peek(1) != ":":
            self.at += 1
            return
        depth = 0
        while self.peek() and not (self.peek() == ":" and depth == 0):
            depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(self.peek(), 0)
            self.at += 1
        self.at += 1

    def arm(self):
        if self.peek() == ";":
            self.at += 1
            return
        if self.peek() != "begin":
            self.report("generate arm without begin : gen_...")
            self.item()
            return
        if self.peek(1) != ":":
            self.report("generate arm without a name: begin : gen_...")
            self.at += 1
        else:
            if not re.match(r"gen_[a-z0-9_]+\Z", self.peek(2)):
                self.report(f"generate arm named {self.peek(2)}, gen_... wanted")
            self.at += 3
        self.items("end")

    def statement(self):
        word = self.peek()
        if word in ("@", "#"):
            self.at += 1
            if self.peek() == "(":
                self.skip_parentheses()
            else:
                self.at += 1
            self.statement()
        elif word == "begin":
            self.at += 1
            if self.peek() == ":":
                self.at += 2
            while self.peek() and self.peek() != "end":
                self.statement()
            self.at += 1
        elif word == "if":
            self.at += 1
            self.skip_parentheses()
            self.statement()
            if self.peek() == "else":
                self.at += 1
                self.statement()
        elif word in ("case", "casez", "casex"):
            self.skip_past("endcase")
        elif word in ("for", "while", "repeat", "wait"):
            self.at += 1
            self.skip_parentheses()
            self.statement()
        elif word == "forever":
            self.at += 1
            self.statement()
        else:
            self.skip_past(";")
