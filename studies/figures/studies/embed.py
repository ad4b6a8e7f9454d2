"""make embed: meshes, and points by construction, in lattices of every kind.

SPDX-License-Identifier: Apache-2.0
"""

from figures.expressions import shown
from figures.table import Table


def _table(reports, rows):
    return Table(["mesh", "lattice", "points", "inside", "not converged", "max residual",
                  "Newton steps", "folds"],
                 [[row["mesh"], row["lattice"], shown(row["points"]), shown(row["inside"]),
                   shown(row["not_converged"]), shown(row["max_residual_relative"], ".1e"),
                   shown(row["newton_mean_iterations"], ".2f"), row["folds"]] for row in rows])


def lattices(reports, *meshes):
    """All of them, or those of some meshes."""
    return _table(reports, [row for row in reports.rows("embed")
                            if not meshes or row["mesh"] in meshes])


def printed(reports):
    return lattices(reports).text()


def missing(reports):
    return "" if len({row["mesh"] for row in reports.rows("embed")}) >= 4 else "meshes"


TABLES = {"lattices": lattices}
