# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python module godrays: enable, tag, disable, its errors, and that rays are seen."""

import datetime
import gc
import math
import types
import unittest
import warnings

import godrays
from godrays import vtkGodRaysPass
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkCubeSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)
from vtkmodules.vtkRenderingOpenGL2 import vtkToneMappingPass


def make_actor(source):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def make_scene():
    """A window with a cone, and the cone."""
    cone = make_actor(vtkConeSource())
    renderer = vtkRenderer()
    renderer.AddActor(cone)
    renderer.GetActiveCamera().SetPosition(0, 0, 5)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(120, 90)
    window.AddRenderer(renderer)
    return window, renderer, cone


def pixels(window):
    window.Render()
    data = vtkUnsignedCharArray()
    width, height = window.GetSize()
    window.GetPixelData(0, 0, width - 1, height - 1, 0, data, 0)
    return bytes(memoryview(data))


BEHIND = (0.1, 0.15, -1)  # a sun behind the cone, seen from the camera


class Enable(unittest.TestCase):
    def test_rays_change_pixels_and_disable_restores_them(self):
        window, renderer, _ = make_scene()
        before = pixels(window)
        rays = godrays.enable(renderer, light=BEHIND)
        changed = sum(a != b for a, b in zip(before, pixels(window)))
        self.assertGreater(changed, 1000, rays.GetPlan())
        godrays.disable(renderer)
        self.assertEqual(pixels(window), before)
        self.assertIsNone(renderer.GetPass())

    def test_a_sun_is_placed_where_nothing_shines(self):
        window, renderer, _ = make_scene()
        before = pixels(window)
        rays = godrays.enable(renderer)
        self.assertEqual(rays.GetSunPlacement(), vtkGodRaysPass.SUN_EVERY_VIEW)
        changed = sum(a != b for a, b in zip(before, pixels(window)))
        self.assertGreater(changed, 1000, rays.GetPlan())
        self.assertEqual(rays.GetNumberOfLights(), 1)
        placed = rays.GetLight(0).GetPosition()
        self.assertTrue(all(light.LightTypeIsHeadlight() for light in renderer.GetLights()))
        godrays.enable(renderer, intensity=0.5)  # keeps it
        pixels(window)
        self.assertEqual(rays.GetLight(0).GetPosition(), placed)
        godrays.enable(renderer, sun_at=(0.9, 0.8))
        self.assertEqual(rays.GetSunPlacement(), vtkGodRaysPass.SUN_BY_HAND)
        pixels(window)
        self.assertEqual(rays.GetNumberOfLights(), 1)
        self.assertNotEqual(rays.GetLight(0).GetPosition(), placed)
        godrays.enable(renderer, light=BEHIND)
        pixels(window)
        self.assertEqual(rays.GetNumberOfLights(), 1)
        self.assertEqual(rays.GetLight(0).GetPosition(), BEHIND)
        godrays.enable(renderer, sun_placement="sun_every_view")
        self.assertEqual(rays.GetSunPlacement(), vtkGodRaysPass.SUN_EVERY_VIEW)
        for wrong in ((0.5,), (0.5, math.nan), (1, 2, 3)):
            with self.assertRaisesRegex(ValueError, "a place in the picture"):
                godrays.enable(renderer, sun_at=wrong)

    def test_the_sun_of_a_date_and_place(self):
        # the example of the solar position algorithm, [RedaAndreas2004]
        zone = datetime.timezone(datetime.timedelta(hours=-7))
        dates = ("2003-10-17T12:30:30-07:00", datetime.datetime(2003, 10, 17, 12, 30, 30, 0, zone))
        for date in dates:
            east, north, up = godrays.sun(date, 39.742476, -105.1786)
            self.assertAlmostEqual(math.degrees(math.atan2(east, north)) % 360, 194.34, 2)
            self.assertAlmostEqual(math.degrees(math.asin(up)), 39.888, delta=0.02)
        turned = godrays.sun(dates[0], 39.742476, -105.1786, up=(0, 2, 0), north=(0, 1, -1))
        self.assertAlmostEqual(math.dist(turned, (east, up, -north)), 0.0)
        _, renderer, _ = make_scene()
        rays = godrays.enable(renderer, light=turned)
        self.assertEqual(rays.GetLight(0).GetPosition(), turned)
        for wrong, words in (
            (("noon", 0, 0), "noon"),
            ((dates[0], 91, 0), "latitude 91"),
            ((dates[0], math.nan, 0), "latitude nan"),
            ((dates[0], 39.7, 105.2), "below the horizon"),
            ((dates[0], 39.7, -105.2, (0, 0, 1), (0, 0, 2)), "parallel"),
        ):
            with self.assertRaisesRegex(ValueError, words):
                godrays.sun(*wrong)

    def test_every_kind_of_target(self):
        window, renderer, _ = make_scene()
        plotter = types.SimpleNamespace(renderer=renderer)
        for target in (renderer, window, plotter):
            rays = godrays.enable(target, light=BEHIND)
            self.assertIsInstance(rays, vtkGodRaysPass)
            self.assertIs(renderer.GetPass(), rays)
            godrays.disable(target)
            self.assertIsNone(renderer.GetPass())
            godrays.disable(target)  # again: nothing happens

    def test_disable_takes_off_a_pass_set_by_hand(self):
        _, renderer, _ = make_scene()
        rays = vtkGodRaysPass()
        renderer.SetPass(rays)
        godrays.disable(renderer)
        self.assertIsNone(renderer.GetPass())
        outer = vtkToneMappingPass()
        outer.SetDelegatePass(rays)
        renderer.SetPass(outer)
        with self.assertRaisesRegex(ValueError, "vtkToneMappingPass.*SetDelegatePass"):
            godrays.disable(renderer)
        self.assertIs(outer.GetDelegatePass(), rays)

    def test_wrong_targets(self):
        with self.assertRaisesRegex(TypeError, "vtkRenderer.*not int"):
            godrays.enable(1, light=BEHIND)
        with self.assertRaisesRegex(ValueError, "AddRenderer"):
            godrays.enable(vtkRenderWindow(), light=BEHIND)

    def test_every_kind_of_light(self):
        _, renderer, _ = make_scene()
        lamp = vtkLight()
        sphere = make_actor(vtkSphereSource())
        renderer.AddActor(sphere)
        rays = godrays.enable(renderer, light=[lamp, sphere, [0, 1, 0]])
        self.assertEqual(rays.GetNumberOfLights(), 2)
        self.assertIs(rays.GetLight(0), lamp)
        self.assertEqual(rays.GetLight(1).GetPosition(), (0, 1, 0))
        self.assertFalse(rays.GetLight(1).GetPositional())
        self.assertEqual(vtkGodRaysPass.GetRole(sphere), vtkGodRaysPass.LIGHT)

    def test_wrong_lights(self):
        _, renderer, _ = make_scene()
        with self.assertRaisesRegex(TypeError, "vtkLight.*not str"):
            godrays.enable(renderer, light=["sun"])
        for direction in ((0, 0, 0), (float("nan"), 0, 1), (float("inf"), 0, 1)):
            with self.assertRaisesRegex(ValueError, "no direction"):
                godrays.enable(renderer, light=direction)

    def test_the_renderers_own_lights(self):
        _, renderer, cone = make_scene()
        headlight = vtkLight()
        headlight.SetLightTypeToHeadlight()
        renderer.AddLight(headlight)
        rays = godrays.enable(renderer)
        self.assertEqual(rays.GetSunPlacement(), vtkGodRaysPass.SUN_EVERY_VIEW)
        lamp = vtkLight()
        renderer.AddLight(lamp)
        rays = godrays.enable(renderer)
        self.assertEqual(rays.GetSunPlacement(), vtkGodRaysPass.SUN_IF_NO_LIGHT)
        self.assertEqual([rays.GetLight(i) for i in range(rays.GetNumberOfLights())], [lamp])

    def test_lights_that_make_no_shafts(self):
        """Those of the renderer make way for a sun; those that are named are told, once, with a remedy."""
        behind_the_eye = (0.1, 0.2, 1)
        for named in (False, True):
            window, renderer, _ = make_scene()
            before = pixels(window)
            light = vtkLight()
            light.SetPosition(behind_the_eye)
            renderer.AddLight(light)
            with warnings.catch_warnings(record=True) as caught, self.subTest(named=named):
                warnings.simplefilter("always")
                rays = godrays.enable(renderer, light=light if named else None)
                for _ in range(8):
                    changed = pixels(window)
                    renderer.GetActiveCamera().Azimuth(0 if named else 45)
                    self.assertEqual(rays.scattering is None, named, rays.plan)
            told = [str(each.message) for each in caught if each.category is godrays.GodRaysWarning]
            if named:
                self.assertEqual(len(told), 1, told)
                self.assertRegex(told[0], "no light reaches.*behind the camera.*SunPlacement")
                self.assertEqual(told[0], rays.advice.strip() + ".")
            else:
                self.assertEqual(told, [])
                self.assertNotEqual(changed, before)
                self.assertEqual(rays.GetNumberOfLights(), 2)

    def test_a_sun_by_azimuth_and_elevation(self):
        _, renderer, _ = make_scene()
        rays = godrays.enable(renderer, sun=(90, 0))
        self.assertAlmostEqual(math.dist(rays.light.GetPosition(), (1, 0, 0)), 0)
        godrays.enable(renderer, sun=(0, 30))
        self.assertAlmostEqual(math.dist(rays.light.GetPosition(), (0, 0.75**0.5, 0.5)), 0)
        self.assertEqual(rays.GetNumberOfLights(), 1)
        sky = godrays.sky(renderer, up=(0, 1, 0), north=(0, 0, -1))
        godrays.enable(renderer, sun=[0, 0])
        self.assertAlmostEqual(math.dist(rays.light.GetPosition(), (0, 0, -1)), 0)
        sun = godrays.vtkGodRaysSun()
        godrays.enable(renderer, sun=sun)  # as before, the property of the pass
        self.assertIs(rays.GetSun(), sun)
        self.assertIsNotNone(sky)

    def test_a_color_of_the_light(self):
        _, renderer, _ = make_scene()
        lamp = vtkLight()
        rays = godrays.enable(renderer, light=[lamp, BEHIND], light_color="#ff8000")
        for i in range(2):
            self.assertAlmostEqual(math.dist(rays.GetLight(i).GetDiffuseColor(), (1, 128 / 255, 0)), 0)
        window, renderer, _ = make_scene()
        rays = godrays.enable(renderer, light_color=(0, 0, 1))  # of a sun that is yet to be placed
        window.Render()
        self.assertEqual(rays.light.GetDiffuseColor(), (0, 0, 1))
        red, _, blue = rays.scattering.mean((0, 1))
        self.assertGreater(blue, 10 * red)

    def test_light_preset_and_repr_of_the_rays(self):
        window, renderer, cone = make_scene()
        rays = godrays.enable(renderer)
        self.assertRegex(repr(rays), r"^<vtkGodRaysPass: default, intensity 1, 0 lights; no frame yet>$")
        self.assertIsNone(rays.light)
        rays.light = BEHIND
        self.assertEqual(rays.light.GetPosition(), BEHIND)
        self.assertEqual(rays.GetSunPlacement(), vtkGodRaysPass.SUN_BY_HAND)
        rays.light = cone
        self.assertIsNone(rays.light)
        self.assertEqual(vtkGodRaysPass.GetRole(cone), vtkGodRaysPass.LIGHT)
        godrays.tag(cone, "automatic")
        rays.light = None
        window.Render()
        self.assertIsNotNone(rays.light)
        for name in godrays.presets():
            rays.preset = name
            self.assertEqual(rays.model.Describe(), godrays.vtkGodRaysPresets.NewModel(name).Describe())
            same = godrays.vtkGodRaysPresets.NewModel(rays.preset)
            self.assertEqual(same.Describe(), rays.model.Describe())
        rays.preset = "fog"
        self.assertEqual(rays.preset, "fog")
        rays.asymmetry = 0.123
        self.assertIsNone(rays.preset)
        with self.assertRaisesRegex(ValueError, "no preset 'fogg'; did you mean fog"):
            rays.preset = "fogg"
        window.Render()
        self.assertRegex(repr(rays), "vtkGodRaysHomogeneousModel.*1 lights; light: .*scattering")
        self.assertIn("Intensity: 1", str(rays))
        with self.assertRaisesRegex(godrays.Error, "on no renderer"):
            vtkGodRaysPass().light = BEHIND

    def test_a_tagged_prop_is_light_enough(self):
        _, renderer, cone = make_scene()
        godrays.tag(cone, "light")
        self.assertEqual(godrays.enable(renderer).GetNumberOfLights(), 0)

    def test_again_changes_the_pass_that_is_there(self):
        _, renderer, cone = make_scene()
        rays = godrays.enable(renderer, light=cone)
        self.assertIs(godrays.enable(renderer, intensity=0.5), rays)
        self.assertEqual(vtkGodRaysPass.GetRole(cone), vtkGodRaysPass.LIGHT)
        self.assertIs(godrays.enable(renderer, light=BEHIND), rays)
        self.assertEqual(rays.GetNumberOfLights(), 1)
        self.assertEqual(vtkGodRaysPass.GetRole(cone), vtkGodRaysPass.AUTOMATIC)
        self.assertEqual(rays.GetIntensity(), 0.5)

    def test_the_renderer_keeps_the_pass_and_nothing_else_does(self):
        window, renderer, _ = make_scene()
        deleted = []
        rays = godrays.enable(renderer, light=BEHIND)
        rays.AddObserver("DeleteEvent", lambda *_: deleted.append(True))
        del rays
        gc.collect()
        window.Render()
        self.assertIsInstance(renderer.GetPass(), vtkGodRaysPass)
        self.assertEqual(deleted, [])
        del window, renderer
        gc.collect()
        self.assertEqual(deleted, [True])


