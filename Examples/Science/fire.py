# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Smoke of a simulated fire in a corridor, and a number: is the sign over the far exit still seen?

The sources simulate fire and plume; the smoke that fills the corridor has a visibility, 30 m here, or
the third argument. What is printed is what is left of the contrast of the sign, by godrays.measure().
"""

import sys

import godrays
import stage
import vtkmodules.all as vtk

visibility = float(sys.argv[3]) if len(sys.argv) > 3 else 30.0  # [m]
renderer = vtk.vtkRenderer()
renderer.SetBackground(0.75, 0.82, 0.9)
walls = vtk.vtkAppendPolyData()
stage.box(walls, -1.6, 1.6, -1, 24, -0.1, 0)
stage.box(walls, -1.6, 1.6, -1, 24, 3, 3.1)
stage.box(walls, -1.7, -1.6, -1, 24, 0, 3)
stage.box(walls, -1.6, 1.6, 24, 24.1, 0, 3)
stage.box(walls, 1.6, 1.7, -1, 24, 0, 1)  # on the right, windows
stage.box(walls, 1.6, 1.7, -1, 24, 2.5, 3)
for y in range(-1, 24, 3):
    stage.box(walls, 1.6, 1.7, y, y + 1.6, 1, 2.5)
corridor = stage.add(renderer, walls, (0.55, 0.55, 0.52))
corridor.GetProperty().SetAmbient(0.3)
door, sign = vtk.vtkAppendPolyData(), vtk.vtkAppendPolyData()
stage.box(door, -0.55, 0.55, 23.95, 24, 0, 2.1)
stage.box(sign, -0.45, 0.45, 23.9, 23.95, 2.25, 2.6)
stage.add(renderer, door, (0.35, 0.2, 0.12)).GetProperty().SetAmbient(0.4)
stage.add(renderer, sign, (0.1, 1.0, 0.4)).GetProperty().LightingOff()

smoke = godrays.vtkGodRaysSmokeSource()
smoke.SetDimensions(48, 48, 96)
smoke.SetSpacing(1 / 32)
smoke.SetDiffusivity(0.0005)
smoke.SetRiseSpeed(0.7)
smoke.SetTurbulence(0.7)
smoke.SetSourceCenter(0, 0, 0.35)
smoke.SetSourceRadius(0.2)
smoke.SetSourceRate(4)
smoke.SetTimeStep(0.99 * smoke.GetLargestTimeStep())
smoke.UpdateTimeStep(5)
opacity, grey = vtk.vtkPiecewiseFunction(), vtk.vtkColorTransferFunction()
for density, alpha, level in (0, 0, 0.1), (0.05, 0.1, 0.12), (0.6, 0.7, 0.25):
    opacity.AddPoint(density, alpha)
    grey.AddRGBPoint(density, level, level, level)
mapper = vtk.vtkSmartVolumeMapper()
mapper.SetInputConnection(smoke.GetOutputPort())
plume = vtk.vtkVolume()
plume.SetMapper(mapper)
plume.SetPosition(-0.8, 5, 0)
plume.GetProperty().SetScalarOpacity(opacity)
plume.GetProperty().SetColor(grey)
plume.GetProperty().SetScalarOpacityUnitDistance(0.1)
plume.GetProperty().SetInterpolationTypeToLinear()
renderer.AddVolume(plume)
fire = godrays.vtkGodRaysFireSource()
fire.UpdateTimeStep(5)
flames = vtk.vtkPointGaussianMapper()
flames.SetInputConnection(fire.GetOutputPort())
flames.SetScaleArray("Size")
flames.SetScaleFactor(1)
flames.EmissiveOn()
actor = vtk.vtkActor()
actor.SetMapper(flames)
actor.SetPosition(-0.8, 5, 0.05)
actor.SetScale(0.8)
renderer.AddActor(actor)

renderer.AddLight(stage.light((0, -1, 0.4), (0.9, 0.95, 1), intensity=0.5))
sun = stage.light((1.0, 0.35, 0.75), (1.0, 0.93, 0.8))
rays = godrays.enable(renderer, light=sun, preset="smoke", visibility=visibility, world_unit_in_meters=1,
    intensity=4)
stage.look(renderer, (-0.35, -0.8, 1.65), (0.05, 10, 1.6), 46)
window = stage.show(renderer)
found = godrays.measure(renderer)
place = vtk.vtkCoordinate()
place.SetCoordinateSystemToWorld()
place.SetValue(0, 23.9, 2.42)
column, row = place.GetComputedDisplayValue(renderer)
contrast = float(found["Contrast"][row, column])
distance = float(found["Distance_m"][row, column])
print(f"the sign is {distance:.1f} m away; {contrast:.3f} of its contrast is left: "
    f"{'it is seen' if contrast > 0.02 else 'it is not seen'}")
