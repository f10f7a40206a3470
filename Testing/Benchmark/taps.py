# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Speed against error of the Taps integrator, on a lattice before a sun with a glow about it.

Prints, for each setting, the time of the scattering stage as the median of several frames, that time
over the one of 100 taps at full size, and the error against 1024 taps as root mean square, 99.9th
percentile and maximum, as fractions of the peak.

Usage: taps.py [--short] [--size WIDTHxHEIGHT]
"""

import argparse
import statistics

import godrays
import numpy
import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

parser = argparse.ArgumentParser()
parser.add_argument("--short", action="store_true", help="a small picture, one frame each")
parser.add_argument("--size", default="1280x720")
arguments = parser.parse_args()
width, height = (320, 180) if arguments.short else map(int, arguments.size.split("x"))
frames = 1 if arguments.short else 7

window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetMultiSamples(0)
window.SetSize(width, height)
renderer = vtkRenderer()
window.AddRenderer(renderer)
for i in range(-9, 10):
    for size in ((0.12, 9.0), (16.0, 0.12)):
        bar = vtkCubeSource()
        bar.SetXLength(size[0])
        bar.SetYLength(size[1])
        bar.SetZLength(0.1)
        bar.SetCenter((0.8 * i, 0, 0) if size[0] < 1 else (0, 0.8 * i, 0))
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(bar.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer.AddActor(actor)
camera = renderer.GetActiveCamera()
camera.SetPosition(0, 0, 10)
camera.SetFocalPoint(0, 0, 0)
camera.SetClippingRange(1, 100)

rays = godrays.enable(renderer, light=(0.12, 0.07, -1), measure_times=True)
integrator = rays.GetIntegrator()


def run(taps, scale, tolerance, count):
    integrator.SetNumberOfTaps(taps)
    rays.SetResolutionScale(scale)
    rays.SetErrorTolerance(tolerance)
    times = []
    for _ in range(count + 1):
        window.Render()
        seconds = [0.0] * 4
        rays.GetStageTimes(seconds)
        times.append(seconds[2])
    image = vtkImageData()
    rays.GetScatteringImage(image)
    values = vtk_to_numpy(image.GetPointData().GetScalars()).astype(float)
    return statistics.median(times[1:]), values


reference = run(1024, 1.0, 1 / 255, 1)[1]
peak = reference.max()
base = None
print(f"{width}x{height}, {frames} frames each")
print("taps  scale  tolerance       ms  of 100 taps      RMSE     p99.9       max")
for taps, scale, tolerance in (
    (100, 1.0, 1 / 255), (32, 1.0, 1 / 255), (16, 1.0, 1 / 255),
    (100, 0.5, 1 / 255), (100, 0.25, 1 / 255), (100, 0.5, 1 / 1000), (100, 0.25, 1 / 1000),
):
    seconds, values = run(taps, scale, tolerance, frames)
    base = base or seconds
    error = numpy.abs(values - reference) / peak
    print(
        f"{taps:4d}  {scale:5.2f}  {tolerance:9.5f}  {1e3 * seconds:7.1f}  {seconds / base:11.3f}"
        f"  {numpy.sqrt((error ** 2).mean()):8.1e}  {numpy.percentile(error, 99.9):8.1e}"
        f"  {error.max():8.1e}"
    )
