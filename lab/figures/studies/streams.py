"""make streams: words that arrangements of the control points move.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import Table


def lattices(rows):
    return list(dict.fromkeys(row["lattice"] for row in rows))


def _lines(rows):
    """{(mesh, arrangement, order): {lattice: row}}"""
    lines = {}
    for row in rows:
        lines.setdefault((row["mesh"], row["arrangement"], row["order"]), {})[row["lattice"]] = row
    return lines


def words(reports, mesh="cat.3ds"):
    """Words a vertex of one mesh, arrangements down, lattices across."""
    rows = reports.rows("streams", mesh=mesh)
    names = lattices(rows)
    return Table(["arrangement", "order of vertices", *names],
                 [[arrangement, order, *(f"{line[name]['words_per_vertex']:.2f}" for name in names)]
                  for (_, arrangement, order), line in _lines(rows).items()])


def pages(reports, mesh="cat.3ds"):
    """Words a vertex of one mesh in lattices larger than a page, by what the core keeps."""
    rows = [row for row in reports.get("streams").get("pages", ()) if row["mesh"] == mesh]
    names = lattices(rows)
    lines = {}
    for row in rows:
        storage = f"{row['pages']} pages, opcodes 5, 7" if row["pages"] else "2 buffers, opcodes 2, 3"
        batch = "all" if row["batch"] == row["vertices"] else f"{row['batch']:,}"
        lines.setdefault((storage, batch), {})[row["lattice"]] = row
    return Table(["the core keeps", "vertices sorted together", *names],
                 [[storage, batch, *(f"{line[name]['words_per_vertex']:.2f}" for name in names)]
                  for (storage, batch), line in lines.items()])


def _verdict(line):
    counted = [row for row in line.values() if row["beats_counted"] is not None]
    if not counted:
        return "not built"
    equal = all(row["beats_counted"] == row["beats_predicted"] for row in counted)
    return "equal" if equal else "NOT EQUAL"


def printed(reports):
    rows = reports.rows("streams")
    names = lattices(rows)
    table = Table(["mesh", "vertices", "arrangement", "order", "RTL", *names],
                  [[mesh, str(next(iter(line.values()))["vertices"]), arrangement, order,
                    _verdict(line), *(f"{line[name]['words_per_vertex']:.2f}" for name in names)]
                   for (mesh, arrangement, order), line in _lines(rows).items()])
    large = "".join(f"\n\n{mesh}, lattices by pages of 16 points an axis\n\n"
                    + pages(reports, mesh).text()
                    for mesh in dict.fromkeys(
                        row["mesh"] for row in reports.get("streams").get("pages", ())))
    return "words moved to the core, a vertex\n\n" + table.text() + large


def missing(reports):
    rows = reports.rows("streams")
    meshes = {row["mesh"] for row in rows}
    return "" if len(meshes) >= 3 and len(lattices(rows)) >= 5 else "meshes or lattices"


TABLES = {"words": words, "pages": pages}
