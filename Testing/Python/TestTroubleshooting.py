# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What Documentation/Troubleshooting.md says of causes and remedies is so, row by row."""

import pathlib
import sys
import unittest
import warnings

import godrays
import numpy
import vtkmodules.all as vtk

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import TestCookbook as cookbook

NAMES = {}
exec(compile(cookbook.Recipes((4, 3)).setup, "setup", "exec"), NAMES)


def scene(background=(0.02, 0.04, 0.08), hall=False):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(background)
    renderer.AddActor(NAMES["shell"])
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(240, 180)
    window.AddRenderer(renderer)
    if hall:
        for part in NAMES["hall"]:
            renderer.AddActor(part)
        renderer.SetActiveCamera(NAMES["inside"])
        renderer.ResetCameraClippingRange()
    else:
        renderer.ResetCamera()
    return window, renderer


def structure(rays, window):
    """How much shadows change of the picture [levels]; the pass is left as it was."""
    picture = cookbook.read(window).astype(float)
    former = rays.untagged_props_occlude
    rays.untagged_props_occlude = False
    open_air = cookbook.read(window).astype(float)
    rays.untagged_props_occlude = former
    return cookbook.shafts(picture, open_air)


BEHIND = (0.02, 0.03, -1)  # a sun behind the scene, seen from the positive z axis


