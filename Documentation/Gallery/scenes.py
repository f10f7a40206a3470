# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The gallery's pictures of examples, larger than these draw them.

Usage: scenes.py <folder> <elevations of Jacksboro, .vti>
"""

import os
import pathlib
import runpy
import sys
import tempfile

import vtkmodules.all as vtk

examples = pathlib.Path(__file__).resolve().parents[2] / "Examples"


def run(name, *arguments):
    script = str(examples / name / f"{name}.py")
    sys.path.insert(0, os.path.dirname(script))  # of what it imports
    with tempfile.NamedTemporaryFile(suffix=".png") as small:
        sys.argv = [script, small.name, *arguments]
        return runpy.run_path(script)


def write(scene, name, size=(800, 600)):
    window = scene["window"]
    window.SetSize(size)
    window.Render()
    picture = vtk.vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    picture.ShouldRerenderOff()
    writer = vtk.vtkJPEGWriter()
    writer.SetQuality(88)
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetFileName(os.path.join(folder, f"{name}.jpg"))
    writer.Write()


folder, elevations = sys.argv[1:]
write(run("Outdoor"), "outdoor")
scene = run("Sunrise", elevations)
write(scene, "sunrise")
for name, hours in ("dawn", 7.85), ("day", 12.0), ("dusk", 17.1):
    scene["set_time"](hours)
    write(scene, f"sunrise-{name}", (400, 300))
