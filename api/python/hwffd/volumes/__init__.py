"""Image volumes, resampled through a deformed lattice (docs/volumes.md), and aligned (docs/register.md). This package wants SciPy, and
SimpleITK for files and its images.

    volume = volumes.read("head.nrrd")
    lattice = volumes.lattice_over(volume, (6, 6, 6))
    lattice.deform("twist:30")
    volumes.write("turned.nrrd", volumes.warp(volume, lattice))

SPDX-License-Identifier: Apache-2.0
"""

from hwffd.volumes.files import read, write, write_all
from hwffd.volumes.itk import from_itk, to_itk
from hwffd.volumes.registration import Registration, register
from hwffd.volumes.splines import coefficients
from hwffd.volumes.transforms import read_affine, to_itk_transform, write_transform
from hwffd.volumes.volume import Volume
from hwffd.volumes.warping import (Warped, determinants, displacement_field, lattice_over, resample,
                                   warp)

__all__ = ["Registration", "Volume", "Warped", "coefficients", "determinants", "displacement_field",
           "from_itk", "lattice_over", "read", "read_affine", "register", "resample", "to_itk",
           "to_itk_transform", "warp", "write", "write_all", "write_transform"]
