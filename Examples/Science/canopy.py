# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Trees as points, as a scanner sees them, in morning mist: each point blocks light. The unit is a metre."""

import godrays
import numpy
import stage
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk

random = numpy.random.default_rng(3)


def branch(start, direction, length, radius, depth, parts):
    """Points of a branch and of what grows from it; leaves at the end."""
    along = random.uniform(0, 1, max(int(900 * length * radius**0.5), 30))[:, None]
    around = random.normal(size=(along.shape[0], 3))
    around /= numpy.linalg.norm(around, axis=1)[:, None]
    parts.append(start + along * length * direction + around * radius)
    end = start + length * direction
    if depth == 0:
        parts.append(end + random.normal(size=(150, 3)) * 0.42)
        return
    for _ in range(3):
        turn = direction + random.normal(size=3) * 0.55
        turn[2] = abs(turn[2]) * 0.7 + 0.12
        branch(end, turn / numpy.linalg.norm(turn), length * 0.66, radius * 0.55, depth - 1, parts)


parts = []
trees = ((-4.5, 9), (3.4, 7), (0.2, 14), (-9, 16), (8, 13), (-3, 22), (5, 21), (12, 22), (-13, 24), (0, 30))
for x, y in trees:
    branch(numpy.array([x, y, 0.0]), numpy.array([0.0, 0.0, 1.0]), random.uniform(3.2, 4.2), 0.24, 4, parts)
soil = numpy.column_stack([random.uniform(-22, 22, 90000), random.uniform(-6, 38, 90000), numpy.zeros(90000)])
soil[:, 2] = 0.25 * numpy.sin(soil[:, 0] / 3) * numpy.cos(soil[:, 1] / 4) + random.normal(0, 0.05, 90000)
cloud = numpy.concatenate([*parts, soil])
points = vtk.vtkPoints()
points.SetData(numpy_to_vtk(cloud, deep=True))
data = vtk.vtkPolyData()
data.SetPoints(points)
heights = numpy_to_vtk(cloud[:, 2].copy(), deep=True)
heights.SetName("height")
data.GetPointData().SetScalars(heights)
vertices = vtk.vtkVertexGlyphFilter()
vertices.SetInputData(data)
renderer = vtk.vtkRenderer()
table = stage.colors((0, "#4a3b2a"), (1.5, "#5f5033"), (4, "#3f6b35"), (8, "#7da344"), (11, "#d9dc7a"))
forest = stage.add(renderer, vertices, table=table)
forest.GetProperty().SetPointSize(3)
renderer.SetBackground(0.2, 0.25, 0.27)
floor = vtk.vtkAppendPolyData()
stage.box(floor, -60, 60, -20, 90, -0.4, -0.2)
stage.add(renderer, floor, (0.27, 0.22, 0.16)).GetProperty().SetAmbient(0.6)
sun = stage.light((-0.02, 1, 0.3), (1.0, 0.85, 0.6))
rays = godrays.enable(renderer, light=sun, preset="low-sun", intensity=1.4, background_glow_radius=14)
stage.look(renderer, (0.5, -9, 2.2), (0.8, 14, 4.8), 46)
window = stage.show(renderer)
