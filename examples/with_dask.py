"""Deforms points in chunks on two worker processes of Dask, without all of them in memory at once."""
import dask.array as da
import hwffd
from dask.distributed import Client, LocalCluster


def main():
    points = da.random.default_rng(1).uniform(-1, 1, (1_000_000, 3), chunks=(100_000, 3))
    lattice = hwffd.Lattice.around("box", [[-1, -1, -1], [1, 1, 1]], (6, 6, 6))
    lattice.deform("twist:90")
    moved = hwffd.deform(lattice, points)
    way = da.linalg.norm(moved - points, axis=1)
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster):
        mean, longest = da.compute(way.mean(), way.max())
    assert 0 < mean < longest < 3
    print(f"{len(points)} points in {points.npartitions} chunks moved {mean:.4f} on average, {longest:.4f} at most")


if __name__ == "__main__":  # workers import this file
    main()
