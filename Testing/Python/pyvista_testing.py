# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests with PyVista share: a scene in its plotters."""

import functools

from light_testing import *

try:
    import pyvista
except ImportError as error:
    skip("PyVista", error)

pyvista.OFF_SCREEN = True


def make_plotter(**parameters):
    """A plotter with balls over a plain, in front of the dark."""
    plotter = pyvista.Plotter(window_size=SIZE, lighting="none", **parameters)
    plotter.disable_anti_aliasing()
    plotter.render_window.SetMultiSamples(0)
    fill(plotter)
    return plotter


def fill(plotter):
    """Put the scene into the active subplot."""
    plotter.set_background("black", all_renderers=False)
    plotter.add_light(pyvista.Light(position=(3, 4, 6), focal_point=(0, 0, 0), positional=True,
        cone_angle=40, intensity=0.8))
    for x in (-1.2, 0, 1.2):
        ball = pyvista.Sphere(radius=0.4, center=(x, 0.3 * x + 0.3, 0))
        plotter.add_mesh(ball, color="tan", smooth_shading=True, opacity=0.9 if x == 0 else 1)
    plotter.add_mesh(
        pyvista.Plane(center=(0, -0.9, 0), direction=(0, 1, 0), i_size=6, j_size=6),
        color="steelblue")
    plotter.camera_position = [(0, 0.6, 6), (0, 0, 0), (0, 1, 0)]


def show(plotter):
    plotter.render()
    return plotter.screenshot()


with_and_without = functools.partial(with_and_without, show)
