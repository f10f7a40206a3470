# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""README's code in Python, as it stands there: data are seen, and so are shafts."""

import ast
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
README = ROOT / "README.md"
sys.path.insert(0, str(ROOT / "Documentation" / "Gallery"))

import default_scenes


def read(window):
    reader = vtk.vtkWindowToImageFilter()
    reader.SetInput(window)
    reader.ReadFrontBufferOff()
    reader.Update()
    image = reader.GetOutput()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(image.GetDimensions()[1], image.GetDimensions()[0], -1).astype(float)


class Readme(unittest.TestCase):
    def test_first_picture(self):
        """A program of its own, that has nothing but what stands there."""
        text = README.read_text(encoding="utf-8")
        code = re.search(r"## First pictures\n.*?```python\n(.*?)```", text, re.S).group(1)
        with tempfile.TemporaryDirectory() as folder:
            pictures = []
            for rays in True, False:
                script = code if rays else code.replace("render(", "render(rays=False, data=")
                done = subprocess.run(
                    [sys.executable, "-c", script], cwd=folder, capture_output=True, text=True)
                self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
                self.assertEqual(os.listdir(folder), ["cells.png"])
                reader = vtk.vtkPNGReader()
                reader.SetFileName(os.path.join(folder, "cells.png"))
                reader.Update()
                values = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(float)
                pictures.append(values.max(axis=1))
        after, before = pictures
        data = before > 60
        self.assertTrue(0.1 < data.mean() < 0.6, data.mean())
        low, high = numpy.percentile((after - before)[~data], (10, 90))
        self.assertGreater(high - low, 20)

    def test_python(self):
        text = README.read_text(encoding="utf-8")
        code = re.search(r"## In Python\n[^#]*?```python\n(.*?)```", text, re.S).group(1)
        window, renderer = default_scenes.make("cones", (300, 200))
        grid = vtk.vtkCubeAxesActor()
        before = read(window)
        data = before.max(axis=2) > 20
        names = {"renderer": renderer, "grid": grid}
        pictures = 0
        for statement in ast.parse(code).body:
            exec(compile(ast.Module([statement], []), str(README), "exec"), names)
            if "godrays.enable" not in ast.unparse(statement):
                continue
            with self.subTest(ast.unparse(statement)):
                after = read(window)
                pictures += 1
                # orange cones stay orange, before a background that is lit here and dark there
                self.assertGreater((after[data] - after[data][:, 2:3])[:, 0].mean(), 60)
                self.assertLess(numpy.abs(after - before)[data].mean(), 45)
                lightness = after.max(axis=2)[~data]
                low, high = numpy.percentile(lightness, (10, 90))
                self.assertGreater(high - low, 20)
        self.assertEqual(pictures, 4)
        window.Finalize()


if __name__ == "__main__":
    unittest.main()
