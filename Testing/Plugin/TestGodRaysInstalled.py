# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin of the installed tree: it is complete, and draws."""

import os
import pathlib
import subprocess

from plugin_testing import *


def find_mapped_files():
    """The files that are mapped into this process, libraries among them."""
    maps = os.fsdecode(pathlib.Path("/proc/self/maps").read_bytes())
    lines = [line.split(maxsplit=5) for line in maps.splitlines()]  # the sixth field, a path, may have blanks
    return {pathlib.Path(fields[5].removesuffix(" (deleted)")) for fields in lines if len(fields) == 6}


class Installed(Case):
    def test_it_draws(self):
        view = make_view(size=(480, 360), SunAzimuth=4, SunElevation=9, SunColor=[1.0, 0.85, 0.6])
        add_colonnade(view)
        shown = pixels(view)
        self.assert_alike(shown, baseline("Plugin-View"), 2)
        view.UseGodRays = 0
        self.assert_different(pixels(view), shown, 50)

    def test_nothing_comes_from_elsewhere(self):
        prefix = pathlib.Path(PLUGIN).resolve().parents[4]
        self.assertTrue(pathlib.Path(godrays.__file__).resolve().is_relative_to(prefix))
        files = find_mapped_files()
        ours = {file for file in files if "GodRays" in file.name}
        self.assertGreaterEqual(len(ours), 7)  # three libraries, their wrappings, the plugin
        for library in ours:
            self.assertTrue(library.is_relative_to(prefix), library)
        qt = {file for file in files if file.name.startswith("libQt")}
        self.assertEqual(qt, set(), "what needs Qt is loaded without a window")

    def test_the_panel_is_beside_it(self):
        """Where GodRays looks for it, with all that it is linked to."""
        plugins = pathlib.Path(PLUGIN).parents[1]
        name = os.environ["GODRAYS_PANEL"]  # empty without Qt
        self.assertEqual([each.name for each in plugins.glob("*Panel*")], [name] if name else [])
        if name:
            panel = plugins / name / pathlib.Path(PLUGIN).name.replace("GodRays", name)
            linked = subprocess.run(
                ["ldd", panel], check=True, capture_output=True, text=True, env={"LC_ALL": "C"}
            ).stdout
            self.assertIn("Widgets", linked)  # a control
            self.assertNotIn("not found", linked)


main()
