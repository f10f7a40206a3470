# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shafts are seen before every kind of background, and data keep their colours, by the defaults."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Gallery"))

import default_scenes
import defaults

defaults.SIZE = (300, 210)
LEAST_CONTRAST = 1.5  # [L*] of shafts, of which gradients and textures alone have none
# A look darkens these, as light that is added is hardly seen there: its shafts are to be clearer.
DARKENED = {"white", "light grey", "light gradient", "light skybox"}
LEAST_BEFORE_LIGHT = 2


class Backgrounds(unittest.TestCase):
    def test_all(self):
        pictures = {}
        for name in default_scenes.BACKGROUNDS:
            (before, look, medium), data, places = defaults.draw("cones", name)
            pictures[name] = before
            with self.subTest(name):
                difference, chroma, _, clipped, contrast = defaults.measure(before, look, data, places[0])
                print(f"{name}: dE {difference:.1f}, chroma {chroma:.2f}, contrast {contrast:.1f}")
                self.assertLess(difference, 10)
                self.assertAlmostEqual(chroma, 1, delta=0.1)
                self.assertLess(clipped, 0.5)
                least = LEAST_BEFORE_LIGHT if name in DARKENED else LEAST_CONTRAST
                self.assertGreater(contrast, least)
                *_, contrast = defaults.measure(before, medium, data, places[1])
                print(f"{name}, a medium: contrast {contrast:.1f}")
                self.assertGreater(contrast, LEAST_CONTRAST)
                # a control: without rays there is none
                *_, contrast = defaults.measure(before, before, data, places[0])
                self.assertLess(contrast, 0.1)
        for name, picture in pictures.items():  # they are what they are called
            kind = picture[-5:, :5].mean()
            self.assertEqual(kind < 100, "dark" in name, name)


if __name__ == "__main__":
    unittest.main()