class Parameters(unittest.TestCase):
    def setUp(self):
        self.window, self.renderer, self.cone = make_scene()

    def enable(self, **parameters):
        return godrays.enable(self.renderer, light=BEHIND, **parameters)

    def test_both_spellings_of_pass_and_model(self):
        rays = self.enable(background_glow=0.25, SunAngularRadius=2, density=0.5, NumberOfSamples=9)
        self.assertEqual(rays.GetBackgroundGlow(), 0.25)
        self.assertEqual(rays.GetSunAngularRadius(), 2)
        self.assertEqual(rays.GetModel().GetDensity(), 0.5)
        self.assertEqual(rays.GetModel().GetNumberOfSamples(), 9)

    def test_constants_by_name(self):
        rays = self.enable(output="scattering", model="published", formulation="babylon")
        self.assertEqual(rays.GetOutput(), vtkGodRaysPass.SCATTERING)
        self.assertEqual(rays.GetModel().GetFormulation(), rays.GetModel().BABYLON)

    def test_an_unknown_constant_changes_nothing(self):
        with self.assertRaisesRegex(ValueError, "output='bogus'.*vtkGodRaysPass.*scattering"):
            self.enable(output="bogus")
        with self.assertRaisesRegex(ValueError, "formulation='nobody'.*PublishedModel.*three_js"):
            self.enable(model="published", formulation="nobody")
        self.assertIsNone(self.renderer.GetPass())

    def test_a_model_of_ones_own(self):
        model = godrays.vtkGodRaysRadialModel()
        rays = self.enable(model=model, decay=0.9)
        self.assertIs(rays.GetModel(), model)
        self.assertEqual(model.GetDecay(), 0.9)

    def test_preset_comes_first(self):
        name = godrays.vtkGodRaysRadialModel.GetPresetName(0)
        rays = self.enable(density=0.125, preset=name)
        self.assertEqual(rays.GetModel().GetDensity(), 0.125)

    def test_an_unknown_parameter_changes_nothing(self):
        with self.assertRaisesRegex(TypeError, "densty.*background_glow.*density.*sun_angular"):
            self.enable(densty=1)
        self.assertIsNone(self.renderer.GetPass())

    def test_volumes_as_medium(self):
        window, renderer, _ = make_scene()
        import vtkmodules.all as vtk

        image = vtk.vtkImageData()
        image.SetDimensions(9, 9, 9)
        image.SetSpacing(0.25, 0.25, 0.25)
        image.SetOrigin(-1, -1, -1)
        image.AllocateScalars(vtk.VTK_FLOAT, 1)
        image.GetPointData().GetScalars().Fill(1)
        mapper = vtk.vtkGPUVolumeRayCastMapper()
        mapper.SetInputData(image)
        volume = vtk.vtkVolume()
        volume.SetMapper(mapper)
        opacity = vtk.vtkPiecewiseFunction()
        opacity.AddPoint(0, 0)
        opacity.AddPoint(2, 1)
        volume.GetProperty().SetScalarOpacity(opacity)
        renderer.AddVolume(volume)
        rays = godrays.enable(
            renderer, light=BEHIND, medium=volume, data_albedo=(0.9, 0.8, 0.7), data_asymmetry=0.2
        )
        window.Render()
        self.assertEqual(rays.GetModel().GetClassName(), "vtkGodRaysVolumeModel")
        self.assertEqual(rays.GetModel().GetDataAlbedo(), (0.9, 0.8, 0.7))
        self.assertEqual(rays.GetModel().GetDataAsymmetry(), 0.2)
        self.assertIn("data of 1 volumes", rays.GetPlan())
        godrays.enable(renderer, medium=[volume], preset="haze")
        window.Render()
        self.assertEqual(rays.GetModel().GetClassName(), "vtkGodRaysHomogeneousModel")
        self.assertIn("data of 1 volumes", rays.GetPlan())
        godrays.tag(volume, "ignored")
        window.Render()
        self.assertNotIn("data of", rays.GetPlan())

    def test_a_medium_by_preset_or_name(self):
        window, renderer, _ = make_scene()
        shadows = godrays.vtkGodRaysShadowMapIntegrator()
        rays = godrays.enable(
            renderer, light=BEHIND, preset="fog", asymmetry=0.3, integrator=shadows, map_size=512
        )
        self.assertEqual(rays.GetModel().GetClassName(), "vtkGodRaysHomogeneousModel")
        self.assertEqual(rays.GetModel().GetScatteringCoefficient(), (0.015,) * 3)
        self.assertEqual(rays.GetModel().GetAsymmetry(), 0.3)
        self.assertEqual(rays.GetIntegrator().GetMapSize(), 512)
        foggy = pixels(window)
        godrays.enable(renderer, model="atmosphere", mie_scattering=(0.01, 0.01, 0.01))
        self.assertEqual(rays.GetModel().GetClassName(), "vtkGodRaysAtmosphereModel")
        godrays.enable(renderer, preset="published:mitchell")
        self.assertEqual(rays.GetModel().GetClassName(), "vtkGodRaysPublishedModel")
        self.assertNotEqual(foggy, pixels(window))
        godrays.enable(renderer, preset="low-sun")
        self.assertEqual(rays.GetModel().GetClassName(), "vtkGodRaysRadialModel")
        for wrong, words in (
            ({"model": "soup"}, "no model 'soup'; there are: radial"),
            ({"model": "radial", "preset": "fog"}, "'fog' is one of vtkGodRaysHomogeneousModel"),
        ):
            with self.assertRaisesRegex(ValueError, words):
                godrays.enable(renderer, **wrong)

    def test_a_preset_belongs_to_the_class_that_lists_it(self):
        presets = godrays.vtkGodRaysPresets
        names = []
        for model, prefix in (
            (godrays.vtkGodRaysRadialModel, ""),
            (godrays.vtkGodRaysHomogeneousModel, ""),
            (godrays.vtkGodRaysPublishedModel, "published:"),
        ):
            for i in range(model.GetNumberOfPresets()):
                name = prefix + model.GetPresetName(i)
                self.assertEqual(presets.GetPresetDescription(len(names)), model.GetPresetDescription(i))
                names.append(name)
                expected = model()
                expected.ApplyPreset(model.GetPresetName(i))
                again = model()
                self.assertTrue(presets.ApplyTo(again, name))
                self.assertEqual(again.Describe(), expected.Describe())
                made = presets.NewModel(name)
                self.assertEqual(made.GetReferenceCount(), 1)  # nobody else's
                self.assertEqual(made.GetClassName(), model.__name__)
                self.assertEqual(made.Describe(), expected.Describe())
                rays = vtkGodRaysPass()
                self.assertTrue(rays.ApplyPreset(name))
                self.assertEqual(rays.GetModel().Describe(), expected.Describe())
        count = presets.GetNumberOfPresets()
        self.assertEqual([presets.GetPresetName(i) for i in range(-1, count + 1)], [None, *names, None])
        self.assertEqual(presets.ListNames(), ", ".join(names))
        self.assertEqual(len(set(names)), count)
        for wrong in ("nonesuch", "", None):
            self.assertIsNone(presets.NewModel(wrong))
            self.assertFalse(presets.ApplyTo(godrays.vtkGodRaysRadialModel(), wrong))
        self.assertFalse(presets.ApplyTo(godrays.vtkGodRaysRadialModel(), "fog"))
        self.assertFalse(presets.ApplyTo(None, "default"))

    def test_an_unknown_preset_changes_nothing(self):
        with self.assertRaisesRegex(ValueError, "no preset 'nonesuch'; there are: "):
            self.enable(preset="nonesuch")
        self.assertIsNone(self.renderer.GetPass())


