"""Commands and code in the pages: fenced blocks, and indented ones that begin with a command.

What stands in an HTML comment before a block says what becomes of it: "run by: TEST" names a test of ctest that runs
it, "not run: REASON" why none does.

SPDX-License-Identifier: Apache-2.0
"""

import re
from dataclasses import dataclass

from apps.docs import staging

_BLOCK = re.compile(r"(?P<mark>^<!-- (?:run by|not run): [^>]*? -->\n\n?)?"
                    r"(?:^```(?P<language>\w*)\n(?P<fenced>.*?)^```$|(?P<indented>(?:^    [^\n]*\n)+))",
                    re.MULTILINE | re.DOTALL)
_MARK = re.compile(r"<!-- (run by|not run): (.*?) -->", re.DOTALL)
_COMMAND = re.compile(r" *(?:[A-Z_]+=\S+ )*(?:hwffd|make|python3 -m|ctest|fusesoc|verilator|cmake|pip|git|head|gtkwave|iceprog|openFPGALoader"
                      r"|(?:build|tools|tests|synth)/\S+) ")
SHOWN = ("", "text", "markdown", "mermaid", "yaml")  # languages of what is no command and no code


@dataclass
class Block:
    page: str
    line: int
    language: str
    text: str
    mark: str = ""  # "run by" or "not run", with
    reason: str = ""
    expected: str = ""  # the block of text behind it

    @property
    def place(self):
        return f"{self.page}:{self.line}"

    def commands(self):
        """Its lines of a shell, those that go on in one."""
        joined = re.sub(r"\\\n *", "", self.text)
        lines = (re.sub(r"\s+#.*", "", line).strip() for line in joined.splitlines())
        return [line for line in lines if line]


def of_text(page, text):
    """All blocks of a page that are commands or code."""
    marked, before = [], None
    for match in _BLOCK.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        if match["indented"] is not None:
            before = None
            if _COMMAND.match(match["indented"]):
                block = Block(page, line, "sh", re.sub(r"^    ", "", match["indented"], flags=re.MULTILINE))
                marked.append(_marked(block, match["mark"]))
        elif match["language"] in SHOWN:
            if match["language"] == "text" and before:
                before.expected = match["fenced"]
            before = None
        else:
            before = _marked(Block(page, line, match["language"], match["fenced"]), match["mark"])
            marked.append(before)
    return marked


def _marked(block, comment):
    if comment:
        block.mark, block.reason = _MARK.match(comment).groups()
    return block


def of_project(root):
    return [block for path in staging.pages(root)
            for block in of_text(str(path.relative_to(root)), path.read_text(encoding="utf-8"))]


def matches(expected, output):
    """Whether something was printed as it is shown, "..." for anything within a line and blanks for blanks."""
    wanted, lines = expected.split("\n"), output.split("\n")
    pattern = [".*".join(re.escape(" ".join(part.split())) for part in line.split("...")) for line in wanted]
    return len(wanted) == len(lines) and all(
        re.fullmatch(expression, " ".join(line.split())) for expression, line in zip(pattern, lines))
