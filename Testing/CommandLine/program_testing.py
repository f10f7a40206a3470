# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the program godrays share: its path is in GODRAYS_PROGRAM."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import sample_files

WIDTH, HEIGHT = 96, 72


def godrays(*arguments, timeout=60, **environment):
    done = subprocess.run(
        [os.environ["GODRAYS_PROGRAM"], *map(str, arguments)],
        capture_output=True, text=True, timeout=timeout, env={**os.environ, **environment})
    # It tells how far it is when that takes a while, as on a busy machine.
    done.stderr = re.sub(r"^reading .*: \d+ %\n", "", done.stderr, flags=re.MULTILINE)
    # Mesa warns of VTK's own shader of volumes, VTK 9.6.
    done.stderr = re.sub(r"^.*g_dataPos' used uninitialized.*\n*", "", done.stderr, flags=re.MULTILINE)
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

    def draw(self, *arguments, size=(WIDTH, HEIGHT), told=()):
        """The picture that the program writes, as rows of RGB. It says one line with the words told, if
        there are any, and any line where that is None."""
        path = self.folder / "picture.png"
        path.unlink(missing_ok=True)
        done = godrays(*arguments, "--size", "{}x{}".format(*size), "--output", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        if told is not None:
            self.assertEqual(len(done.stderr.splitlines()), 1 if told else 0, done.stderr)
        for word in told or ():
            self.assertIn(word, done.stderr)
        return self.read(path, size)

    def draw_each(self, files, *arguments, size=(WIDTH, HEIGHT)):
        """The pictures that one program makes of several files; it says nothing."""
        done = godrays(
            "--each", *files, *arguments, "--size", "{}x{}".format(*size), "--output",
            self.folder / "of-each-{n}.png", timeout=600)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return [self.read(self.folder / f"of-each-{n + 1:04}.png", size) for n in range(len(files))]

    def read(self, path, size):
        """A picture in a file, which has this size, as rows of RGB."""
        reader = vtkPNGReader()
        reader.SetFileName(str(path))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetDimensions(), (*size, 1))
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
        return pixels.reshape(size[1], size[0], 3)

    def fails(self, *arguments, says=(), codes=(2, 3), **environment):
        """Run the program, which must end with one of the codes, 2 for options and 3 for files, and one
        line that says these words."""
        done = godrays(*arguments, **environment)
        self.assertIn(done.returncode, codes, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertTrue(done.stderr.startswith("godrays: "), done.stderr)
        for word in says:
            self.assertIn(word, done.stderr)
