# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A city in the haze of a morning: single scattering, with the shadows of all towers, also on surfaces."""

import godrays
import stage
import vtkmodules.all as vtk

renderer = vtk.vtkRenderer()
renderer.SetBackground(0.95, 0.72, 0.5)
renderer.SetBackground2(0.35, 0.48, 0.7)
renderer.GradientBackgroundOn()
for part in stage.add_city(renderer):
    part.GetProperty().SetAmbient(0.25)

sun = stage.light((-0.7, 0.7, 0.32), (1.0, 0.75, 0.5), intensity=2.3)
renderer.AddLight(sun)
fill = stage.light((0, 0, 1), (0.6, 0.7, 0.9), intensity=0.55)
fill.SetLightTypeToHeadlight()  # which casts no shadows
renderer.AddLight(fill)
rays = godrays.enable(renderer, light=sun, preset="haze", visibility=5000, world_unit_in_meters=1,
    far_limit=2500, asymmetry=0.7, intensity=1.3, shadows=True)
stage.look(renderer, (100, -830, 270), (-20, 0, 78), 44)
window = stage.show(renderer)
