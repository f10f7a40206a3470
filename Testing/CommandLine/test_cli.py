# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program godrays (its path is in GODRAYS_PROGRAM): files of every type, options, errors."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import sample_files

WIDTH, HEIGHT = 96, 72


def godrays(*arguments, **environment):
    done = subprocess.run(
        [os.environ["GODRAYS_PROGRAM"], *map(str, arguments)],
        capture_output=True, text=True, timeout=60, env={**os.environ, **environment})
    # It tells how far it is when that takes a while, as on a busy machine.
    done.stderr = re.sub(r"^reading .*: \d+ %\n", "", done.stderr, flags=re.MULTILINE)
    return done


class ProgramTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.files = sample_files.write_all(cls.folder)
        cls.mesh = cls.folder / "a.vtp"
        cls.hills = cls.folder / "a.tif"

    def draw(self, *arguments, size=(WIDTH, HEIGHT)):
        """The picture that the program writes, as rows of RGB."""
        path = self.folder / "picture.png"
        path.unlink(missing_ok=True)
        done = godrays(*arguments, "--size", "{}x{}".format(*size), "--output", path)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return self.read(path, size)

    def read(self, path, size):
        """A picture in a file, which has this size, as rows of RGB."""
        reader = vtkPNGReader()
        reader.SetFileName(str(path))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetDimensions(), (*size, 1))
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
        return pixels.reshape(size[1], size[0], 3)

    def fails(self, *arguments, says=(), **environment):
        """Run the program, which must end with 1 and one line that says these words."""
        done = godrays(*arguments, **environment)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertTrue(done.stderr.startswith("godrays: "), done.stderr)
        for word in says:
            self.assertIn(word, done.stderr)


class Files(ProgramTest):
    def test_every_type_is_drawn_with_rays(self):
        for file in self.files:
            with self.subTest(file.name):
                with_rays = self.draw(file)
                without = self.draw(file, "--no-rays")
                nothing = self.draw(file, "--no-rays", "--background", "#010203", "--color", "white")
                self.assertGreater((nothing != (1, 2, 3)).any(axis=2).mean(), 0.02, "empty")
                self.assertGreater(abs(with_rays - without).max(), 20, "no rays")

    def test_every_type_that_help_names_has_a_file(self):
        help_text = godrays("--help").stdout  # newer CLI11 breaks the line
        listed = re.search(r"^Reads ((?:\.\w+\s+)+)", help_text, re.MULTILINE).group(1)
        self.assertEqual(sorted(listed.split()), sorted({file.suffix.lower() for file in self.files}))

    def test_several_files_are_drawn_together(self):
        together = self.draw(self.mesh, self.folder / "a.gltf")
        self.assertGreater(abs(together - self.draw(self.mesh)).max(), 20)

    def test_a_georeferenced_picture_has_true_lengths(self):
        stats = godrays(
            self.hills, "--elevation-scale", 1, "--stats", "--size", "64x48", "--output",
            self.folder / "s.png").stdout
        # 23 steps of 0.001 degrees, about 60 degrees north
        east, north, up = map(float, re.search(r"([\d.]+) x ([\d.]+) x ([\d.]+)", stats).groups())
        self.assertAlmostEqual(east, 23 * 55.8, delta=2)
        self.assertAlmostEqual(north, 23 * 111.4, delta=2)
        self.assertLess(up, 201)  # samples without a value are left out

    def test_flat_and_stretched_elevations(self):
        default = self.draw(self.hills)
        self.assertGreater(abs(self.draw(self.hills, "--flat") - default).max(), 20)
        self.assertGreater(abs(self.draw(self.hills, "--elevation-scale", 9) - default).max(), 20)


