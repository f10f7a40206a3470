# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The recipes of Documentation/Cookbook.md run as they stand there: shafts are seen, and so are data.

Usage: TestCookbook.py [--pictures <folder>]   writes the page's pictures instead, 400 x 300 pixels
"""

import contextlib
import io
import os
import pathlib
import re
import sys
import tempfile
import unittest

import godrays
import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

PAGE = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Cookbook.md"
SIZE = (320, 240)
RENDER = godrays.render
WITHOUT_DATA = {22, 24}  # pictures of light alone
WITHOUT_SHAFTS = {12, 23}  # light beside data is transparent; fog that hides things evenly


def read(window):
    values = vtk.vtkUnsignedCharArray()
    window.Render()
    width, height = window.GetSize()
    window.GetPixelData(0, 0, width - 1, height - 1, 0, values, 0)
    return vtk_to_numpy(values).reshape(height, width, 3)[::-1].copy()


class Recipes:
    """Pictures of each recipe: as it stands, with nothing that casts shadows, and without rays."""

    def __init__(self, size):
        self.size = size
        self.setup, self.all = "", {}
        for part in re.split(r"^### ", PAGE.read_text(encoding="utf-8"), flags=re.M):
            code = "".join(re.findall(r"```python\n(.*?)```", part, re.S))
            number = re.match(r"(\d+)\. (.*)", part)
            if number:
                self.all[int(number[1])] = (number[2], code)
            else:
                self.setup += code

    def run(self, number):
        pictures = []
        self.background = None

        def render(data, size=(), **options):
            shape = (self.size[0], self.size[0] * size[1] // size[0]) if size else self.size
            self.background = options.get("background")
            result = RENDER(data, shape, **options)
            options.pop("untagged_props_occlude", None)
            open_air = RENDER(data, shape, untagged_props_occlude=False, **options)
            pictures[:] = [result, open_air, RENDER(data, shape, rays=False, **options)]
            return result

        names = {}
        size = f"{self.size[0]}, {self.size[1]}"
        code = self.all[number][1].replace("window = vtk.vtkRenderWindow()",
            f"window = vtk.vtkRenderWindow(); window.SetOffScreenRendering(1); window.SetSize({size})")
        godrays.render = render
        try:
            exec(compile(self.setup, str(PAGE), "exec"), names)
            exec(compile(code, f"{PAGE}, recipe {number}", "exec"), names)
        finally:
            godrays.render = RENDER
        if "window" in names:
            rays, window = names["rays" if "rays" in names else "shadows"], names["window"]
            pictures.append(read(window))
            rays.untagged_props_occlude = False
            pictures.append(read(window))
            rays.untagged_props_occlude = True
            rays.intensity = 0
            pictures.append(read(window))
            window.Finalize()
        elif not pictures:
            pictures = [names["picture"]]
        return [numpy.asarray(picture)[..., :3].astype(float) for picture in pictures], names


def shafts(picture, open_air):
    """What shadows change: the root mean square of levels, apart from one factor on all of the light."""
    light = picture.mean(2), open_air.mean(2)
    factor = (light[0] * light[1]).sum() / max((light[1] ** 2).sum(), 1)
    return float(numpy.sqrt(((light[0] - factor * light[1]) ** 2).mean()))


def alike(picture, plain, background=None):
    """The correlation of data's colours, less their mean over red, green and blue, with and without rays."""
    backgrounds = [plain[0, 0]]
    if isinstance(background, str) and background.startswith("#"):  # in windows of a room, not in its corner
        backgrounds.append(numpy.array(list(bytes.fromhex(background[1:]))))
    data = numpy.min([numpy.abs(plain - each).max(2) for each in backgrounds], axis=0) > 24
    hues = [(each - each.mean(2, keepdims=True))[data] for each in (picture, plain)]
    return float(numpy.corrcoef(hues[0].ravel(), hues[1].ravel())[0, 1])


class Cookbook(unittest.TestCase):
    def test_recipes(self):
        recipes = Recipes(SIZE)
        self.assertGreaterEqual(len(recipes.all), 20)
        self.assertEqual(sorted(recipes.all), list(range(1, len(recipes.all) + 1)))
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                for number, (title, _) in recipes.all.items():
                    with self.subTest(number=number, title=title):
                        self.check(number, title, recipes)
                self.assertEqual(len(list(pathlib.Path().glob("frame-*.png"))), 4)
                self.assertGreater(pathlib.Path("shell.png").stat().st_size, 10000)
            finally:
                os.chdir(before)

    def check(self, number, title, recipes):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            pictures, names = recipes.run(number)
        picture = pictures[0]
        self.assertGreater(picture.std(), 8)
        self.assertLess((picture.min(2) > 250).mean(), 0.7)
        if len(pictures) == 3 and number not in WITHOUT_SHAFTS:
            found = shafts(*pictures[:2])
            print(f"{number:2} {title}: shadows change it by {found:.1f} levels", flush=True)
            self.assertGreater(found, 2)
            self.assertLess(shafts(picture, picture), 1e-6)  # the control
        if len(pictures) == 3 and number not in WITHOUT_DATA:
            hue = alike(picture, pictures[2], recipes.background)
            print(f"{number:2} {title}: hues are alike by {hue:.3f}", flush=True)
            self.assertGreater(hue, 0.8)
        if number == 2:
            self.assertIn("light: directional", said.getvalue())
        elif number == 10:
            difference = numpy.abs(picture - pictures[2])
            data = numpy.abs(pictures[2] - pictures[2][0, 0]).max(2) > 60
            self.assertLess(numpy.median(difference[data]), 14)
        elif number == 15:
            self.assertGreater(difference_of_halves(picture, pictures[2]), 5)
        elif number == 18:
            red, green, blue = picture.reshape(-1, 3).mean(0)
            self.assertGreater(green, 1.5 * red)
        elif number == 19:
            hues = picture.max(2) - picture.min(2)  # on the floor, which is grey; with white glass 2
            print("19 Coloured glass: hues of", numpy.percentile(hues[-60:], 99), flush=True)
            self.assertGreater(numpy.percentile(hues[-60:], 99), 6)
        elif number == 22:
            self.assertEqual((names["light"].shape, names["light"].dtype), ((*SIZE[::-1], 3), numpy.float32))
        elif number == 23:
            contrast, error = map(float, said.getvalue().split())
            self.assertAlmostEqual(contrast, 0.05 ** (107 / 200), delta=0.004)
            self.assertLess(error, 1e-4)
        elif number == 24:
            layer, sum_ = names["layer"], names["shafts"]
            self.assertEqual(sum_.shape, layer.shape)
            self.assertGreater(sum_[160:].max(), 0.1)  # below what shines


def difference_of_halves(picture, plain):
    """How much light is added below the middle, where shafts reach, by its spread over columns [levels]."""
    added = (picture - plain)[picture.shape[0] // 2 :].mean(2)
    return float(added.mean(0).std())


def write_pictures(folder):
    import vtkmodules.vtkIOImage as io_image

    recipes = Recipes((400, 300))
    os.chdir(tempfile.mkdtemp())
    for number in recipes.all:
        picture = numpy.ascontiguousarray(recipes.run(number)[0][0].astype(numpy.uint8))
        writer = io_image.vtkJPEGWriter()
        writer.SetQuality(85)
        writer.SetInputData(godrays.to_image(picture))
        writer.SetFileName(os.path.join(folder, f"{number:02}.jpg"))
        writer.Write()


if __name__ == "__main__":
    if sys.argv[1:2] == ["--pictures"]:
        write_pictures(os.path.abspath(sys.argv[2]))
    else:
        unittest.main()
