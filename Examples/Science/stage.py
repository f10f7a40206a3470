# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts of this folder share: arguments, data of Debian's packages, actors, a window.

Each takes [picture.png [1280x720]], and opens a window without.
"""

import pathlib
import sys

import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk

SKIPPED = 77  # the exit status if a package with data is missing


def find(path, package):
    """A file of a Debian package, or the end of the program with the remedy."""
    found = sorted(pathlib.Path("/usr/share").glob(path))
    if not found:
        print(f"there is no /usr/share/{path}: install Debian's package {package}", file=sys.stderr)
        sys.exit(SKIPPED)
    return str(found[0])


def colors(*points):
    """A transfer function of (value, "#rrggbb") pairs."""
    function = vtk.vtkColorTransferFunction()
    for value, text in points:
        function.AddRGBPoint(value, *(int(text[i : i + 2], 16) / 255 for i in (1, 3, 5)))
    return function


def add(renderer, source, color=None, table=None, normals=False):
    """Add an actor of an algorithm or a data set, of one colour, of its own, or by a transfer function."""
    if normals:
        smooth = vtk.vtkPolyDataNormals()
        smooth.SplittingOff()
        smooth.SetInputConnection(source.GetOutputPort())
        source = smooth
    mapper = vtk.vtkPolyDataMapper()
    if isinstance(source, vtk.vtkAlgorithm):
        mapper.SetInputConnection(source.GetOutputPort())
    else:
        mapper.SetInputData(source)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    if color is not None:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(*color)
    if table is not None:
        mapper.SetLookupTable(table)
    renderer.AddActor(actor)
    return actor


def box(append, *bounds):
    """Add a box, (x0, x1, y0, y1, z0, z1), to a vtkAppendPolyData."""
    cube = vtk.vtkCubeSource()
    cube.SetBounds(bounds)
    append.AddInputConnection(cube.GetOutputPort())


def add_city(renderer):
    """Add 1444 made towers, coloured by heights, and their ground; the unit is a metre."""
    random = numpy.random.default_rng(4)
    blocks = vtk.vtkAppendPolyData()
    for i in range(-9, 10):
        for j in range(-9, 10):
            centre = numpy.exp(-(i**2 + j**2) / 18)
            x, y = 90 * i, 90 * j
            for dx, dy in ((-18, -18), (18, -18), (-18, 18), (18, 18)):
                height = random.gamma(4, 7) + centre * random.gamma(3, 38)
                box(blocks, x + dx - 15, x + dx + 15, y + dy - 15, y + dy + 15, 0, height)
    heights = vtk.vtkElevationFilter()
    heights.SetInputConnection(blocks.GetOutputPort())
    heights.SetLowPoint(0, 0, 0)
    heights.SetHighPoint(0, 0, 200)
    table = colors((0, "#31407a"), (0.3, "#4f8a9a"), (0.7, "#c9a66b"), (1, "#f5e3c0"))
    towers = add(renderer, heights, table=table)
    ground = vtk.vtkAppendPolyData()
    box(ground, -1500, 1500, -1500, 1500, -1, 0)
    return towers, add(renderer, ground, (0.2, 0.2, 0.22))


def volume_of(data, most, color):
    """A vtkVolume of data whose scalars are extinction [1/m], up to most; its colour is the albedo."""
    opacity, colors = vtk.vtkPiecewiseFunction(), vtk.vtkColorTransferFunction()
    for each in numpy.linspace(0, most, 256):
        opacity.AddPoint(each, 1 - numpy.exp(-each))  # of 1 m
    colors.AddRGBPoint(0, *color)
    mapper = vtk.vtkSmartVolumeMapper()
    mapper.SetInputDataObject(data)
    volume = vtk.vtkVolume()
    volume.SetMapper(mapper)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().SetColor(colors)
    volume.GetProperty().SetScalarOpacityUnitDistance(1)
    volume.GetProperty().SetInterpolationTypeToLinear()
    return volume


def image_of(values, spacing, origin=(0, 0, 0)):
    """A vtkImageData of an array [z, y, x]."""
    image = vtk.vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.SetSpacing(spacing)
    image.SetOrigin(origin)
    scalars = numpy_to_vtk(numpy.ascontiguousarray(values, numpy.float32).ravel(), deep=True)
    scalars.SetName("values")
    image.GetPointData().SetScalars(scalars)
    return image


def light(position, color=(1, 1, 1), positional=False, intensity=1.0):
    result = vtk.vtkLight()
    result.SetLightTypeToSceneLight()
    result.SetPosition(position)
    result.SetColor(color)
    result.SetIntensity(intensity)
    if positional:
        result.PositionalOn()
        result.SetConeAngle(180)
    return result


def look(renderer, position, focus, angle=30, up=(0, 0, 1)):
    camera = renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint(focus)
    camera.SetViewUp(up)
    camera.SetViewAngle(angle)
    renderer.ResetCameraClippingRange()


def make_window(renderer):
    """A window of the size that the arguments ask for, off screen if a picture is."""
    window = vtk.vtkRenderWindow()
    window.AddRenderer(renderer)
    size = sys.argv[2] if len(sys.argv) > 2 else "1280x720"
    window.SetSize([int(each) for each in size.split("x")])
    if len(sys.argv) > 1:
        window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    return window


def show(renderer):
    """Write the picture that the arguments name, or let the user look around. Returns the window."""
    window = renderer.GetRenderWindow() or make_window(renderer)
    if len(sys.argv) > 1:
        window.Render()
        picture = vtk.vtkWindowToImageFilter()
        picture.SetInput(window)
        picture.ReadFrontBufferOff()
        picture.ShouldRerenderOff()
        writer = vtk.vtkPNGWriter()
        writer.SetInputConnection(picture.GetOutputPort())
        writer.SetFileName(sys.argv[1])
        writer.Write()
    else:
        interactor = vtk.vtkRenderWindowInteractor()
        interactor.SetRenderWindow(window)
        interactor.GetInteractorStyle().SetCurrentStyleToTrackballCamera()
        interactor.Start()
    return window
