# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A sea of wind waves under broken clouds: a random surface of the JONSWAP spectrum [Hasselmann1973]."""

import godrays
import numpy
import stage
import vtkmodules.all as vtk

# Waves, 512 x 512 on 1600 m: a wind of 14 m/s, 120 km of fetch.
count, width, gravity, wind, fetch = 512, 1600.0, 9.81, 14.0, 120e3
random = numpy.random.default_rng(7)
k = 2 * numpy.pi * numpy.fft.fftfreq(count, width / count)
kx, ky = numpy.meshgrid(k, k)
k = numpy.maximum(numpy.hypot(kx, ky), 1e-6)
omega = numpy.sqrt(gravity * k)
peak = 22 * (gravity**2 / (wind * fetch)) ** (1 / 3)
alpha = 0.076 * (wind**2 / (fetch * gravity)) ** 0.22
width_of_peak = numpy.where(omega <= peak, 0.07, 0.09)
spectrum = alpha * gravity**2 / omega**5 * numpy.exp(-1.25 * (peak / omega) ** 4)
spectrum *= 3.3 ** numpy.exp(-((omega - peak) ** 2) / (2 * width_of_peak**2 * peak**2))
spread = 2 / numpy.pi * numpy.maximum(-ky / k, 0) ** 2  # towards the eye
density = spectrum * spread * 0.5 * gravity / omega / k  # of the plane of wave numbers
step = 2 * numpy.pi / width
noise = random.normal(size=(2, count, count))
amplitude = numpy.sqrt(density / 2) * step * (noise[0] + 1j * noise[1])
heights = numpy.fft.ifft2(amplitude).real * count**2 * numpy.sqrt(2)
print(f"significant height: {4 * heights.std():.1f} m")

heights = numpy.tile(heights, (2, 2))
image = stage.image_of(heights[None], (width / count, width / count, 1), (-width, 0, 0))
surface = vtk.vtkImageDataGeometryFilter()
surface.SetInputData(image)
waves = vtk.vtkWarpScalar()
waves.SetInputConnection(surface.GetOutputPort())
renderer = vtk.vtkRenderer()
table = stage.colors((-2, "#06202e"), (0, "#11506a"), (1.6, "#3f95a0"), (3, "#d8eef0"))
sea = stage.add(renderer, waves, table=table, normals=True)
sea.GetProperty().SetAmbient(0.25)
sea.GetProperty().SetSpecular(0.7)
sea.GetProperty().SetSpecularPower(40)
sea.GetProperty().SetSpecularColor(1, 0.85, 0.6)

clouds = godrays.vtkGodRaysCloudLayerSource()
clouds.SetWidth(16000)
clouds.SetAltitude(420)
clouds.SetCloudSize(520)
clouds.SetCoverage(0.68)
clouds.SetSoftness(0.25)
clouds.SetColor(0.2, 0.2, 0.24)
clouds.SetResolution(300)
clouds.SetTextureResolution(2)
clouds.SetSeed(5)
layer = stage.add(renderer, clouds)
layer.GetProperty().LightingOff()
layer.ForceTranslucentOn()

renderer.SetBackground(0.6, 0.43, 0.3)
renderer.SetBackground2(0.12, 0.2, 0.34)
renderer.GradientBackgroundOn()
sun = stage.light((0.06, 1, 0.16), (1, 0.8, 0.52))
renderer.AddLight(sun)
renderer.AddLight(stage.light((0, -0.5, 1), (0.6, 0.75, 0.9), intensity=0.5))
rays = godrays.enable(renderer, light=sun, preset="low-sun", intensity=4)
stage.look(renderer, (0, 20, 22), (30, 1000, 105), 40)
renderer.GetActiveCamera().SetClippingRange(2, 12000)
window = stage.show(renderer)
