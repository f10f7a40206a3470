# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data to a picture, without a window: render()."""

from __future__ import annotations

import ctypes
import importlib
import math
import os
import pathlib
import re
import warnings
from typing import TYPE_CHECKING, Any

from vtkmodules.vtkCommonDataModel import vtkBoundingBox, vtkCompositeDataSet, vtkDataObject, vtkDataSet
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCamera,
    vtkDataSetMapper,
    vtkProp,
    vtkRenderer,
    vtkRenderWindow,
)

from ._arrays import to_image
from ._errors import Error, GodRaysWarning, hushed, tell_names, to_numbers

if TYPE_CHECKING:
    from collections.abc import Sequence

_LARGEST = 16384  # [pixels] of a side; X ends the program of larger windows
_XML = {"vti": "ImageData", "vtp": "PolyData", "vtr": "RectilinearGrid", "vts": "StructuredGrid",
    "vtu": "UnstructuredGrid", "vtm": "MultiBlockData"}
_READERS = {
    "ply": ("vtkIOPLY", "vtkPLYReader"),
    "stl": ("vtkIOGeometry", "vtkSTLReader"),
    "obj": ("vtkIOGeometry", "vtkOBJReader"),
    "vtk": ("vtkIOLegacy", "vtkDataSetReader"),
    **{suffix: ("vtkIOXML", f"vtkXML{name}Reader") for suffix, name in _XML.items()},
}


def render(
    data: Any,
    size: Sequence[int] = (800, 600),
    preset: str | None = None,
    *,
    camera: vtkCamera | Sequence[float] = (-60.0, 15.0),
    up: str = "z",
    zoom: float = 1.0,
    background: str | Sequence[float] | None = "#060a14",
    transparent: bool = False,
    rays: bool = True,
    **parameters: Any,
) -> Any:
    """Draw data with god rays, without a window, and return the picture.

    data: a data set of VTK or PyVista; a vtkAlgorithm that makes one; a file (.vtk, .vtp, .vtu, .vti, .vtr,
        .vts, .vtm, .ply, .stl, .obj); a vtkProp; a list of these; or a vtkRenderer, or a plotter, whose scene
        is drawn with its own camera, lights and background, and is left as it was; rays that it has
        keep what they are given here.
    size: width and height [pixels], from 1 to 16384.
    preset: as of enable(); see presets().
    camera: from where the data are seen, (azimuth, elevation) [degrees]. All data are in the picture. Or a
        vtkCamera.
    up: the axis that points up, "x", "y" or "z". Azimuths are counted from the axis that comes next, in the
        order x, y, z, x, to the one after that: with z up, from x to y.
    zoom: how much larger all is seen [no unit].
    background: a name of vtkNamedColors, "#rrggbb", "#rgb", or three numbers in [0, 1].
    transparent: give the picture an alpha, that of the data.
    rays: off, the same picture is drawn without them.
    parameters: all that enable() takes, such as light, sun_at, intensity.

    Returns uint8 [row, column, channel] with 3 channels, or 4 if transparent; the top row first. It shows
    itself in Jupyter, and has save(file).
    Error: there is no screen to draw on, or a file cannot be read. ValueError: nothing of the data could be
    seen, or a number is not as said above.
    """
    import godrays

    _check_names(parameters, godrays.enable)
    sides = f"a width and a height of 1 to {_LARGEST} pixels"
    width, height = (int(number) for number in to_numbers("size", size, (2,), sides))
    if not 1 <= min(width, height) <= max(width, height) <= _LARGEST:
        raise ValueError(f"size={size!r} should be {sides}")
    scene = _scene(data)
    own = scene is None
    if own:
        scene = vtkRenderer()
        for prop in _props(data):
            scene.AddViewProp(prop)
        if not scene.VisibleActorCount() + scene.VisibleVolumeCount():
            raise ValueError("there are no data: nothing could be seen")
        if not vtkBoundingBox(scene.ComputeVisiblePropBounds()).IsValid():
            raise ValueError("no point of the data has finite coordinates: nothing could be seen")
        if background is not None:
            scene.SetBackground(*_color(background))
        _look(scene, camera, up, zoom, width / height)
    window = vtkRenderWindow()
    _need_screen(window)
    former = scene.GetRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0 if transparent else 8)
    window.SetAlphaBitPlanes(transparent)
    window.SetSize(width, height)
    if former is not None:
        former.RemoveRenderer(scene)
    window.AddRenderer(scene)
    found = godrays.vtkGodRaysPass.Find(scene)
    try:
        if rays:
            godrays.enable(scene, preset=preset, **parameters)
        elif found is not None:
            found.Detach(scene)
        return _read(window, transparent)
    finally:
        if rays and found is None:
            godrays.disable(scene)
        elif not rays and found is not None:
            found.Attach(scene)
        window.RemoveRenderer(scene)
        window.Finalize()
        if former is not None:
            former.AddRenderer(scene)


