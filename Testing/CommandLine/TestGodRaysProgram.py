# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program godrays (its path is in GODRAYS_PROGRAM): pictures, lists and errors."""

import os
import pathlib
import struct
import subprocess
import tempfile
import unittest

TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 1 3 4\n"


def godrays(*arguments):
    command = [os.environ["GODRAYS_PROGRAM"], *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=120)


class Program(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = self.folder / "tetrahedron.obj"
        self.file.write_text(TETRAHEDRON)

    def draw(self, *arguments):
        """The bytes of the PNG file that the program writes."""
        picture = self.folder / "picture.png"
        picture.unlink(missing_ok=True)
        done = godrays(self.file, "--size", "160x120", "--output", picture, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return picture.read_bytes()

    def test_draws_a_picture_of_the_size_asked_for(self):
        png = self.draw()
        self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", png[16:24]), (160, 120))

    def test_rays_are_seen(self):
        self.assertNotEqual(self.draw(), self.draw("--no-rays"))

    def test_a_picture_is_the_same_each_time(self):
        self.assertEqual(self.draw(), self.draw())

    def test_every_preset_draws(self):
        presets = [line.split()[0] for line in godrays("--list-presets").stdout.splitlines()]
        self.assertGreater(len(presets), 1)
        for preset in presets:
            with self.subTest(preset):
                self.draw("--preset", preset)

    def test_errors_name_what_is_wrong(self):
        for arguments, name in (
            (["--nonesuch"], "--nonesuch"),
            ([self.folder / "none.obj", "--output", "x.png"], "none.obj"),
            ([self.file, "--preset", "nonesuch", "--output", "x.png"], "nonesuch"),
        ):
            done = godrays(*arguments)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(name, done.stderr)


if __name__ == "__main__":
    unittest.main()
