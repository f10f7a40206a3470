# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The numbers of a medium as arrays."""

from __future__ import annotations

import pathlib
from typing import TYPE_CHECKING, Any

from ._targets import find_renderer, write_whole
from ._vtk import load, vtkImageData
from .vtkGodRaysFilters import vtkGodRaysEXRWriter
from .vtkGodRaysRendering import vtkGodRaysPass

if TYPE_CHECKING:
    import os
    from collections.abc import Sequence

    import numpy

    from ._typing import Target


def measure(
    target: Target,
    irradiance: Sequence[float] | float | None = None,
    file: str | os.PathLike[str] | None = None,
) -> dict[str, numpy.ndarray]:
    """What the medium of a scene with god rays is in numbers, for each pixel of its last picture.

    The keys of the dict are the arrays of vtkGodRaysPass.GetMediumImage(): "Radiance" [1/sr, or W/(m2 sr)],
    "Transmittance", "OpticalDepth" [1], of shape (height, width, 3); "Depth" [scene units], "Distance_m" [m],
    "Contrast" [1], "MeteorologicalRange_m" [m], of shape (height, width). Rows go from the bottom up. Under
    the name with "_Error" is a bound of the error, of shape (); its meaning is there. With volumes as the
    medium "DataExtinction_per_m_Error" and "DataExtinction_per_m_MaxError" [1/m] tell what resampling them
    has changed, of shape ().

    target: as of enable(). What is not drawn yet is drawn.
    irradiance: of a light of colour and intensity 1 [W/m2], one number or three; None for relative radiance.
    file: a .vti or .exr to write, with units and errors.

    ValueError: the picture has no medium, or the file is of another kind. OSError: it cannot be written.
    """
    vtk_to_numpy = load("util.numpy_support").vtk_to_numpy

    renderer = find_renderer(target)
    rays = vtkGodRaysPass.Find(renderer)
    if rays is None:
        raise ValueError("the renderer has no god rays; call enable() with a medium, such as preset='fog'")
    suffix = "" if file is None else str(file)[-4:].lower()
    if file is not None and suffix not in (".vti", ".exr"):
        raise ValueError(f"file={str(file)!r} should end in .vti or .exr")
    if suffix == ".exr" and not vtkGodRaysEXRWriter.IsAvailable():
        raise ValueError("this godrays was built without OpenEXR; write a .vti")
    asked: tuple[Any, ...] = ()
    if irradiance is not None:
        each = [irradiance] * 3 if isinstance(irradiance, (int, float)) else irradiance
        values = [float(value) for value in each]
        if len(values) != 3 or not all(0 <= value <= 1e30 for value in values):
            raise ValueError(f"irradiance={irradiance} should be one number or three, in [0, 1e30]")
        asked = (values,)
    image = vtkImageData()
    if not rays.GetMediumImage(image, *asked):
        window = renderer.GetRenderWindow()
        if window is None:
            raise ValueError("the renderer has no window to draw in; call its AddRenderer() first")
        window.Render()
        if not rays.GetModel().IsA("vtkGodRaysMediumModel"):
            raise ValueError(
                "the picture has no light in a medium, but that of a look; enable() a preset such as 'fog'")
        if not rays.GetMediumImage(image, *asked):
            raise ValueError("the picture has no light in a medium: " + rays.GetPlan().strip())
    if file is not None:
        writer = vtkGodRaysEXRWriter() if suffix == ".exr" else load("vtkIOXML").vtkXMLImageDataWriter()
        if suffix == ".vti":
            writer.SetDataModeToBinary()  # some readers take no appended data
        writer.AddObserver("ErrorEvent", lambda *_: None)  # told as an exception
        writer.SetInputData(image)

        def write(path: pathlib.Path) -> None:
            writer.SetFileName(str(path))
            writer.Write()
            if writer.GetErrorCode() or not path.is_file():
                raise OSError(f"{file} cannot be written; is there such a folder, and is there room?")

        write_whole(file, write)
    found = {}
    width, height, _ = image.GetDimensions()
    for data in (image.GetPointData(), image.GetFieldData()):
        for i in range(data.GetNumberOfArrays()):
            array = data.GetArray(i)
            shape = (height, width) if data is image.GetPointData() else ()
            if array.GetNumberOfComponents() > 1:
                shape += (array.GetNumberOfComponents(),)
            found[array.GetName()] = vtk_to_numpy(array).reshape(shape).copy()
    return found
