# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers of a medium: of a picture's pixels, against closed forms; files of them; the code of Numbers.md."""

import contextlib
import io
import math
import os
import pathlib
import re
import sys
import tempfile
import unittest
import warnings

import godrays
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray, vtkOutputWindow, vtkPoints, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import exr_reader

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Documentation" / "Gallery"))
import smoke_test

WIDTH, HEIGHT = 64, 48
SIGMA = numpy.array([0.03, 0.05, 0.08])  # extinction [1/m]
ARRAYS = {
    "Radiance": 3, "Transmittance": 3, "OpticalDepth": 3, "Depth": 1, "Distance_m": 1, "Contrast": 1,
    "MeteorologicalRange_m": 1}  # fmt: skip


def make_scene(unit=2.0, walls=True):
    """A wall 10 units before the camera that fills the lower left, a medium, and a sun."""
    renderer = vtkRenderer()
    if walls:
        cube = vtkCubeSource()
        cube.SetBounds(-50, 0, -50, 0, -1, 0)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(cube.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, 0, 10)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewAngle(40)
    camera.SetClippingRange(1, 100)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(WIDTH, HEIGHT)
    window.AddRenderer(renderer)
    medium = godrays.vtkGodRaysHomogeneousModel()
    medium.SetScatteringCoefficient(0.02, 0.05, 0.06)
    medium.SetAbsorptionCoefficient(0.01, 0.0, 0.02)
    medium.SetWorldUnitInMeters(unit)
    medium.SetFarLimit(30)
    rays = godrays.enable(renderer, light=(0.3, 0.2, 1.0), model=medium, precision="single")
    return window, renderer, rays, medium


def rays_per_depth(parallel=False):
    """Lengths of the view rays at depth 1, by pixel, rows from the bottom, and their directions."""
    tangent = math.tan(math.radians(20))
    y, x = numpy.mgrid[0:HEIGHT, 0:WIDTH]
    ray = numpy.stack([(2 * (x + 0.5) / WIDTH - 1) * tangent * WIDTH / HEIGHT,
                       (2 * (y + 0.5) / HEIGHT - 1) * tangent, -numpy.ones((HEIGHT, WIDTH))], -1)
    length = numpy.linalg.norm(ray, axis=-1)
    return length, ray / length[..., None]


