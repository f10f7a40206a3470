# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Smoke of a simulated fire in a room, as the medium: its data scatter the light of its windows.

The mixture fraction of the simulation, on an unstructured grid, is resampled to an image. What burnt leaves
soot: 0.04 of it, as of plastics, of which a kilogram has 8700 m^2, in air of 1.2 kg/m^3 at 294 K, thinner
where it is hot. What is printed is how far one can see in the smoke under the ceiling and above the floor.
"""

import pathlib

import godrays
import numpy
import stage
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

reader = vtk.vtkXMLUnstructuredGridReader()
reader.SetFileName(str(pathlib.Path(__file__).with_name("room-fire.vtu")))  # [m], y is up
image = vtk.vtkResampleToImage()
image.SetInputConnection(reader.GetOutputPort())
image.SetSamplingDimensions(120, 50, 48)
image.Update()
field = image.GetOutput()
fraction, kelvin = (vtk_to_numpy(field.GetPointData().GetArray(name)) for name in ("mfrac", "t"))
density = 1.2 * 294 / numpy.maximum(kelvin, 294)  # [kg/m^3]
extinction = 8700 * density * 0.04 * numpy.minimum(fraction, 0.01)  # [1/m]; beyond, it is fuel
smoke = stage.image_of(extinction.reshape(field.GetDimensions()[::-1]), field.GetSpacing(), field.GetOrigin())

plume = stage.volume_of(smoke, extinction.max(), (0.8, 0.8, 0.8))

renderer = vtk.vtkRenderer()
renderer.SetBackground(0.75, 0.82, 0.9)
renderer.AddVolume(plume)
walls, floor = vtk.vtkAppendPolyData(), vtk.vtkAppendPolyData()
stage.box(floor, -0.1, 6.1, -0.1, 0, -0.1, 2.5)
stage.box(walls, -0.1, 6.1, 2.5, 2.6, -0.1, 2.5)  # the ceiling
stage.box(walls, -0.1, 0, 0, 2.5, -0.1, 2.5)
stage.box(walls, 6, 6.1, 0, 2.5, -0.1, 2.5)
stage.box(walls, 0, 6, 0, 1.1, -0.1, 0)  # at the back, windows
stage.box(walls, 0, 6, 2.3, 2.5, -0.1, 0)
for left in numpy.arange(0, 6, 0.75):
    stage.box(walls, left, left + 0.4, 1.1, 2.3, -0.1, 0)
stage.add(renderer, walls, (0.62, 0.6, 0.56)).GetProperty().SetAmbient(0.25)
stage.add(renderer, floor, (0.45, 0.33, 0.22)).GetProperty().SetAmbient(0.25)
flame = vtk.vtkContourFilter()
flame.SetInputConnection(reader.GetOutputPort())
flame.SetInputArrayToProcess(0, 0, 0, 0, "t")
flame.SetValue(0, 600)
flames = stage.add(renderer, flame, (1.0, 0.55, 0.15))
flames.GetProperty().LightingOff()
renderer.AddLight(stage.light((0, 0.6, 1), (0.8, 0.85, 1), intensity=0.45))
sun = stage.light((-0.7, 0.4, -1), (1.0, 0.9, 0.72))
rays = godrays.enable(renderer, light=sun, medium=plume, world_unit_in_meters=1, data_asymmetry=0.4)
stage.look(renderer, (4.5, 1.0, 4.3), (2.35, 1.25, 0.1), 37, (0, 1, 0))
window = stage.show(renderer)
for place, layer in ("under the ceiling", slice(44, 48)), ("above the floor", slice(4, 12)):
    mean = extinction.reshape(48, 50, 120)[:, layer].mean()
    print(f"{place}: {mean:.3f}/m, a visibility of {3 / mean:.1f} m")
