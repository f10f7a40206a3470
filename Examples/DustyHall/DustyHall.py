# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Physical single scattering: sunlight through windows into the dust of a hall."""

import sys

import godrays
import vtkmodules.all as vtk

# A hall, 14 m long and 6 m high; its windows are what walls, sills, lintels and bars leave open.
boxes = vtk.vtkAppendPolyData()
windows = [-5.2, -2.6, 0, 2.6, 5.2]
walls = list(zip([-7] + [x + 0.55 for x in windows], [x - 0.55 for x in windows] + [7]))
for bounds in [
    *[(-7, 7, y, y + 0.3, -4.4, 5) for y in (-0.3, 6)],
    *[(x, x + 0.2, 0, 6, -4.4, 5) for x in (-7, 6.8)],
    *[(a, b, 0, 6, -4.4, -4) for a, b in walls],
    *[(-7, 7, low, high, -4.4, -4) for low, high in ((0, 1.2), (5, 6))],
    *[(x - 0.03, x + 0.03, 1.2, 5, -4.25, -4.15) for x in windows],
    *[(x - 0.55, x + 0.55, 3, 3.06, -4.25, -4.15) for x in windows],
    *[(x - 0.35, x + 0.35, 0, 6, z - 0.35, z + 0.35) for x, z in ((-2.6, -1), (3.9, -1.5))],
]:
    box = vtk.vtkCubeSource()
    box.SetBounds(bounds)
    boxes.AddInputConnection(box.GetOutputPort())
mapper = vtk.vtkPolyDataMapper()
mapper.SetInputConnection(boxes.GetOutputPort())
hall = vtk.vtkActor()
hall.SetMapper(mapper)
hall.GetProperty().SetColor(0.75, 0.68, 0.58)
hall.GetProperty().SetAmbient(0.2)
hall.GetProperty().SetDiffuse(0.4)

renderer = vtk.vtkRenderer()
renderer.AddActor(hall)
renderer.SetBackground(0.75, 0.85, 1)
renderer.GetActiveCamera().SetPosition(-5.5, 1.7, 4.2)
renderer.GetActiveCamera().SetFocalPoint(1.2, 2.7, -4)
renderer.GetActiveCamera().SetViewAngle(62)
renderer.ResetCameraClippingRange()
sun = vtk.vtkLight()
sun.SetPosition(0.35, 0.75, -1)
sun.SetColor(1, 0.86, 0.62)
renderer.AddLight(sun)

dust = godrays.vtkGodRaysHomogeneousModel()  # the scene's unit is a metre
dust.SetScatteringCoefficient(0.09, 0.09, 0.09)
godrays.enable(renderer, light=sun, model=dust, layer_margin=1)  # the roof is outside the picture

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
