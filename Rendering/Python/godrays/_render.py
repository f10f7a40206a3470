# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data to a picture, or to a window: render() and show()."""

from __future__ import annotations

import ctypes
import math
import os
import pathlib
import time
import warnings
from typing import TYPE_CHECKING, Any

from ._arrays import to_image
from ._errors import Error, GodRaysWarning, tell_names, to_numbers
from ._targets import find_direction, to_color, write_whole
from ._vtk import (
    load,
    name_type,
    vtkActor,
    vtkAlgorithm,
    vtkBoundingBox,
    vtkCamera,
    vtkCompositeDataSet,
    vtkDataObject,
    vtkDataSet,
    vtkDataSetMapper,
    vtkLookupTable,
    vtkProp,
    vtkRenderer,
    vtkRenderWindow,
    vtkRenderWindowInteractor,
    vtkScalarsToColors,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

_LARGEST = 16384  # [pixels] of a side; X ends the program of larger windows


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
    color: str | Sequence[float] | None = None,
    opacity: float | None = None,
    scalars: Any = None,
    cmap: Any = None,
    **parameters: Any,
) -> Any:
    """Draw data with god rays, without a window, and return the picture.

    data: a data set of VTK or PyVista; a vtkAlgorithm that makes one; a file of any type that the program
        godrays reads, such as .vti, .nii, .tif or .glb, as it shows it: 3-D images are volumes; a vtkProp; a
        list of these; or a vtkRenderer, or a plotter, whose scene is drawn with its own camera, lights and
        background, and is left as it was; rays that it has keep what they are given here.
    size: width and height [pixels], from 1 to 16384.
    preset: as of enable(); see presets().
    camera: from where the data are seen, (azimuth, elevation) [degrees]. All data are in the picture. Or a
        vtkCamera.
    up: the axis that points up, "x", "y" or "z". Azimuths of the camera are counted from the axis that comes
        next, in the order x, y, z, x, to the one after that: with z up, from x to y.
    zoom: how much larger all is seen [no unit].
    background: a name of vtkNamedColors, "#rrggbb", "#rgb", or three numbers in [0, 1].
    transparent: give the picture an alpha, that of the data.
    rays: off, the same picture is drawn without them.
    color: of the data, in the place of their scalars; as background.
    opacity: of the data. Valid range: [0, 1]. Default is 1.
    scalars: what colours the data: the name of an array of their points or cells, or for data sets an array
        of one number each. Default is the array that they have for it.
    cmap: the colour map of the scalars: a name of Matplotlib's, such as "viridis", or a vtkScalarsToColors.
    parameters: all that enable() takes, such as light, sun_at, intensity. sun=(azimuth, elevation) is counted
        as of the program: clockwise from north, which is +y where z is up, -z where y is, +z where x is.

    Returns uint8 [row, column, channel] with 3 channels, or 4 if transparent; the top row first. It shows
    itself in Jupyter, and has save(file).
    Error: there is no screen to draw on, or a file cannot be read. ValueError: nothing of the data could be
    seen, or a number is not as said above. TypeError: props and scenes have their own colours.
    """
    return _draw(data, size, preset, {name: value for name, value in locals().items() if name in _KEYWORDS},
        parameters, lambda window: _read(window, transparent))


def show(data: Any, size: Sequence[int] = (800, 600), preset: str | None = None, **parameters: Any) -> None:
    """Show data with god rays in a window, until the user closes it or presses Q.

    data, size, preset: as of render().
    parameters: all else that render() takes, but transparent.

    The camera is turned with the left button of the mouse, moved with the middle one, and zoomed with the
    right one. Errors are those of render().
    """
    if "transparent" in parameters:
        raise TypeError("show() has no parameter transparent: a window has no alpha")
    options = {name: parameters.pop(name, value) for name, value in _KEYWORDS.items()}
    del options["transparent"]
    _draw(data, size, preset, options, parameters, _interact)


_KEYWORDS = dict(render.__kwdefaults__ or {})
_LOOKS = ("color", "opacity", "scalars", "cmap")


def _interact(window: Any) -> None:
    load("vtkRenderingUI")  # which has the interactors of platforms
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.SetInteractorStyle(load("vtkInteractionStyle").vtkInteractorStyleTrackballCamera())
    interactor.Initialize()
    window.Render()
    interactor.Start()


