"""The site of make docs: what is taken from texts, headers and bindings, and that a dead link fails the build.

SPDX-License-Identifier: Apache-2.0
"""

import ast
import re
import shutil
import subprocess
import sys

import pytest

from apps.docs import bindings, doxygen, flowchart, python_reference, staging
from tools.project_root import ROOT

HEADERS = ("apps/docs", "api/include", "api/gl/include", "cores/include", "geometry/include", "golden/include",
           "registration/include")
HEADER = """#pragma once
/// @file
/// What is planted here.
namespace hwffd {
/// A thing with *stars* (docs/lattice.md section 1).
/// @throws Error if it is none
class Thing {
 public:
  explicit Thing(int n = 3);
  Thing(const Thing&) = delete;
  int size = 0;  ///< in cells
 private:
  int concealed_;
};
enum class Kind : int { kOne /**< the first */, kTwo };
/// Two of them.
template <class F>
std::vector<F> pair(const F& one, const F* other);
namespace detail { int unspoken(); }
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
def planted(checkout):
    """Doxygen's pages of the public headers and one more of this text."""
    if not shutil.which("doxygen"):
        pytest.skip("no doxygen")
    for name in HEADERS:
        shutil.copytree(ROOT / name, checkout.root / name, dirs_exist_ok=True)

    def pages(text):
        checkout.put({"golden/include/hwffd/planted.hpp": text})
        doxygen.run(checkout.root, checkout.root / "build/with blank")
        return {path.name: path.read_text() for path in (checkout.root / "build/with blank").rglob("*.html")}
    return pages


def test_pages_of_a_header(planted):
    pages = planted(HEADER)
    thing, header, names = (pages[f"{page}.html"] for page in ("classhwffd_1_1Thing", "planted_8hpp", "namespacehwffd"))
    assert 'A thing with <em>stars</em> (<a href="../../lattice.html">docs/lattice.md</a> section 1)' in thing
    assert "in cells" in thing and "if it is none" in thing and "What is planted here." in header
    assert "pair" in header and "kTwo" in header and "the first" in names
    assert not [name for name, text in pages.items() if "concealed_" in text or "unspoken" in text]


@pytest.mark.parametrize("fault, word", (("\\nothing", "nothing"), ("@param m of them", "'m'")))
def test_a_comment_that_doxygen_does_not_understand_fails(planted, fault, word):
    with pytest.raises(doxygen.DoxygenError, match=f"planted.hpp:.*{word}"):
        planted(HEADER.replace("/// Two of them.", f"/// Two of them.\n/// {fault}"))


def test_a_folder_of_headers_that_is_gone_fails(checkout):
    shutil.copytree(ROOT / "apps/docs", checkout.root / "apps/docs")
    with pytest.raises(doxygen.DoxygenError, match="api/include"):
        doxygen.run(checkout.root, checkout.root / "build")


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


def test_docstrings_of_the_bindings_stand_in_the_stub(checkout):
    checkout.put({"api/python/src/a.cpp": 'module.def("f", &f, "An *array_ of x.");\npy::class_<A>(module, "A", "Of A.")\n'
                                          '.def_readonly("n", &A::n, "How many.");\n',
                  "api/python/hwffd/__init__.pyi": "def f() -> int: ...\nclass A:\n    n: int\n",
                  "api/python/hwffd/volumes/b.py": 'def g():\n    """Its\n    own_.\n\n        x_y\n    """\n    return 1\n'})
    python_reference.stage(checkout.root, checkout.root / "build")
    package = ast.parse(checkout.text("build/hwffd/__init__.py"))
    assert ast.get_docstring(package.body[0]) == r"An \*array\_ of x."
    assert ast.get_docstring(package.body[1]) == "Of A." and package.body[1].body[2].value.value == "How many."
    own = ast.get_docstring(ast.parse(checkout.text("build/hwffd/volumes/b.py")).body[0])
    assert own == "Its\nown\\_.\n\n    x_y"


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
    for page in ("docs/reference/cpp.html", "docs/tutorial/10-bitstream.html", "docs/organizations/walk.html"):
        assert (site / "docs" / page).is_file()
    assert "pull_back" in (site / "docs" / "search" / "search_index.js").read_text()


def test_the_page_of_python_has_every_name_with_its_words(site):
    page = (site / "docs/docs/reference/python.html").read_text()
    for name in ("hwffd.deform", "hwffd.Lattice.around", "hwffd.Lattice.control_points", "hwffd.volumes.warp"):
        assert f'id="{name}"' in page, name
    assert "Points attached to a lattice at rest" in page and "The rows that set_device takes" in page
    assert "_refusals" not in page and "hwffd._" not in page


def test_the_reference_has_every_header_and_its_links_lead_to_pages(site):
    pages = {path.name: path.read_text() for path in (site / "docs/docs/reference/cpp").glob("*.html")}
    assert 'href="driver_8hpp.html"' in pages["index.html"] and "classhwffd_1_1Driver.html" in pages
    for folder in ("api/include", "api/gl/include", "geometry/include", "golden/include", "registration/include"):
        for path in (ROOT / folder).rglob("*.h*"):
            assert f">{path.name}<" in pages["files.html"], path
    links = {link for text in pages.values() for link in re.findall(r'href="\.\./\.\./([^"#]*)"', text)}
    assert len(links) > 5
    assert not [link for link in links if not (site / "docs/docs" / link).is_file()]


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
