# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The least that god rays need: a sun, something before it, and one line."""

import sys

import godrays
import vtkmodules.all as vtk

# A colonnade: the ground, a beam and eleven pillars, all boxes.
boxes = vtk.vtkAppendPolyData()
pillars = [(2 * i - 0.4, 2 * i + 0.4, 0, 4, -0.4, 0.4) for i in range(-5, 6)]
for bounds in [(-40, 40, -0.2, 0, -8, 20), (-12, 12, 4, 4.7, -0.5, 0.5), *pillars]:
    box = vtk.vtkCubeSource()
    box.SetBounds(bounds)
    boxes.AddInputConnection(box.GetOutputPort())
mapper = vtk.vtkPolyDataMapper()
mapper.SetInputConnection(boxes.GetOutputPort())
colonnade = vtk.vtkActor()
colonnade.SetMapper(mapper)
colonnade.GetProperty().SetAmbient(0.15)

renderer = vtk.vtkRenderer()
renderer.AddActor(colonnade)
renderer.SetBackground(0.03, 0.06, 0.14)
renderer.GetActiveCamera().SetPosition(-3, 1.3, 9)
renderer.GetActiveCamera().SetFocalPoint(0.5, 2.5, 0)
renderer.GetActiveCamera().SetViewAngle(60)
renderer.ResetCameraClippingRange()
sun = vtk.vtkLight()  # it shines from its position towards the origin
sun.SetPosition(0.645, 0.16, -1)
sun.SetColor(1, 0.85, 0.6)
renderer.AddLight(sun)

rays = godrays.enable(renderer, light=sun, background_glow_falloff=12)

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
