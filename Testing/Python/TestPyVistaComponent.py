# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""plotter.god_rays: found by PyVista without an import, and gone with its plotter."""

import importlib.metadata
import subprocess
import textwrap

from pyvista_testing import *

if not hasattr(pyvista, "register_plotter_component"):
    skip("PyVista 0.48 or newer", f"this is {pyvista.__version__}")


def run(script):
    """What a Python of its own prints, all of it, and its exit status."""
    result = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(script)], text=True, check=False,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    # less that VTK found no display
    lines = [line for line in result.stdout.splitlines() if "bad X server connection" not in line]
    return "\n".join([*lines, f"exit {result.returncode}"])


class Discovery(unittest.TestCase):
    def test_the_metadata(self):
        package = importlib.metadata.distribution("godrays")
        self.assertEqual(package.metadata["Summary"], "God rays for VTK scenes")
        self.assertRegex(package.version, r"^\d+\.\d+\.\d+$")

    def test_it_is_listed_and_loaded_when_used(self):
        said = run("""
            import sys, pyvista
            pyvista.OFF_SCREEN = True
            plotter = pyvista.Plotter()
            assert "god_rays" in dir(plotter)
            assert "godrays" not in sys.modules
            plotter.god_rays
            assert "godrays" in sys.modules
            names = [each.name for each in pyvista.registered_plotter_components()]
            print(names.count("god_rays"))
            """)
        self.assertEqual(said, "1\nexit 0")


class Component(unittest.TestCase):
    def test_enable_change_and_disable(self):
        plotter = make_plotter()
        bare = show(plotter)
        self.assertIsNone(plotter.god_rays.rays)
        rays = plotter.god_rays.enable(**SHAFTS)
        self.assertIs(plotter.god_rays.rays, rays)
        picture = show(plotter)
        self.assertGreater(difference(picture, bare)[0], 3)
        self.assertIs(plotter.god_rays.enable(intensity=0.5), rays)
        self.assertLess(levels(show(plotter)).mean(), levels(picture).mean() - 1)
        actor = next(iter(plotter.actors.values()))
        plotter.god_rays.enable(ignored=actor, occluders=None)
        self.assertEqual(rays.GetRole(actor), rays.IGNORED)
        plotter.god_rays.disable()
        plotter.god_rays.disable()
        self.assertIsNone(plotter.god_rays.rays)
        self.assertEqual(difference(show(plotter), bare), (0, 0))
        with self.assertRaisesRegex(TypeError, "no parameter densty"):
            plotter.god_rays.enable(**SHAFTS, densty=1)
        plotter.close()

    def test_a_sky(self):
        plotter = make_plotter()
        bare = show(plotter)
        light = pyvista.Light(light_type="scene light")
        sky = plotter.god_rays.sky(sun=BEHIND, light=light, up=(0, 1, 0), north=(0, 0, -1))
        blue = show(plotter)
        self.assertGreater(difference(blue, bare)[0], 3)
        rays = plotter.god_rays.enable(light, exposure=0.25)
        self.assertIs(rays.GetDelegatePass(), sky)
        plotter.god_rays.disable()
        self.assertEqual(difference(show(plotter), blue), (0, 0))
        plotter.close()

    def test_the_active_subplot(self):
        plotter = make_plotter(shape=(1, 2))
        plotter.subplot(0, 1)
        fill(plotter)
        right = plotter.god_rays.enable(**SHAFTS)
        plotter.subplot(0, 0)
        self.assertIsNone(plotter.god_rays.rays)
        left = plotter.god_rays.enable(**SHAFTS)
        self.assertIsNot(left, right)
        plotter.subplot(0, 1)
        self.assertIs(plotter.god_rays.rays, right)
        plotter.god_rays.disable()
        plotter.subplot(0, 0)
        self.assertIs(plotter.god_rays.rays, left)
        plotter.close()

    def test_the_plotter_closes_and_everything_is_released(self):
        plotters = [make_plotter(), make_plotter(shape=(1, 2))]
        deleted = []
        for plotter in plotters:
            for renderer in plotter.renderers:
                plotter.renderers.set_active_renderer(*plotter.renderers.index_to_loc(
                    list(plotter.renderers).index(renderer)))
                fill(plotter)
                rays = plotter.god_rays.enable(**SHAFTS)
                rays.AddObserver("DeleteEvent", lambda *_: deleted.append(True))
                sky = plotter.god_rays.sky(sun=BEHIND, up=(0, 1, 0), north=(0, 0, -1))
                sky.AddObserver("DeleteEvent", lambda *_: deleted.append(True))
                del rays, sky
            show(plotter)
        renderers = [renderer for plotter in plotters for renderer in plotter.renderers]
        plotters[0].close()
        self.assertEqual(len(deleted), 2)
        show(plotters[1])  # is as before
        plotters[1].close()
        self.assertEqual(len(deleted), 6)
        self.assertTrue(all(each.GetPass() is None for each in renderers))

    def test_deep_clean(self):
        plotter = make_plotter()
        plotter.god_rays.enable(**SHAFTS)
        show(plotter)
        plotter.close()
        plotter.deep_clean()
        plotter = make_plotter()
        plotter.god_rays.enable(**SHAFTS)
        plotter.deep_clean()
        plotter.close()


class Exit(unittest.TestCase):
    """Nothing is printed by a program that ends, however its plotters end."""

    def test_nothing_is_printed(self):
        for end in ("a.close(); b.close()", "a.show(); b.show()", "", "del a, b", "pyvista.close_all()"):
            with self.subTest(end):
                self.assertEqual(run(PROGRAM + end), "exit 0")


PROGRAM = """
import godrays, pyvista
pyvista.OFF_SCREEN = True

def make():
    plotter = pyvista.Plotter(window_size=(80, 60))
    plotter.add_mesh(pyvista.Sphere())
    return plotter

a, b = make(), make()
a.god_rays.enable()
godrays.enable(b)
for plotter in (a, b):
    plotter.enable_ssao()
    plotter.screenshot()
del plotter
"""


if __name__ == "__main__":
    unittest.main()
