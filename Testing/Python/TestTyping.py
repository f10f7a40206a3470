# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The types of the package, as mypy reads them: correct uses pass, and each wrong one is told."""

import importlib.util
import pathlib
import subprocess
import sys
import tempfile
import unittest

import godrays

PACKAGE = pathlib.Path(godrays.__file__).parent
SAMPLE = pathlib.Path(__file__).with_name("typing_sample.py")

for needed, found in (
    ("the types of the wrapped classes, which VTK 9.2 and later write", (PACKAGE / "py.typed").exists()),
    ("mypy", importlib.util.find_spec("mypy")),
):
    if not found:
        print(f"SKIPPED: these tests need {needed}")
        sys.exit(77)

WRONG = {
    "godrays.enable(42)": '"enable" has incompatible type "int"',
    "godrays.enable(r, light=7)": '"enable" has incompatible type "int"',
    "godrays.enable(r, light='sun')": '"enable" has incompatible type "str"',
    "godrays.enable(r, preset=1)": '"enable" has incompatible type "int"',
    "godrays.enable(r).SetIntensity('much')": '"SetIntensity" of "vtkGodRaysPass"',
    "godrays.enable(r, density='thick')": '"enable" has incompatible type "str"',
    "godrays.enable(r).intensity = 'much'": 'Incompatible types in assignment',
    "godrays.tag(r, 'lamp')": '"tag" has incompatible type',
    "godrays.sun(2024, 43.77, 11.26)": '"sun" has incompatible type "int"',
    "godrays.sky(r, light='sun', sun='noon')": '"sky" has incompatible type "str"',
    "godrays.enabled(r)": 'Module has no attribute "enabled"',
}


CACHE = tempfile.TemporaryDirectory()


def check(*files, strict=True):
    """What mypy says of files. VTK may be without its types, and PyVista be missing."""
    options = ["--cache-dir", CACHE.name, "--ignore-missing-imports"]
    if strict:
        options += ["--strict", "--allow-untyped-calls"]
    return subprocess.run(
        [sys.executable, "-m", "mypy", *options, *map(str, files)],
        text=True, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


class Typing(unittest.TestCase):
    def test_correct_uses(self):
        result = check(SAMPLE)
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("Success", result.stdout)

    def test_wrong_uses(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "wrong.py"
            lines = [
                "import godrays", "from vtkmodules.vtkRenderingCore import vtkRenderer", "r = vtkRenderer()"]
            file.write_text("\n".join([*lines, *WRONG]), encoding="utf-8")
            result = check(file)
        told = {}
        for line in result.stdout.splitlines():
            if ": error: " in line:
                place, message = line.split(": error: ", 1)
                told.setdefault(int(place.rsplit(":", 1)[1]), message)
        for number, (use, message) in enumerate(WRONG.items(), len(lines) + 1):
            with self.subTest(use):
                self.assertIn(message, told.get(number, result.stdout))
        self.assertEqual(len(told), len(WRONG), result.stdout)

    def test_the_package_itself(self):
        # no-redef: three names that each file of types has for itself
        result = check(*sorted(PACKAGE.glob("*.py")), "--disable-error-code=no-redef", strict=False)
        self.assertEqual(result.returncode, 0, result.stdout)


if __name__ == "__main__":
    unittest.main()