def _check_names(parameters: dict[str, Any], enable: Any) -> None:
    """Tell of a name that is probably a misspelt one of render()'s own, which enable() cannot know."""
    own = list(render.__kwdefaults__ or {})
    known = {name.replace("_", "") for name in enable.__kwdefaults__}
    for name in parameters:
        end = "" if name.replace("_", "").lower() in known else tell_names(name, own)
        if "did you mean" in end:
            raise TypeError(f"render() has no parameter {name}{end}, and those of enable()")


def _scene(data: Any) -> Any:
    """The renderer that is to be drawn, None if data are something else."""
    found = data if isinstance(data, vtkRenderer) else getattr(data, "renderer", None)
    return found if isinstance(found, vtkRenderer) else None


def _props(data: Any) -> list[Any]:
    if isinstance(data, (list, tuple)):
        return [prop for each in data for prop in _props(each)]
    if isinstance(data, vtkProp):
        return [data]
    mapper = vtkDataSetMapper()
    if isinstance(data, (str, os.PathLike)):
        data = _read_file(pathlib.Path(data))
    if isinstance(data, vtkAlgorithm):
        data.Update()
        data = data.GetOutputDataObject(0)
    if isinstance(data, vtkCompositeDataSet):
        from vtkmodules.vtkFiltersGeometry import vtkCompositeDataGeometryFilter

        surface = vtkCompositeDataGeometryFilter()
        surface.SetInputData(data)
        surface.Update()
        data = surface.GetOutput()
    if not isinstance(data, vtkDataSet):
        kind = data.GetClassName() if isinstance(data, vtkDataObject) else type(data).__name__
        raise TypeError(
            f"render() needs a data set, a vtkAlgorithm, a file, a vtkProp, a renderer or a list, not {kind}")
    if data.GetNumberOfPoints() == 0:
        raise ValueError("the data set has no points: nothing could be seen")
    if data.GetNumberOfCells() == 0:
        from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter

        cloud = vtkVertexGlyphFilter()
        cloud.SetInputData(data)
        cloud.Update()
        data = cloud.GetOutput()
    mapper.SetInputData(data)
    mapper.SetScalarRange(data.GetScalarRange())
    actor = vtkActor()
    actor.GetProperty().SetPointSize(3)
    actor.SetMapper(mapper)
    return [actor]


def _read_file(path: pathlib.Path) -> Any:
    if path.is_dir():
        raise Error(f"{path}: it is a folder; name a file in it")
    suffix = path.suffix.lower().lstrip(".")
    if suffix not in _READERS:
        raise Error(f"{path}: render() reads {', '.join('.' + each for each in sorted(_READERS))}; the "
            "program godrays reads more, see python3 -m godrays --help")
    if not path.is_file():
        raise Error(f"{path}: there is no such file")
    module, name = _READERS[suffix]
    reader = getattr(importlib.import_module(f"vtkmodules.{module}"), name)()
    reader.SetFileName(str(path))
    with hushed() as messages:
        reader.Update()
    data = reader.GetOutputDataObject(0)
    reason = messages.get_reason()
    if data is None or (isinstance(data, vtkDataSet) and data.GetNumberOfPoints() == 0):
        raise Error(f"{path}: it cannot be read as {suffix}: {reason or 'it has no points'}")
    if reason:
        warnings.warn(f"{path}: {reason}", GodRaysWarning, stacklevel=4)
    return data


