# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A facade at night: shafts from its windows alone, also for an eye that is very near."""

import sys

import godrays
import vtkmodules.all as vtk


def add_boxes(bounds, color):
    boxes = vtk.vtkAppendPolyData()
    for each in bounds:
        box = vtk.vtkCubeSource()
        box.SetBounds(each)
        boxes.AddInputConnection(box.GetOutputPort())
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(boxes.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    renderer.AddActor(actor)
    return actor


def look():
    """From across the street, or from 30 cm before the wall."""
    camera = renderer.GetActiveCamera()
    camera.SetPosition((-5.2, 1.3, 0.3) if near else (-6.5, 1.7, 12))
    camera.SetFocalPoint((-2, 3.4, -0.6) if near else (0.3, 3.9, 0))
    camera.SetViewUp(0, 1, 0)
    camera.SetViewAngle(75 if near else 40)
    renderer.ResetCameraClippingRange()


# A wall of 12.8 m by 7.6 m; eight windows of 1.2 m by 2 m, with bars before their panes.
wall = [(-6.4, 6.4, y, y + 1.2, -0.4, 0) for y in (0, 3.2, 6.4)]
wall += [(x - 0.8, x + 0.8, 0, 7.6, -0.4, 0) for x in (-5.6, -2.8, 0, 2.8, 5.6)]
panes = []
for x in -4.2, -1.4, 1.4, 4.2:
    for y in 1.2, 4.4:
        panes.append((x - 0.7, x + 0.7, y - 0.1, y + 2.1, -0.35, -0.34))
        wall.append((x - 0.04, x + 0.04, y, y + 2, -0.3, -0.25))
        wall.append((x - 0.6, x + 0.6, y + 0.63, y + 0.69, -0.3, -0.25))
        wall.append((x - 0.6, x + 0.6, y + 1.3, y + 1.36, -0.3, -0.25))
renderer = vtk.vtkRenderer()
house = add_boxes(wall, (0.3, 0.31, 0.36))
windows = add_boxes(panes, (1, 0.72, 0.36))
windows.GetProperty().LightingOff()
add_boxes([(-20, 20, -0.2, 0, -0.4, 20)], (0.1, 0.11, 0.13))  # the street
renderer.SetBackground(0.01, 0.012, 0.03)
renderer.SetNearClippingPlaneTolerance(0.0005)  # so that the wall is not cut open
moon = vtk.vtkLight()
moon.SetPosition(-1, 1, 2)
moon.SetColor(0.25, 0.3, 0.45)
renderer.AddLight(moon)
near = sys.argv[-1] == "near"
look()

godrays.enable(
    renderer, light=windows, occluders=[house], untagged_props_occlude=False,
    background_glow=0,  # the windows shine, and nothing else
    preset="low-sun", intensity=0.7,
)  # fmt: skip

window = vtk.vtkRenderWindow()
window.AddRenderer(renderer)
size = sys.argv[2] if len(sys.argv) > 2 + near else "1280x720"
window.SetSize([int(each) for each in size.split("x")])
if len(sys.argv) > 1 + near:
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
    sys.exit()


def press(interactor, event):
    global near
    if interactor.GetKeySym() == "n":
        near = not near
        look()
        interactor.Render()


interactor = vtk.vtkRenderWindowInteractor()
interactor.SetRenderWindow(window)
interactor.AddObserver("KeyPressEvent", press)
window.Render()
interactor.Start()