def _draw(data: Any, size: Any, preset: Any, options: dict[str, Any], parameters: Any, finish: Any) -> Any:
    """Make the scene in a window that is seen or not, and return what finish(window) does."""
    import godrays

    _check_names(parameters, godrays.enable)
    on_screen = "transparent" not in options
    transparent = options.get("transparent", False)
    look = {name: options[name] for name in _LOOKS if options[name] is not None}
    sides = f"a width and a height of 1 to {_LARGEST} pixels"
    width, height = (int(number) for number in to_numbers("size", size, (2,), sides))
    if not 1 <= min(width, height) <= max(width, height) <= _LARGEST:
        raise ValueError(f"size={size!r} should be {sides}")
    if options["up"] not in ("x", "y", "z"):
        raise ValueError(f'up={options["up"]!r} should be "x", "y" or "z"')
    scene = _scene(data)
    if scene is None:
        scene = vtkRenderer()
        for prop in _props(data, look):
            scene.AddViewProp(prop)
        if not scene.VisibleActorCount() + scene.VisibleVolumeCount():
            raise ValueError("there are no data: nothing could be seen")
        if not vtkBoundingBox(scene.ComputeVisiblePropBounds()).IsValid():
            raise ValueError("no point of the data has finite coordinates: nothing could be seen")
        if options["background"] is not None:
            scene.SetBackground(*to_color("background", options["background"]))
        _look(scene, options["camera"], options["up"], options["zoom"], width / height)
    elif look:
        raise TypeError(f"{next(iter(look))} is for data; a scene has its own")
    sun = parameters.get("sun")
    if not (sun is None or hasattr(sun, "GetFrame") or {"light", "sun_at"} & set(parameters)):
        parameters["light"] = find_direction("sun", parameters.pop("sun"), scene, options["up"])
    window = vtkRenderWindow()
    _need_screen(window)
    former = scene.GetRenderWindow()
    window.SetOffScreenRendering(not on_screen)
    window.SetWindowName("godrays")
    window.SetMultiSamples(0 if transparent else 8)
    window.SetAlphaBitPlanes(transparent)
    window.SetSize(width, height)
    if former is not None:
        former.RemoveRenderer(scene)
    window.AddRenderer(scene)
    found = godrays.vtkGodRaysPass.Find(scene)
    try:
        if options["rays"]:
            godrays.enable(scene, preset=preset, **parameters)
        elif found is not None:
            found.Detach(scene)
        return finish(window)
    finally:
        if options["rays"] and found is None:
            godrays.disable(scene)
        elif not options["rays"] and found is not None:
            found.Attach(scene)
        window.RemoveRenderer(scene)
        window.Finalize()
        if former is not None:
            former.AddRenderer(scene)


def _check_names(parameters: dict[str, Any], enable: Any) -> None:
    """Tell of a name that is probably a misspelt one of render()'s own, which enable() cannot know."""
    own = list(_KEYWORDS)
    known = {name.replace("_", "") for name in enable.__kwdefaults__}
    for name in parameters:
        end = "" if name.replace("_", "").lower() in known else tell_names(name, own)
        if "did you mean" in end:
            raise TypeError(f"render() has no parameter {name}{end}, and those of enable()")


def _scene(data: Any) -> Any:
    """The renderer that is to be drawn, None if data are something else."""
    found = data if isinstance(data, vtkRenderer) else getattr(data, "renderer", None)
    return found if isinstance(found, vtkRenderer) else None


def _is_file(data: Any) -> bool:
    return isinstance(data, (str, os.PathLike))


