# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the sky: light and looks, by place or by angles, in C++ and in Python; errors.

Usage: TestSkyImage.py example.py program
"""

import os
import subprocess
import sys

import numpy
from example_testing import baseline, check, end, read

import godrays


def run(command, *arguments):
    return subprocess.run([*command, *arguments], capture_output=True, text=True)


def check_both(name, *arguments):
    """Both twins draw the same; returns what."""
    pictures = []
    for language, command in commands.items():
        file = os.path.join(folder, f"SkyImage_{language}_{name}")
        done = run(command, file, *arguments)
        check(f"{name} in {language}", done.returncode == 0, done.stderr)
        pictures.append(read(file))
    check(f"{name} is the same in both", numpy.array_equal(*pictures))
    return pictures[0]


folder = os.getcwd()
example, program = sys.argv[1:]
commands = {"C++": [program], "Python": [sys.executable, example]}

difference = numpy.abs(check_both("sky.png") - baseline("SkyImage")).max()
check("the picture is the baseline", difference <= 2, f"to {difference} levels")

light = check_both("light.hdr", "40", "180")
source = godrays.vtkGodRaysSkySource()
source.SetSunElevation(40)
source.SetSunAzimuth(180)
source.MultipleScatteringOn()
zenith = [0, 0, 0]
source.GetRadiance((0, 0, 1), zenith)
center = light[127:129, 127:129].mean(axis=(0, 1))
error = numpy.abs(center / zenith - 1).max()
check("the middle is the zenith's radiance", error < 0.005, f"to {error:.2%}")
y, x = (numpy.argwhere(light[..., 1] == light[..., 1].max()).mean(axis=0) + 0.5) / 128 - 1
height = 90 - 2 * numpy.degrees(numpy.arctan(numpy.hypot(x, y)))
check("the sun is 40 degrees high", abs(height - 40) < 0.5, f"{height:.2f}")
check("and in the south", abs(x) < 0.01 and y < 0, f"{x:.3f}, {y:.3f}")

noon = check_both("noon.png", "equirectangular", "2024-06-21T12:30:00Z", "51.48", "0")
check("an equirectangular picture is twice as wide as high", noon.shape[:2] == (256, 512))
for command in commands.values():
    for arguments, word in (
        (["sky.jpg"], "Usage"),
        (["sky.png", "40"], "Usage"),
        (["sky.png", "high", "180"], "Usage"),
        (["sky.png", "yesterday", "51", "0"], "yesterday"),
        (["/nowhere/sky.png", "40", "180"], "/nowhere"),
    ):
        done = run(command, *arguments)
        told = done.returncode == 1 and word in done.stderr and "Traceback" not in done.stderr
        check(f"{' '.join(arguments)} is an error that is told", told)
end()
