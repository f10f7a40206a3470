# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripts of Examples/Science at a small size: shafts are seen, and so are data.

Usage: TestScience.py [--pictures <folder> [<script> ...]]   writes the pictures of its README instead, 800 x 450 pixels
"""

import contextlib
import gc
import io
import pathlib
import runpy
import sys
import tempfile
import unittest

import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "Examples" / "Science"
SCRIPTS = sorted(path.stem for path in FOLDER.glob("*.py") if path.stem not in {"stage", "cloud_field"})
TESTED_BESIDE = {"clouds"}  # whose data are no surface: TestCloudField.py
OF_PACKAGES = {"brain", "molecule", "skull"}  # whose data not every Debian has
sys.path[:0] = [str(ROOT / "Testing" / "Python"), str(FOLDER)]

import TestCookbook as cookbook


def run(name, size, *arguments):
    """What a script leaves behind, and what it says; None if its data are missing."""
    former = sys.argv
    with tempfile.NamedTemporaryFile(suffix=".png") as picture:
        sys.argv = [name, picture.name, size, *arguments]
        try:
            with contextlib.redirect_stdout(io.StringIO()) as said:
                return runpy.run_path(str(FOLDER / f"{name}.py")), said.getvalue()
        except SystemExit as end:
            if end.code != 77:
                raise
            return None, ""
        finally:
            sys.argv = former


def is_data(window):
    """Where the picture has surfaces."""
    depths = vtk.vtkFloatArray()
    width, height = window.GetSize()
    window.GetZbufferData(0, 0, width - 1, height - 1, depths)
    return vtk_to_numpy(depths).reshape(height, width)[::-1] < 1


def details(picture, plain, data):
    """How alike the lightness of neighbouring pixels of data differs, with rays and without: a correlation."""
    steps = [numpy.concatenate([numpy.diff(each.mean(2), axis=axis)[:-1 if axis else None, : None if axis else -1]
        .ravel() for axis in (0, 1)]) for each in (picture, plain)]
    inside = data[:-1, :-1] & data[1:, :-1] & data[:-1, 1:]
    inside = numpy.concatenate([inside.ravel()] * 2)
    return float(numpy.corrcoef(steps[0][inside], steps[1][inside])[0, 1])


class Science(unittest.TestCase):
    def test_scripts(self):
        self.assertEqual(len(SCRIPTS), 12)
        for name in sorted({*SCRIPTS} - TESTED_BESIDE):
            with self.subTest(name):
                self.check(name)
            gc.collect()  # a window that goes later may take away the context of another

    def check(self, name):
        scene, said = run(name, "320x180")
        if scene is None:
            self.assertIn(name, OF_PACKAGES)
            print(f"{name}: no data", flush=True)
            return
        window, rays = scene["window"], scene["rays"]
        rays.untagged_props_occlude = True
        picture = cookbook.read(window).astype(float)
        rays.untagged_props_occlude = False
        open_air = cookbook.read(window).astype(float)
        rays.untagged_props_occlude = True
        rays.intensity = 0
        plain = cookbook.read(window).astype(float)
        data = is_data(window)
        window.Finalize()
        shafts, seen = cookbook.shafts(picture, open_air), details(picture, plain, data)
        print(f"{name}: shadows change it by {shafts:.1f} levels, details are alike by {seen:.3f}", flush=True)
        self.assertGreater(shafts, 4)
        self.assertGreater(seen, 0.5)
        self.assertGreater(picture.std(), 15)
        self.assertLess((picture.min(2) > 250).mean(), 0.2)
        if name == "fire":
            self.assertRegex(said, r"^the sign is 24\.7 m away; 0\.08\d of its contrast is left: it is seen\n$")
        elif name == "room":
            self.assertIn("ceiling: 0.968/m, a visibility of 3.1 m", said)
        elif name == "ocean":
            height = float(said.split(":")[1].split()[0])
            self.assertAlmostEqual(height, 3.19, delta=0.15)  # 4 times the root of the spectrum's integral

    def test_dense_smoke_hides_the_sign(self):
        _, said = run("fire", "320x180", "12")
        contrast = float(said.split("; ")[1].split()[0])
        self.assertAlmostEqual(contrast, 0.05 ** (24.7 / 12), delta=0.0006)  # 5 % are left after 12 m
        self.assertIn("not seen", said)


def write_pictures(folder):
    import godrays
    from vtkmodules.vtkIOImage import vtkJPEGWriter

    for name in sys.argv[3:] or SCRIPTS:
        scene, said = run(name, "1600x900")
        if scene is None:
            continue
        picture = cookbook.read(scene["window"]).astype(float)
        half = picture.reshape(450, 2, 800, 2, 3).mean((1, 3)).astype(numpy.uint8)
        writer = vtkJPEGWriter()
        writer.SetQuality(86)
        writer.SetInputData(godrays.to_image(half))
        writer.SetFileName(f"{folder}/{name}.jpg")
        writer.Write()
        scene["window"].Finalize()
        scene = None
        gc.collect()
        print(name, said.strip(), flush=True)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--pictures"]:
        write_pictures(sys.argv[2])
    else:
        unittest.main()
