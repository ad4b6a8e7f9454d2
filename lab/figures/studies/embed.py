"""make -C lab embed: meshes, and points by construction, in lattices of every kind.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import listing


def lattices(reports, *meshes):
    """All of them, or those of some meshes."""
    return listing([row for row in reports.rows("embed") if not meshes or row["mesh"] in meshes],
                   "mesh | mesh", "lattice | lattice", "points | points", "inside | inside",
                   "not converged | not_converged", "max residual | max_residual_relative:.1e",
                   "Newton steps | newton_mean_iterations:.2f", "folds | folds")


def missing(reports):
    return "" if len({row["mesh"] for row in reports.rows("embed")}) >= 4 else "meshes"


_LARGEST = 61**3  # cells of the largest lattice

TABLES = {"lattices": lattices}
FIGURES = {
    "fold_seconds": lambda reports: reports.get("embed")["fold_check_us_per_cell"] * _LARGEST / 1e6,
}
