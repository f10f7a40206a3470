# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Physical single scattering: the sun through windows into the dust of a hall."""

import sys

import godrays
import vtkmodules.all as vtk

# A hall, 14 m long and 6 m high: floor, roof, walls and pillars; and between its five windows.
bounds = [
    (-7, 7, -0.3, 0, -4.4, 5), (-7, 7, 6, 6.3, -4.4, 5),
    (-7, -6.8, 0, 6, -4.4, 5), (6.8, 7, 0, 6, -4.4, 5),
    (-7, 7, 0, 1.2, -4.4, -4), (-7, 7, 4.8, 6, -4.4, -4), (-7.2, -5.75, 0, 6, -4.4, -4),
    (-2.95, -2.25, 0, 6, -1.35, -0.65), (3.55, 4.25, 0, 6, -1.85, -1.15),
]  # fmt: skip
for x in -5.2, -2.6, 0, 2.6, 5.2:
    bounds.append((x + 0.55, x + 2.05, 0, 6, -4.4, -4))
    bounds.append((x - 0.03, x + 0.03, 1.2, 5, -4.25, -4.15))
boxes = vtk.vtkAppendPolyData()
for each in bounds:
    box = vtk.vtkCubeSource()
    box.SetBounds(each)
    boxes.AddInputConnection(box.GetOutputPort())
mapper = vtk.vtkPolyDataMapper()
mapper.SetInputConnection(boxes.GetOutputPort())
hall = vtk.vtkActor()
hall.SetMapper(mapper)
hall.GetProperty().SetColor(0.72, 0.66, 0.6)
hall.GetProperty().SetAmbient(0.3)
hall.GetProperty().SetDiffuse(0.5)

renderer = vtk.vtkRenderer()
renderer.AddActor(hall)
renderer.SetBackground(0.75, 0.85, 1)
renderer.GetActiveCamera().SetPosition(-1.5, 1.7, 4.9)
renderer.GetActiveCamera().SetFocalPoint(1.3, 2.3, -3.6)
renderer.GetActiveCamera().SetViewAngle(60)
renderer.ResetCameraClippingRange()
sun = vtk.vtkLight()
sun.SetPosition(0.35, 0.75, -1)
sun.SetColor(1, 0.86, 0.62)
renderer.AddLight(sun)

dust = godrays.vtkGodRaysHomogeneousModel()
dust.SetScatteringCoefficient(0.05, 0.05, 0.05)  # [1/m]
godrays.enable(
    renderer, light=sun, model=dust,
    intensity=10,  # as for eyes used to the dark
    shadows=True,  # sunlight comes through the windows alone
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
