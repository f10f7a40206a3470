# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measured terrain at sunrise: the Jacksboro fault in Tennessee, its sun by date and place, and its sky."""

import godrays
import numpy
import stage
import vtkmodules.all as vtk

path = stage.find("**/jacksboro_fault_dem.npz", "python-matplotlib-data")
heights = numpy.load(path)["elevation"][::-1]  # from south to north; 73 m by 93 m between samples
image = stage.image_of(heights[None].astype(float), (73.0, 93.0, 1.0))
surface = vtk.vtkImageDataGeometryFilter()
surface.SetInputData(image)
relief = vtk.vtkWarpScalar()
relief.SetScaleFactor(4)
relief.SetInputConnection(surface.GetOutputPort())
renderer = vtk.vtkRenderer()
table = stage.colors(
    (240, "#1f6b3a"), (380, "#7fae4a"), (520, "#d9c45a"), (750, "#c98a4a"), (1000, "#f2ede6"))
land = stage.add(renderer, relief, table=table, normals=True)
land.GetProperty().SetAmbient(0.25)
land.GetProperty().SetSpecular(0)

morning = godrays.sun("2024-10-21T07:58-04:00", 36.4, -84.3)  # x is east, y north
sunlight = vtk.vtkLight()
sky = godrays.sky(renderer, sun=morning, light=sunlight)
sunlight.SetIntensity(1.5)
renderer.AddLight(sunlight)
renderer.AddLight(stage.light((0, 0, 1), (0.5, 0.6, 0.8), intensity=1.0))
rays = godrays.enable(renderer, light=sunlight, preset="low-sun", intensity=1.7)
stage.look(renderer, (2000, 18600, 3250), (29000, 9300, 3350), 32)
window = stage.show(renderer)
