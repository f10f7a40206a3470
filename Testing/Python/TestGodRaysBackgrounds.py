# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shafts are seen before every kind of background, and data keep their colours, by the defaults."""

import pathlib
import sys
import unittest

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Gallery"))

import default_scenes
import defaults

defaults.SIZE = (300, 210)


class Backgrounds(unittest.TestCase):
    def test_all(self):
        pictures = {}
        for name in default_scenes.BACKGROUNDS:
            (before, look, medium), data, places = defaults.draw("cones", name)
            pictures[name] = before
            with self.subTest(name):
                numbers = defaults.measure(before, look, data, places[0])
                print(f"{name}: {numbers}")
                defaults.expect_colors(self, numbers)
                self.assertGreaterEqual(numbers.shafts, 2)
                numbers = defaults.measure(before, medium, data, places[1])
                ground = defaults.to_lab(medium)[..., 0][data < 0.1]
                spread = numpy.percentile(ground, 95) - numpy.percentile(ground, 5)
                print(f"{name}, a medium: {numbers.shafts} shafts, {spread:.1f} L* from light to dark")
                self.assertGreater(numbers.shafts, 0)
                self.assertGreater(spread, 10)
                self.assertGreater(ground.min(), 60 if name == "white" else 0)
                # gradients and textures have none themselves
                self.assertEqual(defaults.measure(before, before, data, places[0]).shafts, 0)
        for name, picture in pictures.items():  # they are what they are called
            kind = picture[-5:, :5].mean()
            self.assertEqual(kind < 100, "dark" in name, name)


if __name__ == "__main__":
    unittest.main()
