# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the ParaView plugin share: a scene, its pixels, its light.

They run in pvbatch, with the plugin named by GODRAYS_PLUGIN, and write to GODRAYS_TEMPORARY.
"""

import os
import sys
import unittest

import numpy
from paraview import simple, vtk
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger
from vtkmodules.vtkIOImage import vtkPNGReader

PLUGIN = os.environ["GODRAYS_PLUGIN"]
TEMPORARY = os.environ["GODRAYS_TEMPORARY"]
BASELINES = os.environ["GODRAYS_BASELINES"]

simple._DisableFirstRenderCameraReset()
if os.environ.get("GODRAYS_SERVER_PORT"):
    simple.Connect("localhost", int(os.environ["GODRAYS_SERVER_PORT"]))
    simple.LoadPlugin(PLUGIN, remote=True, ns=globals())
simple.LoadPlugin(PLUGIN, remote=False, ns=globals())

import godrays  # after the plugin, whose libraries it shares
import godrays.vtkGodRaysViews  # so that views are known as what they are

VIEW = "GodRaysRenderView"
BACKGROUND = [0.08, 0.1, 0.18]


def make_view(name=VIEW, size=(160, 120), **properties):
    """A view with nothing in it that looks along -z at the origin, from 8 units away."""
    view = simple.CreateView(name)
    view.ViewSize = list(size)
    view.OrientationAxesVisibility = 0
    view.CenterAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = BACKGROUND
    view.CameraPosition = [0, 0, 8]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 1, 0]
    if name == VIEW:
        view.PlaceSun = 0  # 10 degrees above the centre of the picture
    for key, value in properties.items():
        setattr(view, key, value)
    return view


PILLARS = (-1.8, -1.0, 0.7, 1.4)
COLUMNS = (-2.2, -1.6, -1.05, -0.45, 0.15, 0.8, 1.35, 2.0)


def make_pillars(positions=PILLARS, center=True):
    """Sources of pillars before a sun that stands above the middle one, which comes first."""
    pillars = [
        simple.Box(XLength=0.3, YLength=2.4, ZLength=0.3, Center=[x, 0.0, 0.0]) for x in positions
    ]
    if center:
        pillars.insert(0, simple.Box(XLength=0.4, YLength=2.8, ZLength=0.4))
    return pillars


def show(source, view):
    shown = simple.Show(source, view)
    shown.Representation = "Surface"
    shown.ColorArrayName = ["POINTS", ""]
    shown.DiffuseColor = [0.45, 0.45, 0.4]
    return shown


def show_joined(sources, view):
    """Shows sources as one. ParaView takes 0.4 s to make a representation and to delete it."""
    return show(simple.AppendGeometry(Input=sources), view)


def add_pillars(view, *positions, **options):
    """The pillars of make_pillars(), as one representation."""
    return show_joined(make_pillars(*positions, **options), view)


def add_each_pillar(view):
    """The pillars of make_pillars(); returns a representation of each."""
    return [show(pillar, view) for pillar in make_pillars()]


def add_colonnade(view):
    """A row of columns under a beam, each with a representation, as in the baselines."""
    beam = simple.Box(XLength=5.0, YLength=0.3, ZLength=0.3, Center=[0, 1.3, 0])
    for each in [*make_pillars(COLUMNS, center=False), beam]:
        show(each, view)


def add_volume(view):
    """A volume about the origin; returns its representation."""
    source = simple.Wavelet(WholeExtent=[-8, 8, -8, 8, -8, 8])
    data = simple.Transform(Input=source)
    data.Transform.Scale = [0.15, 0.15, 0.15]
    data.TransformAllInputVectors = 0
    image = simple.ResampleToImage(Input=data, SamplingDimensions=[24, 24, 24])
    shown = simple.Show(image, view)
    shown.SetRepresentationType("Volume")
    simple.ColorBy(shown, ("POINTS", "RTData"))
    return shown


def pixels(view, magnification=1):
    """What the view shows, in levels of 255: rows from the bottom, red, green and blue."""
    simple.Render(view)
    image = view.SMProxy.CaptureWindow(magnification)
    image.UnRegister(None)
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars()).astype(int)
    return values.reshape(height, width, -1)[:, :, :3]


def rays(view):
    """The view's pass; in built-in mode."""
    return view.GetClientSideObject().GetGodRaysPass()


