# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every number of cameras, lights, props, passes, models and integrators, set to what is no number, or no use.

Whatever is set: no crash, what is read back is finite and not negative, nothing is darker than without rays,
and each fault is told once, with its remedy. One model and integrator after another has its turn; with
GODRAYS_LONG in the environment each value is tried with all of them.
"""

import itertools
import os
import re
import unittest

import godrays
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkBillboardTextActor3D,
    vtkCamera,
    vtkFollower,
    vtkImageSlice,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)
from vtkmodules.vtkRenderingImage import vtkImageResliceMapper

NAN = float("nan")
INF = float("inf")
VALUES = (NAN, INF, -INF, 0.0, 1e-300, -1e-300, 1e30, -1e30, 1e300, -1e300)
LONG = "GODRAYS_LONG" in os.environ
PAIRS = [(getattr(godrays, f"vtkGodRays{model.split('/')[1]}Model"),
          getattr(godrays, f"vtkGodRays{integrator.split('/')[1]}Integrator"))
         for model, integrator in itertools.product(os.environ["GODRAYS_MODELS"].split(","),
                                                    os.environ["GODRAYS_INTEGRATORS"].split(","))]
# A model of data does nothing in scenes without volumes, as these are; GodRaysVolumeMedium has its tests.
PAIRS = [(model, integrator) for model, integrator in PAIRS
         if integrator().Supports(model()) and model is not godrays.vtkGodRaysVolumeModel]
MATRICES = {  # and how they are put to use
    "SetModelTransformMatrix": None,
    "SetEyeTransformMatrix": None,
    "SetExplicitProjectionTransformMatrix": "UseExplicitProjectionTransformMatrixOn",
    "SetTransformMatrix": None,
    "SetUserMatrix": None,
}
FEW = {"SetMapSize": 128, "SetNumberOfSteps": 16, "SetNumberOfTaps": 50}  # of integrators, to be fast

REMEDY = r"[.] (Set|Move|Use|Add)\b|; it stays |; nothing is changed"
MEDIA = [pair for pair in PAIRS if pair[0]().IsA("vtkGodRaysMediumModel")]
FAULTS = (  # what is set, of what, with which models; and words of the message
    ("camera", lambda it: it.SetPosition(NAN, 0, 10), PAIRS, "the camera's Position is not finite"),
    ("camera", lambda it: it.SetFocalPoint(INF, 0, 0), PAIRS, "the camera's FocalPoint is not finite"),
    ("camera", lambda it: it.SetPosition(0, 0, 0), PAIRS, "the camera's Position is its FocalPoint"),
    ("camera", lambda it: it.SetViewUp(0, NAN, 0), PAIRS, "the camera's ViewUp is not finite"),
    ("camera", lambda it: it.SetViewUp(0, 0, 1), PAIRS, "ViewUp is along its direction of view"),
    ("camera", lambda it: it.SetViewShear(1e300, 0, 1), PAIRS, "the camera's ViewShear is not finite"),
    ("camera", lambda it: it.SetClippingRange(1, 1), PAIRS, "the camera's ClippingRange is empty"),
    ("camera", lambda it: it.SetClippingRange(1, INF), PAIRS, "the camera's ClippingRange is not finite"),
    ("camera, parallel", lambda it: it.SetParallelScale(1e-300), PAIRS, "picture has no width"),
    ("camera, parallel", lambda it: it.SetParallelScale(1e-13), MEDIA, "too small for the depth"),
    ("light", lambda it: it.SetPosition(0, INF, 0), PAIRS, "directional, number 0: its Position"),
    ("light", lambda it: it.SetIntensity(NAN), PAIRS, "directional, number 0: its Intensity"),
    ("light", lambda it: it.SetDiffuseColor(1, INF, 1), PAIRS, "directional, number 0: its DiffuseColor"),
    ("light, lamp", lambda it: it.SetPosition(1e30, 0, 0), PAIRS, "positional, number 0: its Position"),
    ("light, spot", lambda it: it.SetConeAngle(NAN), PAIRS, "positional, number 0: its ConeAngle"),
    ("actor, lamp", lambda it: it.SetPosition(1e30, 0, 0), PAIRS, "the bounds of a vtkOpenGLActor"),
    ("actor", lambda it: it.SetScale(1e300), MEDIA, "the bounds of a vtkOpenGLActor"),
    ("actor, emitter", lambda it: it.SetPosition(1e30, 0, 0), PAIRS, "LIGHT, vtkOpenGLActor: its bounds"),
)


def setters(thing):
    """(name, number of values) of each setter of floating-point numbers."""
    found = set()
    for name in dir(thing):
        if name.startswith("Set"):
            text = re.sub(r"\s+", " ", getattr(thing, name).__doc__ or "")
            for types in re.findall(rf"C\+\+: [^(]*\b{name}\(((?:double \w+(?:, )?)+)\)", text):
                found.add((name, types.count("double")))
    return sorted(found)


def former(thing, name, count):
    """The values that a setter's getter has, or zeros."""
    try:
        values = getattr(thing, "Get" + name[3:])()
    except (AttributeError, TypeError):
        return [0.0] * count
    values = list(values) if count > 1 else [values]
    return values if len(values) == count else [0.0] * count


