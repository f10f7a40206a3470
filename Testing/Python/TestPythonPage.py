# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripts of Documentation/Python.md run as they stand there, and give what the page says."""

import contextlib
import io
import os
import pathlib
import re
import tempfile
import unittest

import godrays
import numpy

PAGE = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Python.md"


class Page(unittest.TestCase):
    def test_its_scripts(self):
        scripts = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.S)
        self.assertEqual(len(scripts), 4)
        names, said = {}, []
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                for script in scripts:
                    with contextlib.redirect_stdout(io.StringIO()) as output:
                        exec(compile(script, str(PAGE), "exec"), names)
                    said.append(output.getvalue())
                self.assertEqual(pathlib.Path("torus.png").read_bytes(), names["picture"]._repr_png_())
            finally:
                os.chdir(before)
        self.assertEqual(said[0], "(300, 400, 3) uint8\n")
        self.assertGreater(names["picture"].std(), 20)
        self.assertIn("light: directional", said[1])
        self.assertGreater(names["light"].max(), 0)
        self.assertIsNone(names["renderer"].GetPass())
        self.assertEqual(names["rays"].intensity, 0.8)
        self.assertEqual((names["shown"].shape, names["shown"].dtype), ((200, 300, 3), numpy.uint8))
        self.assertEqual(names["exact"].shape, names["shafts"].shape)
        comment = re.search(r"print\(error\)  # (.*)", scripts[3])[1]
        self.assertEqual(said[3], comment + "\n")


if __name__ == "__main__":
    unittest.main()
