# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripts of Examples/ParaView: each draws its baseline; without rays it does not.

Plain Python, which starts GODRAYS_PVBATCH.
"""

import os
import pathlib
import subprocess
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

LEVELS = 2
EXAMPLES = pathlib.Path(__file__).parents[2] / "Examples" / "ParaView"
TEMPORARY = pathlib.Path(os.environ["GODRAYS_TEMPORARY"])
BASELINES = pathlib.Path(os.environ["GODRAYS_BASELINES"])

# Background, colours and lights are not the default ones, which are others since ParaView 6.0.
STATE = """
from paraview.simple import *
view = CreateView("RenderView")
view.ViewSize = [480, 360]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [0.25, 0.27, 0.34]
view.KeyLightIntensity = 0.6
shown = Show(Contour(Input=Wavelet(), ContourBy=["POINTS", "RTData"], Isosurfaces=[150.0]), view)
ColorBy(shown, None)
shown.AmbientColor = shown.DiffuseColor = [0.35, 0.4, 0.85]
view.CameraPosition = [0, 0, 50]
view.CameraFocalPoint = [0, 0, 0]
Render(view)
SaveState({!r})
"""


def run(script, *arguments, **environment):
    done = subprocess.run(
        [os.environ["GODRAYS_PVBATCH"], str(script), *map(str, arguments)],
        env={**os.environ, **environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=240,
        check=False,
    )
    if done.returncode:
        raise AssertionError(done.stdout)


def read(file):
    reader = vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    image = reader.GetOutput()
    return image.GetDimensions(), vtk_to_numpy(image.GetPointData().GetScalars()).astype(int)


class Examples(unittest.TestCase):
    def check(self, name, baseline, *arguments):
        plugin = os.environ["GODRAYS_PLUGIN"]
        size, expected = read(BASELINES / f"{baseline}.png")
        for disabled in ("0", "1"):
            picture = TEMPORARY / f"{name}-{disabled}.png"
            run(EXAMPLES / f"{name}.py", plugin, *arguments, picture, GODRAYS_DISABLE=disabled)
            actual_size, actual = read(picture)
            self.assertEqual(actual_size, size)
            difference = abs(actual - expected).max()
            if disabled == "0":
                self.assertLessEqual(difference, LEVELS)
            else:
                self.assertGreater(difference, 10 * LEVELS)

    def test_built_in(self):
        self.check("built_in", "Plugin-View")

    def test_contours(self):
        """Shafts beside the data, and the state that the script writes gives its picture again."""
        plugin = os.environ["GODRAYS_PLUGIN"]
        state, again = TEMPORARY / "contours.pvsm", TEMPORARY / "contours-again.py"
        pictures = []
        for disabled in ("0", "1"):
            picture = TEMPORARY / f"contours-{disabled}.png"
            run(EXAMPLES / "contours.py", plugin, picture, state, GODRAYS_DISABLE=disabled)
            pictures.append(read(picture)[1])
        lit, plain = pictures
        background = plain.max(1) < 30
        self.assertGreater(background.mean(), 0.5)
        low, high = numpy.percentile((lit - plain)[background].mean(1), (10, 90))
        self.assertGreater(high - low, 25)
        hues = [(each - each.mean(1, keepdims=True))[~background].ravel() for each in pictures]
        self.assertGreater(numpy.corrcoef(*hues)[0, 1], 0.7)
        again.write_text(
            "import sys\nfrom paraview.simple import *\nLoadPlugin(sys.argv[1], remote=False, ns=globals())\n"
            "LoadState(sys.argv[2])\nSaveScreenshot(sys.argv[3], GetActiveView(), ImageResolution=[800, 600])\n")
        run(again, plugin, state, TEMPORARY / "contours-again.png", GODRAYS_DISABLE="0")
        _, restored = read(TEMPORARY / "contours-again.png")
        self.assertLessEqual(abs(restored - lit).max(), LEVELS)

    def test_parallel(self):
        self.check("parallel", "Example-ParaView-parallel")

    def test_from_state(self):
        state = TEMPORARY / "example.pvsm"
        script = TEMPORARY / "example_state.py"
        script.write_text(STATE.format(str(state)), encoding="utf-8")
        run(script)
        self.check("from_state", "Example-ParaView-from_state", state)


unittest.main(verbosity=2)