def changes(thing):
    """(text, function that makes the change) of each setter, value and place."""
    for name, count in setters(thing):
        for number, value in enumerate(VALUES):
            for place in {count, number % count}:  # all of them, and one
                values = former(thing, name, count)
                values = [value if i == place or place == count else values[i] for i in range(count)]
                yield f"{name}({values})", lambda it, name=name, values=values: getattr(it, name)(*values)
    for name, use in MATRICES.items():
        if hasattr(thing, name):
            for number, value in enumerate((*VALUES, -1.0)):
                place = ((0, 0), (0, 3), (3, 3), (3, 2))[number % 4]

                def change(it, name=name, use=use, place=place, value=value):
                    matrix = vtkMatrix4x4()
                    matrix.SetElement(*place, value)
                    getattr(it, name)(matrix)
                    if use:
                        getattr(it, use)()

                yield f"{name}{place} {value}", change


class Scene:
    """Two boxes before a light, in a small window; the second one has a role."""

    def __init__(self):
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.1, 0.12, 0.15)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(24, 18)
        self.window.AddRenderer(self.renderer)
        box = vtkCubeSource()
        self.mapper = vtkPolyDataMapper()
        self.mapper.SetInputConnection(box.GetOutputPort())
        self.rays = None

    def set_up(self, pair, kind):
        """Everything but the window made anew; what numbers are changed of."""
        if self.rays:
            self.rays.Detach(self.renderer)
        self.renderer.RemoveAllViewProps()
        self.renderer.RemoveAllLights()
        camera = vtkCamera()
        camera.SetPosition(0, 0, 10)
        camera.SetViewAngle(40)
        camera.SetClippingRange(1, 100)
        camera.SetParallelScale(4)
        camera.SetParallelProjection("parallel" in kind)
        camera.SetUseOffAxisProjection("off-axis" in kind)
        camera.SetScreenBottomLeft(-1, -0.75, -2)
        camera.SetScreenBottomRight(1, -0.75, -2)
        camera.SetScreenTopRight(1, 0.75, -2)
        self.renderer.SetActiveCamera(camera)
        actors = [vtkActor(), vtkActor()]
        for i, actor in enumerate(actors):
            actor.SetMapper(self.mapper)
            actor.SetPosition(2 * i - 1, 0.5, 0)
            self.renderer.AddActor(actor)
        light = vtkLight()
        light.SetPosition(0.3, 0.4, -1)
        light.SetPositional("lamp" in kind or "spot" in kind)
        light.SetConeAngle(30 if "spot" in kind else 180)
        light.SetFocalPoint(*((0.3, 0.4, 5) if "spot" in kind else (0, 0, 0)))
        self.renderer.AddLight(light)
        self.rays = godrays.vtkGodRaysPass()
        self.rays.SetModel(pair[0]())
        self.rays.SetIntegrator(pair[1]())
        self.rays.AddLight(light)
        if hasattr(self.rays.GetModel(), "SetUp"):
            self.rays.GetModel().SetUp(0, 1, 0)  # the light is above the horizon
        if hasattr(self.rays.GetModel(), "SetAttenuateScene"):
            self.rays.GetModel().SetAttenuateScene(False)
        for name, most in FEW.items():
            if hasattr(self.rays.GetIntegrator(), name):
                getattr(self.rays.GetIntegrator(), name)(most)
        if "emitter" in kind:
            godrays.vtkGodRaysPass.SetRole(actors[1], godrays.vtkGodRaysPass.LIGHT)
        self.rays.Attach(self.renderer)
        things = {"camera": camera, "light": light, "actor": actors[1], "property": actors[1].GetProperty(),
                  "pass": self.rays, "model": self.rays.GetModel(), "integrator": self.rays.GetIntegrator()}
        return things[kind.split(",")[0]]

    def pixels(self):
        self.window.Render()
        data = vtkUnsignedCharArray()
        self.window.GetRGBACharPixelData(0, 0, 23, 17, 0, data)
        return vtk_to_numpy(data).astype(int)

    def images(self):
        """What was scattered, and the layers: those that there are."""
        image = vtkImageData()
        for read in (self.rays.GetScatteringImage, self.rays.GetOcclusionImage):
            if read(image):
                yield vtk_to_numpy(image.GetPointData().GetScalars())


