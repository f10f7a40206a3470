# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Screenshots of PyVista with rays: larger than the window, without a background, and warnings of exports."""

import gc
import warnings

from pyvista_testing import *

import godrays


class Scale(unittest.TestCase):
    def test_the_tiles_make_one_picture(self):
        plotter = make_plotter()
        rays = godrays.enable(plotter, **SHAFTS)
        picture = show(plotter)
        for scale in (1, 2, 3):
            with self.subTest(scale):
                large = plotter.screenshot(scale=scale)
                self.assertEqual(large.shape, (scale * SIZE[1], scale * SIZE[0], 3))
                # a window of that size has finer edges as well
                window = make_plotter()
                window.window_size = [scale * each for each in SIZE]
                godrays.enable(window, **SHAFTS)
                finer = show(window)
                window.close()
                off = difference(large, finer)
                shrunk = difference(reduced(large, scale), picture)
                print(f"scale {scale}: off a large window {off[0]:.4f}, at most {off[1]:.0f}; "
                    f"reduced, off the window's {shrunk[0]:.4f}", flush=True)
                self.assertLess(off[0], 0.2)
                self.assertLess(shrunk[0], 0.4)
                for axis in (0, 1):  # no steps where tiles meet
                    steps = numpy.abs(numpy.diff(levels(large), axis=axis))
                    mean = steps.mean((1 - axis, 2))
                    seams = [i * SIZE[1 - axis] + j for i in range(1, scale) for j in (-2, -1, 0, 1)]
                    expected = numpy.abs(numpy.diff(levels(finer), axis=axis)).mean((1 - axis, 2))
                    for seam in seams:
                        self.assertLess(mean[seam], expected[seam] + 0.5)
        self.assertEqual(difference(show(plotter), picture), (0, 0))
        plotter.close()


class TransparentBackground(unittest.TestCase):
    def test_light_over_nothing_has_no_alpha(self):
        """Alpha stays the scene's: light shows over data, and over nothing only where alpha is ignored."""
        plotter = make_plotter()
        plotter.render()
        bare = plotter.screenshot(transparent_background=True)
        rays = godrays.enable(plotter, **SHAFTS)
        opaque = show(plotter)
        picture = plotter.screenshot(transparent_background=True)
        alpha = picture[..., 3]
        self.assertTrue((alpha == bare[..., 3]).all())
        self.assertEqual(difference(picture, opaque), (0, 0))
        light = (levels(picture) - levels(bare)).mean(2)
        nothing, data = alpha == 0, alpha == 255
        self.assertGreater(nothing.mean(), 0.3)
        self.assertGreater(data.mean(), 0.3)
        self.assertGreater(light[data].mean(), 5)
        self.assertGreater(light[nothing].mean(), 5)
        # what a viewer shows over white
        share = alpha[..., None] / 255
        shown = share * levels(picture) + (1 - share) * 255
        self.assertTrue((shown[nothing] == 255).all())
        plotter.close()


class Exports(unittest.TestCase):
    """What leaves the drawing to a browser says, once, that god rays are not drawn there."""

    def call(self, method, *arguments, **keywords):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            try:
                method(*arguments, **keywords)
            except ImportError:  # the packages that write these files
                pass
        return [each for each in caught if "god rays" in str(each.message)]

    def test_once(self):
        for name, arguments in (("export_html", (None,)), ("export_vtksz", (None,))):
            with self.subTest(name):
                plotter = make_plotter(shape=(1, 2))
                self.assertEqual(self.call(getattr(plotter, name), *arguments), [])
                godrays.enable(plotter, **SHAFTS)
                plotter.subplot(0, 1)  # the subplot without rays is active
                told, = self.call(getattr(plotter, name), *arguments)
                self.assertIs(told.category, UserWarning)
                self.assertEqual(told.filename, __file__)
                for word in (name, "screenshot", "jupyter_backend='server'"):
                    self.assertIn(word, str(told.message))
                self.assertEqual(self.call(getattr(plotter, name), *arguments), [])
                plotter.close()

    def test_the_backends_of_notebooks(self):
        for backend, tells in (
            ("client", True), ("html", True), ("server", False), ("trame", False), ("static", False),
            ("none", False),
        ):
            with self.subTest(backend):
                plotter = make_plotter(notebook=True)
                godrays.enable(plotter, **SHAFTS)
                told = self.call(plotter.show, jupyter_backend=backend)
                self.assertEqual(len(told), tells)
                plotter.close()
        plotter = make_plotter()
        godrays.enable(plotter, **SHAFTS)
        self.assertEqual(self.call(plotter.show, auto_close=False), [])
        plotter.close()

    def test_not_after_disable(self):
        plotter = make_plotter(shape=(1, 2))
        before = dict(vars(plotter))
        godrays.enable(plotter, **SHAFTS)
        self.assertNotEqual(set(vars(plotter)), set(before))
        godrays.disable(plotter)
        self.assertEqual(set(vars(plotter)), set(before))  # its own methods
        self.assertEqual(self.call(plotter.export_html, None), [])
        plotter.close()

    def test_no_plotter_is_kept(self):
        plotter = make_plotter()
        godrays.enable(plotter, **SHAFTS)
        show(plotter)
        closed = []
        plotter.render_window.AddObserver("DeleteEvent", lambda *_: closed.append(True))
        plotter.close()
        del plotter
        gc.collect()
        self.assertEqual(closed, [True])


if __name__ == "__main__":
    unittest.main()
