# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A planet from space, with its atmosphere: the sky, seen from above it."""

import sys

import godrays
import vtkmodules.all as vtk

# The unit is 1000 km, the planet's centre the origin. The sun is above the equator, along y.
radius = 6.36
renderer = vtk.vtkRenderer()
sky = godrays.vtkGodRaysSkyPass.Attach(renderer)
sky.SetWorldUnitInMeters(1e6)
sky.SetOrigin(0, radius, 0)
sky.SetUp(0, 1, 0)
sky.SetNorth(0, 0, 1)
sky.SetSunElevation(90)
sky.SetExposure(6)
sky.AerialPerspectiveOff()  # coastlines are a map, not things

camera = renderer.GetActiveCamera()
camera.SetPosition(-12, 2, 5)
camera.SetFocalPoint(0, 0.3, 0)
camera.SetViewUp(0, 0, 1)
camera.SetViewAngle(60)
camera.SetClippingRange(1, 30)

# Those of the far side are cut off: the planet's horizon is a plane before its centre.
coasts = vtk.vtkEarthSource()
coasts.SetRadius(radius)
coasts.SetOnRatio(1)
coasts.OutlineOn()
horizon = vtk.vtkPlane()
part = radius**2 / sum(each**2 for each in camera.GetPosition())  # of the way to the camera
horizon.SetNormal(camera.GetPosition())
horizon.SetOrigin([part * each for each in camera.GetPosition()])
mapper = vtk.vtkPolyDataMapper()
mapper.SetInputConnection(coasts.GetOutputPort())
mapper.AddClippingPlane(horizon)
lines = vtk.vtkActor()
lines.SetMapper(mapper)
lines.RotateZ(150)
lines.GetProperty().SetColor(0.75, 0.85, 0.8)
lines.GetProperty().LightingOff()
renderer.AddActor(lines)

window = vtk.vtkRenderWindow()
window.AddRenderer(renderer)
size = sys.argv[2] if len(sys.argv) > 2 else "1280x720"
window.SetSize([int(each) for each in size.split("x")])
if len(sys.argv) > 1:
    window.SetMultiSamples(0)
    window.SetOffScreenRendering(True)
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
    interactor.Start()
