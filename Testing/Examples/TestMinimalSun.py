# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""An example's program (the last argument), called wrongly: it says how it is called, and writes nothing."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop()
del sys.argv[1:]  # the script


class Arguments(unittest.TestCase):
    def run_program(self, *arguments, **environment):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([PROGRAM, *arguments], cwd=folder, capture_output=True, text=True, timeout=120,
                env={**os.environ, **environment})
            return done, [path.name for path in pathlib.Path(folder).iterdir()]

    def test_what_is_no_picture_or_size(self):
        for arguments, words in (
            (["--help"], "ends in .png, not --help"), (["picture.bmp"], "ends in .png, not picture.bmp"),
            (["picture.png", "60"], "WIDTHxHEIGHT, each from 1 to 16384, not 60"),
            (["picture.png", "0x9"], "not 0x9"),
        ):
            with self.subTest(arguments):
                done, files = self.run_program(*arguments)
                self.assertEqual((done.returncode, files), (1, []))
                self.assertIn(words, done.stderr)
                self.assertIn("Arguments: [picture.png] [WIDTHxHEIGHT]", done.stderr)
        self.assertEqual(self.run_program("picture.png", "60x40")[1], ["picture.png"])

    def test_no_display(self):
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        done = subprocess.run([PROGRAM], capture_output=True, text=True, timeout=120, env=environment)
        if done.returncode == 0:
            self.skipTest("this VTK opens windows without X")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("DISPLAY is not set", done.stderr)


if __name__ == "__main__":
    unittest.main()
