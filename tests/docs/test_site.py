"""The site of make docs: what is taken from texts, headers and bindings, and that a dead link fails the build.

SPDX-License-Identifier: Apache-2.0
"""

import ast
import re
import shutil
import subprocess
import sys

import pytest

from apps.docs import bindings, doxygen, flowchart, python_reference, reference, staging
from tools.project_root import ROOT

HEADER = """#pragma once
namespace hwffd {
/// A thing with *stars* (docs/lattice.md section 1).
/// @throws Error if it is none
class Thing : public Base {
 public:
  explicit Thing(const Base& of, int n = 3);
  Thing(const Thing&) = delete;
  int size = 0;  ///< in cells
 private:
  int hidden_;
};
enum class Kind : int { kOne /**< the first */, kTwo };
/// Two of them.
template <class F>
std::vector<F> pair(const F& one, const F* other);
namespace detail { int inner(); }
}
"""


def test_comments_are_taken_out_but_not_of_code():
    text = "a `<!-- c -->`\n<!-- results 1.0.0: t\nmore -->\n| a |\n<!-- end results -->\n\n```markdown\n<!-- kept -->\n```\n"
    assert staging.without_comments(text) == "a `<!-- c -->`\n| a |\n\n```markdown\n<!-- kept -->\n```\n"


def test_linked_files_come_along(checkout):
    checkout.put({"docs/a.md": "[b](b.md) ![p](p.svg) [c](../rtl/t.csv#x) [w](https://x.example/y)\n```\n[n](no.csv)\n```\n",
                  "docs/b.md": "", "docs/p.svg": "<svg/>", "docs/no.csv": "", "rtl/t.csv": "1\n"})
    pages = staging.stage(checkout.root, checkout.root / "build" / "source")
    assert [path.name for path in pages] == ["a.md", "b.md"]
    staged = {str(path.relative_to(checkout.root / "build" / "source"))
              for path in (checkout.root / "build" / "source").rglob("*") if path.is_file()}
    assert staged == {"docs/a.md", "docs/b.md", "docs/p.svg", "rtl/t.csv"}


def test_a_text_that_is_no_page_is_named_without_a_link(checkout):
    checkout.put({"docs/a.md": "[x](../other/x.md#y) [t](../rtl/t.csv) [n](../other/n.csv) [b](b.md) [d](no.md)\n",
                  "docs/b.md": "", "rtl/t.csv": "1\n"})
    staging.stage(checkout.root, checkout.root / "build" / "source")
    assert checkout.text("build/source/docs/a.md") == "x [t](../rtl/t.csv) n [b](b.md) [d](no.md)\n"


def test_flowchart(tmp_path):
    assert '"a" -> "c"; "b" -> "c";' in flowchart.dot("flowchart LR\n  a & b --> c\n")
    if shutil.which("dot"):
        text = flowchart.drawn("x\n\n```mermaid\nflowchart TB\n  a --> b\n```\n", tmp_path / "page.md")
        assert "(page-flowchart-1.svg)" in text
        assert "</svg>" in (tmp_path / "page-flowchart-1.svg").read_text()


@pytest.mark.parametrize("text", ("graph TB\n a --> b", "flowchart TB\n a -.-> b"))
def test_flowchart_that_is_not_understood(text):
    with pytest.raises(flowchart.FlowchartError, match="flowchart: \".*\" is no "):
        flowchart.dot(text)


@pytest.fixture
def header(checkout):
    """What is found in a header."""
    if not shutil.which("doxygen"):
        pytest.skip("no doxygen")
    checkout.put({"golden/include/hwffd/error.hpp": HEADER})
    parsed = doxygen.headers(doxygen.run(checkout.root, checkout.root / "build"))
    assert list(parsed) == ["hwffd/error.hpp"]
    return parsed["hwffd/error.hpp"]


def test_declarations(header):
    assert [declaration.text for declaration in header.declarations] == [
        "class Thing : public Base", "enum class Kind : int",
        "template<class F> std::vector<F> pair(const F& one, const F* other)"]
    thing, kind, _ = header.declarations
    assert [member.text for member in thing.members] == ["explicit Thing(const Base& of, int n=3)", "int size = 0"]
    assert [(value.name, reference.comment(value)) for value in kind.members] == [("kOne", "the first"), ("kTwo", "")]


