# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Windows of EGL and OSMesa, and Mesa's driver softpipe, show what a window of the screen does.

EGL and OSMesa need no screen; from VTK 9.4 on they are chosen at run time.

Run with a file's name, it draws a scene in the window that the environment asks for, and writes it there.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import godrays
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

SIZE = (128, 96)
CHOICE = "VTK_DEFAULT_OPENGL_WINDOW"


def shown(window):
    window.Render()
    pixels = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, SIZE[0] - 1, SIZE[1] - 1, 0, pixels, 0)
    return vtk_to_numpy(pixels).reshape(SIZE[1], SIZE[0], 3).astype(int)


def draw(file):
    window = vtkRenderWindow()
    print(window.GetClassName(), flush=True)
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    renderer = vtkRenderer()
    renderer.SetBackground(0.05, 0.08, 0.15)
    window.AddRenderer(renderer)
    for i in range(7):
        cube = vtkCubeSource()
        cube.SetCenter(1.5 * i - 4.5, 0.3 * (i % 3) - 0.5, 0)
        cube.SetYLength(3.2)
        cube.SetXLength(0.5)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(cube.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, 0, 10)
    camera.SetViewAngle(40)
    camera.SetClippingRange(1, 100)
    pictures = {"bare": shown(window)}
    print("drawn by VTK", window.ReportCapabilities(), flush=True)
    for medium in (None, "haze"):
        with godrays.enable(renderer, light=(0.3, 0.2, -1), preset=medium) as rays:
            name = medium or "look"
            pictures[name] = shown(window)
            pictures[name + " light"] = rays.scattering
            window.SetSize(60, 40)
            window.Render()
            window.SetSize(*SIZE)
            pictures[name + " again"] = shown(window)
            window.Finalize()
            pictures[name + " in another context"] = shown(window)
    pictures["after"] = shown(window)
    numpy.savez(file, **pictures)


class Windows(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        ran, cls.expected = cls.draw_in(None)
        if ran.returncode:
            raise RuntimeError(ran.stderr)

    @staticmethod
    def draw_in(name, **settings):
        """What the program said, and the pictures, by name."""
        environment = {**os.environ, **settings}
        environment.pop(CHOICE, None)
        if name:
            environment[CHOICE] = name
            environment.pop("DISPLAY", None)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "pictures.npz"
            ran = subprocess.run(
                [sys.executable, __file__, file], env=environment, capture_output=True, text=True, timeout=300)
            pictures = dict(numpy.load(file)) if file.exists() else {}
        return ran, pictures

    def test_of_the_screen_shows_rays(self):
        bare = self.expected["bare"]
        for name in ("look", "haze"):
            self.assertGreater(numpy.abs(self.expected[name] - bare).max(), 20)
        numpy.testing.assert_array_equal(self.expected["after"], bare)

    def check(self, name):
        ran, pictures = self.draw_in(name)
        if ran.stdout.split("\n")[0] != name:
            self.skipTest(f"this VTK has no {name}")
        if "drawn by VTK" not in ran.stdout:
            self.skipTest(f"VTK cannot draw in a {name} here: {ran.stderr[-500:]}")
        self.compare(name, ran, pictures)

    def compare(self, name, ran, pictures):
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertNotRegex(ran.stderr, r"vtkGodRays.*(ERR|WARN)|(ERR|WARN)\|.*vtkGodRays")
        # drivers may take a pixel on an edge for another side
        if numpy.mean(numpy.abs(pictures["bare"] - self.expected["bare"]) > 40) > 0.002:
            self.skipTest(f"VTK itself draws another picture with {name}")
        for each, picture in pictures.items():
            with self.subTest(each):
                difference = numpy.abs(picture - self.expected[each])
                limit = 0.01 * self.expected[each].max() if each.endswith("light") else 2
                self.assertLess(numpy.mean(difference > limit), 0.002)

    def test_of_egl(self):
        self.check("vtkEGLRenderWindow")

    def test_of_osmesa(self):
        self.check("vtkOSOpenGLRenderWindow")

    def test_of_softpipe(self):
        """OpenGL 3.3, of which nothing is compiled."""
        ran, pictures = self.draw_in(None, GALLIUM_DRIVER="softpipe", LIBGL_ALWAYS_SOFTWARE="1")
        if not re.search("OpenGL renderer string: *softpipe", ran.stdout):
            self.skipTest("there is no softpipe here")
        self.compare("softpipe", ran, pictures)


if __name__ == "__main__":
    if sys.argv[-1].endswith(".npz"):
        draw(sys.argv[1])
    else:
        unittest.main()
