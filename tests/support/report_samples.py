"""Reports made up for the tests.

SPDX-License-Identifier: Apache-2.0
"""


def organization(name, interval, **fields):
    """A row of `make organizations`, overlapped unless its name says otherwise."""
    org, word, schedule = name.split("-")[:3]
    n = int(org.removeprefix("tree")) if org.startswith("tree") else 1
    paper = schedule == "paper"
    return {
        "name": name, "org": "tree" if org.startswith("tree") else org, "n": n, "format": word,
        "schedule": schedule, "evaluator": "pipelined", "fmac": False, "formula": 96,
        "clocks_paper": 96, "equal": True, "final_accumulation": 1, "formula_overlapped": interval,
        "interval_overlapped": interval, "equal_overlapped": True, "mismatches": 0, "checked": 10,
        "max_error": 8.65e-5, "seam_values": 6, "seam_differences": 0,
        "operators": {"mul": 4 if paper else 8, "add": 3 if paper else 6, "fma": 0},
        "operators_drawn": {"mul": 64, "add": 48, "fma": 0}, "evaluators": 3,
        "simulation_vertices_per_s": 1234.5, "simulation_share": 0.01, **fields}


def mapped(name, lut, mhz=100.0, target="ecp5", **fields):
    """A row of `make synth`."""
    return {"name": name, "org": name.split("-")[0], "n": 1, "format": name.split("-")[1],
            "target": target, "top": "ffd_org_select", "lut": lut, "lutram": 4, "ff": 7, "dsp": 8,
            "bram": 0, "cells": None, "area_um2": None, "depth": 5, "fmax_mhz": mhz,
            "power_mw": None, "critical_path": None, "kinds": {"LUT4": lut}, "flat": False, **fields}


ORGANIZATIONS = {
    "reference_vertices_per_s": 1e6, "compiler_options": "-O2", "rows": [
        organization("basic-fx18-paper", None), organization("basic-fx18-overlapped", 64),
        organization("basic-fp32-overlapped", 64, max_error=2.31e-7),
        organization("tree8-fx18-paper", None), organization("tree8-fx18-overlapped", 8),
        organization("parallel-fx18-overlapped", 1, n=64),
        organization("parallel-fx18-overlapped", 1, n=64, org="tree"),
        organization("affine-fx18-overlapped", 1, formula=None, clocks_paper=None, equal=None,
                     final_accumulation=None)]}
SYNTH = {"yosys": "Yosys", "sta": None, "wanted": 6, "failed": [], "rows": [
    mapped("basic-fx18-overlapped", 500), mapped("tree8-fx18-overlapped", 900),
    mapped("parallel-fx18-overlapped", 5000), mapped("affine-fx18-overlapped", 9000, None),
    mapped("basic-fp32-overlapped", 950, 90.0),
    mapped("basic-fx18-overlapped", None, None, "generic", cells=44000, dsp=None),
]}
PNR = {"multiplier_mhz": {"ecp5": 142.6}, "rows": [
    {"name": "tree8-fx18-overlapped", "top": "ffd_org_select", "target": "ecp5", "device": "85F",
     "fmax_mhz": 120.0, "fmax_min": 119.0, "fmax_max": 121.0, "fmax_share": 0.84, "aim_share": 0.8,
     "aim_mhz": None, "reached": True, "critical_path": "a to b"}]}
WORDS = {"rows": [
    {"form": "product", "format": word, "word_length": bits, "max_error": error,
     "rms_error": error / 10, "bound": 8 * error, "vertices": 1000}
    for word, bits, error in (
        ("fx17", 17, 2.5e-4), ("fx18", 18, 1.2e-4), ("fx20", 20, 3e-5), ("fx27", 27, 3e-7),
        ("fx28", 28, 1.2e-7), ("fp32-sequential", 32, 4.6e-7), ("fp32-tree", 32, 2.1e-7))]}
STREAMS = {"rows": [
    {"mesh": mesh, "vertices": 10, "lattice": lattice, "arrangement": arrangement, "order": order,
     "words_per_vertex": 4.0468 * points, "beats_predicted": 80, "beats_counted": counted,
     "mismatches": 0}
    for mesh in ("cat.3ds", "horse.3ds")
    for lattice, points in (("4x4x4", 1), ("16x16x16", 2))
    for arrangement, order, counted in (("changed points", "file", None),
                                        ("changed points", "cell", None),
                                        ("resident", "file", 80))]}
COMPARE = {"vertices": 1000, "processor": "a processor", "vector_units": "AVX2", "rows": [
    {"what": what, "kind": kind, "device": device, "vertices_per_s": rate * (2 if ordered else 1),
     "per_multiplier": None, "error": 1e-7, "sorted": ordered, "source": "a sample",
     "latency_ns": 20.0, "bytes_per_vertex": 28.0, "energy_nj_per_vertex": None}
    for what, kind, device, rate in (
        ("device reference", "own", "a processor", 6e7),
        ("interpolation 2.2, eval_cubic", "peer", "a processor", 1e7),
        ("hwffd_stream basic-fx18-overlapped", "core", "a chip", 2e6))
    for ordered in (False, True)]}
TIMELINES = {"rows": [
    {"name": "tree8-fx18-paper", "org": "tree", "n": 8, "schedule": "paper", "clocks": 20,
     "first_done": 18, "lanes": [
         {"name": "3 polynomial evaluators", "spans": [[0, 4, 0], [2, 6, 1]]},
         {"name": "3 accumulators", "spans": [[9, 18, 0], [12, 20, 1]]}]}]}
STRUCTURE = {"target": "ecp5", "designs": [
    {"top": "hwffd_top", "row": "basic-fx18-overlapped", "shown": True, "modules": [
        {"depth": 0, "module": "hwffd_top", "instances": 1, "folder": "top", "lut": 192, "ff": 5,
         "dsp": 1, "bram": 0, "own_lut": 2},
        {"depth": 1, "module": "ffd_mid_a", "instances": 2, "folder": "number", "lut": 100, "ff": 0,
         "dsp": 1, "bram": 0, "own_lut": 100}]}]}
