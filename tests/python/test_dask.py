"""Arrays of Dask are deformed as those of NumPy are, bit for bit, on a cluster of two processes: with bounded
memory, with each lattice sent once, and also where a worker is killed.

SPDX-License-Identifier: Apache-2.0
"""

import hashlib
import os
import pathlib
import pickle
import re
import signal
import sys

import cloudpickle
import dask
import dask.array as da
import hwffd
import numpy as np
import pytest
from dask.distributed import Client, LocalCluster, as_completed

DEVICES = ("model", "reference")
CHUNK = 25_000            # points
MANY = 80 * CHUNK         # points of the array that is larger than what a worker may take
LIMIT = 16 << 20          # bytes that a worker may take while it deforms that
cloudpickle.register_pickle_by_value(sys.modules[__name__])  # workers cannot import this file


@pytest.fixture(scope="module")
def client():
    with (LocalCluster(n_workers=2, processes=True, threads_per_worker=1, dashboard_address=None) as cluster,
          Client(cluster) as connected):
        yield connected


def bent(device, shape="box", **more):
    lattice = hwffd.Lattice.around(shape, [[-1.0, -1, -1], [1, 1, 1]], **more)
    lattice.deform("bend:40")
    lattice.set_outside("clamp")
    lattice.set_device(device)
    return lattice


def uniform(shape, seed=1):
    return np.random.default_rng(seed).uniform(-1.1, 1.1, shape)


def block(block_info=None):
    """The points of a chunk, made where it is wanted."""
    return uniform((CHUNK, 3), block_info[None]["chunk-location"][0])


