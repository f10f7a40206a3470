# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""With defaults alone, scenes of many kinds keep their colours and have shafts: half as clear, at least, as
those of a sum of which nobody chooses the strength."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Gallery"))

import default_scenes
import defaults

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
                self.assertGreater(look.contrast, 2)
                self.assertGreater(medium.contrast, 1)
            worse += plain.difference > 10 or plain.clipped > 0.5
        self.assertGreater(worse, len(SCENES) // 2, "a plain sum is to fail, or the scenes are too easy")


if __name__ == "__main__":
    unittest.main()