class Robustness(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = Scene()
        cls.turn = itertools.cycle(PAIRS)

    def setUp(self):
        self.addCleanup(vtkOutputWindow.SetInstance, None)
        self.said()

    def said(self):
        """What this project has said since; VTK itself may say what it likes."""
        text = getattr(self, "messages", vtkStringOutputWindow()).GetOutput()
        self.messages = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.messages)
        return [message for message in re.split(r"\n(?=ERROR:|Warning:)", "\n" + text)
                if re.search(r"^vtkGodRays\w+ \(0x", message, re.M)]

    def check(self, kind, change, pair):
        """Draw the scene after a change, without rays and with them. Returns what was said of it."""
        scene = self.scene
        change(scene.set_up(pair, kind))
        intensity = scene.rays.GetIntensity()
        scene.rays.SetIntensity(0)
        without = scene.pixels()
        of_setters = self.said()
        scene.rays.SetIntensity(intensity)
        drawn = scene.pixels()
        said = self.said()
        if said:
            drawn = scene.pixels()
            said += self.said()
        plan = scene.rays.GetPlan()
        for image in scene.images():
            self.assertTrue(numpy.isfinite(image).all(), plan)
            self.assertGreaterEqual(image.min(), 0, plan)
        self.assertEqual(len(said), len(set(said)), "told twice")
        for message in of_setters + said:
            self.assertRegex(message, REMEDY, "no remedy")
        if any("god rays: " in message for message in said):
            self.assertTrue((drawn == without).all(), said)
        elif pair[0] is not godrays.vtkGodRaysPublishedModel:  # which may dim the scene
            self.assertGreaterEqual((drawn - without).min(), -1, plan)
        return said

    def try_all(self, *kinds):
        """All changes of each kind with each pair, or, unless GODRAYS_LONG is set, with one of them in turn."""
        turns = list(itertools.product(kinds, PAIRS))
        for kind, pair in turns:
            own = turns  # to take turns with: the others of a model, or of an integrator
            if kind in ("model", "integrator"):
                which = ("model", "integrator").index(kind)
                own = [(kind, each) for each in PAIRS if each[which] is pair[which]]
            for number, (text, change) in enumerate(changes(self.scene.set_up(pair, kind))):
                turn = (number + number // len(VALUES)) % len(own)  # not a value with one pair only
                if LONG or own[turn] == (kind, pair):
                    with self.subTest(kind=kind, model=pair[0].__name__, integrator=pair[1].__name__, set=text):
                        self.check(kind, change, pair)

    def test_faults_are_told_once_with_their_causes(self):
        for kind, change, pairs, words in FAULTS:
            for pair in pairs:
                with self.subTest(kind=kind, model=pair[0].__name__, integrator=pair[1].__name__, words=words):
                    said = self.check(kind, change, pair)
                    self.assertEqual(sum(words in message for message in said), 1, said)
                    self.assertIn(words.split(": ")[-1], self.scene.rays.GetPlan())

    def test_what_has_a_fault_is_left_out_and_the_rest_shines(self):
        for pair in PAIRS:
            with self.subTest(model=pair[0].__name__, integrator=pair[1].__name__):
                scene = self.scene
                actor = scene.set_up(pair, "actor")
                bad = vtkLight()
                bad.SetPosition(NAN, 0, 0)
                scene.rays.AddLight(bad)
                actor.SetScale(1e300)
                actor.UseBoundsOff()
                scene.window.Render()
                said = self.said()
                self.assertEqual(len(said), 1, said)
                self.assertIn("number 1: its Position", said[0])
                self.assertGreater(max(image.max() for image in scene.images()), 0)

    def test_faults_of_cameras_leave_the_scene_without_sky(self):
        for kind, change, pairs, words in FAULTS:
            if "camera" not in kind or pairs is MEDIA:
                continue
            with self.subTest(kind=kind, words=words):
                change(self.scene.set_up(PAIRS[0], kind))
                self.scene.rays.Detach(self.scene.renderer)
                without = self.scene.pixels()
                sky = godrays.vtkGodRaysSkyPass.Attach(self.scene.renderer)
                sky.SetMultipleScattering(False)
                self.said()
                for _ in range(2):
                    self.assertTrue((self.scene.pixels() == without).all())
                said = self.said()
                self.assertEqual(len(said), 1, said)
                self.assertRegex(said[0], f"without sky: .*{words}.*{REMEDY}")
                self.assertIn(words, sky.GetPlan())
                godrays.vtkGodRaysSkyPass.Detach(self.scene.renderer)

    def test_props_that_face_the_camera_stay_as_they_are(self):
        """Billboards, followers and resliced images, also while other cameras see them for margins and maps."""

        def billboard(camera):
            text = vtkBillboardTextActor3D()
            text.SetInput("Billboard")
            text.GetTextProperty().SetFontSize(14)
            return text

        def follower(camera):
            text = vtkFollower()
            text.SetMapper(self.scene.mapper)
            text.SetOrientation(20, 30, 0)
            text.SetCamera(camera)
            return text

        def slice_of_image(camera):
            wave = vtkRTAnalyticSource()
            wave.SetWholeExtent(-4, 4, -4, 4, -4, 4)
            wave.Update()
            mapper = vtkImageResliceMapper()
            mapper.SetInputData(wave.GetOutput())
            mapper.SliceFacesCameraOn()
            mapper.SliceAtFocalPointOn()
            image = vtkImageSlice()
            image.SetMapper(mapper)
            image.SetScale(0.3)
            return image

        for make, pair, margin in itertools.product((billboard, follower, slice_of_image), PAIRS, (0, 0.3)):
            with self.subTest(prop=make.__name__, model=pair[0].__name__, integrator=pair[1].__name__, margin=margin):
                scene = self.scene
                scene.set_up(pair, "camera")
                scene.renderer.GetActiveCamera().Azimuth(20)
                scene.renderer.AddViewProp(make(scene.renderer.GetActiveCamera()))
                scene.rays.SetLayerMargin(margin)
                scene.rays.SetBackgroundGlowRadius(2)  # a glow that reaches into the picture
                scene.rays.SetBackgroundGlowFalloff(6)
                scene.rays.SetIntensity(0)
                without = scene.pixels()
                scene.rays.SetIntensity(1e-9)
                for _ in range(3):
                    drawn = scene.pixels()
                    self.assertIn("blend: ", scene.rays.GetPlan())
                    if pair[0] is not godrays.vtkGodRaysPublishedModel:
                        self.assertLessEqual(abs(drawn - without).max(), 1)

    def test_of_cameras(self):
        self.try_all("camera", "camera, parallel", "camera, off-axis")

    def test_of_lights(self):
        self.try_all("light", "light, lamp", "light, spot")

    def test_of_props(self):
        self.try_all("actor", "actor, lamp", "actor, emitter", "property", "property, emitter")

    def test_of_passes(self):
        self.try_all("pass", "pass, lamp")

    def test_of_models_and_integrators(self):
        self.try_all("model", "integrator")


if __name__ == "__main__":
    unittest.main()
