# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Start parallel_scenes.py on several processes, and compare what they draw.

For plain Python; with GODRAYS_PVBATCH and GODRAYS_MPIRUN.
"""

import os
import pathlib
import re
import subprocess

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

SCRIPT = str(pathlib.Path(__file__).with_name("parallel_scenes.py"))
MPIRUN = [os.environ["GODRAYS_MPIRUN"], "--oversubscribe", "-np"]
if hasattr(os, "geteuid") and os.geteuid() == 0:
    MPIRUN.insert(1, "--allow-run-as-root")


def on_processes(count):
    """The command that runs a script in ParaView on so many processes."""
    pvbatch = [os.environ["GODRAYS_PVBATCH"]]
    return pvbatch if count == 1 else [*MPIRUN, str(count), *pvbatch]


def draw(folder, program, scenes=(), **environment):
    """Draw scenes into a new folder; an AssertionError tells what was said if that fails."""
    os.mkdir(folder)
    done = subprocess.run(
        [*program, SCRIPT, folder, *scenes],
        env={**os.environ, **environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        timeout=240,
        text=True,
        check=False,
    )
    if done.returncode or re.search(r"(ERR|WARN)\|", done.stdout):
        raise AssertionError(f"{folder}: exit status {done.returncode}\n{done.stdout}")
    return folder


def read(folder, name):
    """A picture in levels of 255: rows from the bottom, red, green and blue."""
    reader = vtkPNGReader()
    reader.SetFileName(os.path.join(folder, name + ".png"))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars()).astype(int)
    return values.reshape(height, width, -1)[:, :, :3]


def difference(a, b, name):
    """The largest difference between two folders' pictures of a name [levels]."""
    return int(abs(read(a, name) - read(b, name)).max())