class Sky(unittest.TestCase):
    def test_it_is_behind_the_scene_and_under_the_rays(self):
        window, renderer, _ = make_scene()
        bare = pixels(window)
        light = vtkLight()
        sky = godrays.sky(
            renderer, sun=(200, 5), light=light, atmosphere="earth-hazy", up=(0, 1, 0),
            north=(0, 0, -1), exposure=2, MultipleScattering=False)
        self.assertIs(renderer.GetPass(), sky)
        self.assertEqual((sky.GetSunAzimuth(), sky.GetSunElevation()), (200, 5))
        self.assertEqual((sky.GetUp(), sky.GetExposure()), ((0, 1, 0), 2))
        red, _, blue = light.GetDiffuseColor()
        self.assertLess(blue, 0.9 * red)
        seen = pixels(window)
        self.assertNotEqual(bare[:3], seen[:3])
        rays = godrays.enable(renderer, light=light)
        self.assertIs(rays.GetDelegatePass(), sky)
        self.assertIs(godrays.sky(window), sky)
        godrays.disable(renderer)
        self.assertEqual(seen, pixels(window))
        self.assertTrue(godrays.vtkGodRaysSkyPass.Detach(renderer))
        self.assertEqual(bare, pixels(window))

    def test_the_sun_as_a_direction(self):
        _, renderer, _ = make_scene()
        for azimuth, elevation in ((0, 0), (80, 40), (-100, -10), (170, 89)):
            direction = [0, 0, 0]
            up, north = (0, 3, 0), (2, 1, 0)
            godrays.vtkGodRaysSunPosition.ComputeDirection(
                azimuth, elevation, up, north, direction)
            sky = godrays.sky(renderer, up=up, north=north, sun=direction)
            self.assertAlmostEqual(sky.GetSunAzimuth(), azimuth, 6)
            self.assertAlmostEqual(sky.GetSunElevation(), elevation, 6)

        sun = godrays.vtkGodRaysSun()
        self.assertIs(godrays.sky(renderer, sun=sun).GetSun(), sun)
        renderer.GetActiveCamera().SetPosition(5, 0, 0)  # in its frame, it looks to the north
        renderer.GetActiveCamera().SetFocalPoint(0, 0, 0)
        godrays.sky(renderer, sun=(-1, 1, 0))
        self.assertAlmostEqual(sun.GetAzimuth(), 0, 6)
        self.assertAlmostEqual(sun.GetElevation(), 45, 6)

    def test_errors_change_nothing(self):
        _, renderer, _ = make_scene()
        for error, words, wrong in (
            (TypeError, "no parameter expo; there are: aerial_perspective", {"expo": 1}),
            (TypeError, "no parameter sun_azimuth", {"sun_azimuth": 1}),
            (ValueError, "azimuth, elevation", {"sun": (1, 2, 3, 4)}),
            (ValueError, "azimuth, elevation", {"sun": (0, 0, 0)}),
            (TypeError, "vtkLight, not str", {"light": "sun"}),
            (ValueError, "no atmosphere 'venus'", {"atmosphere": "venus"}),
        ):
            with self.subTest(words), self.assertRaisesRegex(error, words):
                godrays.sky(renderer, **wrong)
        self.assertIsNone(renderer.GetPass())


