"""Volumes from images of SimpleITK, and back.

SPDX-License-Identifier: Apache-2.0
"""

from __future__ import annotations

from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np

from hwffd import UsageError
from hwffd.volumes.missing import missing
from hwffd.volumes.volume import Volume

if TYPE_CHECKING:
    import SimpleITK


def simple_itk() -> ModuleType:
    """The module, for what works without it otherwise."""
    try:
        import SimpleITK  # pylint: disable=import-outside-toplevel
    except ImportError as error:
        raise missing("SimpleITK") from error
    return SimpleITK


def from_itk(image: SimpleITK.Image) -> Volume:
    """A copy of an image of SimpleITK that has three dimensions."""
    itk = simple_itk()
    if image.GetDimension() != 3:
        raise UsageError(f"image: {image.GetDimension()} dimensions; give one that has three")
    values = itk.GetArrayFromImage(image)
    if values.dtype.kind not in "iuf":
        raise UsageError(f"image: voxels of {values.dtype}; give integers or floats")
    return Volume(values, image.GetOrigin(), image.GetSpacing(),
                  np.reshape(image.GetDirection(), (3, 3)))


def to_itk(volume: Volume) -> SimpleITK.Image:
    """The same as an image of SimpleITK."""
    itk = simple_itk()
    values = volume.values.astype(volume.values.dtype.newbyteorder("="), copy=False)
    try:
        image = itk.GetImageFromArray(values, isVector=values.ndim == 4)
    except TypeError as error:
        raise UsageError(f"volume: voxels of {values.dtype}, which ITK has not; give integers, float32 or "
                         "float64") from error
    image.SetOrigin(volume.origin.tolist())
    image.SetSpacing(volume.spacing.tolist())
    image.SetDirection(volume.direction.ravel().tolist())
    return image
