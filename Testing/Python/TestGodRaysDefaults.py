# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""With defaults alone, scenes of many kinds keep their colours and have shafts: half as clear, at least, as
those of a sum of which nobody chooses the strength."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Gallery"))

import numpy

import default_scenes
import default_situations
import defaults
import godrays

defaults.SIZE = (300, 210)

# thin, thick, grey, coloured, translucent and volumes
SCENES = (
    "cones", "streamlines", "molecule", "volume", "lattice", "gyroid", "translucent-contours", "lettering",
)


class Defaults(unittest.TestCase):
    def test_all(self):
        worse = 0
        for name in SCENES:
            (look, medium, plain), fill = defaults.measure_all(name)
            with self.subTest(name):
                self.assertGreater(fill, 1)
                defaults.expect_colors(self, look)
                defaults.expect_colors(self, medium)
                self.assertGreater(look.contrast, 0.5 * plain.contrast)
                self.assertGreater(medium.contrast, 0.5 * plain.contrast)
                self.assertGreater(look.contrast, 2)
                self.assertGreater(medium.contrast, 1)
            worse += plain.difference > 10 or plain.clipped > 0.5
        self.assertGreater(worse, len(SCENES) // 2, "a plain sum is to fail, or the scenes are too easy")

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
