# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""With defaults alone, scenes of many kinds keep their colours and have shafts, as Evidence/Defaults.md promises."""

import math
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Gallery"))

import numpy

import default_scenes
import default_situations
import defaults
import godrays

# thin, thick, grey, coloured, translucent, points and volumes
SCENES = (
    "cones", "exploded-sphere", "streamlines", "translucent-contours", "molecule", "canopy", "volume", "city", "gyroid",
    "lettering", "network", "lattice",
)


def draw_wedges(count, place, change=120):
    """Pictures without and with wedges of light, which fades with distance, behind bright data; what shows data."""
    width, height = defaults.SIZE
    y, x = numpy.mgrid[0:height, 0:width] + 0.5
    data = (numpy.hypot(x - 0.4 * width, y - 0.4 * height) < 0.2 * height) | (abs(x - 0.7 * width) < 0.02 * width)
    y, x = y - place[1] * height, x - place[0] * width
    is_lit = numpy.cos(count * numpy.arctan2(y, x)) > 0 if count else True
    light = change * is_lit * numpy.exp(-numpy.hypot(x, y) / height)
    before = numpy.where(data, 200.0, 20.0)[..., None] * numpy.ones(3)
    return before, before + (light * ~data)[..., None], data


class Defaults(unittest.TestCase):
    def test_promises(self):
        looks, before_white, media_before_white = [], [], []
        for name in SCENES:
            look, medium = defaults.measure_scene(name)
            looks.append(look)
            white, medium_before_white = defaults.measure_scene(name, "white")
            before_white.append(white)
            media_before_white.append(medium_before_white)
            with self.subTest(name):
                defaults.expect_colors(self, look)
                defaults.expect_colors(self, medium)
                self.assertGreater(medium.shafts, 0)
        self.assertGreaterEqual(numpy.mean([each.shafts for each in before_white]), 6)
        self.assertGreaterEqual(numpy.mean([each.shafts for each in media_before_white]), 2.5)
        for promises, numbers in ((defaults.PROMISES, looks), (defaults.BEFORE_WHITE, before_white)):
            for promise in promises:
                value, holds = promise.measure(numbers)
                with self.subTest(promise.what):
                    self.assertTrue(holds, f"{value:.3g}, promised {promise.bound}")

    def test_promises_are_broken_without_rays(self):
        (before, *_), data, places = defaults.draw("cones", columns={"look": {}})
        numbers = [defaults.measure(before, before, data, places[0])]
        self.assertEqual((numbers[0].shafts, numbers[0].area, numbers[0].difference), (0, 0, 0))
        broken = [promise.number for promise in defaults.PROMISES if not promise.measure(numbers)[1]]
        self.assertEqual(broken, ["shafts", "shafts", "clear_shafts", "area"])

    def test_shafts_are_counted(self):
        for place in (0.5, 0.5), (0.55, 0.4), (0.1, 0.35), (0.6, 0.95):
            for count in (0, 1, 5, 12) if place[0] in (0.5, 0.55) else (0, 1):
                with self.subTest(place=place, count=count):
                    before, after, data = draw_wedges(count, place)
                    numbers = defaults.measure(before, after, data, place)
                    self.assertEqual((numbers.shafts, numbers.clear_shafts), (count, count))
                    self.assertEqual(numbers.area > 5, count > 0)
                    self.assertEqual((numbers.difference, numbers.lightness), (0, 0))

    def test_faint_shafts_are_not_clear(self):
        before, after, data = draw_wedges(5, (0.5, 0.5), 20)
        numbers = defaults.measure(before, after, data, (0.5, 0.5))
        self.assertEqual((numbers.shafts, numbers.clear_shafts), (5, 0))

    def test_data_are_measured(self):
        """Data that turn by 20 degrees of hue and shine, and mud behind them."""
        before, _, data = draw_wedges(0, (0.5, 0.5))
        before[data] = (200, 60, 60)
        after = before + numpy.where(data, 0, 40)[..., None]
        after[data] = (255, 60, 20)
        numbers = defaults.measure(before, after, data, (0.5, 0.5))
        old, new = (defaults.to_lab(numpy.array(color) + 0.0) for color in ((200, 60, 60), (255, 60, 20)))
        self.assertAlmostEqual(numbers.difference, math.dist(old, new))
        self.assertAlmostEqual(numbers.lightness, new[0] - old[0])
        turn = math.degrees(math.atan2(new[2], new[1]) - math.atan2(old[2], old[1]))
        self.assertAlmostEqual(numbers.hue, turn)
        self.assertAlmostEqual(numbers.clipped, 100)
        self.assertAlmostEqual(numbers.mud, 100)
        self.assertAlmostEqual(numbers.ground, defaults.to_lab(numpy.full(3, 60.0))[0])

    def test_a_volume_alone_has_the_light_of_a_medium_behind_it(self):
        _, data, ((x, y),) = defaults.draw("volume", columns={"medium": {"preset": "haze"}})
        column, row = round(x * defaults.SIZE[0]), round(y * defaults.SIZE[1])
        self.assertTrue(data[row - 10 : row + 10, column - 10 : column + 10].any(), (x, y))

    def test_translucent_without_peeling(self):
        """Data that leave neither depth nor their opacity in alpha."""
        window, renderer = default_situations.make("translucent", defaults.SIZE)
        renderer.UseDepthPeelingOff()
        window.SetMultiSamples(0)
        window.Render()
        before = defaults.read(window, "colour")
        data = numpy.abs(before - before[0, 0]).max(-1) > 2
        self.assertGreater(data.mean(), 0.05)
        for preset in ("default", "haze"):
            rays = godrays.enable(renderer, preset=preset)
            window.Render()
            after = defaults.read(window, "colour")
            numbers = defaults.measure(before, after, data, defaults.get_place(renderer, rays.GetLight(0)))
            godrays.disable(renderer)
            print(preset, numbers)
            with self.subTest(preset):
                defaults.expect_colors(self, numbers)
        window.Finalize()

    def test_smoke_has_no_outline(self):
        """Light is held back over a volume by as much as it hides, not at once where it begins."""
        window, renderer = default_scenes.make("smoke", (200, 140))
        window.SetMultiSamples(0)
        window.Render()
        before = defaults.to_light(defaults.read(window, "colour"))
        alpha = defaults.read(window, "alpha")[..., 3] / 255
        rays = godrays.enable(renderer)
        window.Render()
        change = defaults.to_light(defaults.read(window, "colour")) - before
        light = rays.scattering[::-1] * rays.GetExposure()
        # light that 8 bits show and that the shoulder does not hold back
        clear = (light.max(-1) > 0.02) & (light.max(-1) < 0.4)

        parts = []
        for least in numpy.arange(0, 0.6, 0.05):
            chosen = clear & (alpha > least) & (alpha <= least + 0.05)
            self.assertGreater(chosen.sum(), 20)
            parts.append(numpy.median((change / numpy.maximum(light, 1e-6))[chosen]))
        print("light over smoke of growing opacity:", numpy.round(parts, 2))
        self.assertGreater(parts[0], 0.9)
        self.assertLess(parts[-1], 0.3)
        self.assertLess(-numpy.diff(parts).min(), 0.2)
        window.Finalize()


if __name__ == "__main__":
    unittest.main()