class DamagedFiles(ProgramTest):
    def test_files_cut_off(self):
        cut = self.folder / "cut"
        for path in list(self.folder.iterdir()):
            if path.is_dir() and path != cut:
                shutil.copytree(path, cut / path.name)
        cut.mkdir(exist_ok=True)
        for name in ("a.raw", "values.raw", "triangles.bin", "colors.mtl"):
            shutil.copy(self.folder / name, cut)
        for file in self.files:
            if file.suffix == ".obj":
                continue  # a shorter text of this kind is as good as the whole
            with self.subTest(file.name):
                part = cut / file.name
                contents = file.read_bytes()
                part.write_bytes(contents[: len(contents) * 6 // 10])
                self.fails(part, "--output", self.folder / "p.png", says=[str(part)])

    def test_files_with_other_contents(self):
        for extension in sorted({file.suffix.lower() for file in self.files}):
            with self.subTest(extension):
                path = self.folder / ("other" + extension)
                path.write_text("This is a letter, not data.\n" * 20)
                self.fails(path, "--output", self.folder / "p.png", says=[str(path)])

    def test_cells_with_points_that_are_not_there(self):
        corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
        ply = "ply\nformat ascii 1.0\nelement vertex 3\n" + "".join(
            f"property float {axis}\n" for axis in "xyz")
        ply += "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        vtk = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET {}\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n"
        for name, text in (
            ("cells.obj", corners + "f 1 2 9\n"),
            ("cells.ply", ply + "0 0 0\n1 0 0\n0 1 0\n3 0 1 77\n"),
            ("lines.vtk", vtk.format("POLYDATA") + "LINES 1 3\n2 0 -5\n"),
            ("cells.vtk", vtk.format("UNSTRUCTURED_GRID") + "CELLS 1 4\n3 0 1 3\nCELL_TYPES 1\n5\n"),
        ):
            with self.subTest(name):
                path = self.folder / name
                path.write_text(text)
                self.fails(path, "--output", self.folder / "p.png", says=[name, "not there"])

    def test_a_reader_that_fills_the_stack(self):
        path = self.folder / "cycle.gltf"
        path.write_text('{"asset":{"version":"2.0"},"nodes":[{"children":[0]}],"scene":0,'
                        '"scenes":[{"nodes":[0]}]}')
        self.fails(path, "--output", self.folder / "p.png", says=["cycle.gltf", "cannot be read"])

    def test_empty_file(self):
        for extension in (".vtp", ".stl", ".png"):
            path = self.folder / ("empty" + extension)
            path.touch()
            self.fails(path, "--output", "p.png", says=[str(path), "is empty"])

    def test_missing_file(self):
        self.fails("none.vtp", "--output", "p.png", says=["none.vtp", "no such file"])

    def test_directory(self):
        self.fails(self.folder, "--output", "p.png", says=["is a directory"])

    def test_unknown_type(self):
        path = self.folder / "a.xyz"
        path.write_text("1 2 3\n")
        self.fails(path, "--output", "p.png", says=["unknown type", ".vtp"])

    def test_no_regular_file(self):
        path = self.folder / "pipe.vtp"
        os.mkfifo(path)
        self.fails(path, "--output", "p.png", says=["no regular file"])

    @unittest.skipIf(os.geteuid() == 0, "the superuser may read every file")
    def test_unreadable_file(self):
        path = self.folder / "secret.vtp"
        shutil.copy(self.mesh, path)
        path.chmod(0)
        self.fails(path, "--output", "p.png", says=["permissions"])

    def test_file_without_geometry(self):
        path = self.folder / "points.vtk"
        path.write_text("# vtk DataFile Version 3.0\nempty\nASCII\nDATASET POLYDATA\n")
        self.fails(path, "--output", "p.png", says=["nothing to draw"])

    def test_file_of_no_size(self):
        path = self.folder / "speck.obj"
        path.write_text("v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nf 1 2 3\n")
        self.fails(path, "--output", "p.png", says=["too near", "smaller unit"])

    def test_table(self):
        path = self.folder / "table.vtk"
        path.write_text(
            "# vtk DataFile Version 3.0\ntable\nASCII\nDATASET TABLE\nROW_DATA 1\n"
            "FIELD FieldData 1\nvalues 1 1 float\n7\n")
        self.fails(path, "--output", "p.png", says=["vtkTable", "no shape"])

    def test_a_good_file_does_not_hide_a_bad_one(self):
        self.fails(self.mesh, "none.vtp", "--output", "p.png", says=["none.vtp"])


class Arguments(ProgramTest):
    def test_values_that_cannot_be(self):
        for arguments, words in (
            (["--sun", "east"], ["--sun", "'east'", "AZIMUTH,ELEVATION"]),
            (["--sun", "1,2,3"], ["--sun"]),
            (["--sun", "1,"], ["--sun"]),
            (["--sun", "10,95"], ["--sun", "-90 to 90"]),
            (["--sun", "nan,1"], ["--sun"]),
            (["--sun", "1,2", "--light", "1,2,3"], ["--sun", "--light"]),
            (["--date", "2024-06-21T12:00Z"], ["--date", "--place"]),
            (["--place", "48,11"], ["--date", "--place"]),
            (["--date", "noon", "--place", "48,11"], ["--date", "'noon'", "2024-06-21T"]),
            (["--date", "2024-06-21T12:00Z", "--place", "48,190"], ["--place", "-180 to 180"]),
            (["--date", "2024-06-21T12:00Z", "--place", "48,11", "--sun", "1,2"], ["--sun"]),
            # sunrise and sunset of Munich on that day: 05:13 and 21:17
            (["--date", "2024-06-21T23:30+02:00", "--place", "48.137,11.575"],
             ["below the horizon", "05:1", "21:1"]),
            (["--date", "2024-12-21T12:00Z", "--place", "80,0"], ["below the horizon"]),
            (["--sky", "venus"], ["--sky", "'venus'", "earth-hazy"]),
            (["--sky", "mars", "--light", "1,2,3"], ["--sky", "--light"]),
            (["--sky", "mars", "--background", "red"], ["--sky", "--background"]),
            (["--light", "1,2"], ["--light", "X,Y,Z"]),
            (["--light-color", "1,2,3"], ["--light-color", "r,g,b"]),
            (["--light-color", "nocolor"], ["--light-color"]),
            (["--light-size", "-1"], ["--light-size"]),
            (["--fill", "x"], ["--fill"]),
            (["--preset", "nonesuch"], ["--preset", "nonesuch", "default"]),
            (["--preset", "fog", "--decay", "0.9"], ["--decay", "looks", "--optical-depth"]),
            (["--optical-depth", "1"], ["--optical-depth", "medium"]),
            (["--preset", "fog", "--optical-depth", "0"], ["--optical-depth"]),
            (["--intensity", "-1"], ["--intensity", "0 to 10000"]),
            (["--density", "3"], ["--density", "0 to 2"]),
            (["--decay", "2"], ["--decay"]),
            (["--weight", "1e9"], ["--weight"]),
            (["--exposure", ""], ["--exposure"]),
            (["--preset", ""], ["--preset", "needs a value"]),
            (["--output", ""], ["--output", "needs a value"]),
            (["--isosurface", "1"], ["--isosurface", "3-D image"]),
            (["--glow", "1.5"], ["--glow", "0 to 1"]),
            (["--glow-angle", "200"], ["--glow-angle"]),
            (["--tolerance", "0"], ["--tolerance"]),
            (["--show", "all"], ["--show", "occlusion"]),
            (["--size", "100"], ["--size", "WIDTHxHEIGHT"]),
            (["--size", "0x100"], ["--size"]),
            (["--size", "100x100x3"], ["--size"]),
            (["--size", "99999x99999"], ["--size"]),
            (["--camera-position", "1,2"], ["--camera-position"]),
            (["--camera-position", "1,2,3", "--focal-point", "1,2,3"], ["the same"]),
            (["--view-up", "0,0,0"], ["--view-up"]),
            (["--view-angle", "0"], ["--view-angle"]),
            (["--up", "W"], ["--up", "X, Y or Z"]),
            (["--background", "nocolor"], ["--background"]),
            (["--background", "red:green:blue"], ["--background", "two"]),
            (["--scalars", "nonesuch"], ["--scalars", "nonesuch", "Elevation"]),
            (["--colormap", "nonesuch"], ["--colormap", "viridis"]),
            (["--range", "2,1"], ["--range"]),
            (["--color", "256,0,0"], ["--color"]),
            (["--opacity", "2"], ["--opacity"]),
            (["--elevation-scale", "0"], ["--elevation-scale"]),
            (["--nonesuch"], ["--nonesuch", "--help"]),
            (["--sun"], ["--sun"]),
        ):
            with self.subTest(arguments):
                self.fails(self.mesh, "--output", self.folder / "p.png", *arguments, says=words)

    def test_isosurface_outside_the_values(self):
        self.fails(
            self.folder / "a.vti", "--isosurface", 1e6, "--output", self.folder / "p.png",
            says=["--isosurface", "values are from"])

    def test_no_file(self):
        self.fails(says=["no file", "--help"])

    def test_output_that_cannot_be_written(self):
        self.fails(self.mesh, "--output", self.folder / "no" / "p.png", says=["no folder", "mkdir"])
        self.fails(self.mesh, "--output", self.folder / "p.gif", says=[".png"])
        folder = self.folder / "folder.png"
        folder.mkdir()
        self.fails(self.mesh, "--output", folder, says=["directory"])

    def test_no_display(self):
        picture = self.folder / "p.png"
        self.fails(self.mesh, "--output", picture, says=["xvfb-run"], DISPLAY="")
        self.fails(self.mesh, "--output", picture, says=["xvfb-run"], DISPLAY=":987")
        self.fails(self.mesh, says=["xvfb-run"], DISPLAY="")


class Pictures(ProgramTest):
    def test_size(self):
        self.draw(self.mesh, "--size", "9x9")  # given again after it: the last one counts
        self.draw(self.mesh, size=(130, 70))

    def test_jpeg(self):
        picture = self.folder / "p.jpg"
        done = godrays(self.mesh, "--size", "64x48", "--output", picture)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(picture.read_bytes()[:2], b"\xff\xd8")

    def test_a_picture_is_the_same_each_time(self):
        self.assertTrue((self.draw(self.mesh) == self.draw(self.mesh)).all())

    def test_options_change_the_picture(self):
        default = self.draw(self.mesh)
        for arguments in (
            ["--sun", "-10,12"], ["--light", "0,2,-2"], ["--light-color", "blue"],
            ["--light-size", "5"], ["--fill", "2"], ["--preset", "crisp-shafts"],
            ["--preset", "fog", "--optical-depth", "1"],
            ["--preset", "haze", "--world-unit", "300"], ["--intensity", "3"],
            ["--density", "0.5"], ["--decay", "0.9"], ["--weight", "0.1"],
            ["--exposure", "3"], ["--glow", "0"], ["--glow-angle", "60"],
            ["--show", "occlusion"], ["--show", "rays"], ["--camera-position", "0,-5,1"],
            ["--focal-point", "0.3,0,0"], ["--view-up", "1,0,0"], ["--view-angle", "60"],
            ["--parallel"], ["--up", "Y"], ["--background", "black"], ["--sky", "earth-clear"],
            ["--sky", "mars", "--world-unit", "1000"],
            ["--background", "#200000:navy"], ["--scalars", "none"], ["--colormap", "inferno"],
            ["--range", "0,9"], ["--color", "1,0,0"], ["--opacity", "0.3"], ["--edges"],
            ["--elevation-scale", "2"],
        ):
            with self.subTest(arguments):
                self.assertGreater(abs(self.draw(self.mesh, *arguments) - default).max(), 8)

    def test_the_light_of_a_given_sun_is_where_it_should_be(self):
        """Looking north, a sun in the north-north-west is on the left of the middle."""
        camera = ["--camera-position", "0,-5,0", "--focal-point", "0,0,0", "--view-angle", "60"]
        for azimuth, side in ((340, -1), (20, 1)):
            rays = self.draw(self.mesh, "--sun", f"{azimuth},10", "--show", "rays", *camera).sum(2)
            row, column = numpy.unravel_index(rays.argmax(), rays.shape)
            self.assertGreater(side * (column - WIDTH / 2), 10)
            self.assertGreater(row, HEIGHT / 2)  # above the middle: rows begin at the foot

    def test_the_sun_of_a_date_and_place(self):
        # the example of the solar position algorithm: azimuth 194.34, elevation 39.89 degrees
        given = self.draw(
            self.mesh, "--date", "2003-10-17T12:30:30-07:00", "--place", "39.742476,-105.1786")
        self.assertLess(abs(given - self.draw(self.mesh, "--sun", "194.34,39.888")).max(), 4)
        self.assertGreater(abs(given - self.draw(self.mesh, "--sun", "196.5,39.888")).max(), 8)

    def test_the_physical_sky_reddens_and_goes_dark(self):
        camera = ["--camera-position", "0,-5,0.2", "--focal-point", "0,0,0.4", "--no-rays"]
        def light(*sun):
            picture = self.draw(self.mesh, "--sky", "earth-clear", *sun, *camera)
            return picture[-10:].mean((0, 1))  # of the uppermost rows
        noon, evening = light("--sun", "180,60"), light("--sun", "0,1")
        self.assertGreater(noon[2] / noon[0], 1.5)
        self.assertLess(evening[2] / evening[0], 1.2)
        night = light("--date", "2024-06-21T23:30+02:00", "--place", "30,11.575")
        self.assertLess(night.max(), 5)

    def test_every_camera_and_sun_gives_a_picture(self):
        for arguments in (
            ["--sun", "0,90"], ["--sun", "0,-90"], ["--light", "0,0,0"],
            ["--camera-position", "0,0,9"], ["--camera-position", "0,0,-9"],
            ["--sun", "90,5", "--parallel"], ["--light", "0,0,5", "--parallel"],
            ["--camera-position", "0,0,0", "--focal-point", "0,0,1"],
        ):
            with self.subTest(arguments):
                self.draw(self.mesh, *arguments)


class Lists(ProgramTest):
    def test_presets(self):
        done = godrays("--list-presets")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = done.stdout.splitlines()
        self.assertIn("default", [line.split()[0] for line in lines])
        self.assertIn("fog", [line.split()[0] for line in lines])
        self.assertTrue(all(len(line.split()) > 1 for line in lines))

    def test_colormaps(self):
        self.assertIn("viridis", godrays("--list-colormaps").stdout.split())

    def test_help_and_version(self):
        self.assertIn("--sun", godrays("--help").stdout)
        self.assertRegex(godrays("--version").stdout, r"^godrays \d+\.\d+")

    def test_stats(self):
        arguments = [self.mesh, "--size", "64x48", "--output", self.folder / "s.png", "--stats"]
        text = godrays(*arguments).stdout
        for word in ("cells", "colours    by Elevation", "--camera-position", "--sun", "(chosen)",
                     "plan", "stage times", "scattering"):
            self.assertIn(word, text)
        error, largest = map(float, re.search(r"error +(\S+) .*largest ([^;]+);", text).groups())
        self.assertTrue(0 < error <= largest < 0.1, text)
        self.assertLess(error, 1 / 255)
        self.assertIn("--no-rays", godrays(*arguments, "--no-rays").stdout)

    def test_stats_tell_how_to_have_the_picture_again(self):
        text = godrays(
            self.mesh, "--size", f"{WIDTH}x{HEIGHT}", "--output", self.folder / "s.png",
            "--stats").stdout
        camera = re.search(r"camera     (.*)", text).group(1).split()
        light = re.search(r"light      (--sun \S+)", text).group(1).split()
        again = self.draw(self.mesh, *camera, *light)
        self.assertLess(abs(again - self.draw(self.mesh)).mean(), 1)


if __name__ == "__main__":
    unittest.main()
