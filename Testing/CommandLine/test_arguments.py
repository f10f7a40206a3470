# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program godrays: what its options take and tell."""

import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from program_testing import HEIGHT, WIDTH, ProgramTest, godrays


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
            (["--date", "2024-06-21T12:00", "--place", "48,11"], ["--date", "a zone"]),
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
            (["--sun-at", "1,1", "--sun", "1,2"], ["--sun-at", "--sun"]),
            (["--camera", "1,2", "--focal-point", "1,2,3"], ["--camera", "--focal-point"]),
            (["--camera", "1,95"], ["--camera", "-90 to 90"]),
            (["--zoom", "0"], ["--zoom"]),
            (["--parallel-height", "2"], ["--parallel"]),
            (["--transparent", "--sky", "mars"], ["--transparent", "--sky"]),
            (["--turntable", "1.5"], ["--turntable", "whole"]),
            (["--turntable", "3"], ["--output", "{frame}"]),
            (["--film", "f.ogv"], ["--film", "--turntable"]),
            (["--time", "now"], ["--time"]),
            (["--quiet", "--verbose"], ["--quiet", "--verbose"]),
            (["--window", "1,0"], ["--window", "width"]),
            (["--volume-preset", "mri"], ["--volume-preset", "ct-skin-bone"]),
            (["--volume-medium", "--isosurface", "1"], ["--volume-medium", "--isosurface"]),
            (["--volume-medium", "--optical-depth", "1"], ["--optical-depth", "--preset"]),
            (["--volume-medium", "--preset", "low-sun"], ["--volume-medium", "haze"]),
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

    def test_output_that_is_a_file_to_be_read(self):
        picture = self.folder / "heights.png"
        shutil.copy(self.folder / "a.png", picture)
        (self.folder / "link.png").symlink_to(picture)
        (self.folder / "hard.png").hardlink_to(picture)
        before = picture.read_bytes()
        for output in (picture, f"{self.folder}/./heights.png", self.folder / "link.png",
                       self.folder / "hard.png"):
            self.fails(self.mesh, picture, "--output", output, says=["file to be read", "another name"])
            self.assertEqual(picture.read_bytes(), before)

    def test_a_picture_is_written_whole_or_not_at_all(self):
        folder = self.folder / "whole"
        folder.mkdir()
        target = folder / "target.png"
        link = folder / "p.png"
        link.symlink_to(target)
        for former in (None, b"the former picture"):
            if former:
                target.write_bytes(former)
            # Files end after 100 bytes, and the program is told so rather than killed.
            done = subprocess.run(
                [os.environ["GODRAYS_PROGRAM"], self.mesh, "--output", link],
                capture_output=True, text=True, restore_signals=False,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)))
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn("could not be written", done.stderr)
            self.assertEqual(target.read_bytes() if former else target.exists(), former or False)
            self.assertEqual(
                sorted(each.name for each in folder.iterdir()),
                ["p.png", "target.png"] if former else ["p.png"])
        self.assertEqual(godrays(self.mesh, "--output", link).returncode, 0)
        self.assertTrue(link.is_symlink())
        self.read(target, (1200, 800))
        self.assertEqual(len(list(folder.iterdir())), 2)

    def test_a_disk_that_is_full_at_any_byte(self):
        """Of each kind of file: no cut file is taken for a whole one, and the former one stays."""
        former = b"the former file"
        folder = self.folder / "full"
        folder.mkdir()
        kinds = {name: ["--output", folder / name] for name in ("a.png", "a.jpg", "a.hdr")}
        kinds["a.vti"] = ["--preset", "haze", "--numbers", folder / "a.vti"]
        kinds["a.ogv"] = ["--turntable", "3", "--film", folder / "a.ogv"]
        for name, arguments in kinds.items():
            command = [os.environ["GODRAYS_PROGRAM"], self.mesh, "--size", "160x120", *arguments]
            self.assertEqual(subprocess.run(command, check=False).returncode, 0)
            size = (folder / name).stat().st_size
            for limit in (100, size // 2, size - 1, size):
                (folder / name).write_bytes(former)
                done = subprocess.run(command, capture_output=True, text=True, restore_signals=False,
                    preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
                with self.subTest(name, limit=limit, size=size):
                    if done.returncode == 0:
                        self.assertGreaterEqual((folder / name).stat().st_size, size - 8)
                        self.assertEqual(limit, size)
                    else:
                        self.assertEqual(done.returncode, 3, done.stderr)
                        self.assertIn("could not be written", done.stderr)
                        self.assertEqual((folder / name).read_bytes(), former)
            self.assertEqual([each.name for each in folder.iterdir()], [name], "something is left")
            (folder / name).unlink()

    def test_names_and_things_that_are_no_files(self):
        name = "n" * 251 + ".png"
        self.assertEqual(godrays(self.mesh, "--output", self.folder / name).returncode, 0)
        self.assertGreater((self.folder / name).stat().st_size, 1000)
        self.fails(self.mesh, "--output", self.folder / ("n" + name), says=["too long"], codes=[3])
        pipe = self.folder / "pipe.png"
        os.mkfifo(pipe)
        link = self.folder / "device.png"
        link.symlink_to("/dev/null")
        for path in pipe, link:
            self.fails(self.mesh, "--output", path, says=["a device", "- for the standard"], codes=[3])
        self.assertTrue(pipe.is_fifo() and link.is_char_device())
        film = self.folder / "film.ogv"
        film.symlink_to("/dev/null")
        self.fails(self.mesh, "--turntable", "3", "--film", film, says=["--film", "a device"], codes=[3])

    def test_a_full_folder_for_temporary_files(self):
        path = self.folder / "missing.gltf"
        path.write_text('{"asset":{"version":"2.0"},"nodes":[],"scene":0,"scenes":[{"nodes":[]}],'
                        '"images":[{"uri":"none.png"}]}' + " " * 1000)
        done = subprocess.run(
            [os.environ["GODRAYS_PROGRAM"], path, "--output", self.folder / "p.png"],
            capture_output=True, text=True, restore_signals=False,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)))
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertRegex(done.stderr, "a copy without them in .* could not be written; is the disk full")

    def test_nothing_is_left_of_a_program_that_is_ended(self):
        former = b"the former picture"
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=number), tempfile.TemporaryDirectory() as name:
                folder = pathlib.Path(name)
                (folder / "p.png").write_bytes(former)
                program = subprocess.Popen(
                    [os.environ["GODRAYS_PROGRAM"], self.mesh, "--size", "3000x2000", "--output", folder / "p.png"],
                    stderr=subprocess.PIPE, text=True,
                    preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))  # shells ignore it behind
                while program.poll() is None and len(list(folder.iterdir())) < 2:
                    time.sleep(0.001)
                program.send_signal(number)
                told = program.communicate(timeout=60)[1]
                self.assertEqual(program.returncode, -number, told)
                self.assertEqual([each.name for each in folder.iterdir()], ["p.png"])
                self.assertEqual((folder / "p.png").read_bytes(), former)

    def test_nothing_is_left_of_a_copy_when_a_reader_crashes(self):
        """Of a file whose picture is missing there is a copy; its nodes go round in circles."""
        path = self.folder / "copied.gltf"
        path.write_text('{"asset":{"version":"2.0"},"nodes":[{"children":[0]}],"scene":0,'
                        '"scenes":[{"nodes":[0]}],"images":[{"uri":"none.png"}]}')
        with tempfile.TemporaryDirectory() as folder:
            self.fails(path, "--output", self.folder / "p.png", says=["cannot be read"], TMPDIR=folder)
            self.assertEqual(os.listdir(folder), [])

    def test_a_server_that_ends_without_connections(self):
        """Xvfb -terminate ends where one without -noreset resets: between connections there must be one."""
        with subprocess.Popen(["Xvfb", "-displayfd", "1", "-terminate", "-screen", "0", "640x480x24"],
                stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as server:
            self.addCleanup(server.kill)
            display = ":" + server.stdout.readline().strip()
            done = godrays(self.mesh, "--size", "64x48", "--output", self.folder / "p.png", DISPLAY=display)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(server.wait(20), 0)

    def test_no_display(self):
        picture = self.folder / "p.png"
        no_display = {"says": ["xvfb-run"], "codes": [4]}
        self.fails(self.mesh, "--output", picture, **no_display, DISPLAY="")
        self.fails(self.mesh, "--output", picture, **no_display, DISPLAY=":987")
        self.fails(self.mesh, **no_display, DISPLAY="")

    def test_exit_codes_by_kind(self):
        picture = self.folder / "p.png"
        self.fails(self.mesh, "--nonesuch", codes=[2])
        self.fails(self.mesh, "--output", picture, "--scalars", "nonesuch", codes=[2])
        self.fails("none.vtp", "--output", picture, codes=[3])
        self.fails(self.mesh, "--output", self.folder / "no" / "p.png", codes=[3])

    def test_misspelt_names_are_guessed(self):
        for arguments, right in (
            (["--prest", "fog"], "--preset"), (["--isosruface=1"], "--isosurface"),
            (["--preset", "defualt"], "default"), (["--preset", "long-shaft"], "long-shafts"),
            (["--out", "a.png"], "--output"), (["--colormap", "virids"], "viridis"), (["--volume-preset", "ct-bon"], "ct-bone"),
        ):
            with self.subTest(arguments):
                self.fails(self.mesh, *arguments, says=[f"did you mean {right}?"], codes=[2])
        done = godrays(self.mesh, "--frobnicate")
        self.assertNotIn("did you mean", done.stderr)


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

    def test_numbers(self):
        """The command of Documentation/Numbers.md, and what a medium leaves of light."""
        page = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Numbers.md"
        command = re.search(r"^    godrays (terrain.tif .*)$", page.read_text("utf-8"), re.M).group(1).split()
        path = self.folder / "haze.vti"
        command[command.index("haze.vti")] = path
        command[0] = self.hills
        done = godrays(*command, "--size", "96x72")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        reader = vtkXMLImageDataReader()
        reader.SetFileName(str(path))
        reader.Update()
        image = reader.GetOutput()
        self.assertEqual(image.GetDimensions(), (96, 72, 1))

        def array(name):
            return vtk_to_numpy(image.GetPointData().GetArray(name)).astype(float)

        seen = numpy.isfinite(array("Depth"))
        self.assertGreater(seen.mean(), 0.1)
        tau = 7.49e-4 * array("Distance_m")[seen]  # of haze
        numpy.testing.assert_allclose(array("OpticalDepth")[seen, 1], tau, 1e-4)
        numpy.testing.assert_allclose(array("Transmittance")[seen, 0], numpy.exp(-tau), 1e-4)
        numpy.testing.assert_allclose(array("MeteorologicalRange_m"), 3.912 / 7.49e-4, 1e-4)
        brightest = 1000 * (1 - 0.9**2) / (4 * numpy.pi * (1 - 0.9) ** 3)  # straight ahead, all of it
        self.assertGreater(array("Radiance").max(), 1e-3 * brightest)
        self.assertLess(array("Radiance").max(), brightest)
        self.fails(self.mesh, "--numbers", path, says=["--numbers", "medium"])
        fog = (self.mesh, "--preset", "fog", "--numbers")
        self.fails(*fog, "n.png", says=["--numbers", ".vti or .exr"])
        self.fails(*fog, self.folder / "none" / "n.vti", says=["--numbers", "no folder"])
        self.fails(*fog, path, "--no-rays", says=["--numbers", "--no-rays"])
        self.fails(*fog, path, "--irradiance", "1,-1,1", says=["--irradiance"])
        self.fails(self.mesh, "--irradiance", "1,1,1", says=["--irradiance", "--numbers"])
        exr = self.folder / "n.exr"
        done = godrays(*fog, exr, "--size", "96x72")
        if done.returncode == 0:  # built with OpenEXR
            self.assertEqual(exr.read_bytes()[:4], b"\x76\x2f\x31\x01")
            self.assertIn(b"Transmittance.G", exr.read_bytes())
        else:
            self.assertIn("OpenEXR", done.stderr)

    def test_help_and_version(self):
        self.assertIn("--sun", godrays("--help").stdout)
        self.assertRegex(godrays("--version").stdout, r"^godrays \d+\.\d+")

    def test_stats(self):
        arguments = [self.mesh, "--size", "64x48", "--output", self.folder / "s.png", "--stats"]
        text = godrays(*arguments).stdout
        for word in ("cells", "colours    by Elevation", "--camera-position", "light      --", "(chosen)",
                     "plan", "stage times", "scattering"):
            self.assertIn(word, text)
        error, largest = map(float, re.search(r"error +(\S+) .*largest ([^;]+);", text).groups())
        self.assertTrue(0 < error <= largest < 0.1, text)
        self.assertLess(error, 1 / 255)
        self.assertIn("--no-rays", godrays(*arguments, "--no-rays").stdout)

    def test_stats_tell_how_to_have_the_picture_again(self):
        haze = ["--preset", "haze"]
        lights = []
        for options in [], haze, [*haze, "--sun-at", "0.2,0.8"], [*haze, "--parallel"], [*haze, "--world-unit", "10"]:
            with self.subTest(options=options):
                text = godrays(
                    self.mesh, "--size", f"{WIDTH}x{HEIGHT}", "--output", self.folder / "s.png",
                    "--stats", *options).stdout
                camera = re.search(r"camera     (.*)", text).group(1).split()
                light = re.search(r"light      (--(?:sun|light) \S+)", text).group(1).split()
                kept = options if "--world-unit" in options else options[:2]
                again = self.draw(self.mesh, *kept, *camera, *light)
                self.assertLess(abs(again - self.draw(self.mesh, *options)).mean(), 1)
                lights.append(light)
        look, medium, asked, parallel, known = lights
        self.assertEqual(medium[0], "--light")
        self.assertNotIn(medium, (look, asked, parallel, known))
        self.assertNotIn(asked, (look, parallel, known))
        self.assertEqual(known, look)


if __name__ == "__main__":
    unittest.main()