def read(file):
    """A picture, as pixels() has it."""
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    values = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
    return values.reshape(height, width, -1)[:, :, :3]


def baseline(name):
    """A picture of Testing/Baseline/, as pixels() has it."""
    return read(os.path.join(BASELINES, name + ".png"))


def layer(view, which="Scattering"):
    """Scattered light, or the occlusion layer, of the last frame as floats; None without rays."""
    image = vtk.vtkImageData()
    if not getattr(rays(view), f"Get{which}Image")(image):
        return None
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)


def clip(view, direction):
    """The clip coordinates X, Y and w of a sun, from the view's own parameters."""
    position, focus, up = (
        numpy.array(value, float)
        for value in (view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp)
    )
    backward = (position - focus) / numpy.linalg.norm(position - focus)
    right = numpy.cross(up, backward)
    right /= numpy.linalg.norm(right)
    above = numpy.cross(backward, right)
    scale = 1.0 / numpy.tan(numpy.radians(view.CameraViewAngle) / 2.0)
    width, height = view.ViewSize
    return (
        scale * height / width * numpy.dot(direction, right),
        scale * numpy.dot(direction, above),
        -numpy.dot(direction, backward),
    )


def error_of_light(view, direction):
    """Largest difference between the light scattered in a frame, without a look's response, and its evaluation
    on the processor of the occlusion layer read back, as a fraction of the peak; for one sun."""
    model = rays(view).GetModel()
    response = None
    if model.IsA("vtkGodRaysRadialModel"):
        response = model.GetReach(), model.GetStreaks()
        model.SetReach(0)
        model.SetStreaks(0)
        simple.Render(view)
    image, expected = vtk.vtkImageData(), vtk.vtkImageData()
    if not rays(view).GetOcclusionImage(image):
        raise AssertionError("no rays: " + rays(view).GetPlan())
    light = clip(view, direction)
    if not model.Evaluate(image, light, 1.0 / light[2], 1.0, list(view.ViewSize), expected):
        raise AssertionError("the model was not evaluated")
    scattered = layer(view)
    wanted = vtk_to_numpy(expected.GetPointData().GetScalars()).reshape(scattered.shape)
    if response:
        model.SetReach(response[0])
        model.SetStreaks(response[1])
        simple.Render(view)
    return abs(scattered - wanted).max() / wanted.max()


class Messages:
    """VTK's errors and warnings while it lasts."""

    def __enter__(self):
        self.window = vtk.vtkStringOutputWindow()
        self.former = vtk.vtkOutputWindow.GetInstance()
        vtk.vtkOutputWindow.SetInstance(self.window)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        return self

    def __exit__(self, *_):
        vtk.vtkOutputWindow.SetInstance(self.former)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_INFO)

    @property
    def text(self):
        return self.window.GetOutput()


def write(view, name):
    """The view's picture, among what the tests leave behind, to look at."""
    simple.SaveScreenshot(os.path.join(TEMPORARY, name + ".png"), view)


class Case(unittest.TestCase):
    """A session of its own: nothing of the former test is left."""

    def setUp(self):
        simple.ResetSession()
        simple._DisableFirstRenderCameraReset()

    def assert_alike(self, a, b, levels=0):
        self.assertEqual(a.shape, b.shape)
        self.assertLessEqual(abs(a - b).max(), levels)

    def assert_different(self, a, b, levels=20):
        self.assertEqual(a.shape, b.shape)
        self.assertGreater(abs(a - b).max(), levels)


def main():
    """Run the tests; pvbatch has taken the arguments."""
    program = unittest.main(module="__main__", argv=[sys.argv[0], "-v"], exit=False)
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0 if program.result.wasSuccessful() else 1)  # ParaView's own exit loses the status
