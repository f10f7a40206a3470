# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A day over a city: sun and sky by date and place, shadows on surfaces, and shafts in haze.

Usage: city_day.py [picture.png [1280x720 [frames]]]

The picture is of 8 h. With frames, such as 261, it is a film from 6 to 19 h instead: picture-0000.png and so
on, and picture.mp4 where ffmpeg is there.
"""

import math
import pathlib
import shutil
import subprocess
import sys

import godrays
import stage
import vtkmodules.all as vtk

frames = int(sys.argv.pop()) if len(sys.argv) > 3 else 0
renderer = vtk.vtkRenderer()
towers, ground = stage.add_city(renderer)
ground.GetProperty().SetColor(0.4, 0.4, 0.4)
sun = godrays.vtkGodRaysSun()  # over Florence; x is east, y north
sun.SetFrame(sun.Z_UP)
sun.SetPosition(sun.DATE_AND_PLACE)
day = sun.GetEphemeris()
day.SetDateTime("2024-09-22T08:00+02:00")
day.SetLatitude(43.77)
day.SetLongitude(11.26)
light = vtk.vtkLight()
renderer.AddLight(light)
sky = godrays.sky(renderer, sun=sun, highlight_shoulder=True)
# The haze ends behind the city, so that the sky is seen. The sky says how bright the sun is.
rays = godrays.enable(renderer, light=light, preset="haze", visibility=8000, asymmetry=0.7, far_limit=2000,
    world_unit_in_meters=1, automatic_exposure=False, shadows=True)
stage.look(renderer, (-790, 230, 210), (60, 0, 80), 44)


def set_time(hours):
    """Move the sun. As an eye does, the exposure makes up for most of the light that is missing."""
    day.SetTimeOfDay(hours)
    sky.SetExposure(1)
    sky.UpdateLight(light)
    of_sky = [0, 0, 0]
    sky.GetSkyIrradiance((0, 0, 1), of_sky)
    sky.SetExposure(1.3 / (0.7 * light.GetIntensity() + max(of_sky) / math.pi + 1e-5) ** 0.8)
    sky.UpdateLight(light)


set_time(8)
name = str(pathlib.Path(sys.argv[1]).with_suffix("")) if frames else ""
for frame in range(frames):
    set_time(6 + 13 * frame / max(frames - 1, 1))
    sys.argv[1] = f"{name}-{frame:04}.png"
    stage.show(renderer)
    print(f"{sys.argv[1]}: {day.GetDateTime()[11:16]}", flush=True)
if frames and shutil.which("ffmpeg"):
    subprocess.run(["ffmpeg", "-y", "-loglevel", "error", "-framerate", "25", "-i", f"{name}-%04d.png",
        "-pix_fmt", "yuv420p", f"{name}.mp4"], check=True)
window = renderer.GetRenderWindow() if frames else stage.show(renderer)
