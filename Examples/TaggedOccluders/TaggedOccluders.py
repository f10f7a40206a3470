# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A lamp that is a prop, and a lantern about it that alone blocks its light: the floor does not."""

import sys

import godrays
import vtkmodules.all as vtk

renderer = vtk.vtkRenderer()
renderer.GetActiveCamera().SetPosition(0, 1.6, 7.5)
renderer.GetActiveCamera().SetFocalPoint(0, 0.1, 0)


def add_actor(shape, *color):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(shape.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().SetColor(color)
    renderer.AddActor(actor)
    return actor


ball = vtk.vtkSphereSource()
ball.SetRadius(0.5)
lamp = add_actor(ball, 1, 0.75, 0.35)
lamp.GetProperty().LightingOff()
globe = vtk.vtkSphereSource()
plates = vtk.vtkShrinkPolyData()  # of the globe, with gaps between them
plates.SetInputConnection(globe.GetOutputPort())
plates.SetShrinkFactor(0.62)
lantern = add_actor(plates, 0.25, 0.28, 0.35)
lantern.SetScale(2)
slab = vtk.vtkCubeSource()
slab.SetBounds(-6, 6, -1.6, -1.4, -4, 3)
add_actor(slab, 0.10, 0.12, 0.18)
rays = godrays.enable(renderer, light=lamp, occluders=[lantern], untagged_props_occlude=False)
rays.SetBackgroundGlow(0.05)
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
