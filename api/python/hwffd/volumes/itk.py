"""Volumes from images of SimpleITK, and back.

SPDX-License-Identifier: Apache-2.0
"""

import numpy as np

from hwffd import Error, UsageError
from hwffd.volumes.volume import Volume


def simple_itk():
    """The module, for what works without it otherwise."""
    try:
        import SimpleITK  # pylint: disable=import-outside-toplevel
    except ImportError as error:
        raise Error("volumes: SimpleITK is missing: pip install SimpleITK") from error
    return SimpleITK


def from_itk(image) -> Volume:
    """A copy of an image of SimpleITK that has three dimensions."""
    itk = simple_itk()
    if image.GetDimension() != 3:
        raise UsageError(f"image: {image.GetDimension()} dimensions; give one that has three")
    values = itk.GetArrayFromImage(image)
    if values.dtype.kind not in "iuf":
        raise UsageError(f"image: voxels of {values.dtype}; give integers or floats")
    return Volume(values, image.GetOrigin(), image.GetSpacing(),
                  np.reshape(image.GetDirection(), (3, 3)))


def to_itk(volume: Volume):
    """The same as an image of SimpleITK."""
    itk = simple_itk()
    image = itk.GetImageFromArray(volume.values, isVector=volume.values.ndim == 4)
    image.SetOrigin(volume.origin.tolist())
    image.SetSpacing(volume.spacing.tolist())
    image.SetDirection(volume.direction.ravel().tolist())
    return image
