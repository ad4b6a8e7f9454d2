"""make streams: words that arrangements of the control points move.

SPDX-License-Identifier: Apache-2.0
"""

from figures.table import Table


def lattices(rows):
    return list(dict.fromkeys(row["lattice"] for row in rows))


def _lines(rows):
    """{(mesh, arrangement, order): {lattice: row}}"""
    found = {}
    for row in rows:
        found.setdefault((row["mesh"], row["arrangement"], row["order"]), {})[row["lattice"]] = row
    return found


def words(reports, mesh="cat.3ds"):
    """Words a vertex of one mesh, arrangements down, lattices across."""
    rows = reports.rows("streams", mesh=mesh)
    names = lattices(rows)
    return Table(["arrangement", "order of vertices", *names],
                 [[arrangement, order, *(f"{line[name]['words_per_vertex']:.2f}" for name in names)]
                  for (_, arrangement, order), line in _lines(rows).items()])


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
    return "words moved to the core, a vertex\n\n" + table.text()


def missing(reports):
    rows = reports.rows("streams")
    meshes = {row["mesh"] for row in rows}
    return "" if len(meshes) >= 3 and len(lattices(rows)) >= 5 else "meshes or lattices"


TABLES = {"words": words}
