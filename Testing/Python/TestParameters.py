# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Documentation/Parameters.md is as headers have it, and each parameter changes its pictures."""

import pathlib
import sys
import unittest

import numpy

DOCUMENTATION = pathlib.Path(__file__).resolve().parents[2] / "Documentation"
sys.path.insert(0, str(DOCUMENTATION / "Gallery"))

import parameters


class Parameters(unittest.TestCase):
    def test_the_page_is_that_of_the_headers(self):
        page = (DOCUMENTATION / "Parameters.md").read_text(encoding="utf-8")
        self.assertEqual(page, parameters.make_page(), "run Documentation/Gallery/parameters.py again")

    def test_each_changes_its_pictures(self):
        scene = parameters.cookbook_scene()
        for _, cls, base, each in parameters.SECTIONS:
            for name, values, more in each:
                with self.subTest(name):
                    low, high = (
                        parameters.picture(scene, cls, base, name, value, more, (80, 60)).astype(float)
                        for value in (values[0], values[-1]))
                    change = float(numpy.sqrt(((high - low) ** 2).mean()))
                    print(f"{name}: {change:.1f} levels from low to high", flush=True)
                    self.assertGreater(change, 4)
                    strip = DOCUMENTATION / "Parameters" / f"{name}.jpg"
                    self.assertGreater(strip.stat().st_size, 4000)


if __name__ == "__main__":
    unittest.main()
