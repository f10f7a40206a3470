# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The shortest program with god rays: a scene with gaps and one line."""

import sys

import godrays
import vtkmodules.all as vtk

# The edges of a grid as tubes, in the colours of the grid's values
grid = vtk.vtkRTAnalyticSource()
grid.SetWholeExtent(0, 3, 0, 3, 0, 3)
edges = vtk.vtkExtractEdges()
edges.SetInputConnection(grid.GetOutputPort())
tubes = vtk.vtkTubeFilter()
tubes.SetInputConnection(edges.GetOutputPort())
tubes.SetRadius(0.08)
tubes.SetNumberOfSides(16)
tubes.Update()
colors = vtk.vtkColorTransferFunction()
colors.AddRGBPoint(-20, 0.95, 0.85, 0.3)
colors.AddRGBPoint(100, 0.15, 0.7, 0.6)
colors.AddRGBPoint(260, 0.3, 0.45, 0.95)
mapper = vtk.vtkPolyDataMapper()
mapper.SetInputConnection(tubes.GetOutputPort())
mapper.SetLookupTable(colors)
lattice = vtk.vtkActor()
lattice.SetMapper(mapper)

renderer = vtk.vtkRenderer()
renderer.AddActor(lattice)
renderer.GradientBackgroundOn()
renderer.SetBackground(0.016, 0.02, 0.031)  # shafts show before dark grounds
renderer.SetBackground2(0.055, 0.067, 0.094)
camera = renderer.GetActiveCamera()
camera.SetPosition(0, -1, 0)
camera.SetFocalPoint(0, 0, 0)
camera.SetViewUp(0, 0, 1)
camera.Azimuth(25)
camera.Elevation(20)
renderer.ResetCamera()
camera.Dolly(1.12)
renderer.ResetCameraClippingRange()

rays = godrays.enable(renderer)  # a sun behind the lattice, at the place with the most shafts

window = vtk.vtkRenderWindow()
window.AddRenderer(renderer)
window.SetMultiSamples(8)
size = sys.argv[2] if len(sys.argv) > 2 else "1280x720"
window.SetSize([int(each) for each in size.split("x")])
if len(sys.argv) > 1:
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
