"""What the live page takes and refuses: meshes, lattices, and browsers that lack something. Always on the page with a
worker that stands for the core.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib
import struct

import pytest
from browser import NO_WEBASSEMBLY, NO_WEBGL, WATCH, Open, started, stub_page

CORNERS = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
TRIANGLES = [(a, b, c) for a, *rest in FACES for b, c in zip(rest, rest[1:])]


def obj():
    lines = ["# a cube", *(f"v {x} {y} {z}" for x, y, z in CORNERS)]
    return "\n".join([*lines, *("f " + " ".join(f"{k + 1}//1" for k in face) for face in FACES), ""])


def ply(form, vertices=None):
    head = (f"ply\nformat {form} 1.0\ncomment a cube\nelement vertex {vertices or len(CORNERS)}\nproperty float x\n"
            "property double y\nproperty float z\nproperty uchar red\n"
            f"element face {len(FACES)}\nproperty list uchar int vertex_indices\nend_header\n")
    if form == "ascii":
        rows = [f"{x} {y} {z} 7" for x, y, z in CORNERS]
        return head + "\n".join([*rows, *("4 " + " ".join(map(str, face)) for face in FACES), ""])
    order = "<" if form == "binary_little_endian" else ">"
    return (head.encode() + b"".join(struct.pack(f"{order}fdfB", x, y, z, 7) for x, y, z in CORNERS)
            + b"".join(struct.pack(f"{order}B4i", 4, *face) for face in FACES))


def stl_text():
    facets = ("facet normal 0 0 0\nouter loop\n"
              + "".join(f"vertex {x} {y} {z}\n" for x, y, z in (CORNERS[k] for k in face))
              + "endloop\nendfacet\n" for face in TRIANGLES)
    return "solid cube\n" + "".join(facets) + "endsolid cube\n"


def stl_binary():
    facets = b"".join(struct.pack("<12fH", 0, 0, 0, *(w for k in face for w in CORNERS[k]), 0) for face in TRIANGLES)
    return b"solid but binary".ljust(80) + struct.pack("<I", len(TRIANGLES)) + facets


def lattice(swapped=False):
    """4 x 5 x 4 points around the cube; swapped: two layers change places, so that it folds."""
    layer = [0, 2, 1, 3, 4] if swapped else range(5)
    points = [[i - 1, (layer[j] - 1) / 2, k - 1] for i in range(4) for j in range(5) for k in range(4)]
    return json.dumps({"hwffd_lattice": 1, "dims": [4, 5, 4], "points": points})


GOOD = {"cube.obj": obj(), "text.ply": ply("ascii"), "little.PLY": ply("binary_little_endian"),
        "big.ply": ply("binary_big_endian"), "text.stl": stl_text(), "binary.stl": stl_binary()}

# File and a part of the sentence that says why it is not taken.
BAD = {
    "letter.obj": ("Dear reader,\nthis is no mesh.\n", "no vertex was found"),
    "points.obj": ("v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no triangle"),
    "index.obj": ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "vertex 9"),
    "nan.obj": ("v 0 0 zero\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "not a finite number"),
    "noise.stl": (bytes(range(256)) * 3, "no STL file"),
    "cut.stl": (stl_binary()[:-9], "no STL file"),
    "cut.ply": (ply("binary_little_endian")[:-3], "ends before"),
    "word.ply": (ply("ascii").replace("uchar red", "colour red"), "colour red"),
    "corner.ply": (ply("ascii").replace("4 0 1 3 2", "4 0 1 a 2"), "vertex NaN"),
    "wrapped.ply": (ply("ascii").replace("4 0 1 3 2", "4 0 1 4294967299 2"), "vertex 4294967299"),
    "format.ply": (ply("ascii").replace("ascii", "asci"), "format"),
    "nothing.ply": ("ply\nformat ascii 1.0\nelement nothing 1e15\nend_header\n", "no vertex was found"),
    "head.ply": ("ply\nelement vertex 3\n", "no PLY file"),
    "five.ply": (ply("binary_little_endian", 5_000_000), "5 million vertices"),
    "picture.png": (b"\x89PNG", "not read here"),
    "text.json": ("not JSON", "not JSON"),
    "other.json": ('{"dims": [4, 4, 4]}', "hwffd_lattice"),
    "small.json": ('{"hwffd_lattice": 1, "dims": [3, 4, 4], "points": []}', "dims"),
    "shape.json": ('{"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box"}', "shape"),
    "extra.json": ('{"hwffd_lattice": 1, "dims": [4, 4, 4], "points": [], "colour": 1}', "colour"),
    "far.json": (lattice().replace("[-1, ", "[1e39, ", 1), "binary32"),
    "short.json": ('{"hwffd_lattice": 1, "dims": [4, 4, 4], "points": [[0, 0, 0]]}', "64 points"),
}


@pytest.fixture(scope="module")
def browser():
    with started() as chromium:
        yield chromium


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    return stub_page(tmp_path_factory.mktemp("page"))


@pytest.fixture(scope="module")
def tab(browser, page):
    opened = Open(browser.new_context(), page.as_uri())
    yield opened
    assert not opened.errors


@pytest.mark.parametrize("name", GOOD)
def test_mesh(tab, name):
    """A cube has 8 vertices in every format, welded where the format repeats them."""
    tab.page.select_option("#mesh", "ball")
    tab.quiet()
    assert tab.number("vertices") == 7000
    tab.load(name, GOOD[name])
    tab.until("document.getElementById('vertices').textContent === '8'")
    assert tab.number("mismatches") == 0


@pytest.mark.parametrize("name", BAD)
def test_refused(tab, name):
    """One sentence names the file and says why; the page goes on with what it had."""
    content, why = BAD[name]
    tab.load(name, content)
    notice = tab.notice()
    assert name in notice and why in notice and notice.endswith(".")
    tab.page.click("#notice button")
    tab.page.select_option("#kind", "twist")
    tab.quiet()
    assert tab.number("mismatches") == 0


def test_many_vertices_as_text(tab):
    """Five million lines are refused after two million."""
    tab.load("five.obj", "v 0 0 0\n" * 5_000_000)
    assert "2 million vertices" in tab.notice()
    tab.page.click("#notice button")


def test_dropped(tab):
    """A file that is dropped is taken as one that is chosen."""
    drop = """text => { const data = new DataTransfer(); data.items.add(new File([text], "dropped.obj"));
      document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true })); }"""
    tab.page.select_option("#mesh", "knot")
    tab.quiet()
    tab.page.evaluate(drop, obj())
    tab.until("document.getElementById('vertices').textContent === '8'")


def test_lattice_file(tab):
    """A lattice comes back as it was saved."""
    tab.load("cube.obj", obj())
    tab.load("lattice.json", lattice(), "#lattice-file")
    tab.quiet()
    assert tab.page.input_value("#dims-1") == "5" and tab.text("folds") == ""
    with tab.page.expect_download() as download:
        tab.page.click("#save-lattice")
    saved = json.loads(pathlib.Path(download.value.path()).read_text())
    wanted = json.loads(lattice())
    assert saved["dims"] == wanted["dims"] and saved["points"] == wanted["points"]


@pytest.fixture
def slow(browser, page):
    """The page with a worker that answers late."""
    context = browser.new_context()
    tab = Open(context, page.as_uri(), (WATCH, """
      const Quick = window.Worker;
      window.sent = [];
      window.Worker = class extends Quick {
        postMessage(...all) {
          sent.push(all[0].type);
          setTimeout(() => super.postMessage(...all), 400);
        }
      };"""))
    yield tab
    assert not tab.errors
    context.close()


def test_a_mesh_before_there_are_cores(browser, page):
    """It waits for the first core, without which the worker refuses it."""
    context = browser.new_context()
    tab = Open(context, page.as_uri(), ("""
      const Quick = window.Worker;
      window.sent = [];
      window.Worker = class extends Quick {
        postMessage(...all) {
          sent.push(all[0].type);
          super.postMessage(...all);
        }
        set onmessage(does) { super.onmessage = (event) => setTimeout(() => does(event), 1500); }
      };""",), has_core=False)
    tab.load("cube.obj", obj())
    tab.until("document.getElementById('vertices').textContent === '8'")
    assert tab.page.evaluate("sent.filter((type) => type !== 'watch')")[:3] == ["open", "dims", "mesh"]
    assert tab.page.is_hidden("#notice") and not tab.errors
    context.close()


@pytest.mark.parametrize("field, word", [("#mesh", "knot"), ("#kind", "twist")])
def test_a_lattice_file_behind_what_is_still_to_be_answered(slow, field, word):
    """What the worker says of the mesh or the shape before is of a lattice that is out of date."""
    slow.page.select_option(field, word)
    slow.load("lattice.json", lattice(), "#lattice-file")
    slow.quiet()
    assert slow.page.input_value("#dims-1") == "5" and saved_points(slow) == json.loads(lattice())["points"]


def test_a_point_that_is_moved_behind_a_shape(slow):
    """It is moved where it is seen, and the shape is out of date."""
    rest = saved_points(slow)
    slow.page.select_option("#kind", "twist")
    slow.page.fill("#place-0", "-9")
    slow.page.keyboard.press("Tab")
    slow.quiet()
    moved = saved_points(slow)
    assert moved[0] == pytest.approx([-9, *rest[0][1:]], rel=1e-4) and moved[1:] == rest[1:]


def test_a_point_of_a_lattice_that_goes_is_not_moved(slow):
    slow.page.fill("#dims-0", "4")
    slow.page.keyboard.press("Tab")
    slow.page.fill("#place-0", "-9")
    slow.page.keyboard.press("Tab")
    slow.quiet()
    assert len(saved_points(slow)) == 4 * 6 * 5 and saved_points(slow)[0][0] > -9
    assert "dims" in slow.page.evaluate("sent") and "points" not in slow.page.evaluate("sent")


@pytest.mark.parametrize("text", ["", "1e39"])
def test_what_is_no_place_moves_nothing(tab, text):
    """An empty field, and a number that binary32 does not hold: the field has the place again."""
    rest, place = saved_points(tab), tab.place()
    tab.page.fill("#place-0", text)
    tab.page.keyboard.press("Tab")
    assert tab.place() == place
    assert saved_points(tab) == rest


def test_folds(tab):
    """A lattice that folds is taken, and one sentence says where."""
    tab.load("folded.json", lattice(swapped=True), "#lattice-file")
    tab.quiet()
    assert "folds in" in tab.text("folds") and "(0, 0, 0)" in tab.text("folds")
    tab.page.click("#rest")
    tab.quiet()
    assert tab.text("folds") == ""


def saved_points(tab):
    with tab.page.expect_download() as download:
        tab.page.evaluate("document.getElementById('save-lattice').click()")  # the mouse stays
    return json.loads(pathlib.Path(download.value.path()).read_text())["points"]


@pytest.fixture
def ball(tab):
    tab.page.select_option("#mesh", "ball")
    tab.quiet()
    return tab


def test_escape_ends_a_drag(ball):
    """The pointer then moves no point, and the next drag begins anew."""
    rest = saved_points(ball)
    mouse, (x, y) = ball.page.mouse, max(ball.points_on_screen())
    mouse.move(x, y)
    mouse.down()
    mouse.move(x - 20, y - 10)
    ball.page.keyboard.press("Escape")
    moved = saved_points(ball)
    assert sum(a != b for a, b in zip(rest, moved)) == 1
    mouse.move(x - 60, y - 40)
    mouse.up()
    ball.quiet()
    assert saved_points(ball) == moved


def test_a_second_finger_does_not_move_the_point(browser, page):
    context = browser.new_context(viewport={"width": 400, "height": 900}, has_touch=True, is_mobile=True)
    tab = Open(context, page.as_uri())
    fingers = context.new_cdp_session(tab.page)
    x, y = max(tab.points_on_screen())
    box = tab.page.locator("#view").bounding_box()
    other = (box["x"] + 8, box["y"] + box["height"] - 8)  # where no point is

    def touch(kind, *places):
        fingers.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [
            {"x": place[0], "y": place[1], "id": finger} for finger, place in enumerate(places)]})

    touch("touchStart", (x, y))
    touch("touchMove", (x - 12, y - 9))
    tab.quiet()
    moved = tab.place()
    touch("touchStart", (x - 12, y - 9), other)
    touch("touchMove", (x - 12, y - 9), (other[0] + 40, other[1] - 40))
    tab.quiet()
    assert tab.place() == moved
    touch("touchMove", (x - 24, y - 18), (other[0] + 40, other[1] - 40))
    touch("touchEnd")
    tab.quiet()
    assert tab.place() != moved and not tab.errors
    context.close()


def test_without_webassembly(browser, page):
    tab = Open(browser.new_context(), page.as_uri(), (NO_WEBASSEMBLY,), has_core=False)
    assert "no WebAssembly" in tab.notice() and not tab.errors
    assert tab.page.locator("#organizations tbody tr").count() > 5
    assert tab.page.locator("#pareto circle").count() > 5


def test_without_webgl(browser, page):
    """The core, its figures and the point's fields work without the picture."""
    tab = Open(browser.new_context(), page.as_uri(), (WATCH, NO_WEBGL))
    assert "no WebGL" in tab.text("no-view")
    assert tab.number("mismatches") == 0
    tab.page.fill("#place-0", "-9")
    tab.page.keyboard.press("Tab")
    tab.quiet()
    assert tab.place()[0] == -9 and tab.number("mismatches") == 0
    assert tab.page.locator("#organizations tbody tr").count() > 5
