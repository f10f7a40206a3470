# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The gallery's picture of skies behind and air before a scene. Usage: skies.py <file.jpg>"""

import math
import sys

import godrays
import vtkmodules.all as vtk

from sources import add, warp


SOIL = 0.57, 0.42, 0.28  # of Mars


def look(renderer, position, azimuth, elevation, angle):
    across = math.cos(math.radians(elevation))
    turn = math.radians(azimuth)
    direction = across * math.sin(turn), across * math.cos(turn), math.sin(math.radians(elevation))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint([place + way for place, way in zip(position, direction)])
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(angle)
    renderer.ResetCameraClippingRange()


def mountains(renderer, sun, azimuth, soil=None, **parameters):
    """A range of 40 km, in a unit of 400 m, at an hour that its sun tells."""
    source = godrays.vtkGodRaysTerrainSource()
    source.SetDimensions(601, 601)
    source.SetHeight(9)
    source.SetFeatures(4)
    source.SetSeed(3)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("Color")
    actor = add(renderer, mapper, warp(source))
    if soil:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(soil)
    look(renderer, (-4, -48, 9), azimuth, -2, 34)
    light = vtk.vtkLight()
    godrays.sky(renderer, sun=sun, light=light, world_unit_in_meters=400, **parameters)
    renderer.AutomaticLightCreationOff()
    renderer.AddLight(light)
    godrays.shadows(renderer)
    return light


def noon(renderer):
    mountains(renderer, (120, 50), 0, exposure=2.5)


def evening(renderer):
    light = mountains(renderer, (12, 4), 0, atmosphere="earth-hazy", exposure=2)
    godrays.enable(renderer, light=light, preset="low-sun", intensity=0.5)


def dusk(renderer):
    """Away from the sun: the Earth's own shadow rises, below a red arch."""
    look(renderer, (0, 0, 2), 90, 12, 40)
    godrays.sky(renderer, sun=(270, -2.5), exposure=40)


def space(renderer):
    """From 300 km up, after sunset."""
    look(renderer, (0, 0, 3e5), 180, -16, 14)
    godrays.sky(renderer, sun=(180, -14), exposure=6)


def mars(renderer):
    """A low sun over dust: blue about it, yellowish brown elsewhere."""
    mountains(renderer, (6, 4), 0, SOIL, atmosphere="mars", exposure=0.3)


def mars_by_day(renderer):
    mountains(renderer, (250, 25), 0, SOIL, atmosphere="mars", exposure=12)


def main(path):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(1000, 960)
    for i, scene in enumerate((noon, evening, dusk, space, mars, mars_by_day)):
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(i % 2 / 2, (2 - i // 2) / 3, i % 2 / 2 + 0.5, (3 - i // 2) / 3)
        window.AddRenderer(renderer)
        scene(renderer)
    window.Render()
    picture = vtk.vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    writer = vtk.vtkJPEGWriter()
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetFileName(path)
    writer.SetQuality(90)
    writer.Write()


if __name__ == "__main__":
    main(sys.argv[1])