def _props(data: Any, look: dict[str, Any]) -> list[Any]:
    if _is_file(data):
        data = [data]
    if isinstance(data, (list, tuple)):
        files = [each for each in data if _is_file(each)]  # which share the ranges of their colours
        others = [prop for each in data if not _is_file(each) for prop in _props(each, look)]
        return [*(_read_files(files, **look) if files else []), *others]
    if isinstance(data, vtkProp):
        if look:
            raise TypeError(f"{next(iter(look))} is for data; a {data.GetClassName()} has its own")
        return [data]
    mapper = vtkDataSetMapper()
    if isinstance(data, vtkAlgorithm):
        data.Update()
        data = data.GetOutputDataObject(0)
    if isinstance(data, vtkCompositeDataSet):
        surface = load("vtkFiltersGeometry").vtkCompositeDataGeometryFilter()
        surface.SetInputData(data)
        surface.Update()
        data = surface.GetOutput()
    if not isinstance(data, vtkDataSet):
        kind = data.GetClassName() if isinstance(data, vtkDataObject) else name_type(data)
        raise TypeError(
            f"render() needs a data set, a vtkAlgorithm, a file, a vtkProp, a renderer or a list, not {kind}")
    if data.GetNumberOfPoints() == 0:
        raise ValueError("the data set has no points: nothing could be seen")
    if data.GetNumberOfCells() == 0:
        cloud = load("vtkFiltersGeneral").vtkVertexGlyphFilter()
        cloud.SetInputData(data)
        cloud.Update()
        data = cloud.GetOutput()
    mapper.SetInputData(data)
    mapper.SetScalarRange(data.GetScalarRange())
    actor = vtkActor()
    actor.GetProperty().SetPointSize(3)
    actor.SetMapper(mapper)
    _color(actor, mapper, data, **look)
    return [actor]


def _check_color(color: Any, opacity: Any, scalars: Any, cmap: Any) -> tuple[Any, float]:
    """The numbers of a colour, None if there is none, and of an opacity."""
    if color is not None and (scalars is not None or cmap is not None):
        raise ValueError("color is in the place of scalars and cmap; give one of them")
    alpha = to_numbers("opacity", [1 if opacity is None else opacity], (1,), "in [0, 1]", (0, 1))[0]
    return None if color is None else tuple(to_color("color", color)), alpha


def _color(
    actor: Any, mapper: Any, data: Any, color: Any = None, opacity: Any = None, scalars: Any = None,
    cmap: Any = None
) -> None:
    """Give the data of an actor the looks that render() is asked for."""
    rgb, alpha = _check_color(color, opacity, scalars, cmap)
    if rgb:
        actor.GetProperty().SetColor(rgb)
        mapper.ScalarVisibilityOff()
    actor.GetProperty().SetOpacity(alpha)
    points, cells = data.GetPointData(), data.GetCellData()
    if scalars is not None and not isinstance(scalars, str):
        import numpy

        values = numpy.ascontiguousarray(scalars, float).ravel()
        array = load("util.numpy_support").numpy_to_vtk(values, deep=True)
        array.SetName("scalars")
        count = array.GetNumberOfTuples()
        if count not in (data.GetNumberOfPoints(), data.GetNumberOfCells()):
            raise ValueError(f"scalars has {count} numbers, where the data have {data.GetNumberOfPoints()} "
                f"points and {data.GetNumberOfCells()} cells")
        copy = data.NewInstance()
        copy.ShallowCopy(data)
        mapper.SetInputData(copy)
        points, cells = copy.GetPointData(), copy.GetCellData()
        (points if count == data.GetNumberOfPoints() else cells).AddArray(array)
        scalars = "scalars"
    shown = points.GetScalars() or cells.GetScalars()
    if scalars is not None:
        owner = points if points.HasArray(scalars) else cells
        shown = owner.GetArray(scalars)
        if shown is None:
            names = [each.GetArrayName(i) or ""
                for each in (points, cells) for i in range(each.GetNumberOfArrays())]
            raise ValueError(f"the data have no array {scalars!r} of numbers" + tell_names(scalars, names))
        if owner is points:
            mapper.SetScalarModeToUsePointFieldData()
        else:
            mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray(scalars)
        mapper.SetScalarRange(shown.GetFiniteRange(-1 if shown.GetNumberOfComponents() > 1 else 0))
    if cmap is not None:
        if shown is None:
            raise ValueError("cmap is for scalars, and the data have none")
        mapper.SetColorModeToMapScalars()
        mapper.SetLookupTable(_table(cmap))
        mapper.UseLookupTableScalarRangeOff()


def _table(cmap: Any) -> vtkScalarsToColors:
    """The colours of a colour map of Matplotlib, by its name, or of VTK, as they are."""
    if isinstance(cmap, vtkScalarsToColors):
        return cmap
    try:
        from matplotlib import colormaps
    except ImportError as error:
        meaning = "needs Matplotlib, or should be a vtkScalarsToColors"
        raise ValueError(f"cmap={cmap!r} {meaning}: {error}") from error
    if cmap not in list(colormaps):
        raise ValueError(f"there is no cmap {cmap!r}" + tell_names(cmap, colormaps))
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i, color in enumerate(colormaps[cmap](range(256))):
        table.SetTableValue(i, color)
    return table