def _look(scene: Any, camera: Any, up: str, zoom: float, aspect: float) -> None:
    if isinstance(camera, vtkCamera):
        scene.SetActiveCamera(camera)
        scene.ResetCameraClippingRange()
        return
    meaning = "a vtkCamera, or (azimuth, elevation), with an elevation within 89.9"
    azimuth, elevation = map(math.radians, to_numbers("camera", camera, (2,), meaning))
    if not abs(elevation) <= math.radians(89.9):
        raise ValueError(f"camera={camera!r} should be {meaning}")
    if not (isinstance(zoom, (int, float)) and math.isfinite(zoom) and zoom > 0):
        raise ValueError(f"zoom={zoom!r} should be a positive number")
    if up not in ("x", "y", "z"):
        raise ValueError(f'up={up!r} should be "x", "y" or "z"')
    first = ("xyz".index(up) + 1) % 3
    place, upwards = [0.0] * 3, [0.0] * 3
    place[first] = math.cos(elevation) * math.cos(azimuth)
    place[(first + 1) % 3] = math.cos(elevation) * math.sin(azimuth)
    place["xyz".index(up)] = math.sin(elevation)
    upwards["xyz".index(up)] = 1.0
    looks = scene.GetActiveCamera()
    looks.SetFocalPoint(0, 0, 0)
    looks.SetPosition(place)
    looks.SetViewUp(upwards)
    scene.ResetCamera()
    if aspect < 1:  # the angle of view is that of the height
        looks.Dolly(aspect)
    looks.Dolly(zoom)
    scene.ResetCameraClippingRange()


def _color(color: Any) -> Sequence[float]:
    if not isinstance(color, str):
        meaning = 'three numbers in [0, 1], "#rrggbb" or a name of vtkNamedColors'
        numbers = to_numbers("background", color, (3,), meaning)
        if not 0 <= min(numbers) <= max(numbers) <= 1:
            raise ValueError(f"background={color!r} should be {meaning}")
        return numbers
    from vtkmodules.vtkCommonColor import vtkNamedColors

    text = color.strip()
    if re.fullmatch("#([0-9a-fA-F]{3}){1,2}", text):
        digits = len(text) // 3
        return [int(text[i : i + digits], 16) / (16**digits - 1) for i in range(1, len(text), digits)]
    colors = vtkNamedColors()
    if not colors.ColorExists(text):
        raise ValueError(f"there is no color {color!r}; give #rrggbb or a name of vtkNamedColors")
    return list(colors.GetColor3d(text))


def _need_screen(window: Any) -> None:
    """VTK ends the program if a window for X finds no screen."""
    if window.GetClassName() != "vtkXOpenGLRenderWindow":
        return
    try:
        library = ctypes.CDLL("libX11.so.6")
    except OSError:
        return
    library.XOpenDisplay.restype = ctypes.c_void_p
    display = library.XOpenDisplay(None)
    if not display:
        name = os.environ.get("DISPLAY")
        raise Error(f"VTK needs a screen to draw on, and there is none at DISPLAY={name or ''}: run this "
            'under xvfb-run -a -s "-screen 0 1280x1024x24"')
    library.XCloseDisplay(ctypes.c_void_p(display))


def _read(window: Any, transparent: bool) -> Any:
    from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
    from vtkmodules.util.numpy_support import vtk_to_numpy

    window.Render()
    width, height = window.GetSize()
    values = vtkUnsignedCharArray()
    if transparent:
        window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, values, 0)
    else:
        window.GetPixelData(0, 0, width - 1, height - 1, 0, values, 0)
    return _picture_class()(vtk_to_numpy(values).reshape(height, width, -1)[::-1])


def to_png(array: Any) -> bytes:
    """The PNG of a picture, uint8 [row, column] or [row, column, channel], the top row first."""
    from vtkmodules.vtkIOImage import vtkPNGWriter

    writer = vtkPNGWriter()
    writer.WriteToMemoryOn()
    writer.SetInputData(to_image(array))
    writer.Write()
    return bytes(memoryview(writer.GetResult()))


def _picture_class() -> Any:
    """The class Picture, made when it is first needed: NumPy is."""
    global _picture
    if _picture is None:
        import numpy

        class Picture(numpy.ndarray):  # type: ignore[misc]
            """An array of NumPy, uint8 [row, column, channel], that Jupyter shows as a picture."""

            def __new__(cls, array: Any) -> Any:
                return numpy.array(array, dtype=numpy.uint8).view(cls)

            def _repr_png_(self) -> Any:
                if self.ndim not in (2, 3) or 0 in self.shape or self.dtype != numpy.uint8:
                    return None  # what has been computed with it is numbers
                return to_png(numpy.asarray(self))

            def save(self, file: Any) -> None:
                """Write the picture as PNG. ValueError: the name ends otherwise."""
                if pathlib.Path(file).suffix.lower() != ".png":
                    raise ValueError(f"file={str(file)!r} should end in .png: save() writes no other type")
                pathlib.Path(file).write_bytes(to_png(numpy.asarray(self)))

        Picture.__qualname__ = "Picture"  # where pickle finds it
        _picture = Picture
    return _picture


def __getattr__(name: str) -> Any:
    if name == "Picture":
        return _picture_class()
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


_picture: Any = None
