# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""How long the sources of scenes take: the fastest of a few. VTK_SMP_MAX_THREADS says on how many threads."""

import time

import godrays
from vtkmodules.vtkCommonDataModel import vtkPerlinNoise
from vtkmodules.vtkImagingHybrid import vtkSampleFunction


def fastest(action, repeats=5):
    """[ms]"""
    times = []
    for i in range(repeats):
        begin = time.perf_counter()
        action(i)
        times.append(1e3 * (time.perf_counter() - begin))
    return min(times)


def update(source):
    def action(_):
        source.Modified()
        source.Update()

    return action


for turbulence in (0.4, 0.0):
    smoke = godrays.vtkGodRaysSmokeSource()
    smoke.SetDimensions(128, 128, 128)
    smoke.SetTurbulence(turbulence)
    smoke.UpdateTimeStep(1.0)
    ms = fastest(lambda i: smoke.UpdateTimeStep(1.0 + 0.2 * (i + 1))) / 10
    print(f"smoke, 128^3, turbulence {turbulence}: {ms:.1f} ms per step")

for octaves in (9, 1):
    terrain = godrays.vtkGodRaysTerrainSource()
    terrain.SetDimensions(1024, 1024)
    terrain.SetOctaves(octaves)
    print(f"terrain, 1024^2, octaves {octaves}: {fastest(update(terrain)):.0f} ms")
noise = vtkSampleFunction()
noise.SetImplicitFunction(vtkPerlinNoise())
noise.SetSampleDimensions(1024, 1024, 1)
noise.SetModelBounds(-2, 2, -2, 2, 0, 0)
noise.ComputeNormalsOff()
print(f"vtkPerlinNoise, 1024^2, one octave: {fastest(update(noise)):.0f} ms")

fire = godrays.vtkGodRaysFireSource()
fire.SetSpawnRate(100000)
fire.SetCapacity(100000)
fire.UpdateTimeStep(5.0)
print(f"fire, {fire.GetOutput().GetNumberOfPoints()} particles: {fastest(update(fire)):.1f} ms")

clouds = godrays.vtkGodRaysCloudLayerSource()
print(f"clouds, 129^2 points and 512^2 texels: {fastest(update(clouds)):.0f} ms")