class Causes(unittest.TestCase):
    def setUp(self):
        warnings.simplefilter("ignore", godrays.GodRaysWarning)

    def test_a_sun_beyond_the_picture(self):
        window, renderer = scene()
        rays = godrays.enable(renderer, light=(0, 0, 1))
        window.Render()
        self.assertIn("no light reaches the picture", rays.plan)
        godrays.enable(renderer, sun_at=(0.5, 0.6))
        self.assertGreater(structure(rays, window), 3)
        window, renderer = scene(hall=True)  # a medium: lights count everywhere
        rays = godrays.enable(renderer, light=(0.4, -1, 0.5), preset="dust")
        window.Render()
        self.assertNotIn("no light reaches", rays.plan)
        self.assertIsNotNone(rays.scattering)

    def test_nothing_blocks(self):
        window, renderer = scene()
        rays = godrays.enable(renderer, light=BEHIND, untagged_props_occlude=False)
        without = structure(rays, window)
        godrays.enable(renderer, occluders=[NAMES["shell"]])
        self.addCleanup(godrays.tag, NAMES["shell"], "automatic")
        picture = cookbook.read(window).astype(float)
        godrays.tag(NAMES["shell"], "automatic")
        open_air = cookbook.read(window).astype(float)
        self.assertLess(without, 1e-6)
        self.assertGreater(cookbook.shafts(picture, open_air), 3)

    def test_a_light_background(self):
        found = {}
        for background in (0.02, 0.02, 0.02), (1, 1, 1):
            window, renderer = scene(background)
            rays = godrays.enable(renderer, light=BEHIND, darken_light_background=False)
            found[background[0]] = structure(rays, window)
            if background[0] == 1:
                rays.darken_light_background = True
                darkened = structure(rays, window)
        self.assertGreater(found[0.02], 3 * found[1])
        self.assertGreater(darkened, 1.5 * found[1])

    def test_weak_for_the_sake_of_data(self):
        window, renderer = scene()
        rays = godrays.enable(renderer, light=BEHIND)
        once = structure(rays, window)
        rays.intensity = 2
        self.assertGreater(structure(rays, window), 1.2 * once)
        rays.data_first = True
        data = cookbook.read(window).astype(float)
        rays.intensity = 0
        plain = cookbook.read(window).astype(float)
        shell = numpy.abs(plain - plain[0, 0]).max(2) > 60
        self.assertLess(numpy.median(numpy.abs(data - plain)[shell]), 30)

    def test_a_medium_of_another_unit(self):
        window, renderer = scene()
        rays = godrays.enable(renderer, light=BEHIND, preset="fog", world_unit_in_meters=0.01)
        window.Render()
        self.assertIn("the medium hardly shows", rays.advice)
        rays.model.world_unit_in_meters = 10000
        window.Render()
        self.assertIn("the medium hides the scene", rays.advice)
        rays.model.world_unit_in_meters = 0
        rays.model.optical_depth = 0.3
        window.Render()
        self.assertNotIn("the medium", rays.advice)

    def test_a_sheet_of_light(self):
        window, renderer = scene()
        rays = godrays.enable(renderer, light=BEHIND, preset="long-shafts", exposure=6.0)
        self.assertFalse(rays.automatic_exposure)
        sheet = cookbook.read(window).astype(float)
        rays.automatic_exposure = True
        mended = cookbook.read(window).astype(float)
        self.assertGreater(numpy.median(sheet.min(2)), 170)
        self.assertLess(numpy.median(mended.min(2)), 100)

    def test_dark_in_a_room(self):
        window, renderer = scene(hall=True)
        rays = godrays.enable(renderer, light=(-0.5, 1, 0.5), preset="dust")
        dark = structure(rays, window)
        rays.intensity = 4
        self.assertGreater(structure(rays, window), 1.3 * dark)

    def test_dim_in_a_medium(self):
        window, renderer = scene()
        rays = godrays.enable(renderer, light=BEHIND, preset="smoke", optical_depth=2.0)
        dim = cookbook.read(window).astype(float)
        rays.model.attenuate_scene = False
        self.assertGreater(cookbook.read(window).mean(), dim.mean() + 3)

    def test_a_layer_alone(self):
        window, renderer = scene()
        rays = godrays.enable(renderer, light=BEHIND, output="occlusion")
        layer = cookbook.read(window).astype(float)
        rays.output = "composite"
        whole = cookbook.read(window).astype(float)
        shell = slice(60, 120), slice(90, 150)
        self.assertGreater(numpy.ptp(whole[shell], axis=2).mean(), 2 * numpy.ptp(layer[shell], axis=2).mean())

    def test_shadows_on_surfaces(self):
        window, renderer = scene()
        ground = NAMES["box"](-2, 2, -2, 2, -1.1, -1.0, color=(1, 1, 1))
        renderer.AddActor(ground)
        sun = vtk.vtkLight()
        sun.SetPosition(0.2, 0.3, 1)
        renderer.AddLight(sun)
        shadows = godrays.shadows(renderer)
        black = cookbook.read(window).astype(float)
        weak = vtk.vtkLight()
        weak.SetLightTypeToHeadlight()
        weak.SetIntensity(0.3)
        renderer.AddLight(weak)
        mended = cookbook.read(window).astype(float)
        before, after = ((each.max(2) < 3).mean() for each in (black, mended))
        print(f"black in shadow: {before:.3f} of the picture, with a headlight {after:.3f}", flush=True)
        self.assertGreater(before, 0.01)
        self.assertLess(after, 0.1 * before)

        renderer.RemoveActor(ground)
        half = cookbook.read(window).astype(float)
        shadows.most_data_shadow = 1
        whole = cookbook.read(window).astype(float)
        shadows.surface_shadows = False
        without = cookbook.read(window).astype(float)
        self.assertGreater((without - whole).mean(), 1.5 * (without - half).mean())
        self.assertGreater((without - half).mean(), 0.1)

    def test_night_under_a_sky(self):
        window, renderer = scene()
        renderer.GetActiveCamera().SetPosition(0, -4, 2)
        renderer.GetActiveCamera().SetViewUp(0, 0, 1)
        renderer.ResetCamera()
        sun, weak = vtk.vtkLight(), vtk.vtkLight()
        weak.SetLightTypeToHeadlight()
        renderer.AddLight(sun)
        sky = godrays.sky(renderer, sun=(0, -2), light=sun)
        shell = slice(70, 110), slice(100, 140)
        dark = cookbook.read(window).astype(float)[shell].mean()
        sky.SetExposure(100 * sky.GetExposure())
        exposed = cookbook.read(window).astype(float)[shell].mean()
        sky.SetExposure(sky.GetExposure() / 100)
        renderer.AddLight(weak)
        lit = cookbook.read(window).astype(float)[shell].mean()
        print(f"data at dusk: {dark:.0f} levels, exposed {exposed:.0f}, by a headlight {lit:.0f}", flush=True)
        self.assertLess(dark, 20)
        self.assertGreater(exposed, dark + 30)
        self.assertGreater(lit, dark + 30)


if __name__ == "__main__":
    unittest.main()
