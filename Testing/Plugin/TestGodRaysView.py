# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The view: it draws rays, of the brightness of the model; without them it is ParaView's."""

import os

from plugin_testing import *


class View(Case):
    def test_rays_are_those_of_the_model(self):
        view = make_view()
        view.Integrator = "Taps"  # which the model evaluates one by one
        add_pillars(view)
        simple.Render(view)
        plan = rays(view).GetPlan()
        self.assertIn("geometry rendered once", plan)
        angle = numpy.radians(view.SunElevation)
        direction = (0.0, numpy.sin(angle), -numpy.cos(angle))
        self.assertLess(error_of_light(view, direction), 2e-3)
        # a control: the sun elsewhere is told from it
        wrong = (0.0, numpy.sin(1.2 * angle), -numpy.cos(1.2 * angle))
        self.assertGreater(error_of_light(view, wrong), 2e-2)
        # and it is added to the picture: bright above, and dark behind the middle pillar
        light = layer(view)
        self.assertGreater(light[100, 75].min(), 0.2)
        self.assertLess(light[5, 80].max(), 0.25 * light[5, 120].max())
        write(view, "PluginView")

    def test_without_rays_it_is_a_render_view(self):
        plain = make_view("RenderView")
        add_pillars(plain)
        expected = pixels(plain)
        view = make_view()
        add_pillars(view)
        self.assert_different(pixels(view), expected, 50)
        view.Intensity = 0.0
        self.assert_alike(pixels(view), expected)
        view.Intensity = 1.0
        view.UseGodRays = 0
        self.assert_alike(pixels(view), expected)
        view.UseGodRays = 1
        self.assert_different(pixels(view), expected, 50)

    def test_its_picture_is_the_baseline(self):
        sun = {"SunAzimuth": 4, "SunElevation": 9, "SunColor": [1.0, 0.85, 0.6]}
        view = make_view(size=(480, 360), **sun)
        add_colonnade(view)
        write(view, "Plugin-View")
        expected = baseline("Plugin-View")
        self.assert_alike(pixels(view), expected, 2)
        view.SunElevation = 12.0
        self.assert_different(pixels(view), expected)
        view.UseGodRays = 0
        self.assert_different(pixels(view), expected, 50)

    def test_the_sun_in_the_world(self):
        view = make_view()
        add_pillars(view)
        expected = pixels(view)
        view.SunFrame = "World, Y up"
        self.assert_alike(pixels(view), expected, 1)
        view.SunFrame = "World, Z up"  # north is +y: above the picture, at right angles to the view
        self.assert_different(pixels(view), expected)
        view.CameraPosition = [0, -8, 0]
        view.CameraViewUp = [0, 0, 1]
        view.SunAzimuth = 10.0
        simple.Render(view)
        a, e = numpy.radians([10.0, 10.0])
        north_and_up = (numpy.cos(e) * numpy.sin(a), numpy.cos(e) * numpy.cos(a), numpy.sin(e))
        self.assertLess(error_of_light(view, north_and_up), 2e-3)
        view.SunFrame = "World, X up"
        view.CameraPosition = [0, 0, -8]
        view.CameraViewUp = [1, 0, 0]
        simple.Render(view)
        north_and_up = (numpy.sin(e), numpy.cos(e) * numpy.sin(a), numpy.cos(e) * numpy.cos(a))
        self.assertLess(error_of_light(view, north_and_up), 2e-3)

    def test_the_sun_by_date_and_place(self):
        # the example of the solar position algorithm, [RedaAndreas2004], in thicker air
        place = {
            "SunPosition": "Date and place",
            "SunFrame": "World, Z up",
            "SunDate": [2003, 10, 17],
            "SunTimeOfDay": 12 + 30 / 60 + 30 / 3600,
            "SunTimeZone": -7.0,
            "SunLatitude": 39.742476,
            "SunLongitude": -105.1786,
        }
        view = make_view(CameraPosition=[2.0, 6.7, -4.0], CameraViewUp=[0, 0, 1], **place)
        view.Integrator = "Taps"  # which the model evaluates one by one
        add_pillars(view)
        shown = pixels(view)
        view.UpdatePropertyInformation()
        azimuth, elevation = view.GetPropertyValue("SunAngles")
        self.assertAlmostEqual(azimuth, 194.3402, delta=0.005)
        self.assertAlmostEqual(elevation, 90.0 - 50.1116, delta=0.02)
        a, e = numpy.radians([azimuth, elevation])
        south = (numpy.cos(e) * numpy.sin(a), numpy.cos(e) * numpy.cos(a), numpy.sin(e))
        self.assertLess(error_of_light(view, south), 2e-3)

        by_angles = {"SunPosition": "Azimuth and elevation", "SunAzimuth": azimuth}
        for name, value in {**by_angles, "SunElevation": elevation}.items():
            setattr(view, name, value)
        self.assert_alike(pixels(view), shown)
        view.SunPosition = "Date and place"
        view.SunTimeOfDay = 10.0
        self.assert_different(pixels(view), shown)

        # it goes down, and does not shine from below
        view.SunTimeOfDay = 23.0
        simple.Render(view)
        self.assertIn("light: none", rays(view).GetPlan())
        view.SunPosition = "Azimuth and elevation"
        view.SunElevation = -20.0
        simple.Render(view)
        self.assertNotIn("light: none", rays(view).GetPlan())

    def test_up_and_north(self):
        view = make_view(SunFrame="World, Y up", SunAzimuth=5.0)
        add_pillars(view)
        expected = pixels(view)
        view.SunFrame = "World, by Up and North"
        self.assert_different(pixels(view), expected)  # as on a map
        view.SunUp = [0, 2, 0]
        view.SunNorth = [0, 7, -3]
        self.assert_alike(pixels(view), expected)
        with Messages() as messages:
            view.SunNorth = [0, 1, 0]
            simple.Render(view)
            simple.Render(view)
        self.assertEqual(messages.text.count("parallel"), 1, messages.text)
        self.assertIn("light: none", rays(view).GetPlan())
        view.SunNorth = [0, 0, -1]
        self.assert_alike(pixels(view), expected)

    def test_lights_of_the_light_inspector(self):
        view = make_view(LightSource="What is tagged as a light")
        add_pillars(view)
        dark = pixels(view)
        self.assertIn("light: none", rays(view).GetPlan())
        lamp = simple.AddLight(view=view)
        lamp.Coords = "Scene"
        lamp.Type = "Directional"
        lamp.Position = [0.0, 1.0, -5.0]
        lamp.FocalPoint = [0.0, 0.0, 0.0]
        lamp.DiffuseColor = [1.0, 0.2, 0.2]
        unlit = pixels(view)
        view.LightSource = "Lights of the Light Inspector"
        shining = pixels(view)
        self.assert_different(shining, unlit, 50)
        direction = numpy.array([0.0, 1.0, -5.0]) / numpy.sqrt(26.0)
        self.assertLess(error_of_light(view, direction), 2e-3)
        light = layer(view)
        self.assertGreater(light[:, :, 0].max(), 10 * light[:, :, 1].max())
        # the same light by the view's list, whatever LightSource says
        view.LightSource = "What is tagged as a light"
        view.Lights = [lamp]
        self.assert_alike(pixels(view), shining)
        view.Lights = []
        self.assert_alike(pixels(view), unlit)
        self.assertLess(abs(unlit - dark).max(), 256)

    def test_shadows_on_surfaces(self):
        """Of a box over a floor, from straight above, in a sun at 45 degrees on the right; 20 pixels are 1."""
        view = make_view(LightSource="What is tagged as a light", UseLight=0, CameraParallelProjection=1)
        view.CameraParallelScale = 3.0
        floor = simple.Box(XLength=12, YLength=12, ZLength=0.1, Center=[0, 0, -0.05])
        show_joined([floor, simple.Box(XLength=0.6, YLength=0.6, ZLength=0.4, Center=[0, 0, 1.2])], view)
        sun = simple.AddLight(view=view)
        sun.Coords, sun.Type = "Scene", "Directional"
        sun.Position, sun.FocalPoint = [1.0, 0.0, 1.0], [0.0, 0.0, 0.0]
        before = pixels(view)
        view.SurfaceShadows = 1
        darker = before - pixels(view)
        self.assertGreater(darker[56:64, 50:62].min(), 40)
        darker[50:70, 42:70] = 0
        self.assertLessEqual(abs(darker).max(), 1)

    def test_presets(self):
        view = make_view()
        add_pillars(view)
        default = pixels(view)
        view.Preset = "long-shafts"
        crisp = pixels(view)
        self.assert_different(crisp, default, 10)
        view.Model.Density = 0.3
        self.assert_alike(pixels(view), crisp)  # the model counts with "custom" alone
        view.Preset = "custom"
        self.assert_different(pixels(view), crisp, 10)
        self.assertEqual(rays(view).GetModel().GetDensity(), 0.3)
        view.Model.Density = 0.97
        self.assert_alike(pixels(view), default)
        with Messages() as messages:
            view.SMProxy.GetProperty("Preset").SetElement(0, "no-such-look")
            view.SMProxy.UpdateVTKObjects()
        self.assertIn("low-sun", messages.text)
        self.assertIn("sea-water", messages.text)
        self.assert_alike(pixels(view), default)

    def test_tone_mapping_comes_after_the_rays(self):
        plain = make_view("RenderView")
        add_pillars(plain)
        # a pillar is lit in part
        view = make_view(BackgroundGlow=0.4, BackgroundGlowFalloff=18, AutomaticExposure=0)
        add_pillars(view)
        plain.UseFXAA = view.UseFXAA = 0  # ParaView would smooth edges twice
        with_rays = pixels(view)
        without = pixels(plain)
        rays(view).SetDisplayTransfer(rays(view).POWER_TRANSFER)  # as within the mapping
        joined = pixels(view)
        for each in (plain, view):
            each.ToneMappingType = 2  # exponential: each of red, green and blue for itself
            each.Exposure = 1.5
            each.UseToneMapping = 1
            each.UseFXAA = 0
        mapped = pixels(view)
        mapped_without = pixels(plain)
        self.assert_different(mapped, mapped_without, 30)
        self.assert_different(mapped, with_rays, 5)
        # on a pillar, the mapping of what the picture shows with rays (ParaView leaves out the
        # background)
        pillar = joined[40:80, 50:54] / 255.0
        self.assertGreater(pillar.max() - pillar.min(), 0.1)
        expected = 255.0 * (1.0 - numpy.exp(-1.5 * pillar**2.2)) ** (1.0 / 2.2)
        self.assertLess(abs(mapped[40:80, 50:54] - expected).max(), 2)
        self.assertGreater(abs(with_rays[40:80, 50:54] - expected).max(), 10)
        plain.UseToneMapping = view.UseToneMapping = 0
        self.assert_alike(pixels(view), with_rays)
        self.assert_alike(pixels(plain), without)
        view.UseGodRays = 0
        view.UseToneMapping = 1
        self.assert_alike(pixels(view), mapped_without)
        view.UseGodRays = 1
        self.assert_alike(pixels(view), mapped)

    def test_fxaa_and_ambient_occlusion(self):
        for name in ("UseFXAA", "UseAmbientOcclusion"):
            with self.subTest(name):
                plain = make_view("RenderView", **{name: 1})
                add_pillars(plain)
                expected = pixels(plain)
                setattr(plain, name, 0)
                self.assert_different(pixels(plain), expected, 2)
                view = make_view(**{name: 1})
                add_pillars(view)
                self.assert_different(pixels(view), expected, 50)
                view.Intensity = 0.0
                self.assert_alike(pixels(view), expected)

    def test_views_come_and_go(self):
        with Messages() as messages:
            for _ in range(3):
                view = make_view()
                add_pillars(view)
                simple.Render(view)
                simple.Delete(view)
        self.assertEqual(messages.text, "")


main()
