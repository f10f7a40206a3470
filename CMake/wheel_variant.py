# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Usage: wheel_variant.py [--install]

Make pyproject.toml that of a wheel to publish, for one distribution of VTK. GODRAYS_VARIANT in the
environment names it: vtk, the default, or cvista. The wheel then needs the distribution's version. With
--install, also install what builds the wheel: scikit-build-core, and the distribution's SDK, in which CMake
finds VTK.
"""

import os
import pathlib
import re
import subprocess
import sys

VARIANTS = {  # name of the wheel, what it needs, what else builds it
    "vtk": (
        "godrays", "vtk==9.7.*",
        ["vtk==9.7.1", "vtk-sdk==9.7.1", "--find-links=https://vtk.org/files/wheel-sdks"]),
    "cvista": (
        "godrays-cvista", "cvista-rendering==9.7.0.5.*",
        ["cvista-rendering==9.7.0.5.*", "cvista-sdk==9.7.0.5.*"]),
}


def main():
    name, needs, builds = VARIANTS[os.environ.get("GODRAYS_VARIANT", "vtk")]
    path = pathlib.Path(__file__).resolve().parents[1] / "pyproject.toml"
    text = re.sub(r'(?m)^name = "[^"]*"', f'name = "{name}"', path.read_text(encoding="utf-8"), count=1)
    text = re.sub(r"(?m)^dependencies = .*$", f'dependencies = ["numpy", "{needs}"]', text, count=1)
    path.write_text(text, encoding="utf-8")
    if "--install" in sys.argv[1:]:
        builds = ["ninja", "numpy", "scikit-build-core>=0.11", *builds]
        subprocess.run([sys.executable, "-m", "pip", "install", *builds], check=True)


if __name__ == "__main__":
    main()
