# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters in ParaView's pipeline."""

from plugin_testing import *


def make_picture():
    """A disc of light behind bars, 64 x 48, that moves to the right with time."""
    source = simple.ProgrammableSource(OutputDataSetType="vtkImageData")
    source.ScriptRequestInformation = """
from paraview import util
util.SetOutputWholeExtent(self, [0, 63, 0, 47, 0, 0])
info = self.GetOutputInformation(0)
info.Set(self.GetExecutive().TIME_STEPS(), [0.0, 1.0], 2)
info.Set(self.GetExecutive().TIME_RANGE(), [0.0, 1.0], 2)
"""
    source.Script = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
image = self.GetImageDataOutput()
image.SetExtent(0, 63, 0, 47, 0, 0)
info = self.GetOutputInformation(0)
time = info.Get(self.GetExecutive().UPDATE_TIME_STEP()) or 0.0
y, x = numpy.mgrid[0:48, 0:64]
light = (numpy.hypot(x - 20 - 16 * time, y - 24) < 8) & (x % 6 > 1)
for name, values in (("Dark", 0 * x), ("Light", light)):
    array = numpy_to_vtk(values.ravel().astype(numpy.float32), deep=True)
    array.SetName(name)
    image.GetPointData().AddArray(array)
"""
    return source


class Menus(Case):
    def result(self, proxy):
        proxy.UpdatePipeline()
        data = simple.servermanager.Fetch(proxy)
        return vtk_to_numpy(data.GetPointData().GetArray("Light")).reshape(48, 64).astype(float)

    def test_filters(self):
        picture = make_picture()
        exact = simple.GodRaysReferenceFilter(Input=picture)
        fast = simple.GodRaysScatteringFilter(Input=picture)
        for each in (exact, fast):
            each.SelectInputScalars = ["POINTS", "Light"]
            each.LightClip = [-0.3, 0.0, 1.0]
        expected, actual = self.result(exact), self.result(fast)
        self.assertGreater(expected.max(), 0.1)
        rms = numpy.sqrt(((actual - expected) ** 2).mean())
        self.assertLess(rms, fast.ErrorTolerance * expected.max())
        fast.Density = 0.5
        self.assertGreater(abs(self.result(fast) - expected).max(), 0.05)
        exact.SelectInputScalars = ["POINTS", "Dark"]
        exact.UpdatePipeline()
        data = simple.servermanager.Fetch(exact).GetPointData()
        self.assertEqual(data.GetArray("Dark").GetRange(), (0.0, 0.0))

    def test_light_in_a_medium(self):
        """A ball before a lamp."""
        reference = simple.GodRaysSingleScatteringReference(
            Input=simple.Sphere(Center=[0, 0, -3], Radius=0.4, ThetaResolution=48, PhiResolution=48)
        )
        reference.Size = [96, 72]
        reference.Light = [0.1, 0.2, -5.0, 1.0]
        reference.FarLimit = 10.0

        def draw():
            reference.UpdatePipeline()
            data = simple.servermanager.Fetch(reference).GetPointData()
            return vtk_to_numpy(data.GetArray("Radiance"))[:, 0]

        shadowed = draw()
        reference.Input = simple.Sphere(Center=[0, 9, 9], Radius=0.4)
        lit = draw()
        self.assertGreater(lit.max(), 0.0)
        self.assertTrue((shadowed <= lit).all())
        self.assertGreater(numpy.sqrt(((lit - shadowed) ** 2).mean()), 0.1 * numpy.percentile(lit, 99))

    def test_visibility(self):
        """Signs in fog, one behind a wall."""
        signs = simple.Line(Point1=[10, 0, 0], Point2=[100, 0, 0], Resolution=1)
        wall = simple.Plane(Origin=[50, -5, -5], Point1=[50, 5, -5], Point2=[50, -5, 5])
        seen = simple.GodRaysVisibilityFilter(Input=signs)
        seen.ScatteringCoefficient = [0.03] * 3

        def array(name):
            seen.UpdatePipeline()
            data = simple.servermanager.Fetch(seen).GetPointData()
            return list(vtk_to_numpy(data.GetArray(name)))

        numpy.testing.assert_allclose(array("Contrast"), numpy.exp([-0.3, -3.0]), 1e-6)
        self.assertEqual(array("Visible"), [1, 1])
        seen.ContrastThreshold = 0.05
        self.assertEqual(array("Visible"), [1, 0])
        self.assertEqual(array("Hidden"), [0, 0])
        seen.Occluders = wall
        self.assertEqual(array("Hidden"), [0, 1])

    def test_time(self):
        picture = make_picture()
        rays = simple.GodRaysScatteringFilter(Input=picture)
        rays.SelectInputScalars = ["POINTS", "Light"]
        centres = []
        for time in (0.0, 1.0):
            rays.UpdatePipeline(time)
            data = simple.servermanager.Fetch(rays).GetPointData().GetArray("Light")
            values = vtk_to_numpy(data).reshape(48, 64)
            centres.append((values.sum(0) * numpy.arange(64)).sum() / values.sum())
        self.assertGreater(centres[1] - centres[0], 8.0)


main()
