# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A rose window in two viewports, each with a camera, a look and a pass of its own."""

import sys

import godrays
import vtkmodules.all as vtk

rose = vtk.vtkDiskSource()
rose.SetInnerRadius(0.6)
rose.SetOuterRadius(3)
rose.SetRadialResolution(3)
rose.SetCircumferentialResolution(16)
plates = vtk.vtkShrinkPolyData()  # of the rose, with gaps between them
plates.SetInputConnection(rose.GetOutputPort())
plates.SetShrinkFactor(0.7)
wall = vtk.vtkDiskSource()  # about the rose
wall.SetInnerRadius(3)
wall.SetOuterRadius(30)
wall.SetCircumferentialResolution(96)
parts = vtk.vtkAppendPolyData()
parts.AddInputConnection(plates.GetOutputPort())
parts.AddInputConnection(wall.GetOutputPort())
mapper = vtk.vtkPolyDataMapper()
mapper.SetInputConnection(parts.GetOutputPort())
facade = vtk.vtkActor()
facade.SetMapper(mapper)
facade.GetProperty().SetColor(0.35, 0.4, 0.55)
facade.GetProperty().SetAmbient(0.08)
sun = vtk.vtkLight()  # it shines from its position towards the origin
sun.SetPosition(0.05, 0.1, -1)
sun.SetColor(1, 0.85, 0.6)
window = vtk.vtkRenderWindow()
for i, look in enumerate(["cathedral", "low-sun"]):
    renderer = vtk.vtkRenderer()
    renderer.SetViewport(0.5 * i, 0, 0.5 + 0.5 * i, 1)
    renderer.AddActor(facade)
    renderer.AddLight(sun)
    renderer.SetBackground(0.2, 0.26, 0.42)
    renderer.GetActiveCamera().SetPosition(-2 * i - 0.5, 1.5 * i - 1, 12 + 2 * i)
    renderer.GetActiveCamera().SetViewAngle(45)
    window.AddRenderer(renderer)
    rays = godrays.enable(renderer, light=sun, preset=look)
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