def chunked_points(count):
    """Points that nobody has as a whole."""
    return da.map_blocks(block, chunks=((CHUNK,) * (count // CHUNK), (3,)), dtype=float, meta=np.empty((0, 0)))


def digest(chunk):
    return np.frombuffer(hashlib.sha256(chunk.tobytes()).digest(), np.uint8).reshape(1, -1)


def memory(field):
    """Bytes of this process: VmRSS now, VmHWM at most."""
    text = pathlib.Path("/proc/self/status").read_text(encoding="ascii")
    return 1024 * int(re.search(rf"^{field}:\s+(\d+) kB$", text, re.MULTILINE)[1])


def forget_peak():
    pathlib.Path("/proc/self/clear_refs").write_text("5", encoding="ascii")
    return memory("VmRSS")


@pytest.mark.parametrize("device, most", (
    ("model", 1), ("reference", 3), pytest.param("model", 3, marks=pytest.mark.whole)))
def test_two_processes_give_the_bits_of_one(client, device, most):
    compared = 0
    for lattice in (bent(device), bent(device, "sphere"), bent(device, family="clamped"))[:most]:
        for shape, chunks in ((2000, 3), (300, 3)), ((40, 30, 3), (7, 11, 2)), ((3,), (3,)), ((0, 3), (1, 3)):
            for dtype in np.float32, np.float64, np.int16:
                points = uniform(shape).astype(dtype)
                moved = hwffd.deform(lattice, da.from_array(points, chunks=chunks))
                assert isinstance(moved, da.Array) and moved.chunks[-1] == (3,)
                expected = hwffd.deform(lattice, points)
                computed = client.compute(moved).result()
                assert moved.dtype == computed.dtype == expected.dtype and computed.shape == expected.shape
                assert computed.tobytes() == expected.tobytes()
                compared += computed.size
    assert compared == most * 3 * 3 * (2000 + 1200 + 1)


def test_other_schedulers_and_unknown_chunks():
    lattice = bent("model")
    points = uniform((5000, 3))
    chunked = da.from_array(points, chunks=(700, 3))
    expected = hwffd.deform(lattice, points)
    before = hwffd.threads()
    for scheduler in "threads", "synchronous":
        computed = hwffd.deform(lattice, chunked).compute(scheduler=scheduler)
        np.testing.assert_array_equal(computed, expected)
    right = hwffd.deform(lattice, chunked[chunked[:, 0] > 0]).compute(scheduler="threads")
    np.testing.assert_array_equal(right, expected[points[:, 0] > 0])
    assert len(right) > 1000 and hwffd.threads() == before


def test_the_lattice_is_that_of_the_call():
    lattice = bent("reference")
    points = uniform((100, 3))
    expected = hwffd.deform(lattice, points)
    moved = hwffd.deform(lattice, da.from_array(points, chunks=(30, 3)))
    lattice.deform("twist:90")
    np.testing.assert_array_equal(moved.compute(scheduler="synchronous"), expected)
    again = hwffd.deform(lattice, da.from_array(points, chunks=(30, 3)))
    assert again.name != moved.name
    assert abs(again.compute(scheduler="synchronous") - expected).max() > 0.1


@pytest.mark.parametrize("points, more, message", (
    (da.zeros((5, 4)), {}, r"points: shape \(5, 4\); give \(\.\.\., 3\)"),
    (da.zeros(()), {}, r"points: shape \(\); give"),
    (da.zeros((5, 3), dtype=complex), {}, "points: numbers of complex128; give float32"),
    (da.zeros((5, 3)), {"out": np.zeros((5, 3))}, "out: points are of Dask; store the result with dask"),
    (dask.delayed([1, 2, 3]), {}, "points: of Dask, but no array; give")))
def test_what_is_no_array_of_points_is_refused_at_once(points, more, message):
    with pytest.raises(hwffd.UsageError, match=message):
        hwffd.deform(bent("reference"), points, **more)


def watch():
    """Has a worker keep the lattices that it deforms by."""
    chunks = sys.modules["hwffd._chunks"]
    chunks.seen, plain = [], chunks._deform_chunk  # pylint: disable=protected-access

    def watched(chunk, lattice):
        chunks.seen.append(lattice)
        return plain(chunk, lattice)

    chunks._deform_chunk, chunks.plain = watched, plain  # pylint: disable=protected-access


def watched_calls():
    """How many chunks and how many lattices there were."""
    chunks = sys.modules["hwffd._chunks"]
    chunks._deform_chunk = chunks.plain  # pylint: disable=protected-access
    return len(chunks.seen), len({id(lattice) for lattice in chunks.seen})


def test_a_worker_gets_a_lattice_once_and_takes_its_threads(client):
    lattice = bent("reference", dims=(12, 12, 12))
    client.run(hwffd.set_threads, 5)
    client.run(lambda: __import__("hwffd._chunks"))
    client.run(watch)
    moved = hwffd.deform(lattice, chunked_points(20 * CHUNK))
    graph = sum(len(cloudpickle.dumps(task)) for task in dict(moved.__dask_graph__()).values())
    moved.map_blocks(digest, chunks=(1, 32), dtype=np.uint8).compute()
    calls = client.run(watched_calls).values()
    assert sum(chunks for chunks, _ in calls) == 20
    assert {lattices for _, lattices in calls} == {1} and len(calls) == 2
    assert set(client.run(hwffd.threads).values()) == {1}
    assert graph < 2 * len(pickle.dumps(lattice))


@pytest.mark.parametrize("device", ("reference", pytest.param("model", marks=pytest.mark.whole)))
def test_memory_of_a_worker_is_bounded(client, device):
    """Both take their points from Dask in the same way; the model takes ten times as long."""
    lattice = bent(device)
    digests = hwffd.deform(lattice, chunked_points(MANY)).map_blocks(digest, chunks=(1, 32), dtype=np.uint8)
    client.run(hwffd.deform, lattice, block({None: {"chunk-location": (0, 0)}}))
    before = client.run(forget_peak)
    computed = client.compute(digests).result()
    taken = {worker: most - before[worker] for worker, most in client.run(memory, "VmHWM").items()}
    assert len(taken) == 2 and max(taken.values()) < LIMIT, taken
    assert MANY * 24 > 2.5 * LIMIT
    for number in range(MANY // CHUNK):
        moved = hwffd.deform(lattice, block({None: {"chunk-location": (number, 0)}}))
        assert digest(moved).tobytes() == computed[number].tobytes()


def test_a_killed_worker_loses_nothing(client):
    lattice = bent("model", "sphere")
    points = uniform((200_000, 3))
    chunks = [part[0] for part in hwffd.deform(lattice, da.from_array(
        points, chunks=(5_000, 3))).to_delayed()]
    workers = client.run(os.getpid)
    futures = client.compute(chunks)
    for finished, _ in enumerate(as_completed(futures), 1):
        held = {worker for future, where in client.who_has(futures).items() for worker in where}
        if finished >= 10 and held == set(workers):
            break
    assert finished < 30
    victim = next(iter(workers))
    lost = sum(where == (victim,) for where in client.who_has(futures).values())
    os.kill(workers[victim], signal.SIGKILL)
    moved = np.concatenate(client.gather(futures))
    assert lost > 0
    assert moved.tobytes() == hwffd.deform(lattice, points).tobytes()
    client.wait_for_workers(2)
    assert workers[victim] not in client.run(os.getpid).values()