def _read_files(
    files: list[Any], color: Any = None, opacity: Any = None, scalars: Any = None, cmap: Any = None
) -> list[Any]:
    """The props that the program makes of files."""
    rgb, alpha = _check_color(color, opacity, scalars, cmap)
    if not (scalars is None or isinstance(scalars, str)):
        raise TypeError("scalars of numbers are for data sets; those of a file are the name of an array")
    colors = [[0.0] * 3 for _ in range(0 if cmap is None else 256)]
    table = vtkScalarsToColors() if cmap is None else _table(cmap)
    low, high = table.GetRange()
    for i, each in enumerate(colors):
        table.GetColor(low + (high - low) * i / 255, each)
    try:
        from . import _files  # type: ignore[attr-defined]

        names = [os.fsencode(each) for each in files]
        props, notes = _files.make_props(names, scalars or "", rgb, alpha, [*map(tuple, colors)])
    except ImportError as error:
        raise Error(f"{files[0]}: no reader was built; use one of VTK in its place ({error})") from error
    except RuntimeError as error:
        kind, words = (ValueError, str(error)[2:]) if str(error).startswith("--") else (Error, str(error))
        raise kind(words) from None  # of an option of the program, which is named as the parameter
    for note in notes:
        warnings.warn(note, GodRaysWarning, stacklevel=5)
    return list(props)


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


def _need_screen(window: Any) -> None:
    """VTK ends the program if a window for X finds no screen.

    The connection is kept: a server without -noreset resets when the last one is closed, as between this and
    VTK's, and refuses further ones meanwhile.
    """
    name = os.environ.get("DISPLAY") or ""
    if window.GetClassName() != "vtkXOpenGLRenderWindow" or name in _screens:
        return
    try:
        library = ctypes.CDLL("libX11.so.6")
    except OSError:
        return
    library.XOpenDisplay.restype = ctypes.c_void_p
    for attempt in range(20 if name else 1):
        time.sleep(0.05 if attempt else 0)  # the server may reset just now
        display = library.XOpenDisplay(None)
        if display:
            _screens[name] = display
            return
    raise Error(f"VTK needs a screen to draw on, and there is none at DISPLAY={name}: run this "
        'under xvfb-run -a -s "-screen 0 1280x1024x24"')


_screens: dict[str, Any] = {}  # of DISPLAY, as Xlib has it


def _read(window: Any, transparent: bool) -> Any:
    window.Render()
    width, height = window.GetSize()
    values = load("vtkCommonCore").vtkUnsignedCharArray()
    if transparent:
        window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, values, 0)
    else:
        window.GetPixelData(0, 0, width - 1, height - 1, 0, values, 0)
    vtk_to_numpy = load("util.numpy_support").vtk_to_numpy
    return _picture_class()(vtk_to_numpy(values).reshape(height, width, -1)[::-1])


def encode(array: Any, suffix: str = ".png", quality: int = 95) -> bytes:
    """The file of a picture, uint8 [row, column] or [row, column, channel], the top row first.

    quality: of a JPEG. Valid range: [0, 100]. Default is 95, that of vtkJPEGWriter.
    """
    writers = load("vtkIOImage")
    writer = writers.vtkPNGWriter() if suffix == ".png" else writers.vtkJPEGWriter()
    if suffix != ".png":
        writer.SetQuality(quality)
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
                return encode(numpy.asarray(self))

            def save(self, file: Any) -> None:
                """Write the picture as .png, or .jpg, which has no alpha.

                ValueError: the name ends otherwise.
                """
                suffix = pathlib.Path(file).suffix.lower()
                if suffix not in (".png", ".jpg", ".jpeg"):
                    raise ValueError(
                        f"file={str(file)!r} should end in .png or .jpg: save() writes no other type")
                if suffix != ".png" and self.ndim == 3 and self.shape[2] == 4:
                    raise ValueError(f"file={str(file)!r} should end in .png: the picture has an alpha")
                data = encode(numpy.asarray(self), suffix)
                write_whole(file, lambda path: path.write_bytes(data))

        Picture.__qualname__ = "Picture"  # where pickle finds it
        _picture = Picture
    return _picture


def __getattr__(name: str) -> Any:
    if name == "Picture":
        return _picture_class()
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


_picture: Any = None
