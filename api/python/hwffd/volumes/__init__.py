"""Image volumes, resampled through a deformed lattice (docs/volumes.md). This package wants SciPy, and
SimpleITK for files and its images.

    volume = volumes.read("head.nrrd")
    lattice = volumes.lattice_over(volume, (6, 6, 6))
    lattice.deform("twist:30")
    volumes.write("turned.nrrd", volumes.warp(volume, lattice))

SPDX-License-Identifier: Apache-2.0
"""

from hwffd.volumes.files import read, write, write_all
from hwffd.volumes.itk import from_itk, to_itk
from hwffd.volumes.splines import coefficients
from hwffd.volumes.volume import Volume
from hwffd.volumes.warping import Warped, displacement_field, lattice_over, resample, warp

__all__ = ["Volume", "Warped", "coefficients", "displacement_field", "from_itk", "lattice_over",
           "read", "resample", "to_itk", "warp", "write", "write_all"]
