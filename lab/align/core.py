"""What a core would take for one evaluation, but for the images: an estimate from routed clocks.

Forward and transpose of a grid go through `walk` and through the scatter by rows, in clocks that the tests of the core
assert (docs/organizations/walk.md, docs/interface.md section 7). A row of n voxels that touches c cells takes

    forward    max(n, 4 * (c + 3)) clocks
    transpose  max(n, 3 * (c + 3)) clocks

Control points are loaded four in three beats, and the sum of one is collected in six clocks. Nothing is counted for the
images: values, gradients of the moving one and the metric are left to who is at the other end of the streams.

SPDX-License-Identifier: Apache-2.0
"""

import csv

from tools.project_root import ROOT

# Of synth/variants.csv: what evaluates, what adds gradients up, and both in one.
HALVES = (("positions", "hwffd_stream", "walk-fx17-overlapped-powers+grids"),
          ("transpose", "hwffd_scatter", "affine-fx17-overlapped-powers+rows"))
TARGET = "ecp5"


def clocks(reports):
    """For each half its clock in MHz: (what, row, MHz, whether it was routed). One that has not been routed has the
    clock that `make pnr` asks of it."""
    with open(ROOT / "synth" / "clocks.csv", encoding="utf-8") as file:
        aims = {(row["top"], row["name"], row["target"]): row["aim_mhz"] for row in csv.DictReader(file)}
    halves = []
    for what, top, name in HALVES:
        routed = reports.rows("pnr", top=top, name=name, target=TARGET) if reports.has("pnr") else []
        mhz = routed[0]["fmax_mhz"] if routed else float(aims[top, name, TARGET])
        halves.append({"what": what, "top": top, "name": name, "mhz": mhz, "routed": bool(routed)})
    return halves


def clocks_of(counts, cells):
    """(of positions, of the transpose) of one evaluation: a grid of counts voxels in a lattice of cells."""
    rows, points = counts[1] * counts[2], (cells[0] + 3) * (cells[1] + 3) * (cells[2] + 3)
    return (rows * max(counts[0], 4 * (cells[0] + 3)) + 3 * points / 4,
            rows * max(counts[0], 3 * (cells[0] + 3)) + 6 * points)


def estimate(reports, counts, cells):
    """Rows of the report: each half, its clock, clocks and seconds of an evaluation; and the rate of both together."""
    halves = clocks(reports)
    for half, count in zip(halves, clocks_of(counts, cells)):
        half.update(clocks=count, seconds=count / (half["mhz"] * 1e6))
    voxels = counts[0] * counts[1] * counts[2]
    return {"counts": list(counts), "cells": list(cells), "halves": halves,
            "voxels_per_s": voxels / sum(half["seconds"] for half in halves)}
