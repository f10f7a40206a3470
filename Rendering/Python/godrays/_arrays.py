# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images as arrays of NumPy: [row, column] or [row, column, channel], the top row first."""

from __future__ import annotations

import inspect
import textwrap
from typing import TYPE_CHECKING, Any

from ._errors import Error, raising, to_numbers
from ._properties import describe, set_value, snake
from ._vtk import load, name_type, vtkAlgorithm, vtkImageData
from .vtkGodRaysFilters import vtkGodRaysScatteringFilter, vtkGodRaysToneMappingFilter

if TYPE_CHECKING:
    from collections.abc import Sequence


def to_image(array: Any) -> vtkImageData:
    """A vtkImageData with a copy of an array's numbers; VTK has the bottom row first.

    array: the picture [row, column] or [row, column, channel], the top row first.

    ValueError: it is no such array.
    """
    import numpy

    numpy_to_vtk = load("util.numpy_support").numpy_to_vtk

    array = numpy.asarray(array)
    if array.ndim not in (2, 3) or 0 in array.shape or array.dtype.kind not in "fiub":
        raise ValueError(
            f"a picture is an array of numbers [row, column] or [row, column, channel], not of {array.dtype} "
            f"and shape {array.shape}"
        )
    if array.dtype == bool:
        array = array.astype(numpy.uint8)
    elif array.dtype == numpy.float16:  # which VTK has not
        array = array.astype(numpy.float32)
    flipped = numpy.ascontiguousarray(array[::-1]).reshape(array.shape[0] * array.shape[1], -1)
    image = vtkImageData()
    image.SetDimensions(array.shape[1], array.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(flipped, deep=True))
    return image


def to_array(image: vtkImageData) -> Any:
    """An array with a copy of an image's numbers, of the type that they have; [row, column] if it is grey.

    image: a vtkImageData; its active scalars count. Of the array the top row is the first.

    Error: the image is empty. TypeError: it is no image.
    """
    import numpy
    vtk_to_numpy = load("util.numpy_support").vtk_to_numpy

    if not isinstance(image, vtkImageData):
        raise TypeError(f"to_array() needs a vtkImageData, not {name_type(image)}")
    scalars = image.GetPointData().GetScalars()
    if scalars is None or scalars.GetNumberOfTuples() == 0:
        raise Error("the image is empty")
    width, height, _ = image.GetDimensions()
    shape = (height, width, -1) if scalars.GetNumberOfComponents() > 1 else (height, width)
    return numpy.array(vtk_to_numpy(scalars).reshape(shape)[::-1])


def apply(filter: Any, array: Any) -> Any:
    """An array, through a filter of images of VTK or of this project, such as vtkGodRaysScatteringFilter.

    filter: a vtkAlgorithm that takes and makes a vtkImageData.
    array: the picture [row, column] or [row, column, channel], the top row first.
    Returns the filter's output, likewise. Error: what the filter tells, if it is one of this project's.
    """
    if not isinstance(filter, vtkAlgorithm):
        raise TypeError(f"apply() needs a filter, a vtkAlgorithm, not {name_type(filter)}")
    filter.SetInputDataObject(0, to_image(array))
    with raising():
        filter.Update()
    return to_array(filter.GetOutputDataObject(0))


def scatter(
    array: Any,
    light: Sequence[float],
    *,
    density: float | None = None,
    decay: float | None = None,
    weight: float | None = None,
    exposure: float | None = None,
    number_of_samples: int | None = None,
    error_tolerance: float | None = None,
    method: str | int | None = None,
) -> Any:
    """The shafts of a picture of light and what blocks it: the radial sum of vtkGodRaysScatteringFilter.

    No OpenGL is needed. Add the result to a picture of linear light, and encode that.

    array: the occlusion layer: linear light where the light and its glow are seen, 0 where it is blocked;
        [row, column] or [row, column, channel] with up to 4 channels, the top row first.
    light: where the light is, from (0, 0) at the picture's lower left to (1, 1); it may be beyond. Three
        numbers are homogeneous clip coordinates (x, y, w).
    Returns float32 of the same shape.

    Each further parameter is left at its default if it is None:
    """
    given = {
        "Density": density, "Decay": decay, "Weight": weight, "Exposure": exposure,
        "NumberOfSamples": number_of_samples, "ErrorTolerance": error_tolerance, "Method": method}
    import numpy

    place = to_numbers("light", light, (2, 3), "a place in the picture, such as (0.7, 0.8), or (x, y, w)")
    array = numpy.asarray(array)
    if array.dtype.kind in "iu" and array.dtype != numpy.uint8:
        array = array.astype(float)  # whole numbers of other sizes are not summed
    filter = vtkGodRaysScatteringFilter()
    _set(filter, given)
    with raising():
        (filter.SetLightPosition if len(place) == 2 else filter.SetLightClip)(*place)
    return apply(filter, array)


def tone_map(
    array: Any,
    *,
    automatic_exposure: bool | None = None,
    key: float | None = None,
    exposure: float | None = None,
    curve: str | int | None = None,
    white_point: float | None = None,
) -> Any:
    """A picture of linear light as it is to be shown, by vtkGodRaysToneMappingFilter; no OpenGL is needed.

    array: linear light of any unit and type, [row, column] or [row, column, channel].
    automatic_exposure: off where an exposure is given, else on.
    Returns uint8, encoded by sRGB's transfer, of one or three channels.

    Each further parameter is left at its default if it is None:
    """
    if automatic_exposure is None and exposure is not None:
        automatic_exposure = False
    filter = vtkGodRaysToneMappingFilter()
    _set(filter, {
        "AutomaticExposure": automatic_exposure, "Key": key, "Exposure": exposure, "Curve": curve,
        "WhitePoint": white_point})
    return apply(filter, array)


def _set(filter: Any, settings: dict[str, Any]) -> None:
    for name, value in settings.items():
        if value is not None:
            set_value(filter, name, value)


def document(function: Any, *classes: type) -> None:
    """Add to a function's documentation what C++ says of the properties that its keywords set."""
    properties = {snake(name[3:]): (cls, name[3:]) for cls in reversed(classes)
        for name in dir(cls) if name.startswith("Set")}
    told = inspect.cleandoc(function.__doc__)  # Python 3.13 leaves its indentation out, older ones do not
    for keyword in function.__kwdefaults__:
        if keyword in properties and f"\n{keyword}:" not in told:
            text = f"{keyword}: {describe(*properties[keyword])}"
            told += "\n" + textwrap.fill(text, 100, subsequent_indent=" " * 4)
    function.__doc__ = told


document(scatter, vtkGodRaysScatteringFilter)
document(tone_map, vtkGodRaysToneMappingFilter)