def make_box(*bounds):
    box = vtkCubeSource()
    box.SetBounds(*bounds)
    return box


class Shadows(unittest.TestCase):
    """A box over a floor, from straight above, in the light of a sun at 45 degrees on the right."""

    def setUp(self):
        self.window, self.renderer, cone = make_scene()
        self.renderer.RemoveActor(cone)
        self.floor = make_actor(make_box(-3, 3, -3, 3, -0.1, 0))
        for actor in (self.floor, make_actor(make_box(-0.3, 0.3, -0.3, 0.3, 1, 1.4))):
            self.renderer.AddActor(actor)
        self.renderer.GetActiveCamera().ParallelProjectionOn()
        self.renderer.GetActiveCamera().SetParallelScale(2.25)  # 20 pixels are 1
        self.renderer.ResetCameraClippingRange()
        self.sun, head = vtkLight(), vtkLight()
        self.sun.SetLightTypeToSceneLight()
        self.sun.SetPosition(1, 0, 1)
        head.SetLightTypeToHeadlight()
        head.SetIntensity(0.2)
        for light in (self.sun, head):
            self.renderer.AddLight(light)

    def darkening(self, before):
        """By how much each pixel is darker than before: [levels] in the shadow, and elsewhere."""
        shadow, elsewhere = [], []
        for i, (was, now) in enumerate(zip(before[::3], pixels(self.window)[::3])):
            x, y = (i % 120 + 0.5 - 60) / 20, (i // 120 + 0.5 - 45) / 20
            if -1.6 < x < -0.8 and abs(y) < 0.2:
                shadow.append(was - now)
            elif not (-1.8 < x < -0.6 and abs(y) < 0.4):
                elsewhere.append(abs(was - now))
        return shadow, elsewhere

    def test_lights_cast_them_without_rays(self):
        before = pixels(self.window)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            shadows = godrays.shadows(self.renderer)
        self.assertIs(self.renderer.GetPass(), shadows)
        self.assertEqual((shadows.intensity, shadows.surface_shadows), (0, True))
        shadow, elsewhere = self.darkening(before)
        self.assertGreater(min(shadow), 40)
        self.assertLessEqual(max(elsewhere), 1)
        self.assertIs(godrays.shadows(self.window, untagged_props_occlude=False), shadows)
        self.assertLessEqual(max(map(max, self.darkening(before))), 1)
        godrays.disable(self.window)
        self.assertEqual(pixels(self.window), before)

    def test_data_keep_their_colours(self):
        filter = vtkElevationFilter()
        filter.SetInputConnection(self.floor.GetMapper().GetInputConnection(0, 0))
        self.floor.GetMapper().SetInputConnection(filter.GetOutputPort())
        before = pixels(self.window)
        whole, half = (
            sum(self.darkening(before)[0]) for part in (1, 0.5)
            if godrays.shadows(self.window, most_data_shadow=part))
        self.assertAlmostEqual(half / whole, 0.5, 1)
        with self.assertRaisesRegex(godrays.Error, "MostDataShadow must be"):
            godrays.shadows(self.window, most_data_shadow=math.nan)

    def test_rays_that_are_there_stay(self):
        rays = godrays.enable(self.renderer, light=BEHIND, intensity=0.5)
        self.assertIs(godrays.shadows(self.renderer), rays)
        self.assertEqual((rays.intensity, rays.surface_shadows), (0.5, True))

    def test_rays_can_be_added(self):
        shadows = godrays.shadows(self.renderer)
        self.assertIs(godrays.enable(self.renderer, light=BEHIND), shadows)
        self.assertEqual((shadows.intensity, shadows.surface_shadows), (1, True))
        godrays.enable(self.renderer, intensity=0)
        self.assertEqual(godrays.enable(self.renderer).intensity, 0)

    def test_ambient_occlusion_is_where_it_is_narrow(self):
        """A wall on the floor: its foot is darker, a floor far from it is not."""
        self.renderer.AddActor(make_actor(make_box(1.5, 1.7, -3, 3, 0, 2)))
        rays = godrays.enable(self.renderer, light=BEHIND, intensity=0)
        before = pixels(self.window)

        def column(x):
            now = pixels(self.window)
            rows = range(20, 70)
            return sum(before[3 * (120 * y + x)] - now[3 * (120 * y + x)] for y in rows) / len(rows)

        self.assertIs(godrays.enable(self.renderer, ambient_occlusion=True), rays)
        self.assertGreater(column(60 + 29), 6)
        self.assertLess(abs(column(60 - 40)), 3)
        godrays.enable(self.renderer, ambient_occlusion=False)
        self.assertEqual(pixels(self.window), before)

    def test_a_short_name(self):
        for differing in ({"surface_shadows": False}, {"SurfaceShadows": False}):
            with self.assertRaisesRegex(ValueError, "shadows=True and .*=False differ"):
                godrays.enable(self.renderer, shadows=True, **differing)
        self.assertIsNone(self.renderer.GetPass())
        before = pixels(self.window)
        rays = godrays.enable(self.renderer, intensity=0, shadows=True, surface_shadows=True)
        self.assertGreater(min(self.darkening(before)[0]), 40)
        self.assertFalse(godrays.enable(self.renderer, shadows=False).surface_shadows)
        self.assertEqual(pixels(self.window), before, rays.GetPlan())

    def test_headlights_alone_are_told(self):
        self.sun.SwitchOff()
        with self.assertWarnsRegex(godrays.GodRaysWarning, "No light.*SetLightTypeToSceneLight"):
            godrays.shadows(self.renderer)
        godrays.enable(self.renderer, light=(1, 0, 1))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            godrays.shadows(self.renderer)


class Tag(unittest.TestCase):
    def test_roles(self):
        actor = vtkActor()
        for name in ("occluder", "light", "ignored", "medium", "automatic"):
            godrays.tag(actor, name)
            self.assertEqual(vtkGodRaysPass.GetRole(actor), getattr(vtkGodRaysPass, name.upper()))
        godrays.tag(actor, vtkGodRaysPass.OCCLUDER)
        self.assertEqual(vtkGodRaysPass.GetRole(actor), vtkGodRaysPass.OCCLUDER)

    def test_enable_tags(self):
        _, renderer, cone = make_scene()
        sphere = make_actor(vtkSphereSource())
        godrays.enable(renderer, light=BEHIND, occluders=[cone], ignored=sphere)
        self.assertEqual(vtkGodRaysPass.GetRole(cone), vtkGodRaysPass.OCCLUDER)
        self.assertEqual(vtkGodRaysPass.GetRole(sphere), vtkGodRaysPass.IGNORED)
        godrays.enable(renderer, occluders=None, ignored=None)  # nothing

    def test_errors(self):
        with self.assertRaisesRegex(ValueError, "automatic, occluder, light, ignored"):
            godrays.tag(vtkActor(), "lamp")
        with self.assertRaisesRegex(TypeError, "vtkProp.*not int"):
            godrays.tag(1, "light")


if __name__ == "__main__":
    unittest.main()
