# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Three lamps, each of its own colour, in lanterns."""

import sys

import godrays
import vtkmodules.all as vtk

# From far away, so that all are seen along their axes: shafts leave between the panes.
renderer = vtk.vtkRenderer()
renderer.SetBackground(0.02, 0.025, 0.05)
renderer.GetActiveCamera().SetPosition(0, 0.1, 32)
renderer.GetActiveCamera().SetFocalPoint(0, 0, 0)
renderer.GetActiveCamera().SetViewAngle(11)

lamps = vtk.vtkLight(), vtk.vtkLight(), vtk.vtkLight()
colors = (1, 0.38, 0.12), (0.25, 0.85, 0.4), (0.3, 0.5, 1)
positions = (-2.1, -0.9, 0), (0.1, 0.95, 0), (2.2, -0.75, 0)
for lamp, color, position in zip(lamps, colors, positions):
    sphere = vtk.vtkSphereSource()
    sphere.SetCenter(position)
    sphere.SetRadius(0.8)
    sphere.SetThetaResolution(12)
    sphere.LatLongTessellationOn()
    panes = vtk.vtkShrinkPolyData()
    panes.SetInputConnection(sphere.GetOutputPort())
    panes.SetShrinkFactor(0.75)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(panes.GetOutputPort())
    lantern = vtk.vtkActor()
    lantern.SetMapper(mapper)
    lantern.GetProperty().SetColor(0.3, 0.3, 0.34)
    lantern.GetProperty().SetAmbient(0.1)
    renderer.AddActor(lantern)

    lamp.SetPositional(True)
    lamp.SetConeAngle(180)
    lamp.SetPosition(position)
    lamp.SetColor(color)
    renderer.AddLight(lamp)
renderer.ResetCameraClippingRange()

rays = godrays.enable(
    renderer, light=lamps, intensity=2.5,
    background_glow_radius=0.4, background_glow_falloff=1,  # [degrees] within the lanterns
)  # fmt: skip

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
