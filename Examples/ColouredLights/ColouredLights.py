# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Three lamps, each of its own colour, behind a lattice."""

import sys

import godrays
import vtkmodules.all as vtk

bars = vtk.vtkAppendPolyData()
uprights = [(i - 0.3, i + 0.3, -6, 6, -0.2, 0.2) for i in range(-5, 6)]
crossbars = [(-6, 6, i - 0.2, i + 0.2, -0.2, 0.2) for i in range(-5, 6)]
for bounds in uprights + crossbars:
    bar = vtk.vtkCubeSource()
    bar.SetBounds(bounds)
    bars.AddInputConnection(bar.GetOutputPort())
mapper = vtk.vtkPolyDataMapper()
mapper.SetInputConnection(bars.GetOutputPort())
lattice = vtk.vtkActor()
lattice.SetMapper(mapper)

renderer = vtk.vtkRenderer()
renderer.AddActor(lattice)
renderer.GetActiveCamera().SetPosition(2.5, 1, 14)
renderer.GetActiveCamera().SetFocalPoint(0, 0, 0)
renderer.ResetCameraClippingRange()

lamps = vtk.vtkLight(), vtk.vtkLight(), vtk.vtkLight()
colors = (1, 0.2, 0.1), (0.2, 1, 0.3), (0.2, 0.4, 1)
positions = (-3.5, -1, -3), (0.3, 1.6, -3), (3, -1.4, -3)
for lamp, color, position in zip(lamps, colors, positions):
    lamp.SetPositional(True)
    lamp.SetConeAngle(180)
    lamp.SetPosition(position)
    lamp.SetColor(color)
    renderer.AddLight(lamp)

rays = godrays.enable(renderer, light=lamps, background_glow_falloff=8)

window = vtk.vtkRenderWindow()
window.AddRenderer(renderer)
window.SetSize(400, 300)
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
