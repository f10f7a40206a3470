# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes as people make them, in which defaults might go wrong: other lights, units, sizes in the picture,
materials and kinds of props than those of default_scenes."""

import math

import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk

import default_scenes
from default_scenes import actor, elevation, open_window, through


def shine(renderer, position, color, directional=False):
    """A light that stands in the scene, which godrays.enable() takes for what shines."""
    light = vtk.vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(position)
    light.SetFocalPoint(0, 0, 0)
    light.SetPositional(not directional)
    light.SetConeAngle(90)
    light.SetColor(color)
    renderer.AddLight(light)


def add(renderer, *props):
    for prop in props:
        renderer.AddViewProp(prop)


def add_cones(renderer, scale=1.0):
    for prop in default_scenes.cones():
        prop.SetScale(scale, scale, scale)
        add(renderer, prop)


def ball(radius=1.0, centre=(0, 0, 0), resolution=40):
    source = vtk.vtkSphereSource()
    source.SetRadius(radius)
    source.SetCenter(centre)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution // 2)
    return source


def lamp_in_a_shell(renderer):
    """A sphere whose faces leave gaps, lit from within and by the eye."""
    shrink = vtk.vtkShrinkPolyData()
    shrink.SetShrinkFactor(0.7)
    add(renderer, actor(elevation(through(ball(resolution=24), shrink))))
    renderer.CreateLight()
    shine(renderer, (0, 0, 0), (1, 0.9, 0.7))


def lamp_alone_in_a_shell(renderer):
    """The same, which nothing lights from outside."""
    shrink = vtk.vtkShrinkPolyData()
    shrink.SetShrinkFactor(0.7)
    add(renderer, actor(through(ball(resolution=24), shrink), (0.3, 0.6, 0.8)))
    shine(renderer, (0, 0, 0), (1, 0.9, 0.7))


def several_lights(renderer):
    """Cones among three lamps of their own colours."""
    add_cones(renderer)
    shine(renderer, (-4, 3, -4), (1, 0.5, 0.4))
    shine(renderer, (4, 3, -4), (0.4, 0.6, 1))
    shine(renderer, (0, 4, 6), (0.9, 0.9, 0.9))


def light_kit(renderer):
    kit = vtk.vtkLightKit()
    kit.AddLightsToRenderer(renderer)
    add_cones(renderer)


def without_lights(renderer):
    """Cones that nothing lights, in their ambient colours."""
    renderer.AutomaticLightCreationOff()
    add_cones(renderer)
    for prop in renderer.GetViewProps():
        prop.GetProperty().SetAmbient(0.8)


def sun_behind_all(renderer):
    """A wall that hides the sun, which is straight behind it."""
    wall = vtk.vtkPlaneSource()
    wall.SetOrigin(-2, -1.2, 0)
    wall.SetPoint1(2, -1.2, 0)
    wall.SetPoint2(-2, 1.2, 0)
    wall.SetResolution(20, 12)
    add(renderer, actor(elevation(wall, 1)))
    renderer.CreateLight()
    shine(renderer, (0, 0, -1), (1, 0.95, 0.85), directional=True)


def translucent(renderer):
    """Translucent cones, one behind the other, in order, without which alpha does not say where they are."""
    renderer.UseDepthPeelingOn()
    add_cones(renderer)
    for prop in renderer.GetViewProps():
        prop.GetProperty().SetOpacity(0.6)


def lines(renderer):
    """Ten curves, drawn as lines."""
    for index in range(10):
        x = numpy.linspace(-3, 3, 200)
        points = numpy.stack([x, numpy.sin(2 * x + 0.3 * index), 0.3 * index + 0 * x], -1)
        curve = vtk.vtkLineSource()
        data = vtk.vtkPoints()
        data.SetData(numpy_to_vtk(points, deep=True))
        curve.SetPoints(data)
        color = [0.5 + 0.45 * math.cos(0.6 * index + phase) for phase in (0, 2, 4)]
        prop = actor(curve, color)
        prop.GetProperty().SetLineWidth(2)
        add(renderer, prop)


def points(renderer):
    """20000 points of one pixel, coloured by their heights."""
    rng = numpy.random.default_rng(3)
    values = rng.normal(size=(20000, 3)) * (1, 0.5, 1)
    data = vtk.vtkPolyData()
    coordinates = vtk.vtkPoints()
    coordinates.SetData(numpy_to_vtk(values, deep=True))
    data.SetPoints(coordinates)
    scalars = numpy_to_vtk(values[:, 1].copy(), deep=True)
    data.GetPointData().SetScalars(scalars)
    vertices = vtk.vtkVertexGlyphFilter()
    vertices.SetInputData(data)
    add(renderer, actor(vertices))


def close(renderer):
    """A ball that fills all of the picture but its corners."""
    source = ball(1.0, resolution=80)
    add(renderer, actor(elevation(source, 1)))


def dark(renderer):
    add_cones(renderer)
    for index, prop in enumerate(renderer.GetViewProps()):
        prop.GetProperty().SetColor(0.08, 0.02 + 0.01 * index, 0.04)


def bright(renderer):
    add_cones(renderer)
    for index, prop in enumerate(renderer.GetViewProps()):
        prop.GetProperty().SetColor(1, 0.9 + 0.02 * index, 0.75)


def white(renderer):
    add_cones(renderer)
    for prop in renderer.GetViewProps():
        prop.GetProperty().SetColor(1, 1, 1)


def unlit(renderer):
    """A colour map without shading, with its scalar bar."""
    wave = vtk.vtkPlaneSource()
    wave.SetResolution(60, 60)
    wave.Update()
    bend = vtk.vtkWarpScalar()
    data = wave.GetOutput()
    x = numpy.array([data.GetPoint(i)[:2] for i in range(data.GetNumberOfPoints())])
    heights = 0.2 * numpy.sin(7 * x[:, 0]) * numpy.cos(6 * x[:, 1])
    data.GetPointData().SetScalars(numpy_to_vtk(heights, deep=True))
    bend.SetInputData(data)
    prop = actor(bend)
    prop.GetProperty().LightingOff()
    prop.RotateX(-65)
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(prop.GetMapper().GetLookupTable())
    bar.SetTitle("height")
    add(renderer, prop, bar)


def chart(renderer):
    """A plot of 2-D, which rays leave alone, beside a surface."""
    table = vtk.vtkTable()
    for name in ("x", "y"):
        column = vtk.vtkFloatArray()
        column.SetName(name)
        for index in range(20):
            column.InsertNextValue(index if name == "x" else math.sin(0.4 * index))
        table.AddColumn(column)
    plot = vtk.vtkChartXY()
    plot.SetAutoSize(False)
    plot.SetSize(vtk.vtkRectf(10, 10, 130, 90))
    plot.AddPlot(0).SetInputData(table, 0, 1)
    context = vtk.vtkContextActor()
    context.GetScene().AddItem(plot)
    context.GetScene().SetRenderer(renderer)
    add_cones(renderer)
    add(renderer, context)


def wireframe(renderer):
    add_cones(renderer)
    for prop in renderer.GetViewProps():
        prop.GetProperty().SetRepresentationToWireframe()


def bright_volume(renderer):
    """A volume whose colours are strong and light."""
    image = vtk.vtkRTAnalyticSource()
    image.SetWholeExtent(-20, 20, -20, 20, -20, 20)
    mapper = vtk.vtkSmartVolumeMapper()
    mapper.SetInputConnection(image.GetOutputPort())
    colors = vtk.vtkColorTransferFunction()
    for value, color in (40, (0.1, 0.2, 0.9)), (150, (0.9, 0.9, 0.2)), (260, (0.9, 0.1, 0.1)):
        colors.AddRGBPoint(value, *color)
    opacity = vtk.vtkPiecewiseFunction()
    opacity.AddPoint(140, 0)
    opacity.AddPoint(270, 0.3)
    prop = vtk.vtkVolume()
    prop.SetMapper(mapper)
    prop.GetProperty().SetColor(colors)
    prop.GetProperty().SetScalarOpacity(opacity)
    prop.GetProperty().SetInterpolationTypeToLinear()
    add(renderer, prop)


def metal(renderer):
    """Balls of metals, by physically based shading."""
    for index in range(5):
        prop = actor(ball(0.6, (1.5 * (index - 2), 0, 0)), (0.9, 0.5 + 0.1 * index, 0.3))
        prop.GetProperty().SetInterpolationToPBR()
        prop.GetProperty().SetMetallic(0.6)
        prop.GetProperty().SetRoughness(0.2 + 0.15 * index)
        add(renderer, prop)


def parallel(renderer):
    add_cones(renderer)
    renderer.GetActiveCamera().ParallelProjectionOn()


def from_above(renderer):
    """A flat plate, seen from above, that has a few holes."""
    plate = vtk.vtkPlaneSource()
    plate.SetResolution(15, 15)
    shrink = vtk.vtkShrinkPolyData()
    shrink.SetShrinkFactor(0.85)
    add(renderer, actor(elevation(through(plate, shrink), 0)))


def inside(renderer):
    """A room of columns, with the camera among them."""
    for index in range(12):
        column = vtk.vtkCylinderSource()
        column.SetRadius(0.25)
        column.SetHeight(4)
        column.SetResolution(24)
        column.SetCenter(2.0 * (index % 4 - 1.5), 0, -2.0 * (index // 4))
        add(renderer, actor(elevation(column, 1)))


# what it is, how it is made, elevation of the camera, how many times nearer it is
SITUATIONS = {
    "lamp in a shell": (lamp_in_a_shell, 10, 1),
    "lamp alone in a shell": (lamp_alone_in_a_shell, 10, 1),
    "several lights": (several_lights, 10, 1),
    "light kit": (light_kit, 10, 1),
    "without lights": (without_lights, 10, 1),
    "sun behind all": (sun_behind_all, 0, 1),
    "translucent": (translucent, 10, 1),
    "lines": (lines, 20, 1),
    "points": (points, 10, 1.3),
    "close": (close, 10, 2.5),
    "tiny": (lambda renderer: add_cones(renderer, 1e-6), 10, 1),
    "huge": (lambda renderer: add_cones(renderer, 1e6), 10, 1),
    "dark": (dark, 10, 1),
    "bright": (bright, 10, 1),
    "white": (white, 10, 1),
    "unlit": (unlit, 0, 1.4),
    "chart": (chart, 10, 1),
    "wireframe": (wireframe, 10, 1),
    "bright volume": (bright_volume, 20, 1),
    "metal": (metal, 10, 1),
    "parallel": (parallel, 10, 1),
    "from above": (from_above, 0, 1),
    "inside": (inside, 5, 2.2),
}


def make(name, size):
    """A window that shows a situation."""
    fill, height, zoom = SITUATIONS[name]
    window, renderer = open_window(size)
    fill(renderer)
    camera = renderer.GetActiveCamera()
    camera.Elevation(height)
    renderer.ResetCamera()
    camera.Dolly(zoom)
    renderer.ResetCameraClippingRange()
    return window, renderer