def test_page_of_a_header(header):
    text = reference.pages({header.path: header})["meshes"]
    assert "### Thing\n" in text and "hidden" not in text and "inner" not in text
    assert "A thing with <em>stars</em> ([docs/lattice.md](../lattice.md) section 1)." in text
    assert "throws <code>Error</code> if it is none" in text
    assert "| <code>int size = 0</code> | in cells |" in text


def test_a_header_needs_a_page():
    with pytest.raises(reference.HeaderError, match="hwffd/new/x.hpp: on no page"):
        reference.pages({"hwffd/new/x.hpp": doxygen.Header("hwffd/new/x.hpp", [])})


def test_nothing_is_read_as_markdown():
    assert not re.search(r"[*_`\[\]|<>]", reference.escaped("a*b_c[0] | `x` <T>").replace("&lt;", "").replace("&gt;", ""))


def test_every_name_of_the_python_package_has_a_docstring():
    texts = bindings.docstrings(sorted((ROOT / "api/python/src").glob("*.cpp")))
    tree = ast.parse((ROOT / python_reference.PACKAGE / "__init__.pyi").read_text())
    names = [node.name for node in tree.body if isinstance(node, ast.FunctionDef)]
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and node.name in ("Lattice", "Embedding"):
            names += [node.name] + [f"{node.name}.{child.name}" for child in node.body
                                    if isinstance(child, ast.FunctionDef)]
    unsaid = [name for name in names if not texts.get(name) and name != "Embedding.__len__"]
    assert len(names) > 40 and not unsaid


def test_a_docstring_may_hold_brackets_and_calls():
    text = 'type.def("f", &f, py::arg("a") = g(1, 2), "One (two), " "three.")'
    assert bindings.arguments(text, text.index("(") + 1)[-1] == '"One (two), " "three."'


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """make docs in a folder of its own."""
    for program in ("doxygen", "dot"):
        if not shutil.which(program):
            pytest.skip(f"no {program}: run tools/install docs")
    build = tmp_path_factory.mktemp("site")
    result = subprocess.run([sys.executable, "-B", "-m", "apps.docs", "--build", build], text=True, check=False,
                            capture_output=True)
    assert result.returncode == 0, result.stdout + result.stderr
    return build


def test_the_site_is_whole(site):
    home = (site / "docs" / "index.html").read_text()
    assert "<!-- results" not in home
    for page in ("docs/reference/lattices.html", "docs/tutorial/10-bitstream.html", "docs/organizations/nested.html"):
        assert (site / "docs" / page).is_file()
    assert "Embedder" in (site / "docs" / "search" / "search_index.js").read_text()


def test_nothing_is_fetched_from_other_hosts(site):
    fetched = re.compile(r"<(?:script|img|iframe|link)\b[^>]*(?:src|href)=[\"']?(?:https?:)?//(?!www\.w3\.org)")
    for page in (site / "docs").rglob("*.html"):
        foreign = [address for address in fetched.findall(page.read_text()) if "canonical" not in address]
        assert not foreign, page


def test_dead_links_and_pages_that_no_menu_has_fail(site, tmp_path):
    dead = ("docs/nowhere.md", "docs/assurance.md#nowhere", "/rtl")
    source = shutil.copytree(site / "docs-source", tmp_path / "source")
    page = source / "CHANGELOG.md"
    page.write_text(page.read_text() + "".join(f"\n[x]({link})\n" for link in dead))
    (source / "docs" / "unlisted.md").write_text("# Unlisted\n")
    result = subprocess.run([sys.executable, "-B", "-m", "apps.docs", "--build", tmp_path, "--source", source],
                            text=True, check=False, capture_output=True)
    assert result.returncode == 1
    for link in dead:
        assert re.search(f"CHANGELOG.md.*'{link}'", result.stderr), result.stderr
    assert "docs/unlisted.md" in result.stderr
