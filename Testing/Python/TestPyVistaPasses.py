# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rays on PyVista's plotters: with its other effects, before and after them, and in subplots."""

from pyvista_testing import *

import godrays

EFFECTS = {
    "nothing": lambda plotter: None,
    "depth peeling": lambda plotter: plotter.enable_depth_peeling(8),
    "shadows": lambda plotter: plotter.enable_shadows(),
    "SSAO": lambda plotter: plotter.enable_ssao(radius=0.4, kernel_size=64),
    "EDL": lambda plotter: plotter.enable_eye_dome_lighting(),
    "depth of field": lambda plotter: plotter.enable_depth_of_field(),
    "FXAA": lambda plotter: plotter.enable_anti_aliasing("fxaa"),
    "SSAA": lambda plotter: plotter.enable_anti_aliasing("ssaa", all_renderers=False),
    "MSAA": lambda plotter: plotter.enable_anti_aliasing("msaa", multi_samples=8),
    "SSAO and SSAA": lambda plotter: (
        plotter.enable_ssao(radius=0.4, kernel_size=64),
        plotter.enable_anti_aliasing("ssaa"),
    ),
    "EDL and depth of field": lambda plotter: (
        plotter.enable_eye_dome_lighting(),
        plotter.enable_depth_of_field(),
    ),
}


class Effects(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        plotter = make_plotter()
        rays = godrays.enable(plotter, **SHAFTS)
        cls.light = light_of(*with_and_without(plotter, rays))
        plotter.close()

    def test_both_orders(self):
        check_effects(self, EFFECTS)

    def pictures(self, effect, rays_first):
        """With rays and without, and their plan; without an order, the effect alone."""
        plotter = make_plotter()
        if rays_first is True:
            rays = godrays.enable(plotter, **SHAFTS)
        effect(plotter)
        if rays_first is False:
            rays = godrays.enable(plotter, **SHAFTS)
        if rays_first is None:
            show(plotter)
            result = show(plotter)
        else:
            result = (*with_and_without(plotter, rays), rays.GetPlan())
        plotter.close()
        return result

    def test_effects_come_and_go(self):
        plotter = make_plotter()
        rays = godrays.enable(plotter, **SHAFTS)
        first = show(plotter)
        for on, off in (
            ("enable_ssao", "disable_ssao"),
            ("enable_eye_dome_lighting", "disable_eye_dome_lighting"),
            ("enable_depth_of_field", "disable_depth_of_field"),
        ):
            with self.subTest(on):
                getattr(plotter, on)()
                self.assertGreater(difference(show(plotter), first)[0], 0.1)
                getattr(plotter, off)()
                self.assertEqual(difference(show(plotter), first), (0, 0))
        plotter.enable_ssao(radius=0.4)
        show(plotter)
        godrays.disable(plotter)
        picture = show(plotter)
        plotter.close()
        plotter = make_plotter()
        plotter.enable_ssao(radius=0.4)
        self.assertEqual(difference(show(plotter), picture), (0, 0))
        plotter.close()


class Subplots(unittest.TestCase):
    def test_the_active_renderer_alone(self):
        plotter = make_plotter(shape=(1, 2), border=False)
        plotter.subplot(0, 1)
        fill(plotter)
        half = SIZE[0] // 2
        bare = show(plotter)
        rays = godrays.enable(plotter, **SHAFTS)
        self.assertIsNone(plotter.renderers[0].GetPass())
        picture = show(plotter)
        self.assertEqual(difference(picture[:, :half], bare[:, :half]), (0, 0))
        self.assertGreater(difference(picture[:, half:], bare[:, half:])[0], 2)

        # a renderer of PyVista by itself; each subplot has rays of its own
        other = godrays.enable(plotter.renderers[0], **SHAFTS)
        self.assertIsNot(rays, other)
        both = show(plotter)
        self.assertEqual(difference(both[:, half:], picture[:, half:]), (0, 0))
        self.assertLess(difference(both[:, :half], both[:, half:])[0], 0.1)  # the same scene

        godrays.disable(plotter.renderers[0])
        self.assertEqual(difference(show(plotter), picture), (0, 0))
        godrays.disable(plotter)
        plotter.close()

    def test_an_effect_in_the_other_subplot(self):
        for name in ("SSAO", "SSAA", "depth peeling"):
            with self.subTest(name):
                plotter = make_plotter(shape=(1, 2), border=False)
                plotter.subplot(0, 1)
                fill(plotter)
                half = SIZE[0] // 2
                rays = godrays.enable(plotter, **SHAFTS)
                picture = show(plotter)
                plotter.subplot(0, 0)
                EFFECTS[name](plotter)
                self.assertEqual(difference(show(plotter)[:, half:], picture[:, half:]), (0, 0))
                self.assertIn("light: directional", rays.GetPlan())
                plotter.close()


if __name__ == "__main__":
    unittest.main()
