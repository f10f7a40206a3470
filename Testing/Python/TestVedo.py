# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rays on vedo's plotters: with its effects, before and after them, and in one of several renderers."""

import functools

from light_testing import *

try:
    import vedo
except ImportError as error:
    skip("vedo", error)

import godrays

vedo.settings.default_backend = "vtk"

EFFECTS = {
    "nothing": lambda plotter: None,
    "ambient occlusion": lambda plotter: plotter.add_ambient_occlusion(0.4),
    "depth of field": lambda plotter: plotter.add_depth_of_field(),
    "shadows": lambda plotter: plotter.add_shadows(),
    "depth peeling": lambda plotter: plotter.use_depth_peeling(),
}


def make_plotter(effect=None, rays_first=None, **parameters):
    """A plotter with balls over a plain, and its rays."""
    plotter = vedo.Plotter(offscreen=True, size=SIZE, bg="black", **parameters)
    rays = None
    if rays_first is True:
        rays = godrays.enable(plotter, **SHAFTS)
    if effect:
        effect(plotter)
    if rays_first is False:
        rays = godrays.enable(plotter, **SHAFTS)
    fill(plotter)
    return plotter, rays


def fill(plotter):
    """Put the scene into the active renderer."""
    balls = [vedo.Sphere((x, 0.3 * x + 0.3, 0), r=0.4).c("tan") for x in (-1.2, 0, 1.2)]
    plain = vedo.Plane(pos=(0, -0.9, 0), normal=(0, 1, 0), s=(6, 6)).c("steelblue")
    plotter.show(
        *balls, plain,
        camera={"pos": (0, 0.6, 6), "focal_point": (0, 0, 0), "viewup": (0, 1, 0)},
        resetcam=False, interactive=False)


def show(plotter):
    plotter.render()
    return plotter.screenshot(asarray=True)


with_and_without = functools.partial(with_and_without, show)


class Effects(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        plotter, rays = make_plotter(rays_first=False)
        cls.light = light_of(*with_and_without(plotter, rays))
        plotter.close()

    def test_both_orders(self):
        check_effects(self, EFFECTS)

    def pictures(self, effect, rays_first):
        """With rays and without, and their plan; without an order, the effect alone."""
        plotter, rays = make_plotter(effect, rays_first)
        if rays is None:
            show(plotter)
            result = show(plotter)
        else:
            result = (*with_and_without(plotter, rays), rays.GetPlan())
        plotter.close()
        return result


class Renderers(unittest.TestCase):
    def test_the_active_one_alone(self):
        plotter = vedo.Plotter(offscreen=True, size=SIZE, bg="black", N=2, sharecam=False)
        for i in (0, 1):
            plotter.at(i)
            fill(plotter)
        bare = show(plotter)
        half = SIZE[0] // 2
        rays = godrays.enable(plotter.at(1), **SHAFTS)
        self.assertIs(plotter.renderers[1].GetPass(), rays)
        self.assertIsNone(plotter.renderers[0].GetPass())
        picture = show(plotter)
        self.assertEqual(difference(picture[:, :half], bare[:, :half]), (0, 0))
        self.assertGreater(difference(picture[:, half:], bare[:, half:])[0], 2)

        other = godrays.enable(plotter.renderers[0], **SHAFTS)
        self.assertIsNot(other, rays)
        both = show(plotter)
        self.assertEqual(difference(both[:, half:], picture[:, half:]), (0, 0))
        godrays.disable(plotter.at(1))
        godrays.disable(plotter.at(0))
        self.assertEqual(difference(show(plotter), bare), (0, 0))
        plotter.close()

    def test_objects_are_lights_and_occluders(self):
        plotter = vedo.Plotter(offscreen=True, size=SIZE, bg="black")
        lamp = vedo.Sphere((0, 0.5, -3), r=0.3).c("yellow").lighting("off")
        ball = vedo.Sphere((1, 0, 0), r=0.4)
        rays = godrays.enable(plotter, light=lamp, occluders=[ball])
        # to vedo 2023, an object is its actor
        self.assertEqual(rays.GetRole(getattr(lamp, "actor", lamp)), rays.LIGHT)
        self.assertEqual(rays.GetRole(getattr(ball, "actor", ball)), rays.OCCLUDER)
        plotter.close()


if __name__ == "__main__":
    unittest.main()
