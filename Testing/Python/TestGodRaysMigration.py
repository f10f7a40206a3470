# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of other programs give here what their own formulas give."""

import math
import pathlib
import re
import unittest
import warnings

import godrays
import numpy
import vtkmodules.all as vtk

PAGE = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Migration.md"
FUNCTIONS = [name for name in godrays.__all__ if name.startswith("from_")]


def plate(distance, color=(1, 1, 1)):
    """A plate that fills the picture of an eye at the origin that looks along y, and its window."""
    source = vtk.vtkPlaneSource()
    source.SetOrigin(-2 * distance, distance, -2 * distance)
    source.SetPoint1(2 * distance, distance, -2 * distance)
    source.SetPoint2(-2 * distance, distance, 2 * distance)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetColor(color)
    renderer = vtk.vtkRenderer()
    renderer.AddActor(actor)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(65, 49)  # with a pixel in the middle
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, 0, 0)
    camera.SetFocalPoint(0, 1, 0)
    camera.SetViewUp(0, 0, 1)
    camera.SetClippingRange(distance / 100, 3 * distance)
    return window, renderer, actor


def geometric(ratio, count):
    return sum(ratio**k for k in range(count))


class Looks(unittest.TestCase):
    """A layer that is 1 everywhere has a sum that can be written down."""

    def light(self, settings):
        window, renderer, actor = plate(10)
        rays = godrays.enable(renderer, light=actor, precision="single", **settings)
        window.Render()
        return float(rays.scattering[24, 32, 1])

    def test_pmndrs(self):
        given = {"density": 0.9, "decay": 0.93, "weight": 0.5, "exposure": 0.3, "samples": 40, "clampMax": 9}
        self.assertAlmostEqual(self.light(godrays.from_pmndrs(given)), 0.3 * 0.5 * geometric(0.93, 40), places=4)
        self.assertAlmostEqual(
            self.light(godrays.from_pmndrs({"clampMax": 9})), 0.6 * 0.4 * geometric(0.9, 60), places=4)
        self.assertAlmostEqual(self.light(godrays.from_pmndrs({})), 1, places=4)

    def test_babylon(self):
        expected = 0.4 * 0.2 * (1 + 0.5 * geometric(0.96815, 100))
        given = {"exposure": 0.2, "weight": 0.5}
        self.assertAlmostEqual(self.light(godrays.from_babylon(given)), expected, places=4)

    def test_threejs(self):
        self.assertAlmostEqual(self.light(godrays.from_threejs({"fGodRayIntensity": 0.5})), 0.5, places=4)


class Media(unittest.TestCase):
    def depths(self, settings, distance):
        """The optical depth and the scene's distance at the middle of the picture."""
        window, renderer, _ = plate(distance)
        godrays.enable(renderer, light=(0, 0, 1), **settings)
        found = godrays.measure(renderer)
        return found["OpticalDepth"][24, 32], float(found["Depth"][24, 32])

    def test_unity(self):
        even = godrays.from_unity({"meanFreePath": 50, "albedo": (0.9, 0.5, 0.1), "maximumHeight": 0})
        tau, depth = self.depths(even, 20)
        numpy.testing.assert_allclose(tau, 20 / 50, rtol=1e-3)
        self.assertAlmostEqual(depth, 20, places=2)
        numpy.testing.assert_allclose(even["scattering_coefficient"], (0.018, 0.01, 0.002))
        high = godrays.from_unity({"meanFreePath": 50, "baseHeight": -10, "maximumHeight": 40})
        tau, _ = self.depths(high, 20)  # a level view at 10 m above the base of 50 m of fog
        numpy.testing.assert_allclose(tau, 20 / 50 * 0.001 ** (10 / 50), rtol=2e-3)

    def test_unreal(self):
        settings = godrays.from_unreal({"FogDensity": 0.5, "FogHeightFalloff": 2, "FogHeight": -300})
        tau, _ = self.depths(settings, 1500)  # [cm]
        numpy.testing.assert_allclose(tau, 0.5 * 0.5 / 1000 * 2 ** (-2 / 1000 * 300) * 1500, rtol=2e-3)

    def test_blender(self):
        settings = godrays.from_blender(
            {"Color": (0.8, 0.5, 0.2), "Density": 0.1, "Absorption Color": (0.25, 0, 0), "Anisotropy": 0.4})
        tau, _ = self.depths(settings, 10)
        numpy.testing.assert_allclose(tau, (0.8 + 0.2 * 0.5, 1, 1), rtol=1e-3)
        self.assertEqual(settings["asymmetry"], 0.4)

    def test_good_godrays(self):
        """Where all of the view ray is lit, the light's colour is mixed in by 1 - e^(-density s)."""
        window, renderer, actor = plate(60)
        rays = godrays.enable(
            renderer, light=(0, 0, 1), untagged_props_occlude=False, **godrays.from_good_godrays({"density": 0.02}))
        window.Render()
        self.assertEqual(rays.intensity, 4)
        self.assertAlmostEqual(
            float(4 * rays.scattering[24, 32, 1]), 1 - math.exp(-0.02 * 60), delta=0.004)


class Words(unittest.TestCase):
    def test_all_are_accepted_by_enable(self):
        for name in FUNCTIONS:
            with self.subTest(name):
                window, renderer, _ = plate(10)
                godrays.enable(renderer, light=(0, 1, 1), **getattr(godrays, name)({}))
                window.Render()

    def test_defaults_are_told(self):
        for name in FUNCTIONS:
            with self.subTest(name):
                self.assertIn(" default", getattr(godrays, name).__doc__)

    def test_what_is_unknown_or_has_no_counterpart(self):
        for name in FUNCTIONS:
            with self.subTest(name):
                with self.assertRaisesRegex(ValueError, f"{name} does not know 'colour'; .*[Tt]here are: \\w+"):
                    getattr(godrays, name)({"colour": 1})
        with self.assertWarnsRegex(godrays.GodRaysWarning, "kernelSize has no counterpart: "):
            godrays.from_pmndrs({"kernelSize": 3})
        for wrong in float("nan"), (1, 2), "much":
            with self.assertRaises((ValueError, TypeError)):
                godrays.from_pmndrs({"density": wrong})
        with self.assertRaisesRegex(ValueError, "meanFreePath=0 should be above 0"):
            godrays.from_unity({"meanFreePath": 0})

    def test_the_page_names_all(self):
        text = PAGE.read_text(encoding="utf-8")
        self.assertEqual(sorted(set(re.findall(r"`godrays\.(from_\w+)\(", text))), sorted(FUNCTIONS))


if __name__ == "__main__":
    warnings.simplefilter("default")
    unittest.main()
