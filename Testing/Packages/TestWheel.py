# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""pip install ./Rendering/Python, into a virtual environment, without a network.

The wheel is made of the build tree; with GODRAYS_LONG in the environment, of one that it makes itself.
"""

import csv
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ["GODRAYS_BUILD"])
FOLDER = BUILD / "Testing" / "Wheel"
ENVIRONMENT = {name: value for name, value in os.environ.items()
    if name not in ("PYTHONPATH", "LD_LIBRARY_PATH", "CMAKE_PREFIX_PATH")}


def run(*command, cwd="/"):
    ran = subprocess.run(list(map(str, command)), cwd=cwd, env=ENVIRONMENT, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if ran.returncode:
        raise AssertionError(f"{' '.join(map(str, command))} returned {ran.returncode}:\n{ran.stdout}")
    return ran.stdout


class Wheel(unittest.TestCase):
    def test_pip_installs_what_runs(self):
        shutil.rmtree(FOLDER, ignore_errors=True)
        run(sys.executable, "-m", "venv", "--system-site-packages", FOLDER)
        python = FOLDER / "bin" / "python"
        pip = (python, "-m", "pip", "--disable-pip-version-check")
        settings = () if "GODRAYS_LONG" in os.environ else ("--config-settings", f"build-dir={BUILD}")
        run(*pip, "wheel", "--no-index", "--no-deps", *settings, "-w", FOLDER / "wheels",
            ROOT / "Rendering" / "Python")
        (wheel,) = (FOLDER / "wheels").glob("*.whl")
        self.assertRegex(wheel.name, r"^godrays-[\d.]+-cp3\d+-cp3\d+-linux_\w+\.whl$")
        with zipfile.ZipFile(wheel) as held:
            names = held.namelist()
            (record,) = [name for name in names if name.endswith("/RECORD")]
            rows = list(csv.reader(held.read(record).decode().splitlines()))
            self.assertEqual(sorted(row[0] for row in rows), sorted(names))
        for pattern in (r"godrays/__init__\.py", r"godrays/libvtkGodRaysFilters\.so\.\d+\.\d+",
                r"godrays/vtkGodRaysRendering\.so", r"godrays-[\d.]+\.dist-info/(METADATA|WHEEL|LICENSE)"):
            self.assertTrue(any(re.fullmatch(pattern, name) for name in names), pattern)

        run(*pip, "install", "--no-index", wheel)
        code = ("import importlib.metadata, os, sys, godrays; from vtkmodules.vtkFiltersSources import vtkConeSource\n"
            "picture = godrays.render(vtkConeSource(), (80, 60))\n"
            "maps = [os.fsdecode(line).split(maxsplit=5) for line in open('/proc/self/maps', 'rb').read().splitlines()]\n"
            "files = {fields[5] for fields in maps if len(fields) == 6}\n"
            "ours = [each for each in files if 'GodRays' in os.path.basename(each)]\n"
            "print(godrays.__file__, importlib.metadata.version('godrays'), picture.shape, picture.std() > 5,\n"
            "    all(each.startswith(sys.prefix) for each in ours), len(ours) >= 5)")
        self.assertRegex(run(python, "-c", code), rf"{re.escape(str(FOLDER))}\S* [\d.]+ \(60, 80, 3\) True True True")
        if any(name == "godrays/godrays" for name in names):
            for program in ((python, "-m", "godrays"), (FOLDER / "bin" / "godrays",)):
                self.assertRegex(run(*program, "--version"), r"godrays \d")
        run(*pip, "uninstall", "--yes", "godrays")
        self.assertFalse(list(FOLDER.glob("lib/*/site-packages/godrays*")))


if __name__ == "__main__":
    unittest.main()
