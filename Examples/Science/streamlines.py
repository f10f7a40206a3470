# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Streamlines of a vortex, in dust, about a lamp in its eye: Burgers' solution, with its own numbers."""

import godrays
import numpy
import stage
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk

# v_r = -a r, v_z = 2 a z, v_phi = G/(2 pi r) (1 - e^(-a r^2/(2 nu))) [Burgers1948]
strain, circulation, viscosity, count = 0.09, 9.0, 0.03, 48
axis = numpy.linspace(-3, 3, count)
z, y, x = numpy.meshgrid(numpy.linspace(0, 6, count), axis, axis, indexing="ij")
r2 = numpy.maximum(x**2 + y**2, 1e-6)
swirl = circulation / (2 * numpy.pi * r2) * (1 - numpy.exp(-strain * r2 / (2 * viscosity)))
velocity = numpy.stack([-strain * x - swirl * y, -strain * y + swirl * x, 2 * strain * z], -1)
field = stage.image_of(numpy.linalg.norm(velocity, axis=-1), (6 / (count - 1),) * 3, (-3, -3, 0))
field.GetPointData().GetScalars().SetName("speed")
vectors = numpy_to_vtk(velocity.reshape(-1, 3), deep=True)
vectors.SetName("velocity")
field.GetPointData().SetVectors(vectors)

angles = numpy.linspace(0, 2 * numpy.pi, 14, endpoint=False)
starts = vtk.vtkPoints()
for index, angle in enumerate(angles):
    radius = 2.7 if index % 2 else 1.9
    starts.InsertNextPoint(radius * numpy.cos(angle), radius * numpy.sin(angle), 0.15 + 0.5 * (index % 3))
seeds = vtk.vtkPolyData()
seeds.SetPoints(starts)
tracer = vtk.vtkStreamTracer()
tracer.SetInputData(field)
tracer.SetSourceData(seeds)
tracer.SetMaximumPropagation(90)
tracer.SetIntegratorTypeToRungeKutta45()
tubes = vtk.vtkTubeFilter()
tubes.SetRadius(0.085)
tubes.SetNumberOfSides(10)
tubes.SetInputConnection(tracer.GetOutputPort())
renderer = vtk.vtkRenderer()
renderer.SetBackground(0.01, 0.015, 0.03)
table = stage.colors((0.4, "#2b4a9b"), (0.9, "#2fa39a"), (1.4, "#e6c34a"), (2.2, "#f4f0e0"))
lines = stage.add(renderer, tubes, table=table)
lines.GetMapper().SetScalarModeToUsePointFieldData()
lines.GetMapper().SelectColorArray("speed")
floor = vtk.vtkAppendPolyData()
stage.box(floor, -8, 8, -8, 8, -0.15, -0.1)
stage.add(renderer, floor, (0.25, 0.23, 0.2))
renderer.AddLight(stage.light((1, -2, 1.2), (0.9, 0.95, 1), intensity=0.9))
lamp = stage.light((0, 0, 2.2), (1, 0.78, 0.5), positional=True)
rays = godrays.enable(renderer, light=lamp, preset="dust", optical_depth=0.3, intensity=3)
stage.look(renderer, (5.5, -9.5, 3.8), (0, 0, 2.4), 38)
window = stage.show(renderer)
