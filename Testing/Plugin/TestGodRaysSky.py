# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The sky of the view: its parameters, what is before it, and the rays in its sun's colour."""

from plugin_testing import *

UP = {"SunFrame": "World, Y up"}


def sky(view):
    """The view's pass of the sky; in built-in mode."""
    return view.GetClientSideObject().GetSkyPass()


class Sky(Case):
    def test_its_parameters(self):
        view = make_view(UseSky=1, **UP)
        view.SunAzimuth, view.SunElevation = 370.0, -3.0
        view.SkyOrigin = [1.0, -2.0, 3.0]
        view.WorldUnitInMeters = 5.0
        simple.Render(view)
        for name, value in {
            "SunAzimuth": 370.0,
            "SunElevation": -3.0,
            "Origin": (1.0, -2.0, 3.0),
            "WorldUnitInMeters": 5.0,
        }.items():
            self.assertEqual(getattr(sky(view), "Get" + name)(), value, name)
        self.assertIs(sky(view).GetSun(), rays(view).GetSun())
        up, north = [0.0] * 3, [0.0] * 3
        sky(view).GetSun().GetAxes(None, up, north)
        self.assertEqual((up, north), ([0.0, 1.0, 0.0], [0.0, 0.0, -1.0]))

        with Messages() as messages:
            sky(view).SetOrigin(float("nan"), 0.0, 0.0)
            simple.Render(view)
        self.assertEqual(messages.text.count("stays"), 1, messages.text)
        self.assertEqual(sky(view).GetOrigin(), (1.0, -2.0, 3.0))

        presets = view.SMProxy.GetProperty("SkyAtmosphere").FindDomain("vtkSMEnumerationDomain")
        for i in range(presets.GetNumberOfEntries()):
            view.SkyAtmosphere = presets.GetEntryText(i)
            expected = godrays.vtkGodRaysAtmosphere()
            expected.LoadPreset(presets.GetEntryValue(i))
            for name in ("GroundRadius", "TopHeight", "MieScattering", "GroundAlbedo"):
                actual = getattr(sky(view).GetAtmosphere(), "Get" + name)()
                self.assertEqual(actual, getattr(expected, "Get" + name)(), name)
        with Messages() as messages:
            sky(view).GetAtmosphere().LoadPreset(presets.GetNumberOfEntries())
        self.assertNotEqual(messages.text, "")

    def test_it_is_that_of_the_pass(self):
        view = make_view(UseSky=1, UseGodRays=0, SunElevation=6.0, **UP)
        plain = make_view("RenderView")
        for each in (view, plain):
            add_pillars(each)
            each.UseFXAA = 0  # ParaView shares it between views as they are made
        without = pixels(plain)
        attached = godrays.vtkGodRaysSkyPass.Attach(plain.GetRenderer())
        attached.SetUp(0, 1, 0)
        attached.SetNorth(0, 0, -1)
        attached.SetSunAzimuth(0.0)
        attached.SetSunElevation(6.0)
        expected = pixels(plain)
        self.assert_different(expected, without, 100)
        self.assert_alike(pixels(view), expected, 1)
        view.UseSky = 0
        self.assert_alike(pixels(view), without)

    def test_what_is_translucent_is_before_it(self):
        view = make_view(UseSky=1, UseGodRays=0, SunElevation=30.0, **UP)
        view.SkySunDisc = 0
        sky_alone = pixels(view)
        shown = simple.Show(simple.Plane(Origin=[-9, -9, 0], Point1=[9, -9, 0], Point2=[-9, 9, 0]), view)
        shown.ColorArrayName = ["POINTS", ""]
        shown.AmbientColor, shown.Ambient, shown.Diffuse = [0.0, 0.0, 0.0], 1.0, 0.0
        shown.Opacity = 0.5
        self.assert_alike(pixels(view), sky_alone // 2, 2)

    def test_the_air_before_the_scene(self):
        """White things 20 km away are bluer in the air of noon; 20 m away they are not."""
        view = make_view(UseSky=1, UseGodRays=0, SunElevation=50.0, SunAzimuth=120.0, **UP)
        wall = simple.Plane(Origin=[-2, 0.2, 0], Point1=[2, 0.2, 0], Point2=[-2, 1.2, 0])
        shown = simple.Show(wall, view)
        shown.ColorArrayName = ["POINTS", ""]
        shown.AmbientColor, shown.Ambient, shown.Diffuse = [0.2, 0.2, 0.2], 1.0, 0.0
        near = pixels(view)[85, 80]
        self.assert_alike(near, numpy.array([51, 51, 51]), 1)
        view.WorldUnitInMeters = 2500.0
        red, _, blue = pixels(view)[85, 80]
        self.assertGreater(blue, red + 15)
        view.SkyAerialPerspective = 0
        self.assert_alike(pixels(view)[85, 80], near)

    def test_the_horizon_of_the_camera(self):
        """With the frame Camera the horizon is straight ahead, however the camera stands."""
        view = make_view(UseSky=1, UseGodRays=0, SkySunDisc=0)
        expected = pixels(view)
        self.assertGreater(expected[70, 80].sum(), expected[50, 80].sum() + 100)
        view.CameraPosition = [300.0, 500.0, -8.0]
        view.CameraViewUp = [0.3, 0.2, 0.9]
        self.assert_alike(pixels(view), expected, 1)
        view.SunFrame = "World, Y up"
        self.assert_different(pixels(view), expected, 40)

    def test_rays_have_the_colour_of_its_sun(self):
        view = make_view(SunElevation=2.0, **UP)
        add_pillars(view)
        simple.Render(view)
        white = layer(view)
        self.assertLess(abs(white[:, :, 0] - white[:, :, 2]).max(), 1e-3 * white.max())
        view.UseSky = 1
        simple.Render(view)
        red = layer(view)
        irradiance = [0.0] * 3
        sky(view).GetSunColor(irradiance)
        ratio = irradiance[2] / irradiance[0]
        self.assertLess(ratio, 0.5)
        self.assertAlmostEqual(red[:, :, 2].sum() / red[:, :, 0].sum(), ratio, delta=0.02 * ratio)
        view.SunElevation = -2.0
        simple.Render(view)
        self.assertIsNone(layer(view))  # it has set
        view.UseSky = 0
        view.SunElevation = 2.0
        simple.Render(view)
        self.assertLess(abs(layer(view) - white).max(), 2e-3 * white.max())

    def test_axes_that_are_parallel(self):
        for source in ("Sun", "Lights of the Light Inspector"):
            for up in ([0.0, 0.0, 1.0], [float("nan"), 0.0, 0.0]):
                view = make_view(UseSky=1, SunFrame="World, by Up and North", LightSource=source)
                view.SunUp, view.SunNorth = up, [0.0, 0.0, 1.0]
                with Messages() as messages:
                    simple.Render(view)
                    simple.Render(view)
                # of the rays, of the sky
                self.assertEqual(messages.text.count("ERR"), 2, messages.text)

    def test_its_picture_is_the_baseline(self):
        view = make_view(size=(480, 360), UseSky=1, SunElevation=2.0, SunAzimuth=4.0, **UP)
        add_colonnade(view)
        write(view, "Plugin-Sky")
        expected = baseline("Plugin-Sky")
        self.assert_alike(pixels(view), expected, 2)
        view.SunElevation = 4.0
        self.assert_different(pixels(view), expected, 40)
        view.UseSky = 0
        self.assert_different(pixels(view), expected, 100)


main()
