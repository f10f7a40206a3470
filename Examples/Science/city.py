# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A city in the haze of a morning: single scattering, with the shadows of all towers. The unit is a metre."""

import godrays
import numpy
import stage
import vtkmodules.all as vtk

random = numpy.random.default_rng(4)
blocks = vtk.vtkAppendPolyData()
for i in range(-9, 10):
    for j in range(-9, 10):
        centre = numpy.exp(-(i**2 + j**2) / 18)
        x, y = 90 * i, 90 * j
        for dx, dy in ((-18, -18), (18, -18), (-18, 18), (18, 18)):
            height = random.gamma(4, 7) + centre * random.gamma(3, 38)
            stage.box(blocks, x + dx - 15, x + dx + 15, y + dy - 15, y + dy + 15, 0, height)
heights = vtk.vtkElevationFilter()
heights.SetInputConnection(blocks.GetOutputPort())
heights.SetLowPoint(0, 0, 0)
heights.SetHighPoint(0, 0, 200)
renderer = vtk.vtkRenderer()
renderer.SetBackground(0.95, 0.72, 0.5)
renderer.SetBackground2(0.35, 0.48, 0.7)
renderer.GradientBackgroundOn()
table = stage.colors((0, "#31407a"), (0.3, "#4f8a9a"), (0.7, "#c9a66b"), (1, "#f5e3c0"))
towers = stage.add(renderer, heights, table=table)
towers.GetProperty().SetAmbient(0.25)
ground = vtk.vtkAppendPolyData()
stage.box(ground, -1500, 1500, -1500, 1500, -1, 0)
stage.add(renderer, ground, (0.2, 0.2, 0.22)).GetProperty().SetAmbient(0.3)

sun = stage.light((0.22, 1, 0.13), (1.0, 0.72, 0.42))
renderer.AddLight(sun)
renderer.AddLight(stage.light((-0.3, -1, 0.8), (0.6, 0.7, 0.9), intensity=0.6))
rays = godrays.enable(renderer, light=sun, preset="haze", visibility=4000, world_unit_in_meters=1,
    intensity=2.5)
stage.look(renderer, (-120, -760, 150), (30, 200, 75), 44)
window = stage.show(renderer)
