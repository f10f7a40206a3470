# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The gallery's comparison of the examples Statue and Facade with the published sums.

Writes the pictures, and prints how far the sums are from their own limits, and what they cost.
Usage: comparison.py <folder>
"""

import os
import runpy
import sys
import time

import godrays
import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Examples")


class Visitor(vtk.vtkGenericRenderWindowInteractor):
    """What an example takes for its interactor: Start() hands it to a function."""

    visit = None

    def Start(self):
        self.GetRenderWindow().SetMultiSamples(0)
        type(self).visit(self)

    def rays(self):
        return self.GetRenderWindow().GetRenderers().GetFirstRenderer().GetPass()

    def press(self, key):
        self.SetKeySym(key)
        self.InvokeEvent("KeyPressEvent")

    def picture(self):
        grab = vtk.vtkWindowToImageFilter()
        grab.SetInput(self.GetRenderWindow())
        grab.ReadFrontBufferOff()
        grab.Update()
        return grab.GetOutput()

    def light(self):
        self.Render()
        image = vtk.vtkImageData()
        self.rays().GetScatteringImage(image)
        return vtk_to_numpy(image.GetPointData().GetScalars()).astype(float)

    def Render(self):
        self.GetRenderWindow().Render()


def visit(name, function):
    vtk.vtkRenderWindowInteractor = Visitor
    Visitor.visit = function
    sys.argv = [name]
    sys.path.insert(0, os.path.join(EXAMPLES, name))
    runpy.run_path(os.path.join(EXAMPLES, name, name + ".py"))


def write(rows, file):
    """Rows of pictures, the first one on top."""
    columns = vtk.vtkImageAppend()
    columns.SetAppendAxis(1)
    for row in reversed(rows):
        pictures = vtk.vtkImageAppend()
        for picture in row:
            pictures.AddInputData(picture)
        columns.AddInputConnection(pictures.GetOutputPort())
    writer = vtk.vtkJPEGWriter()
    writer.SetInputConnection(columns.GetOutputPort())
    writer.SetQuality(92)
    writer.SetFileName(os.path.join(folder, file))
    writer.Write()


def report(name, light, limit):
    error = numpy.abs(light - limit) / limit.max()
    print(f"| {name} | {100 * numpy.sqrt((error**2).mean()):.3f} | {100 * error.max():.2f} |")


def measure(visitor, scene, preset):
    """The published sum of n samples, and ours, each against its limit of ever more samples."""
    rays = visitor.rays()
    rays.SetPrecision(rays.SINGLE)
    ours, model = rays.GetModel(), godrays.vtkGodRaysPublishedModel()
    taps = godrays.vtkGodRaysTapsIntegrator()
    converged = visitor.light()
    rays.SetIntegrator(taps)
    taps.SetNumberOfTaps(4000)
    ours_limit = visitor.light()
    rays.SetModel(model)
    model.ApplyPreset(preset)
    model.SetClampMaximum(65504)
    decay, weight, samples = model.GetDecay(), model.GetWeight(), model.GetNumberOfSamples()

    def sum_of(count):
        """The same sum, by another number of samples."""
        each = decay ** (samples / count)
        model.SetDecay(each)
        model.SetWeight(weight * (1 - each) / (1 - decay))
        model.SetNumberOfSamples(count)
        return visitor.light()

    limit = sum_of(8000)
    for count in samples // 2, samples, 2 * samples:
        report(f"{scene}, published, {count} samples", sum_of(count), limit)
    brightness = []
    for count in samples // 2, samples, 2 * samples:
        model.ApplyPreset(preset)
        model.SetNumberOfSamples(count)
        brightness.append(f"{visitor.light().mean():.3f} with {count}")
    model.ApplyPreset(preset)
    times = []
    for each, integrator in (model, taps), (ours, None):
        rays.SetModel(each)
        rays.SetIntegrator(integrator)
        visitor.Render()
        began = time.perf_counter()
        for _ in range(5):
            visitor.Render()
        times.append((time.perf_counter() - began) / 5)
    report(f"{scene}, ours", converged, ours_limit)
    print(f"{scene}, published, mean by the number of samples: {', '.join(brightness)}")
    print(f"{scene}: {1000 * times[0]:.0f} ms a frame, published; {1000 * times[1]:.0f} ms, ours")


def visit_statue(visitor):
    pictures = []
    for _ in "published", "ours":
        visitor.press("g")
        pictures.append(visitor.picture())
    write([pictures], "statue.jpg")
    measure(visitor, "statue", "gianassi")


def visit_facade(visitor):
    rows = []
    visitor.GetRenderWindow().SetSize(400, 300)
    ours, model = visitor.rays().GetModel(), godrays.vtkGodRaysPublishedModel()
    for _ in "far", "near":
        row = []
        visitor.rays().SetModel(model)
        visitor.rays().SetIntensity(1)
        for preset in "layers-as-published", "layers":
            model.ApplyPreset(preset)
            row.append(visitor.picture())
        visitor.rays().SetModel(ours)
        visitor.rays().SetIntensity(0.7)
        row.append(visitor.picture())
        rows.append(row)
        visitor.press("n")
    write(rows, "facade.jpg")
    visitor.GetRenderWindow().SetSize(800, 600)
    measure(visitor, "facade", "layers")
    visitor.press("n")
    measure(visitor, "facade, near", "layers")


folder = sys.argv[1]
print("| sum | root mean square error, % of the peak | largest |\n|---|---|---|")
visit("Statue", visit_statue)
visit("Facade", visit_facade)
