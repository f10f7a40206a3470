# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program godrays (its path is in GODRAYS_PROGRAM): series, films, references, volumes, files of
options, and the documents made of its tables."""

import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOImage import vtkHDRReader, vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "Python"))
import exr_reader
import sample_files
from program_testing import HEIGHT, WIDTH, ProgramTest, godrays

SIZE = f"{WIDTH}x{HEIGHT}"
README = pathlib.Path(__file__).parent.parent.parent / "Examples/godrays/README.md"


class OutputTest(ProgramTest):
    def write(self, *arguments):
        done = godrays(*arguments, "--size", SIZE)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done

    def picture(self, name):
        return self.read(self.folder / name, (WIDTH, HEIGHT))


class Skies(OutputTest):
    def get_light_above_the_sun(self, air, elevation):
        """The brightest channel of the sky 5 degrees above the sun, as it is shown: 1 is white."""
        pitch = math.radians(elevation + 5.0)
        path = self.folder / "sky.exr"
        self.write(
            self.mesh, "--sky", air, "--sun", f"0,{elevation}", "--no-rays", "--view-angle", "20",
            "--camera-position", "0,1000,1000",
            "--focal-point", f"0,{1000 + 10 * math.cos(pitch)},{1000 + 10 * math.sin(pitch)}", "--output", path)
        channels, _ = exr_reader.read(path)
        return max(float(channels[c][HEIGHT // 2, WIDTH // 2]) for c in "RGB")

    def test_the_exposure_leaves_room_about_the_sun(self):
        self.assertAlmostEqual(self.get_light_above_the_sun("mars", 8), 1.0, delta=0.05)
        # where there is room, it is not chosen for that
        self.assertLess(self.get_light_above_the_sun("earth-clear", 40), 0.8)


class Data(OutputTest):
    def get_lightness(self, *arguments):
        """CIE 1976 L* of the picture."""
        shown = self.draw(self.mesh, "--scalars", "Elevation", *arguments) / 255
        light = numpy.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)
        y = light @ (0.2126, 0.7152, 0.0722)
        return numpy.where(y > 216 / 24389, 116 * numpy.cbrt(y) - 16, y * 24389 / 27)

    def test_values_that_are_one_are_no_colours(self):
        ball = sample_files.surface(scalars=False)
        values = numpy_to_vtk(numpy.full(ball.GetNumberOfPoints(), 7.0), deep=True)
        values.SetName("One")
        ball.GetPointData().SetScalars(values)
        path = self.folder / "one.vtp"
        sample_files.write(vtkXMLPolyDataWriter(), ball, path)
        plain = self.draw(path, "--scalars", "none")
        self.assertEqual(abs(self.draw(path) - plain).max(), 0)
        for asked in ["--scalars", "One"], ["--range", "0,10"], ["--colormap", "viridis"]:
            self.assertGreater(abs(self.draw(path, *asked) - plain).max(), 50, asked)

    def test_data_first_changes_their_lightness_alone_and_little(self):
        white = ["--no-rays", "--background", "#010203", "--color", "white"]
        covered = (self.draw(self.mesh, *white) != (1, 2, 3)).all(axis=2)
        for axis in 0, 1:  # pixels at the edge are the background's in part
            covered = covered & numpy.roll(covered, 1, axis) & numpy.roll(covered, -1, axis)
        before = self.get_lightness("--no-rays")
        for preset in "default", "fog":
            rays = ["--preset", preset, "--intensity", "6"]
            with self.subTest(preset):
                changes = [abs(self.get_lightness(*rays, *first) - before)[covered].max()
                    for first in ([], ["--data-first"])]
                self.assertGreater(changes[0], 5)
                self.assertLess(changes[1], 11)


class Shadows(OutputTest):
    # from straight above, where 12 pixels are 1, in the light of a sun in the east
    VIEW = ["--camera-position", "0,0,9", "--focal-point", "0,0,0", "--view-up", "0,1,0", "--parallel",
            "--parallel-height", 6, "--sun", "90,45", "--no-ambient-occlusion", "--color", "#808080",
            "--fill", 0.3]

    def floor(self):
        """A floor under a box."""
        both = vtkAppendPolyData()
        for bounds in (-5, 5, -5, 5, -0.1, 0), (-0.5, 0.5, -0.5, 0.5, 1, 1.5):
            cube = vtkCubeSource()
            cube.SetBounds(bounds)
            cube.Update()
            both.AddInputData(cube.GetOutput())
        both.Update()
        path = self.folder / "floor.vtp"
        sample_files.write(vtkXMLPolyDataWriter(), both.GetOutput(), path)
        return path

    def split(self, picture):
        """What is in the shadow, and what is elsewhere."""
        y, x = numpy.mgrid[0:HEIGHT, 0:WIDTH]
        x, y = (x + 0.5 - WIDTH / 2) / 12, (y + 0.5 - HEIGHT / 2) / 12
        elsewhere = (x < -2.3) | (x > -0.2) | (abs(y) > 0.8)
        return picture[(x > -1.8) & (x < -0.7) & (abs(y) < 0.3)], picture[elsewhere]

    def test_those_of_a_skys_sun_are_all_that_changes(self):
        sky = ["--sky", "earth-clear", "--intensity", 0]
        plain, drawn = (self.draw(self.floor(), *self.VIEW, *sky, *shadows, told=None)
            for shadows in ([], ["--shadows"]))
        shadow, elsewhere = self.split(plain - drawn)
        self.assertGreater(shadow.min(), 40)
        self.assertLessEqual(abs(elsewhere).max(), 1)

    def test_the_light_of_rays_casts_them(self):
        drawn = [self.draw(self.floor(), *self.VIEW, "--shadows", *alone, told=None)
            for alone in (["--intensity", 0], ["--no-rays"])]
        shadow, elsewhere = self.split(drawn[0])
        self.assertGreater(numpy.median(elsewhere) - numpy.median(shadow), 40)
        self.assertTrue((drawn[0] == drawn[1]).all())


class Cameras(OutputTest):
    CAMERA = ["--camera-position", "0,-5,0", "--focal-point", "0,0,0", "--view-angle", "60"]

    def test_the_camera_is_where_its_angles_have_it(self):
        for angles, expected in (("180,0", (0, -1, 0)), ("90,30", (0.866, 0, 0.5)), ("0,90", (0, 0, 1))):
            text = self.write(
                self.mesh, "--camera", angles, "--output", self.folder / "p.png", "--stats").stdout
            numbers = re.search(r"--camera-position (\S+) --focal-point (\S+)", text).groups()
            position, focus = (numpy.array(each.split(","), float) for each in numbers)
            direction = (position - focus) / numpy.linalg.norm(position - focus)
            self.assertLess(abs(direction - expected).max(), 0.01)

    def test_zoom_makes_things_larger(self):
        def share(*arguments):
            picture = self.draw(
                self.mesh, "--no-rays", "--background", "#010203", "--color", "white", *arguments)
            return (picture != (1, 2, 3)).any(axis=2).mean()
        for camera in ["--camera", "180,0"], ["--camera", "180,0", "--parallel"]:
            self.assertAlmostEqual(
                share(*camera, "--zoom", 0.5) / share(*camera), 0.25, delta=0.06)

    def test_the_sun_is_at_its_place_in_the_picture(self):
        for x, y in (0.2, 0.8), (0.75, 0.6):
            light = self.draw(
                self.mesh, *self.CAMERA, "--sun-at", f"{x},{y}", "--show", "occlusion",
                told=None).sum(axis=2)
            rows, columns = numpy.nonzero(light > 0.9 * light.max())
            self.assertAlmostEqual(columns.mean() / WIDTH, x, delta=0.05)
            self.assertAlmostEqual(rows.mean() / HEIGHT, y, delta=0.05)


class Series(OutputTest):
    def test_a_turntable_goes_about_once(self):
        name = str(self.folder / "turn-{frame}.png")
        film = self.folder / "turn.ogv"
        self.write(
            self.mesh, "--camera", "180,10", "--sun", "200,20", "--turntable", 3, "--output", name,
            "--film", film, "--quiet")
        self.assertEqual(film.read_bytes()[:4], b"OggS")
        self.assertEqual(len(list(self.folder.glob("turn-*.png"))), 3)
        self.assertFalse(list(self.folder.glob(".*")), "parts are left")
        # The third camera is 240 degrees on, which is 60 degrees, against the clock from above.
        told = None
        third = self.draw(self.mesh, "--camera", "300,10", "--sun", "200,20", told=told)
        other = self.draw(self.mesh, "--camera", "60,10", "--sun", "200,20", told=told)
        self.assertLess(
            min(abs(self.picture("turn-0003.png") - each).mean() for each in (third, other)), 1)
        self.assertGreater(abs(self.picture("turn-0003.png") - self.picture("turn-0001.png")).max(), 12)

    def test_each_picture_of_a_turntable_has_rays(self):
        """The light turns with the camera unless it was given; then the program says that it left the picture."""
        for file in self.mesh, self.hills:
            for arguments in [], ["--sky", "earth-clear"], ["--preset", "haze"]:
                with self.subTest(f"{file} {arguments}"):
                    pictures = []
                    for rays in "rays", "no-rays":
                        name = str(self.folder / (rays + "-{frame}.png"))
                        self.write(file, *arguments, *["--no-rays"] * (rays == "no-rays"), "--turntable", 5,
                            "--output", name)
                        pictures.append([self.picture(f"{rays}-{i:04}.png") for i in range(1, 6)])
                    for i, (with_rays, without) in enumerate(zip(*pictures)):
                        self.assertGreater(abs(with_rays - without).max(), 60, i)
        done = godrays(self.mesh, "--sun", "200,20", "--turntable", 5, "--output", name)
        self.assertRegex(done.stderr, r"^(godrays: no light reaches the picture \([^\n]*\n)+$")

    def test_time_steps(self):
        path = self.folder / "growing.pvd"
        sample_files.write_pvd(path, (0.3, 0.5, 0.8))
        plain = ["--no-rays", "--background", "#010203", "--camera-position", "0,-5,0",
                 "--focal-point", "0,0,0", "--sun", "20,30"]
        self.write(path, *plain, "--animate", "--output", self.folder / "step-{frame}-{time}.png")
        names = sorted(each.name for each in self.folder.glob("step-*.png"))
        self.assertEqual(names, ["step-0001-0.png", "step-0002-0.5.png", "step-0003-1.png"])
        shares = [(self.picture(name) != (1, 2, 3)).any(axis=2).mean() for name in names]
        for share, radius in zip(shares[1:], (0.5, 0.8)):
            self.assertAlmostEqual(share / shares[0], (radius / 0.3) ** 2, delta=0.8)
        nearest = self.draw(path, *plain, "--time", 0.6)
        self.assertTrue((nearest == self.picture(names[1])).all())

    def test_a_series_of_paraview_is_as_a_collection(self):
        collection = self.folder / "steps.pvd"
        sample_files.write_pvd(collection, (0.3, 0.5, 0.8))
        series = self.folder / "steps.vtp.series"
        files = [{"name": f"steps-pvd-{i}.vtp", "time": 0.5 * i} for i in (2, 0, 1)]
        series.write_text(json.dumps({"file-series-version": "1.0", "files": files}, indent=2))
        plain = ["--no-rays", "--camera-position", "0,-5,0", "--focal-point", "0,0,0", "--sun", "20,30"]
        self.write(series, *plain, "--animate", "--output", self.folder / "series-{time}.png")
        names = sorted(each.name for each in self.folder.glob("series-*.png"))
        self.assertEqual(names, ["series-0.5.png", "series-0.png", "series-1.png"])
        for time in "0", "0.5", "1":
            expected = self.draw(collection, *plain, "--time", time)
            self.assertTrue((self.picture(f"series-{time}.png") == expected).all())
        self.assertGreater(abs(self.picture("series-0.png") - self.picture("series-1.png")).max(), 20)
        self.assertTrue((self.draw(series, *plain) == self.picture("series-0.png")).all())
        for text, words in (
            ("{}", ["names no files"]), ('{"files": [{"name": "a.vtp"}]}', ["no number as its time"]),
            ('{"files": [{"name": "a.vtp", "time": 0}', ["names no files"]), ("x", ["names no files"]),
            ('{"files": [{"name": "steps.vtp.series", "time": 0}]}', ["another .series"]),
            ('{"files": [{"name": "none.vtp", "time": 0}]}', ["none.vtp", "no such file"]),
        ):
            series.write_text(text)
            self.fails(series, says=words, codes=[3])

    def test_a_picture_of_each_file(self):
        self.write(
            "--each", self.mesh, self.folder / "a.obj", "--output", self.folder / "each-{n}-{name}.png")
        self.assertTrue((self.picture("each-0001-a.png") == self.draw(self.mesh)).all())
        self.assertTrue((self.picture("each-0002-a.png") == self.draw(self.folder / "a.obj")).all())
        self.fails("--each", self.mesh, "--output", self.folder / "x-{word}.png", says=["{word}"])

    @unittest.skipIf(shutil.which("ffmpeg"), "there is ffmpeg")
    def test_a_film_without_ffmpeg(self):
        self.fails(
            self.mesh, "--turntable", 2, "--film", self.folder / "f.mp4", says=["ffmpeg", ".ogv"])

    def test_ffmpeg_gets_the_pictures(self):
        """A program of its name, which counts them."""
        program = self.folder / "bin" / "ffmpeg"
        program.parent.mkdir(exist_ok=True)
        program.write_text('#!/bin/sh\nfor last; do :; done\ngrep -ac IHDR > "$last"\n')
        program.chmod(0o755)
        film = self.folder / "it's a film.mp4"
        path = f"{program.parent}:{os.environ['PATH']}"
        done = godrays(self.mesh, "--turntable", 3, "--film", film, "--size", SIZE, PATH=path)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(film.read_text(), "3\n")
        program.write_text("#!/bin/sh\nexit 1\n")
        film.unlink()
        self.fails(
            self.mesh, "--turntable", 3, "--film", film, "--size", SIZE, "--quiet", says=["could not be written"],
            PATH=path)
        self.assertFalse(film.exists())


class Output(OutputTest):
    def test_the_standard_output(self):
        done = subprocess.run(
            [os.environ["GODRAYS_PROGRAM"], self.mesh, "--size", SIZE, "--output", "-"],
            capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        (self.folder / "printed.png").write_bytes(done.stdout)
        self.assertTrue((self.picture("printed.png") == self.draw(self.mesh)).all())

    def test_the_standard_input(self):
        temporary = self.folder / "temporary"
        temporary.mkdir()
        for name in "a.vtp", "a.vtk", "a.glb", "a.vti":
            with self.subTest(name):
                done = subprocess.run(
                    [os.environ["GODRAYS_PROGRAM"], "-", "--up", "Z", "--size", SIZE, "--output",
                     self.folder / "in.png"],
                    input=(self.folder / name).read_bytes(), capture_output=True,
                    env={**os.environ, "TMPDIR": str(temporary)})
                self.assertEqual((done.returncode, done.stderr), (0, b""))
                expected = self.draw(self.folder / name, "--up", "Z", told=None)
                self.assertTrue((self.picture("in.png") == expected).all())
        self.assertEqual(list(temporary.iterdir()), [])
        self.fails("-", "-", says=["once"], codes=[2])
        done = subprocess.run(
            [os.environ["GODRAYS_PROGRAM"], "-", "--output", "-"], input=b"a letter", capture_output=True)
        self.assertEqual(done.returncode, 3)
        self.assertIn(b"unknown type", done.stderr)

    def test_a_terminal_is_told_of_what_takes_long(self):
        """Where each drawing call takes a while, as of a large volume; nothing remains of it."""
        axis = numpy.linspace(-1, 1, 100)
        z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
        image = vtkImageData()
        image.SetDimensions(100, 100, 100)
        image.GetPointData().SetScalars(
            numpy_to_vtk(numpy.exp(-x * x - y * y - z * z).astype("f4").ravel(), deep=1))
        path = self.folder / "large.vti"
        sample_files.write(vtkXMLImageDataWriter(), image, path)
        sizes = ["700x500", "1400x1000", "2800x2000"]  # the next one, if it is drawn within a second
        was_told = False
        for quiet, size in [*(([], size) for size in sizes), (["--quiet"], sizes[0])]:
            if was_told and not quiet:
                continue
            master, slave = os.openpty()
            done = subprocess.run(
                [os.environ["GODRAYS_PROGRAM"], path, "--size", size, *quiet, "--output",
                 self.folder / "large.png"],
                stderr=slave)
            os.write(slave, b"end")
            told = ""
            while not told.endswith("end"):
                told += os.read(master, 100000).decode()
            os.close(slave)
            os.close(master)
            self.assertEqual(done.returncode, 0)
            if quiet:
                self.assertEqual(told, "end")
            elif told != "end" or size == sizes[-1]:
                self.assertTrue(told.endswith("\r\033[Kend"), told)
                self.assertRegex(told, r"\r(drawing|preparing large): 1 s\x1b\[K")
                was_told = True

    def test_over_black_a_transparent_picture_is_as_one_with_a_black_background(self):
        camera = ["--camera", "180,0", "--sun", "5,10", "--no-ambient-occlusion"]
        for rays in [], ["--no-rays"]:
            path = self.folder / "transparent.png"
            self.write(self.mesh, *camera, *rays, "--transparent", "--output", path)
            reader = vtkPNGReader()
            reader.SetFileName(str(path))
            reader.Update()
            pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(float)
            pixels = pixels.reshape(HEIGHT, WIDTH, 4)
            self.assertGreater((pixels[..., 3] < 128).mean(), 0.2)
            self.assertEqual(pixels[HEIGHT // 2, WIDTH // 2, 3], 255)
            over_black = pixels[..., :3] * pixels[..., 3:] / 255
            black = self.draw(self.mesh, *camera, *rays, "--background", "black")
            self.assertLess(abs(over_black - black).max(), 2)
            partly = (pixels[..., 3] % 255 > 0).mean()  # without rays, edges alone
            self.assertTrue(partly < 0.05 if rays else partly > 0.2, partly)

    def linear(self, path):
        """A picture of light, as rows of RGB from the foot."""
        if path.suffix == ".exr":
            return numpy.stack([exr_reader.read(path)[0][c] for c in "RGB"], axis=2).astype(float)
        reader = vtkHDRReader()
        reader.SetFileName(str(path))
        reader.Update()
        light = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
        return light.reshape(HEIGHT, WIDTH, 3).astype(float)

    def test_pictures_of_light(self):
        """Encoded as screens have it, they are the PNG, and above white they go on."""
        camera = ["--camera", "180,0", "--sun", "5,10", "--no-ambient-occlusion"]
        names = {"scene": ["--no-rays"], "rays": ["--exposure", 2, "--show", "rays"],
                 "both": ["--exposure", 2]}
        light = {}
        for name, arguments in names.items():
            path = self.folder / f"{name}.exr"
            self.write(self.mesh, *camera, *arguments, "--output", path)
            light[name] = self.linear(path)
            shown = numpy.clip(light[name], 0, 1)
            shown = 255 * numpy.where(
                shown <= 0.0031308, 12.92 * shown, 1.055 * shown ** (1 / 2.4) - 0.055)
            picture = self.draw(self.mesh, *camera, *arguments)
            difference = abs(shown - picture).max(axis=2)
            # Samples of a pixel are averaged as light, not as shown; below white a PNG's rays are compressed
            # before they are clipped; and a PNG is rounded after noise of half a level.
            self.assertLess((difference[light[name].max(axis=2) < 0.3] > 1.1).mean(), 0.05, name)
            as_it_is = abs(255 * numpy.clip(light[name], 0, 1) - picture).max(axis=2)
            self.assertGreater((as_it_is > 10).mean(), 0.5, "it is not linear")
        self.assertGreater(light["both"].max(), 1.3)
        added = light["scene"] + light["rays"]
        ground = light["scene"].max(axis=2) < 0.02  # over data, rays are capped, and the sun lights these
        self.assertGreater(ground.mean(), 0.3)
        self.assertLess(numpy.percentile(abs(light["both"] - added)[ground], 95), 1e-3)
        path = self.folder / "both.hdr"
        self.write(self.mesh, *camera, *names["both"], "--output", path)
        brightest = light["both"].max(axis=2, keepdims=True)
        self.assertLess((abs(self.linear(path) - light["both"]) / brightest).max(), 0.004)

    def test_an_exr_has_opacity(self):
        """Premultiplied, as OpenEXR has it: over black it is the picture with a black background."""
        camera = ["--camera", "180,0", "--sun", "5,10", "--no-ambient-occlusion"]
        opacities = []
        for rays in ["--exposure", 2], ["--no-rays"]:
            path = self.folder / "transparent.exr"
            self.write(self.mesh, *camera, *rays, "--transparent", "--output", path)
            channels, _ = exr_reader.read(path)
            self.assertEqual(sorted(channels), ["A", "B", "G", "R"])
            light = self.linear(path)
            opacities.append(channels["A"])
            self.write(self.mesh, *camera, *rays, "--background", "black", "--output", path)
            self.assertNotIn("A", exr_reader.read(path)[0])
            self.assertLess(abs(light - self.linear(path)).max(), 1e-3)
        opacity = opacities[1]
        self.assertEqual(abs(opacities[0] - opacity).max(), 0, "rays have an opacity")
        self.assertEqual((opacity.min(), opacity.max()), (0, 1))
        self.assertEqual(opacity[HEIGHT // 2, WIDTH // 2], 1)
        self.assertGreater((opacity == 0).mean(), 0.2)
        png = self.folder / "transparent.png"
        self.write(self.mesh, *camera, "--no-rays", "--transparent", "--output", png)
        reader = vtkPNGReader()
        reader.SetFileName(str(png))
        reader.Update()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(float)
        pixels = pixels.reshape(HEIGHT, WIDTH, 4)
        self.assertLess(abs(255 * opacity - pixels[..., 3]).max(), 1)
        for name in "none.hdr", "none.jpg":
            output = self.folder / name
            self.fails(
                self.mesh, "--transparent", "--output", output, codes=[2],
                says=["--transparent", name[4:], ".png or .exr"])
            self.assertFalse(output.exists())

    def write_environment(self, name, light, height=64):
        """A .hdr of bytes without runs: three mantissas of 1/256 each, and an exponent of 0."""
        pixels = numpy.full((height, 2 * height, 4), 128, numpy.uint8)
        pixels[..., :3] = numpy.rint(256 * numpy.asarray(light))
        path = self.folder / name
        path.write_bytes(
            f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {2 * height}\n".encode() +
            pixels.tobytes())
        return path

    def test_an_environment(self):
        """It is behind the scene, its middle to the north, and lights surfaces in place of --fill."""
        light = numpy.full((64, 128, 3), (0.1, 0.2, 0.5))
        for column, color in (68, (0.5, 0, 0)), (100, (0, 0.5, 0)):  # right of north, and of east
            light[:, column : column + 3] = color
        path = self.write_environment("stripes.hdr", light)
        plain = [self.mesh, "--no-rays", "--sun", "20,10"]
        for azimuth, stripe in (180, 0), (270, 1), (0, None):
            picture = self.draw(*plain, "--hdri", path, "--camera", f"{azimuth},0")
            background = numpy.median(picture[HEIGHT - 3], axis=0)
            self.assertLess(abs(background - (89, 124, 188)).max(), 3)
            found = picture[HEIGHT - 3].argmax(axis=1) == stripe
            self.assertEqual(found.sum() > 3, stripe is not None)
            if stripe is not None:
                self.assertGreater(numpy.nonzero(found)[0].mean(), WIDTH / 2)
        bare = [*plain, "--scalars", "none", "--color", "white", "--camera", "180,0"]
        for name, color in ("red.hdr", (0.6, 0.1, 0.1)), ("blue.hdr", (0.1, 0.1, 0.6)):
            picture = self.draw(
                *bare, "--hdri", self.write_environment(name, numpy.full((64, 128, 3), color)))
            seen = picture[HEIGHT // 2 - 8 : HEIGHT // 2, WIDTH // 2 - 8 : WIDTH // 2].mean(axis=(0, 1))
            self.assertEqual(seen.argmax(), numpy.argmax(color))
            self.assertGreater(seen.max(), 2 * seen.min())
        grey = self.write_environment("grey.hdr", numpy.full((64, 128, 3), 0.5))
        dark, light = (self.draw(*bare, "--sun", "180,20", "--hdri", grey, "--color", color)[HEIGHT // 2, WIDTH // 2, 0]
            for color in ("#505050", "white"))
        self.assertAlmostEqual(dark / light, 0x50 / 255, delta=0.1)  # as much light as the colour says
        light = numpy.full((64, 128, 3), 0.05)
        light[:, 64:] = 0.6  # to the east
        picture = self.draw(*bare, "--hdri", self.write_environment("east.hdr", light))
        left, right = (
            picture[HEIGHT // 2, WIDTH // 2 + side : WIDTH // 2 + side + 3].mean()
            for side in (-16, 14))
        self.assertGreater(right, 1.5 * left)
        square = self.folder / "a.hdr"
        self.fails(*bare, "--hdri", square, "--output", "x.png", says=["twice as wide"], codes=[3])
        self.fails(*bare, "--hdri", self.mesh, "--output", "x.png", says=["--hdri", "is no picture"], codes=[3])
        self.fails(*bare, "--hdri", "none.hdr", "--output", "x.png", says=["no such file"], codes=[3])
        self.fails(*bare, "--hdri", path, "--background", "red", says=["leave out"], codes=[2])

    def test_a_reference(self):
        reference = self.folder / "reference.png"
        self.write(self.mesh, "--output", reference)
        self.assertRegex(self.write(self.mesh, "--reference", reference).stdout, "error .* is 0$")
        other = [self.mesh, "--size", SIZE, "--background", "white", "--reference", reference]
        self.fails(*other, says=["error", "--threshold 10"], codes=[5])
        self.assertEqual(godrays(*other, "--threshold", 1e6).returncode, 0)
        self.fails(
            self.mesh, "--size", "50x50", "--reference", reference, says=["96 x 72"], codes=[5])
        self.fails(self.mesh, "--reference", self.mesh, says=["--reference"], codes=[3])

    def test_quiet_and_verbose(self):
        noon = [self.mesh, "--sun", "180,75", "--size", SIZE, "--output", self.folder / "p.png"]
        self.assertIn("out of the picture", godrays(*noon).stderr)
        self.assertEqual(godrays(*noon, "--quiet").stderr, "")
        self.assertRegex(godrays(*noon, "--verbose").stderr, r"read in [\d.]+ s(.|\n)*drawn in [\d.]+ s")


class Volumes(OutputTest):
    def head(self):
        """A ball of bone (1000 HU) in one of water (0 HU), in air (-1000 HU)."""
        axis = numpy.linspace(-1, 1, 40)
        z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
        radius = numpy.sqrt(x * x + y * y + z * z)
        values = numpy.select([radius < 0.4, radius < 0.8], [1000.0, 0.0], -1000.0).astype("f4")
        image = vtkImageData()
        image.SetDimensions(40, 40, 40)
        image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=1))
        path = self.folder / "head.vti"
        sample_files.write(vtkXMLImageDataWriter(), image, path)
        return path

    def test_bone_and_skin(self):
        head = self.head()
        camera = ["--camera", "180,0", "--no-rays", "--background", "#000020"]

        def share(*arguments):
            picture = self.draw(head, *camera, *arguments).astype(int)
            return (abs(picture - (0, 0, 32)).max(axis=2) > 8).mean()
        bone, skin = share("--volume-preset", "ct-bone"), share("--volume-preset", "ct-skin")
        self.assertAlmostEqual(skin / bone, 4, delta=1)
        both = self.draw(head, *camera, "--volume-preset", "ct-skin-bone").sum(axis=2)
        middle, between = both[HEIGHT // 2, WIDTH // 2], both[HEIGHT // 2, WIDTH // 2 + 17]
        self.assertGreater(share("--volume-preset", "ct-skin-bone") / bone, 2)
        self.assertGreater(middle, 1.5 * between, "the skin hides the bone")
        # a window over bone alone, and one that begins below water
        self.assertAlmostEqual(share("--window", "700,600") / bone, 1, delta=0.3)
        self.assertGreater(share("--window", "0,1000") / bone, 2)


class Configuration(OutputTest):
    def test_blocks_by_file_name(self):
        config = self.folder / "config"
        config.write_text(
            "# for all\nbackground = black\n\n[*.vtp]\npreset = fog\nedges\n[b*]\nno-rays\n")
        with_file = self.draw(self.mesh, "--config", config)
        arguments = ["--background", "black", "--preset", "fog", "--edges"]
        self.assertTrue((with_file == self.draw(self.mesh, *arguments)).all())
        again = self.draw(self.mesh, "--config", config, "--background", "#405060", "--edges")
        arguments[1] = "#405060"
        self.assertTrue((again == self.draw(self.mesh, *arguments)).all())
        obj = self.draw(self.folder / "a.obj", "--config", config)
        self.assertTrue((obj == self.draw(self.folder / "a.obj", "--background", "black")).all())

    def test_the_users_own_file(self):
        own = self.folder / "home" / "godrays" / "config"
        own.parent.mkdir(parents=True)
        own.write_text("size = 50x40\n")
        environment = {"XDG_CONFIG_HOME": str(own.parent.parent)}
        path = self.folder / "own.png"
        self.assertEqual(godrays(self.mesh, "--output", path, **environment).returncode, 0)
        self.read(path, (50, 40))
        self.assertEqual(
            godrays(self.mesh, "--output", path, "--no-config", **environment).returncode, 0)
        self.read(path, (1200, 800))

    def test_mistakes(self):
        config = self.folder / "mistaken"
        for text, words in (
            ("prest = fog\n", ["mistaken", "prest", "did you mean --preset?"]),
            ("sun = east\n", ["mistaken: --sun", "east"]), ("size =\n", ["mistaken: --size: needs a value"]), ("[*.vtp\n", ["mistaken:1", "]"]),
            ("--edges\n", ["mistaken:1", "without hyphens"]),
        ):
            config.write_text(text)
            self.fails(self.mesh, "--config", config, says=words, codes=[2])
        self.fails(self.mesh, "--config", self.folder / "none", says=["--config"], codes=[3])


class Documents(OutputTest):
    def document(self, kind):
        done = godrays("--document", kind)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def names(self):
        return re.findall(r"(?<![\w-])--[a-z][a-z-]+(?= )", re.sub(
            r"\n\n+Reads (.|\n)*", "", godrays("--help").stdout))

    def test_the_readme_has_the_tables_of_the_program(self):
        text = README.read_text()
        for kind in "options", "keys":
            self.assertIn(self.document(kind), text, f"godrays --document {kind} prints the table")

    def test_the_manual_has_each_option_and_each_key(self):
        manual = self.document("man").replace("\\-", "-")
        for line in self.document("options").splitlines()[2:]:
            name = re.match(r"\| `(?:-\w`, `)?(--[\w-]+)", line).group(1)
            self.assertIn(name, manual)
        self.assertGreater(len(self.document("keys").splitlines()), 30)
        for line in self.document("keys").splitlines()[2:]:
            self.assertIn(line.split(" | ")[1].removesuffix(" |"), manual)
        if shutil.which("man"):
            done = subprocess.run(
                ["man", "--warnings", "-l", "-"], input=self.document("man").encode(),
                capture_output=True,
                env={**os.environ, "LC_ALL": "C.UTF-8"})
            self.assertEqual((done.returncode, done.stderr), (0, b""))

    def test_bash_completes_names_and_values(self):
        script = self.document("bash") + """
            complete_words() { COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _godrays; echo "${COMPREPLY[@]}"; }
            complete_words godrays --turn
            complete_words godrays --preset long
            complete_words godrays --sun ""
            """
        done = subprocess.run(["bash", "-c", script], capture_output=True, text=True)
        self.assertEqual((done.stdout, done.stderr), ("--turntable\nlong-shafts\n\n", ""))

    def test_zsh_and_fish_have_each_option(self):
        zsh, fish = self.document("zsh"), self.document("fish")
        names = [re.match(r"\| `(?:-\w`, `)?--([\w-]+)", line).group(1)
                 for line in self.document("options").splitlines()[2:]]
        self.assertGreater(len(names), 60)
        for name in names:
            self.assertIn(f"'--{name}[", zsh)
            self.assertRegex(fish, rf"-l {name} ")
        self.assertTrue(zsh.startswith("#compdef godrays\n"))


if __name__ == "__main__":
    unittest.main()
