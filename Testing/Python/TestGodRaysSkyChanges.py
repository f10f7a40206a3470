# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A sky, and the rays of its sun before it, that are changed between frames: the next picture is that of a new window
which had the change from the beginning."""

import unittest

import godrays
import numpy
import vtkmodules.vtkInteractionStyle
import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow, vtkUnsignedCharArray
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

SIZE = (96, 72)


class Scene:
    """Pillars on a plain, their air, sky and sun; look along the y axis, to the sun."""

    def __init__(self, model):
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(*SIZE)
        self.renderer = vtkRenderer()
        self.window.AddRenderer(self.renderer)
        self.pillars = [self.add((2.0 * i - 5.0, 30.0, 2.0), (0.6, 0.6, 8.0 + i % 3)) for i in range(6)]
        self.plain = self.add((0.0, 500.0, -2.0), (2000.0, 1000.0, 0.5))
        self.camera = self.renderer.GetActiveCamera()
        self.camera.SetPosition(0, 0, 1.8)
        self.camera.SetFocalPoint(0, 30, 5)
        self.camera.SetViewUp(0, 0, 1)
        self.camera.SetViewAngle(40)
        self.camera.SetClippingRange(0.1, 2000)
        self.sky = godrays.vtkGodRaysSkyPass.Attach(self.renderer)
        self.sky.SetSunAzimuth(4)
        self.sky.SetSunElevation(14)
        self.air = self.sky.GetAtmosphere()
        self.rays = godrays.vtkGodRaysPass()
        if model:
            self.rays.ApplyPreset(model)
        self.light = vtkLight()
        self.renderer.AddLight(self.light)
        self.rays.AddLight(self.light)
        self.rays.Attach(self.renderer)

    def add(self, center, lengths):
        cube = vtkCubeSource()
        cube.SetCenter(center)
        cube.SetXLength(lengths[0])
        cube.SetYLength(lengths[1])
        cube.SetZLength(lengths[2])
        actor = vtkActor()
        actor.SetMapper(vtkPolyDataMapper())
        actor.GetMapper().SetInputConnection(cube.GetOutputPort())
        self.renderer.AddActor(actor)
        return actor

    def picture(self):
        self.sky.UpdateLight(self.light)
        self.window.Render()
        values = vtkUnsignedCharArray()
        width, height = self.window.GetSize()
        self.window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, values)
        return vtk_to_numpy(values).reshape(height, width, 4).astype(int)

    def end(self):
        self.rays.Detach(self.renderer)
        godrays.vtkGodRaysSkyPass.Detach(self.renderer)
        self.window.Finalize()


def make_air(scene):
    air = godrays.vtkGodRaysAtmosphere()
    air.LoadPreset("mars")
    scene.sky.SetAtmosphere(air)


CHANGES = {
    "elevation": lambda s: s.sky.SetSunElevation(3),
    "azimuth": lambda s: s.sky.SetSunAzimuth(-9),
    "the sun, in place": lambda s: s.sky.GetSun().SetElevation(6),
    "the sun's radius": lambda s: s.sky.GetSun().SetAngularRadius(2),
    "up": lambda s: s.sky.SetUp(0.1, 0, 1),
    "north": lambda s: s.sky.SetNorth(0.2, 1, 0),
    "origin": lambda s: s.sky.SetOrigin(0, 0, -8000),
    "unit": lambda s: s.sky.SetWorldUnitInMeters(100),
    "exposure": lambda s: s.sky.SetExposure(0.02),
    "white balance": lambda s: s.sky.SetWhiteBalance(not s.sky.GetWhiteBalance()),
    "shoulder": lambda s: s.sky.SetHighlightShoulder(not s.sky.GetHighlightShoulder()),
    "disc": lambda s: s.sky.SetSunDisc(not s.sky.GetSunDisc()),
    "multiple scattering": lambda s: s.sky.SetMultipleScattering(not s.sky.GetMultipleScattering()),
    "the air's preset": lambda s: s.air.LoadPreset("earth-hazy"),
    "haze, in place": lambda s: s.air.SetMieScattering(4e-5, 4e-5, 4e-5),
    "ozone, in place": lambda s: s.air.SetOzoneAbsorption(2e-5, 2e-5, 2e-5),
    "another air": make_air,
    "camera": lambda s: s.camera.Azimuth(5),
    "height": lambda s: (s.camera.SetPosition(0, 0, 900), s.camera.SetFocalPoint(0, 30, 903)),
    "a pillar hidden": lambda s: s.pillars[2].VisibilityOff(),
    "a pillar moved": lambda s: s.pillars[3].SetPosition(0.5, 0, 1),
    "window": lambda s: s.window.SetSize(110, 60),
    "rays": lambda s: s.rays.SetIntensity(0.2),
}


class SkyChanges(unittest.TestCase):
    def setUp(self):
        self.said = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.said)

    def tearDown(self):
        vtkOutputWindow.SetInstance(None)
        self.assertEqual(self.said.GetOutput(), "")

    def check(self, model, names):
        scene = Scene(model)
        picture = scene.picture()
        scene.rays.SetIntensity(0)
        self.assertGreater((numpy.abs(picture - scene.picture()).max(axis=2) > 5).mean(), 0.1, "rays")
        scene.end()
        for name in names:
            change = CHANGES[name]
            with self.subTest(name):
                old, new = Scene(model), Scene(model)
                old.picture()
                before = old.picture()
                change(old)
                after = old.picture()
                change(new)
                wanted = new.picture()
                self.assertEqual(after.shape, wanted.shape)
                # A table is kept where it is as good for the new camera.
                self.assertLessEqual(numpy.abs(after - wanted).max(), 1 if name == "camera" else 0)
                if after.shape == before.shape:
                    self.assertGreater(numpy.abs(after - before).max(), 0, "it changes nothing")
                old.end()
                new.end()

    def test_with_a_look(self):
        self.check("low-sun", CHANGES)

    def test_with_a_medium(self):
        self.check("haze", ("elevation", "the air's preset", "unit", "camera", "a pillar moved", "window"))


if __name__ == "__main__":
    unittest.main()
