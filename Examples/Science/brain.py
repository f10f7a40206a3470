# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A scanned brain, lit from within: the surface of its cortex in bands, through whose gaps a lamp shines."""

import sys

import godrays
import numpy
import stage
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

reader = vtk.vtkNIFTIImageReader()
reader.SetFileName(stage.find("mricron/templates/ch2bet.nii.gz", "mricron-data"))  # 1 mm between samples
smooth = vtk.vtkImageGaussianSmooth()
smooth.SetStandardDeviation(0.8)
smooth.SetInputConnection(reader.GetOutputPort())
shrink = vtk.vtkImageShrink3D()
shrink.SetShrinkFactors(*[2 if "320x180" in sys.argv else 1] * 3)
shrink.SetInputConnection(smooth.GetOutputPort())
cortex = vtk.vtkFlyingEdges3D()
cortex.SetValue(0, 75)
cortex.SetInputConnection(shrink.GetOutputPort())
largest = vtk.vtkPolyDataConnectivityFilter()
largest.SetExtractionModeToLargestRegion()
largest.SetInputConnection(cortex.GetOutputPort())
largest.Update()

brain = largest.GetOutput()
points = vtk_to_numpy(brain.GetPoints().GetData())
middle = numpy.array(brain.GetCenter())
bands = numpy.sin((points[:, 2] - points[:, 2].min()) * 2 * numpy.pi / 11) + 0.3  # 11 mm from band to band
scalars = stage.numpy_to_vtk(bands.astype(numpy.float32), deep=True)
scalars.SetName("bands")
brain.GetPointData().SetScalars(scalars)
slabs = vtk.vtkClipPolyData()
slabs.SetInputData(brain)
slabs.SetValue(0)
heights = vtk.vtkElevationFilter()
heights.SetLowPoint(0, 0, points[:, 2].min())
heights.SetHighPoint(0, 0, points[:, 2].max())
heights.SetInputConnection(slabs.GetOutputPort())

renderer = vtk.vtkRenderer()
renderer.SetBackground(0.01, 0.015, 0.03)
table = stage.colors((0, "#3f6fd0"), (0.4, "#b05fa8"), (0.7, "#f08a70"), (1, "#ffdca0"))
actor = stage.add(renderer, heights, table=table)
actor.GetProperty().SetSpecular(0.2)
actor.GetProperty().SetSpecularPower(20)
renderer.AddLight(stage.light((-1, 1, 0.6), (0.85, 0.9, 1), intensity=1.0))
lamp = stage.light(middle + (0, 8, 20), (1, 0.75, 0.45), positional=True)
rays = godrays.enable(renderer, light=lamp, source_radius=22, preset="low-sun", intensity=2.5)
stage.look(renderer, middle + (-370, 170, 60), middle + (0, 0, -3), 24)
window = stage.show(renderer)
