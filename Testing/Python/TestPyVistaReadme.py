# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The script with PyVista of README.md runs, and shows data and shafts."""

import os
import pathlib
import re

from pyvista_testing import *

if not hasattr(pyvista, "register_plotter_component"):
    skip("PyVista 0.48 or newer", f"this is {pyvista.__version__}")

ROOT = pathlib.Path(__file__).parents[2]


def scripts(file):
    """The Python scripts of a Markdown file that are whole with PyVista."""
    text = (ROOT / file).read_text(encoding="utf-8")
    return [each for each in re.findall("```python\n(.*?)```", text, re.DOTALL)
        if "import pyvista" in each]


def run(script, file, **environment):
    """The last picture of a script's plotter."""
    os.environ.update(environment)
    try:
        names = {"__name__": "__main__"}
        exec(compile(script, file, "exec"), names)
        return names["plotter"].last_image
    finally:
        for name in environment:
            del os.environ[name]


class Readme(unittest.TestCase):
    def test_its_scripts(self):
        found = scripts("README.md")
        self.assertTrue(found, "no script with PyVista")
        for script in found:
            self.check(script, "README.md")

    def check(self, script, file):
        picture = run(script, file)
        without = run(script, file, GODRAYS_DISABLE="1")
        light = (levels(picture) - levels(without)).mean(2)
        rows, columns = light.shape
        data = numpy.abs(levels(without) - levels(without)[0, 0]).max(2) > 20
        print(f"{file}: data on {data.mean():.2f} of the picture, light {light[~data].mean():.1f} beside "
            f"and {light[data].mean():.1f} over them", flush=True)

        # the data are seen: large, in many colours, and not washed out
        self.assertGreater(data.mean(), 0.1)
        hues = numpy.unique(levels(picture)[data] // 32, axis=0)
        self.assertGreater(len(hues), 30)
        self.assertGreater(
            correlation(levels(picture)[data], levels(without)[data]), 0.8)
        self.assertLess((levels(picture) >= 254).all(2).mean(), 0.01)

        # the shafts are seen: light and dark by turns along the picture's lower edge
        self.assertGreater(light[~data].mean(), 15)
        edge = light[-rows // 20:].mean(0)
        smooth = numpy.convolve(edge, numpy.ones(9) / 9, "valid")
        turns = numpy.diff(numpy.sign(numpy.diff(smooth[:: max(1, columns // 100)])))
        self.assertGreater(numpy.count_nonzero(turns), 6)
        self.assertGreater(smooth.max() - smooth.min(), 15)


if __name__ == "__main__":
    unittest.main()
