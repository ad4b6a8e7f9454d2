"""Texts with blocks that programs write: tables and sentences with figures.

    <!-- results VERSION: REPORT.TABLE ARGUMENT ...    of measurements, of docs/results/VERSION; the opening
    LINE                                               comment may go on over lines, which the table reads
    -->
    | a table |

    Measured with VERSION.
    <!-- end results -->

    <!-- results VERSION: template                     text, in which {EXPRESSION} is a figure
    LINE
    -->                                                (text_expressions.py says what may be there)

    <!-- sources: REPORT.TABLE ARGUMENT ... -->        of the sources themselves, without a version
    | a table |                                        the last column of some is written by hand, and stays
    <!-- end sources -->

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import shlex

from tools.reports import results, text_expressions
from tools.reports.results import Missing, RequestError
from tools.reports.text_table import Table, cell

PATTERNS = ("*.md", "docs/**/*.md", "synth/**/*.md", "examples/**/*.md", "tests/**/*.md")
CURE = "python3 -m tools.reports.write_blocks"
_BLOCK = re.compile(r"^(?P<open><!-- (?P<kind>results|sources)(?: (?P<version>[^\s:]+))?: (?P<what>[^\n]*?)"
                    r"(?P<lines>\n(?:[^\n]*\n)*?)?(?(lines)-->| -->))\n(?P<inside>(?:(?!<!--)[^\n]*\n)*?)"
                    r"(?P<close><!-- end (?P=kind) -->)$", re.MULTILINE)
# Whatever looks like a mark: one that the form above does not cover is a fault.
_ANY = re.compile(r"<!-- (?:results|sources|end results|end sources|figures)\b|<!--=|<!--/-->")
# Examples of marks, which stand as they are: in a block of code between fences.
_FENCE = re.compile(r"^```[^\n]*\n.*?^```$", re.MULTILINE | re.DOTALL)
_FIGURE = re.compile(r"\{([^{}]*)\}")
_OPEN, _HIDDEN = "<!--", "\0"


class Unknown(Exception):
    """A table of a report that these modules do not know."""


def rows_table(reports, report, words, lines):
    """A table of a report's rows: KEY=VALUE ... and `plain` choose them, each line is a column,
    heading | field:FORMAT, or heading | an expression over another report, joined by name.
    """
    wanted = text_expressions.pairs([word for word in words if word != "plain"])
    rows = reports.rows(report, **wanted)
    if "plain" in words:
        rows = [row for row in rows if len(row["name"].split("-")) == 3]
    columns = [[part.strip() for part in line.split("|", 1)] for line in lines]
    if not columns or any(len(column) != 2 for column in columns):
        raise RequestError(f"{report}.rows: each column is a line, heading | field")
    return Table([head for head, _ in columns],
                 [[_cell(reports, row, what) for _, what in columns] for row in rows])


def _cell(reports, row, what):
    if what.strip("`").partition(":")[0] in row:
        return cell(row, what)
    try:
        return text_expressions.written(reports, what, {"name": row["name"]})
    except Missing:
        if reports.has(what.split(".")[0]):
            return "-"  # the other report has no such row
        raise


def table(reports, what, lines=()):
    """The Table that a block asks for. Raises Missing, RequestError and Unknown."""
    name, *words = shlex.split(what)
    report, dot, kind = name.partition(".")
    if not dot:
        raise RequestError(f"'{name}' is not REPORT.TABLE")
    if kind == "rows":
        if report not in reports.modules and not reports.has(report):
            raise Unknown(report)
        return rows_table(reports, report, words, lines)
    if report not in reports.modules:
        raise Unknown(report)
    tables = reports.modules[report].TABLES
    if kind not in tables:
        raise RequestError(f"{report} has no table '{kind}': one of {', '.join([*tables, 'rows'])}")
    try:
        return tables[kind](reports, *words, **({"lines": lines} if lines else {}))
    except TypeError as error:
        raise RequestError(f"'{what}': {error}") from error


def template(reports, lines):
    """Lines of text with their figures."""
    def figure(match):
        if match[1].lstrip("(").split("(")[-1].split(".")[0] not in reports.modules:
            raise Unknown(match[1])
        return text_expressions.written(reports, match[1])
    return "".join(_FIGURE.sub(figure, line) + "\n" for line in lines)


def _written(reports, what, lines):
    """What stands in a block."""
    if what == "template":
        return template(reports, lines)
    content = table(reports, what, lines)
    if not getattr(content, "rows", True):
        raise RequestError(f"{what}: the table has no rows")
    return content.markdown() + "\n"


def _by_hand(reports, match):
    """What stands in a block whose table has a column that is written by hand."""
    report, _, kind = match["what"].split()[0].partition(".")
    by_hand = getattr(reports.modules.get(report), "BY_HAND", ())
    return match["inside"].splitlines() if kind in by_hand else []


def closing(release):
    """The line below what is of a release, in words."""
    several = " (several commits)" if release.get("mixed") else ""
    return f"Measured with {release['version']}{several}."


class Blocks:
    """What the blocks of a checkout's texts should say. `modules` by name make the tables; with `partly`
    a block of a report that is not among them is not looked at."""

    def __init__(self, root, modules, patterns=PATTERNS, partly=False, cure=CURE):
        self.root, self.modules, self.partly = pathlib.Path(root), modules, partly
        self.patterns, self.cure = patterns, cure
        self._releases = {}

    def texts(self):
        """Every text that may have blocks."""
        return sorted({path for pattern in self.patterns for path in self.root.glob(pattern)
                       if path.name != "CHANGELOG.md"})

    def _release(self, version):
        """(the results of a version, its release.json). Raises RequestError."""
        if version not in self._releases:
            released = results.released(self.root, version, self.modules)
            self._releases[version] = released, results.read(released.folder / results.RELEASE)
        return self._releases[version]

    def inside(self, match):
        """What a block should say. Raises Missing, RequestError and Unknown."""
        lines = [line for line in (match["lines"] or "").splitlines() if line.strip()]
        if match["kind"] == "sources":
            reports = results.Results(self.root, modules=self.modules)
            return _written(reports, match["what"], lines or _by_hand(reports, match))
        if not match["version"]:
            raise RequestError("a block of results names its version: <!-- results VERSION: ...")
        reports, release = self._release(match["version"])
        text = _written(reports, match["what"], lines)
        is_sentence = match["what"] == "template" and not text.startswith("|")
        return f"{text}{'' if is_sentence else chr(10)}{closing(release)}\n"

    def fill(self, text, version=""):
        """(the text with its blocks written, [(line, what is wrong)]). Where there is a fault the text
        stays. With a version, blocks of results become of that one."""
        faults = []
        text = _FENCE.sub(lambda match: match.group().replace(_OPEN, _HIDDEN), text)
        if version:
            text = re.sub(r"^<!-- results [^\s:]+: ", f"<!-- results {version}: ", text, flags=re.MULTILINE)

        def write(match):
            try:
                return f"{match['open']}\n{self.inside(match)}{match['close']}"
            except Unknown as unknown:
                if not self.partly:
                    faults.append((_line(match), f"'{unknown}' is of no report"))
            except (Missing, RequestError, ValueError, KeyError) as error:
                faults.append((_line(match), str(error)))
            return match.group()

        text = _BLOCK.sub(write, text)
        rest = _BLOCK.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)
        faults += [(_line(match), f"a mark without its other half: {match.group()}") for match in _ANY.finditer(rest)]
        return text.replace(_HIDDEN, _OPEN), faults

    def check(self):
        """(texts looked at, what is wrong in them, a line each)."""
        names, wrong = self.texts(), []
        for path in names:
            before, name = path.read_text(encoding="utf-8"), path.relative_to(self.root)
            after, faults = self.fill(before)
            wrong += [f"{name}:{line}: {message}" for line, message in faults]
            wrong += [f"{name}:{line}: not what the results say: '{old.strip()[:60]}', '{new.strip()[:60]}' "
                      f"wanted: {self.cure}" for line, old, new in differences(before, after)]
        return len(names), wrong

    def write(self, version=""):
        """(the texts changed, what is wrong)."""
        changed, wrong = [], []
        for path in self.texts():
            before = path.read_text(encoding="utf-8")
            after, faults = self.fill(before, version)
            wrong += [f"{path.relative_to(self.root)}:{line}: {message}" for line, message in faults]
            if after != before:
                path.write_text(after, encoding="utf-8")
                changed.append(path)
        return changed, wrong


def _line(match):
    return match.string.count("\n", 0, match.start()) + 1


def differences(before, after):
    """(line, what stands there, what the results say) of each line that differs, the first first."""
    old, new = before.splitlines(), after.splitlines()
    if len(old) != len(new):
        at = next((i for i, (a, b) in enumerate(zip(old, new)) if a != b), min(len(old), len(new)))
        return [(at + 1, old[at] if at < len(old) else "", new[at] if at < len(new) else "")]
    return [(number, a, b) for number, (a, b) in enumerate(zip(old, new), 1) if a != b]


def releases(root):
    """What is wrong with the folders of results, a line each: results of several commits that do not say so."""
    wrong = []
    for version in results.versions(root):
        folder = pathlib.Path(root) / results.RELEASED / version
        try:
            release = results.read(folder / results.RELEASE)
            if release.get("version") != version:
                raise RequestError(f"says version {release.get('version')}")
            if release.get("mixed"):
                if not release.get("why"):
                    raise RequestError("is mixed and does not say why")
                continue
            commits = {name: results.read(folder / f"{name}.json").get("commit") for name in release["studies"]}
            if (other := sorted(name for name, commit in commits.items() if commit != release.get("commit"))):
                raise RequestError(f"{other[0]}.json is of another commit than {release.get('commit')}: measure all "
                                   "with make -C lab results")
        except (RequestError, KeyError) as error:
            wrong.append(f"{results.RELEASED}/{version}/{results.RELEASE}: {error}")
    return wrong
