# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""OpenGL's context between frames: none is current, or another window's, or it is gone, or its X server is.

Run with a word, it draws frames, with rays or without, while a test takes its X server away; with a second one, it
destroys the context itself.
"""

import ctypes
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import godrays
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow, vtkUnsignedCharArray
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

SIZE = (48, 36)


def make_walk():
    walk = godrays.vtkGodRaysShadowMapIntegrator()
    walk.SetBackend(walk.GRAPHICS)
    return walk


KINDS = {  # how the light is summed
    "look": (None, None),
    "taps": (None, godrays.vtkGodRaysTapsIntegrator),
    "medium": ("fog", None),
    "medium in shaders": ("fog", make_walk),
}
try:
    OPENGL = ctypes.CDLL("libGL.so.1")
except OSError as reason:
    print(f"SKIPPED: {reason}")
    sys.exit(77)
OPENGL.glXGetCurrentContext.restype = OPENGL.glXGetCurrentDisplay.restype = ctypes.c_void_p
OPENGL.glXMakeCurrent.argtypes = (ctypes.c_void_p, ctypes.c_ulong, ctypes.c_void_p)
OPENGL.glXDestroyContext.argtypes = (ctypes.c_void_p, ctypes.c_void_p)


class Stage:
    """A small window with three pillars, and rays of a kind, or none."""

    def __init__(self, kind=None):
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(*SIZE)
        self.renderer = vtkRenderer()
        self.window.AddRenderer(self.renderer)
        for i in range(3):
            cube = vtkCubeSource()
            cube.SetCenter(1.5 * i - 1.5, 0.4 * i, 0)
            cube.SetYLength(3)
            mapper = vtkPolyDataMapper()
            mapper.SetInputConnection(cube.GetOutputPort())
            actor = vtkActor()
            actor.SetMapper(mapper)
            self.renderer.AddActor(actor)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, 0, 10)
        camera.SetClippingRange(1, 100)
        if kind:
            preset, integrator = KINDS[kind]
            self.rays = godrays.enable(self.renderer, light=(0.3, 0.2, -1), preset=preset)
            if integrator:
                self.rays.SetIntegrator(integrator())

    def shown(self):
        self.window.Render()
        pixels = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, SIZE[0] - 1, SIZE[1] - 1, 0, pixels, 0)
        return vtk_to_numpy(pixels).copy()


def make_none_current():
    """As an application does that draws with OpenGL itself, or hands a context to another thread."""
    OPENGL.glXMakeCurrent(OPENGL.glXGetCurrentDisplay(), 0, None)
    assert not OPENGL.glXGetCurrentContext()


class Contexts(unittest.TestCase):
    def setUp(self):
        self.messages = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.messages)
        self.addCleanup(vtkOutputWindow.SetInstance, None)
        self.other = Stage("look")
        if not self.other.window.IsA("vtkXOpenGLRenderWindow"):
            self.skipTest("the window has no context of GLX")
        self.of_other = self.other.shown()

    def check(self, leave):
        """Whatever is current when pictures are read, drawn, changed and taken back is no matter."""
        bare = Stage().shown()
        for kind in KINDS:
            with self.subTest(kind):
                stage = Stage(kind)
                drawn = stage.shown()
                self.assertGreater(abs(drawn.astype(int) - bare).max(), 20)
                light = stage.rays.scattering.copy()
                leave()
                numpy.testing.assert_array_equal(stage.rays.scattering, light)
                leave()
                self.assertTrue((stage.shown() == drawn).all())
                leave()
                stage.rays.SetIntegrator(None)
                leave()
                stage.rays.SetModel(None)
                leave()
                stage.rays.ReleaseGraphicsResources(stage.window)
                leave()
                stage.shown()
                leave()
                stage.rays.Detach(stage.renderer)
                leave()
                self.assertTrue((stage.shown() == bare).all())
                # names of textures are each context's own: what was released is not the other window's
                self.assertTrue((self.other.shown() == self.of_other).all())
                stage.rays.Attach(stage.renderer)
                stage.shown()
                leave()
                stage.window.Finalize()  # with rays
                self.assertTrue((self.other.shown() == self.of_other).all())
        self.assertNotIn("vtkGodRays", self.messages.GetOutput())

    def test_none_is_current(self):
        self.check(make_none_current)

    def test_another_windows_is_current(self):
        self.check(lambda: self.other.window.MakeCurrent())

    def test_an_x_server_that_goes_away(self):
        """Xlib ends the program, with rays as without."""
        if not shutil.which("Xvfb"):
            self.skipTest("there is no Xvfb")
        ends = {}
        for kind in ("none", "look"):
            to_read, to_write = os.pipe()
            with tempfile.TemporaryFile() as said:
                server = subprocess.Popen(
                    ["Xvfb", "-displayfd", str(to_write), "-screen", "0", "640x480x24", "-nolisten", "tcp"],
                    pass_fds=[to_write], stderr=said)
                try:
                    os.close(to_write)
                    with os.fdopen(to_read) as pipe:
                        display = ":" + pipe.readline().strip()
                    program = subprocess.Popen(
                        [sys.executable, __file__, kind], env={**os.environ, "DISPLAY": display},
                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                    self.assertIn("drawn\n", iter(program.stdout.readline, ""))  # drivers may say something before
                finally:
                    server.terminate()
                    server.wait()
                told, _ = program.communicate("go on\n", timeout=120)
                ends[kind] = program.returncode
                self.assertNotIn("drawn again", told)
                self.assertRegex(told, "fatal IO error|X connection to .* broken")
        self.assertEqual(ends["look"], ends["none"])
        self.assertGreater(ends["look"], 0)  # by exit(), not by a signal

    def test_a_context_that_an_application_destroys(self):
        """VTK's window makes it current again, and Xlib ends the program, with rays as without."""
        ends = {}
        for kind in ("none", "look"):
            done = subprocess.run(
                [sys.executable, __file__, kind, "destroy"], check=False, stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)
            self.assertIn("drawn\n", done.stdout)
            self.assertNotIn("drawn again", done.stdout)
            self.assertIn("GLXBadContext", done.stdout)
            ends[kind] = done.returncode
        self.assertEqual(ends["look"], ends["none"])
        self.assertGreater(ends["look"], 0)  # by exit(), not by a signal


if __name__ == "__main__":
    if len(sys.argv) > 1 and sys.argv[1] in ("none", *KINDS):
        stage = Stage(sys.argv[1] if sys.argv[1] != "none" else None)
        stage.window.Render()
        print("drawn", flush=True)
        if "destroy" in sys.argv:
            display, context = OPENGL.glXGetCurrentDisplay(), OPENGL.glXGetCurrentContext()
            OPENGL.glXMakeCurrent(display, 0, None)
            OPENGL.glXDestroyContext(display, context)
        sys.stdin.readline()
        for _ in range(3):
            stage.window.Render()
        print("drawn again", flush=True)
    else:
        unittest.main()
