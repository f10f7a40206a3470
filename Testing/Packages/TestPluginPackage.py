# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Debian package of the ParaView plugin (GODRAYS_PACKAGES is its folder): what it needs.

Its part with Qt makes it need Qt. A machine with pvserver or pvbatch alone has Qt without it: Debian has these programs
in the package paraview, which needs Qt itself.
"""

import os
import pathlib
import re
import subprocess
import unittest


def run(*command):
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE).stdout


class Depends(unittest.TestCase):
    def test_qt_comes_with_paraview(self):
        (package,) = pathlib.Path(os.environ["GODRAYS_PACKAGES"]).glob("paraview-godrays_*.deb")
        depends = run("dpkg-deb", "--field", str(package), "Depends")
        self.assertRegex(depends, r"\bparaview \(>= [\d.]+")
        brought = set(re.findall(r"(?m)^\S+$", run(
            "apt-cache", "depends", "--recurse", "--no-recommends", "--no-suggests", "--no-conflicts", "--no-breaks",
            "--no-replaces", "--no-enhances", "paraview")))
        self.assertIn("paraview", brought)
        qt = {name for name in re.findall(r"(?:^|[,|]) *([^\s,|]+)", depends) if "qt" in name}
        self.assertEqual(qt - brought, set(), "a machine with pvserver would need more than ParaView does")
        self.assertEqual(any("widgets" in name for name in qt), bool(os.environ["GODRAYS_PANEL"]), qt)


if __name__ == "__main__":
    unittest.main()
