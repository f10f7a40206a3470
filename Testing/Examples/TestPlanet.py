# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The planet: its picture in both languages, and its limb and ground against the integral.

Usage: TestPlanet.py example.py program
"""

import os
import runpy
import subprocess
import sys

import numpy
from example_testing import baseline, check, encoded, end, read

import godrays


def expected(x, y):
    """The levels of a pixel by vtkGodRaysSkySource, in the frame of the eye above the ground."""
    camera = scene["camera"]
    eye, focus = numpy.array(camera.GetPosition()), numpy.array(camera.GetFocalPoint())
    ahead = (focus - eye) / numpy.linalg.norm(focus - eye)
    right = numpy.cross(ahead, camera.GetViewUp())
    right /= numpy.linalg.norm(right)
    half = numpy.tan(numpy.radians(camera.GetViewAngle() / 2)) / 150
    look = ahead + half * ((x - 199.5) * right + (y - 149.5) * numpy.cross(right, ahead))
    up = eye / numpy.linalg.norm(eye)
    sun = numpy.array((0.0, 1.0, 0.0))
    north = sun - sun.dot(up) * up
    north /= numpy.linalg.norm(north)
    source.SetObserverHeight(1e6 * (numpy.linalg.norm(eye) - scene["radius"]))
    source.SetSunElevation(numpy.degrees(numpy.arcsin(sun.dot(up))))
    light = [0, 0, 0]
    source.GetRadiance([look.dot(each) for each in (numpy.cross(north, up), north, up)], light)
    sun = numpy.array(source.GetAtmosphere().GetSunIrradiance())
    white = sun.dot((0.2126, 0.7152, 0.0722)) / sun
    return encoded(scene["sky"].GetExposure() * white * light)


folder = os.getcwd()
example, program = sys.argv[1:]
picture = os.path.join(folder, "Planet_cxx.png")
subprocess.run([program, picture, "400x300"], check=True)
difference = numpy.abs(read(picture) - baseline("Planet")).max()
check("the program draws the baseline", difference <= 2, f"to {difference} levels")
picture = os.path.join(folder, "Planet_py.png")
sys.argv = [example, picture, "400x300"]
scene = runpy.run_path(example)
difference = numpy.abs(read(picture) - baseline("Planet")).max()
check("so does the script", difference <= 2, f"to {difference} levels")

scene["lines"].VisibilityOff()
scene["window"].Render()
scene["picture"].Modified()
scene["writer"].Write()
pixels = read(picture)
source = godrays.vtkGodRaysSkySource()
source.SetSunAzimuth(0)
source.MultipleScatteringOn()
for name, places in (
    ("the ground", [(x, 150) for x in range(80, 260, 10)]),
    ("the limb", [(x, 150) for x in range(60, 72)]),
):
    error = numpy.array([pixels[y, x] - expected(x, y) for x, y in places])
    figures = f"to {numpy.abs(error).max():.1f} levels, {numpy.sqrt((error**2).mean()):.2f} root mean square"
    check(f"{name} is that of the integral", numpy.abs(error).max() <= 3, figures)
check("space is black", (pixels[150, :40] == 0).all() and (pixels[150, 380:] == 0).all())
end()
