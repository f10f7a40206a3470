# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""With defaults alone, also scenes of other lights, units, materials and kinds of props keep their colours
and have shafts; what has none is told."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Gallery"))

import default_situations
import defaults
import godrays

defaults.SIZE = (200, 140)

FIRST = {"data first": {"data_first": True}}
HIDDEN = {"sun behind all"}  # no ray gets past
FILLED = {"close"}  # shows no background near the sun
# light before a silhouette is what one sees
DARK = {"lamp alone in a shell", "dark", "wireframe"}
# a medium dims translucent props by all of it that is before what is behind them, which has their depth
MISSED = {"translucent": 0.87}


class Situations(unittest.TestCase):
    def test_all(self):
        for name in default_situations.SITUATIONS:
            look, medium, first = defaults.measure_scene(
                name, columns=defaults.COLUMNS | FIRST, make=default_situations.make)
            with self.subTest(name):
                if name not in DARK:
                    defaults.expect_colors(self, look)
                    defaults.expect_colors(self, medium, MISSED.get(name, 0.9))
                self.assertEqual(first.clipped, 0)
                self.assertLess(abs(first.tint), 1)
                self.assertEqual(look.shafts > 0, name not in HIDDEN | FILLED)

    def test_what_is_hidden_is_told(self):
        for name in ("sun behind all", "lines"):
            window, renderer = default_situations.make(name, defaults.SIZE)
            rays = godrays.enable(renderer)
            window.Render()
            self.assertEqual("change nothing that can be seen" in rays.GetAdvice(), name in HIDDEN)
            window.Finalize()


if __name__ == "__main__":
    unittest.main()
