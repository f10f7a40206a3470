# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A head in a CT scanner, in dust: a lamp in the skull, whose light leaves through its openings."""

import plistlib
import tarfile

import godrays
import numpy
import stage
import vtkmodules.all as vtk

# A project of InVesalius: numbers in Hounsfield units, slice by slice, and what tells of them.
name = stage.find("doc/invesalius-examples/examples/Cranium.inv3", "invesalius-examples")
with tarfile.open(name) as project:
    files = {member.name.split("/")[-1]: member for member in project.getmembers()}
    about = plistlib.load(project.extractfile(files["main.plist"]))
    shape = about["matrix"]["shape"]
    values = numpy.frombuffer(project.extractfile(files["matrix.dat"]).read(), about["matrix"]["dtype"])
image = stage.image_of(values.reshape(shape), about["spacing"])

smooth = vtk.vtkImageGaussianSmooth()
smooth.SetInputData(image)
smooth.SetStandardDeviation(0.7)
bone = vtk.vtkFlyingEdges3D()
bone.SetInputConnection(smooth.GetOutputPort())
bone.SetValue(0, 280)  # [HU]
largest = vtk.vtkPolyDataConnectivityFilter()
largest.SetInputConnection(bone.GetOutputPort())
largest.SetExtractionModeToLargestRegion()

renderer = vtk.vtkRenderer()
renderer.SetBackground(0.015, 0.02, 0.035)
actor = stage.add(renderer, largest, (0.93, 0.88, 0.78))
actor.GetProperty().SetSpecular(0.15)
x0, x1, y0, y1, z0, z1 = actor.GetBounds()
middle = numpy.array([(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2])
size = z1 - z0
renderer.AddLight(stage.light((-1, 1.6, 0.8), (0.85, 0.9, 1), intensity=0.9))
lamp = stage.light(middle + (0, 0.05 * size, 0.03 * size), (1, 0.72, 0.4), positional=True)
rays = godrays.enable(renderer, light=lamp, preset="dust", optical_depth=0.5, intensity=2.2)
stage.look(renderer, middle + (-1.9 * size, 2.6 * size, 0.35 * size), middle + (0, 0, -0.08 * size), 27)
window = stage.show(renderer)
