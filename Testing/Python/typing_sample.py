# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Correct uses of godrays, for TestTyping.py: a type checker has nothing to say of them."""

import datetime

import godrays
import pyvista
from godrays import vtkGodRaysHomogeneousModel, vtkGodRaysPass, vtkGodRaysSkyPass
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkRenderer, vtkRenderWindow

renderer = vtkRenderer()
window = vtkRenderWindow()
plotter = pyvista.Plotter()
actor = vtkActor()
lamp = vtkLight()

rays: vtkGodRaysPass = godrays.enable(renderer)
godrays.enable(window, light=lamp, preset="fog", asymmetry=0.3)
godrays.enable(plotter, light=(1, 2, 1), occluders=[actor], ignored=actor, density=0.9)
godrays.enable(plotter.renderer, light=[lamp, actor, (0.0, 1.0, 0.0)], model="radial")
godrays.enable(plotter, light=None, occluders=None, model=vtkGodRaysHomogeneousModel())
godrays.enable(plotter, sun=(190, 8), light_color="orange")
rays.light = (0.0, 1.0, 0.5)
rays.preset = "low-sun"
rays.SetIntensity(0.7)
rays.intensity = 0.7
rays.output = vtkGodRaysPass.SCATTERING
strength: float = rays.intensity
with godrays.enable(renderer, light=(0, 0, 1), intensity=0.5, model="homogeneous", visibility=100.0) as fog:
    fog.background_glow = 0.5
picture = godrays.render(actor, (320, 240), preset="low-sun", camera=(-60, 15), sun_at=(0.3, 0.8))
picture.save("picture.png")
godrays.render(actor, scalars="height", cmap="viridis", opacity=0.5, sun=[190, 8])
names: dict[str, str] = godrays.presets()
godrays.enable(renderer, **godrays.from_pmndrs({"density": 0.9}))
shafts = godrays.scatter([[0.0, 1.0]], (0.5, 0.5), density=1.0)
version: str = godrays.__version__
try:
    rays.intensity = float("nan")
except godrays.Error as error:
    print(error)
plan: str = rays.GetPlan()

direction: tuple[float, float, float] = godrays.sun("2024-06-21T20:30+02:00", 43.77, 11.26)
godrays.sun(datetime.datetime.now(datetime.timezone.utc), 43.77, 11.26, up=(0, 1, 0), north=[0, 0, -1])
sky: vtkGodRaysSkyPass = godrays.sky(renderer, sun=direction, light=lamp, atmosphere="earth-hazy")
sky.SetExposure(2.0)
shadows: vtkGodRaysPass = godrays.shadows(renderer, most_data_shadow=0.3)
godrays.enable(renderer, shadows=True)
godrays.sky(window, sun=[250, 8], world_unit_in_meters=1000.0)

found = godrays.measure(renderer, irradiance=(1000.0, 900.0, 800.0), file="numbers.vti")
largest: float = found["Radiance"].max()
godrays.tag(actor, "occluder")
godrays.tag(actor, vtkGodRaysPass.LIGHT)
godrays.disable(plotter)