class Numbers(unittest.TestCase):
    def setUp(self):
        self.messages = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.messages)
        self.addCleanup(vtkOutputWindow.SetInstance, None)

    def test_a_wall_in_fog(self):
        window, renderer, rays, medium = make_scene()
        self.assertFalse(rays.GetMediumImage(vtkImageData()))  # nothing was drawn
        found = godrays.measure(renderer)
        for name, components in ARRAYS.items():
            shape = (HEIGHT, WIDTH, 3) if components == 3 else (HEIGHT, WIDTH)
            self.assertEqual(found[name].shape, shape, name)
            self.assertGreaterEqual(found[name + "_Error"], 0)
        length, _ = rays_per_depth()
        wall = numpy.isfinite(found["Depth"])
        self.assertTrue(wall[: HEIGHT // 2, : WIDTH // 2].all())
        self.assertAlmostEqual(wall.mean(), 0.25, 2)
        error = abs(found["Depth"][wall] / 10 - 1).max()
        print("depth: error", error, "bound", found["Depth_Error"])
        self.assertLess(error, found["Depth_Error"])
        self.assertLess(found["Depth_Error"], 1e-4)
        way = 2.0 * length * numpy.where(wall, 10, 30)  # [m]
        numpy.testing.assert_allclose(found["Distance_m"][wall], way[wall], 2e-5)
        for c in range(3):
            tau = SIGMA[c] * way
            difference = abs(found["OpticalDepth"][..., c] - tau).max()
            self.assertLess(difference, found["OpticalDepth_Error"])
            difference = abs(found["Transmittance"][..., c] - numpy.exp(-tau)).max()
            self.assertLess(difference, found["Transmittance_Error"])
        print("optical depth: bound", found["OpticalDepth_Error"], "of", tau.max())
        self.assertLess(found["OpticalDepth_Error"], 1e-4)
        numpy.testing.assert_array_equal(found["Contrast"], found["Transmittance"][..., 1])
        numpy.testing.assert_allclose(found["MeteorologicalRange_m"], 3.912 / 0.05, 1e-4)
        # a control: another medium is seen in the next picture alone
        medium.SetScatteringCoefficient(0.1, 0.1, 0.1)
        again = godrays.measure(renderer)
        numpy.testing.assert_array_equal(again["OpticalDepth"], found["OpticalDepth"])
        window.Render()
        self.assertGreater(godrays.measure(renderer)["OpticalDepth"].max(), found["OpticalDepth"].max())
        self.assertEqual(self.messages.GetOutput(), "")

    def test_radiance(self):
        """Closed forms for a sun that nothing blocks, relative to it and in watts."""
        _, renderer, rays, medium = make_scene(walls=False)
        length, direction = rays_per_depth()
        sun = numpy.array([0.3, 0.2, 1.0]) / math.sqrt(1.13)
        g = medium.GetAsymmetry()
        phase = (1 - g * g) / (4 * math.pi * (1 + g * g - 2 * g * direction @ sun) ** 1.5)
        way = 60.0 * length
        found = godrays.measure(renderer)["Radiance"]
        for c, scattering in enumerate((0.02, 0.05, 0.06)):
            expected = scattering * phase * -numpy.expm1(-SIGMA[c] * way) / SIGMA[c]
            numpy.testing.assert_allclose(found[..., c], expected, 1e-4)
        watts = godrays.measure(renderer, irradiance=(1000, 800, 600))["Radiance"]
        numpy.testing.assert_allclose(watts, found * [1000, 800, 600], 1e-6)
        numpy.testing.assert_allclose(godrays.measure(renderer, 500)["Radiance"], 500 * found, 1e-6)
        rays.GetIntegrator().SetVerifyPixels(200)
        renderer.GetRenderWindow().Render()
        measured = godrays.measure(renderer)
        self.assertLess(measured["Radiance_Error"], 1e-4)
        rays.RemoveAllLights()  # the scene is dimmed, without light
        renderer.GetRenderWindow().Render()
        dark = godrays.measure(renderer)
        self.assertEqual(dark["Radiance"].max(), 0)
        numpy.testing.assert_array_equal(dark["OpticalDepth"], measured["OpticalDepth"])

    def test_an_atmosphere_is_what_the_filter_says(self):
        """Pixels, with a margin, in parallel and perspective, over a plane and a planet: as points."""
        window, renderer, rays, _ = make_scene()
        air = godrays.vtkGodRaysAtmosphereModel()
        air.SetMieScattering(5e-4, 6e-4, 7e-4)
        air.SetMieScaleHeight(300)
        air.SetWorldUnitInMeters(100)
        air.SetUp(0, 1, 0)
        air.SetGroundLevel(-6)
        air.SetFarLimit(30)
        rays.SetModel(air)
        rays.SetLayerMargin(0.25)
        points = godrays.vtkGodRaysVisibilityFilter()
        points.SetCameraPosition(0, 0, 10)
        points.SetScatteringCoefficient(*(100 * numpy.array(air.GetMieScattering())))
        points.SetAbsorptionCoefficient(*(100 * numpy.array(air.GetMieAbsorption())))
        points.SetScaleHeight(3)
        points.SetGasScatteringCoefficient(*(100 * numpy.array(air.GetRayleighScattering())))
        points.SetGasScaleHeight(air.GetRayleighScaleHeight() / 100)
        points.SetMediumUp(0, 1, 0)
        points.SetGroundLevel(-6)
        points.SetWorldUnitInMeters(100)
        length, direction = rays_per_depth()
        camera = renderer.GetActiveCamera()
        for radius in (0.0, 6.36e6):
            for parallel in (False, True):
                with self.subTest(radius=radius, parallel=parallel):
                    air.SetPlanetRadius(radius)
                    points.SetPlanetRadius(radius / 100)
                    camera.SetParallelProjection(parallel)
                    camera.SetParallelScale(3)
                    window.Render()
                    found = godrays.measure(renderer)
                    for y, x in ((3, 5), (20, 31), (40, 50), (47, 0), (10, 60)):
                        eye = numpy.array([0.0, 0, 10])
                        ray, per = direction[y, x], length[y, x]
                        if parallel:
                            eye[0] = (2 * (x + 0.5) / WIDTH - 1) * 3 * WIDTH / HEIGHT
                            eye[1] = (2 * (y + 0.5) / HEIGHT - 1) * 3
                            ray, per = numpy.array([0, 0, -1.0]), 1.0
                        points.SetCameraPosition(*eye)
                        place = eye + ray * per * min(found["Depth"][y, x], 30)
                        target = vtkPoints()
                        target.SetDataTypeToDouble()
                        target.InsertNextPoint(*place)
                        data = vtkPolyData()
                        data.SetPoints(target)
                        points.SetInputData(data)
                        points.Update()
                        arrays = points.GetOutput().GetPointData()
                        tau = vtk_to_numpy(arrays.GetArray("OpticalDepth"))[0]
                        numpy.testing.assert_allclose(found["OpticalDepth"][y, x], tau, 1e-6)
                        self.assertGreater(tau[0], 0.01)
                        range_m = arrays.GetArray("MeteorologicalRange_m").GetValue(0)
                        self.assertAlmostEqual(found["MeteorologicalRange_m"][y, x] / range_m, 1, 5)
        self.assertEqual(self.messages.GetOutput(), "")

    def test_files(self):
        window, renderer, rays, _ = make_scene()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "numbers.vti")
            found = godrays.measure(renderer, irradiance=1361, file=path)
            reader = vtkXMLImageDataReader()
            reader.SetFileName(str(path))
            reader.Update()
            image = reader.GetOutput()
            for name in ARRAYS:
                array = image.GetPointData().GetArray(name)
                values = vtk_to_numpy(array).reshape(found[name].shape)
                numpy.testing.assert_array_equal(values, found[name])
                self.assertTrue(array.GetInformation().Get(vtkDataArray.UNITS_LABEL()), name)
                error = image.GetFieldData().GetArray(name + "_Error").GetValue(0)
                self.assertEqual(error, found[name + "_Error"])
            if godrays.vtkGodRaysEXRWriter.IsAvailable():
                path = pathlib.Path(folder, "numbers.exr")
                godrays.measure(renderer, irradiance=1361, file=path)
                channels, attributes = exr_reader.read(path)
                for name, components in ARRAYS.items():
                    layer = "" if name == "Radiance" else name + "."
                    for c in range(components):
                        channel = layer + "RGB"[c] if components == 3 else name
                        expected = found[name][..., c] if components == 3 else found[name]
                        numpy.testing.assert_array_equal(channels.pop(channel), expected)
                    error = attributes[name + "_Error"]
                    self.assertAlmostEqual(error / max(found[name + "_Error"], 1e-30), 1, 5)
                self.assertEqual(channels, {})
                self.assertEqual(attributes["Radiance_Unit"], "W m-2 sr-1")
                self.assertEqual(attributes["Distance_m_Unit"], "m")
            for name in ("none/a.vti", "none/a.exr"):
                with self.assertRaises((OSError, ValueError)):
                    godrays.measure(renderer, file=pathlib.Path(folder, name))
            with self.assertRaisesRegex(ValueError, r"\.vti or \.exr"):
                godrays.measure(renderer, file="a.png")

    @unittest.skipUnless(godrays.vtkGodRaysEXRWriter.IsAvailable(), "built without OpenEXR")
    def test_colours_with_opacity(self):
        values = numpy.arange(24, dtype=numpy.float32).reshape(2, 3, 4)
        image = vtkImageData()
        image.SetDimensions(3, 2, 1)
        for name in "Picture", "Glow":
            array = numpy_to_vtk((values + len(name)).reshape(6, 4), deep=1)
            array.SetName(name)
            image.GetPointData().AddArray(array)
        image.GetPointData().SetActiveScalars("Picture")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "layers.exr")
            writer = godrays.vtkGodRaysEXRWriter()
            writer.SetInputData(image)
            writer.SetFileName(str(path))
            writer.Write()
            channels, _ = exr_reader.read(path)
        for layer, name in ("", "Picture"), ("Glow.", "Glow"):
            for c, letter in enumerate("RGBA"):
                found = channels.pop(layer + letter)
                numpy.testing.assert_array_equal(found, values[..., c] + len(name))
        self.assertEqual(channels, {})

    def test_the_code_of_the_page(self):
        text = (ROOT / "Documentation" / "Numbers.md").read_text(encoding="utf-8")
        blocks = re.findall(r"```python\n(.*?)```", text, re.S)
        self.assertEqual(len(blocks), 2)
        printed = io.StringIO()
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(printed):
            os.chdir(folder)
            try:
                for block in blocks:
                    exec(compile(block, "Numbers.md", "exec"), {})
                self.assertTrue(os.path.exists("ball.vti"))
            finally:
                os.chdir(here)
        lines = printed.getvalue().splitlines()
        self.assertEqual(lines[0], "Contrast [0.3012, 0.0067]")
        self.assertTrue(lines[1].startswith("MeteorologicalRange_m [149.78"), lines[1])
        self.assertEqual(lines[2], "Visible [1.0, 0.0]")
        self.assertRegex(lines[3], r"^\(300, 300, 3\) 0\.\d+")
        self.assertEqual(self.messages.GetOutput(), "")

    def test_what_has_none(self):
        _, renderer, rays, medium = make_scene()
        with self.assertRaisesRegex(ValueError, "irradiance"):
            godrays.measure(renderer, irradiance=(1, 2))
        with self.assertRaisesRegex(ValueError, "irradiance"):
            godrays.measure(renderer, irradiance=math.nan)
        image = vtkImageData()
        renderer.GetRenderWindow().Render()
        self.assertTrue(rays.GetMediumImage(image))
        self.assertEqual(self.messages.GetOutput(), "")
        self.assertFalse(rays.GetMediumImage(image, (math.nan, 1, 1)))
        self.assertIn("irradiance must be three numbers", self.messages.GetOutput())
        self.assertEqual(image.GetNumberOfPoints(), 0)
        for change in (
            lambda: rays.SetModel(None),
            lambda: (rays.SetModel(medium), rays.SetOutput(rays.OCCLUSION)),
            lambda: (rays.SetOutput(rays.COMPOSITE), rays.SetIntensity(0)),
        ):
            change()
            renderer.GetRenderWindow().Render()
            self.assertFalse(rays.GetMediumImage(image))
            self.assertEqual(image.GetNumberOfPoints(), 0)
            with self.assertRaisesRegex(ValueError, "no light in a medium"):
                godrays.measure(renderer)
        lone = vtkRenderer()
        godrays.enable(lone, preset="fog")
        with self.assertRaisesRegex(ValueError, "no window"):
            godrays.measure(lone)
        godrays.disable(renderer)
        with self.assertRaisesRegex(ValueError, "enable"):
            godrays.measure(renderer)

    def test_smoke_test(self):
        """Of Accuracy.md: 1 m of soot as a volume leaves 111 of 255 of white, shown as 176."""
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # smoke is seen
            through, beside = smoke_test.draw((96, 64))[2]
        self.assertLess(abs(through[0] - 0.43668), 2.2e-5)
        self.assertEqual(round(255 * through[0]), 111)
        self.assertIn(through[1], (176, 177))
        self.assertEqual(beside, (1.0, 255))  # the control


if __name__ == "__main__":
    unittest.main()
