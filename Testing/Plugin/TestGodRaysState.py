# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""State, trace, animation, screenshots, and several views."""

import glob
import os

from paraview import smstate, smtrace
from plugin_testing import *


def make_scene():
    """A view in which little is as it was at first, with data of several types that have roles."""
    view = make_view(
        SunAzimuth=5.0,
        SunElevation=6.0,
        SunColor=[1.0, 0.8, 0.5],
        Preset="custom",
        BackgroundGlow=0.5,
        Intensity=0.8,
    )
    view.Model.Density = 0.9
    view.Model.Decay = 0.97
    view.Integrator = "Taps"
    view.Integrator.NumberOfTaps = 64
    view.UntaggedPropsOcclude = 0
    pillars = add_each_pillar(view)
    for each, kind, role in zip(
        pillars,
        ("Surface", "Wireframe", "Surface With Edges", "Surface", "Points"),
        ("Ignored", "Occluder", "Occluder", "Automatic", "Light"),
    ):
        each.Representation = kind
        each.GodRaysRole = role
    return view


def path(name):
    return os.path.join(TEMPORARY, name)


class State(Case):
    def check_reloaded(self, expected):
        view = simple.GetActiveViewOrCreate(VIEW)
        self.assertEqual(view.GetXMLName(), VIEW)
        self.assertEqual(view.Model.Density, 0.9)
        self.assertEqual(view.Integrator.NumberOfTaps, 64)
        self.assertEqual(view.Preset, "custom")
        self.assertEqual(
            sorted(
                shown.SMProxy.GetProperty("GodRaysRole").GetElement(0)
                for shown in view.Representations
            ),
            [0, 1, 1, 2, 3],
        )
        self.assert_alike(pixels(view), expected)
        view.Intensity = 0.7
        self.assert_different(pixels(view), expected, 5)
        return view

    def test_state_file(self):
        expected = pixels(make_scene())
        simple.SaveState(path("state.pvsm"))
        simple.ResetSession()
        simple.LoadState(path("state.pvsm"))
        self.check_reloaded(expected)

    def test_state_in_python(self):
        expected = pixels(make_scene())
        text = smstate.get_state()
        simple.ResetSession()
        exec(compile(text, "state.py", "exec"), {"__name__": "__main__"})
        self.check_reloaded(expected)

    def check_round_trips(self, view):
        """A state file and a script bring back what the view shows."""
        expected = pixels(view)
        simple.SaveState(path("state.pvsm"))
        text = smstate.get_state()
        for load in (
            lambda: simple.LoadState(path("state.pvsm")),
            lambda: exec(compile(text, "state.py", "exec"), {"__name__": "__main__"}),
        ):
            simple.ResetSession()
            load()
            view = simple.GetActiveView()
            self.assert_alike(pixels(view), expected)
        return view

    def test_the_role_of_a_volume(self):
        view = make_view(SunElevation=4.0)
        shown = add_volume(view)
        automatic = pixels(view)
        shown.GodRaysRole = "Ignored"
        self.assert_different(pixels(view), automatic, 10)
        view = self.check_round_trips(view)
        view.Representations[0].GodRaysRole = "Automatic"
        self.assert_alike(pixels(view), automatic)

    def test_chosen_lights(self):
        view = make_view(LightSource="What is tagged as a light")
        add_pillars(view)
        for height in (1.0, -1.0):
            lamp = simple.AddLight(view=view)
            lamp.Coords, lamp.Type = "Scene", "Directional"
            lamp.Position, lamp.FocalPoint = [0.0, height, -5.0], [0.0, 0.0, 0.0]
        view.Lights = [lamp]
        chosen = pixels(view)
        view.LightSource = "Lights of the Light Inspector"
        self.assert_different(pixels(view), chosen)
        view.LightSource = "What is tagged as a light"
        view = self.check_round_trips(view)
        view.Lights = []
        self.assert_different(pixels(view), chosen)

    def test_trace(self):
        changes = {
            "ViewSize": [160, 120],
            "SunElevation": 6.0,
            "SunColor": [1.0, 0.8, 0.5],
            "Preset": "long-shafts",
            "Intensity": 0.8,
            "UseColorPaletteForBackground": 0,
            "Background": BACKGROUND,
            "OrientationAxesVisibility": 0,
        }
        smtrace.start_trace()
        view = simple.CreateView(VIEW)
        view.CameraPosition = [0, 0, 8]
        shown = simple.Show(simple.Box(YLength=2.8), view)
        # as the panel does when Apply is pressed: what changes between beginning and end is traced
        begin = smtrace._create_trace_item_internal
        for proxy, values in (
            (view, changes),
            (shown, {"Representation": "Wireframe", "GodRaysRole": "Occluder"}),
        ):
            item = begin("PropertiesModified", [proxy.SMProxy])
            for name, value in values.items():
                setattr(proxy, name, value)
            item.finalize()
            del item
        expected = pixels(view)
        text = smtrace.stop_trace()
        self.assertRegex(text, r"\bSunElevation ?= ?6\.0")
        self.assertRegex(text, r"\bGodRaysRole ?= ?'Occluder'")
        simple.ResetSession()
        exec(compile(text, "trace.py", "exec"), {"__name__": "__main__"})
        view = simple.GetActiveView()
        self.assert_alike(pixels(view), expected)
        view.Intensity = 0.1
        self.assert_different(pixels(view), expected)

    def test_animation(self):
        view = make_view()
        add_pillars(view)
        scene = simple.GetAnimationScene()
        scene.PlayMode = "Sequence"
        scene.NumberOfFrames = 3
        scene.StartTime, scene.EndTime = 0.0, 1.0
        track = simple.GetAnimationTrack("SunElevation", proxy=view)
        track.KeyFrames = [
            simple.CompositeKeyFrame(KeyTime=0.0, KeyValues=[2.0], Interpolation="Ramp"),
            simple.CompositeKeyFrame(KeyTime=1.0, KeyValues=[14.0]),
        ]
        shown = []
        for time, elevation in ((0.0, 2.0), (0.5, 8.0), (1.0, 14.0)):
            scene.AnimationTime = time
            self.assertAlmostEqual(view.SunElevation, elevation)
            shown.append(pixels(view))
        self.assert_different(shown[0], shown[1])
        self.assert_different(shown[1], shown[2])
        for file in glob.glob(path("animation*.png")):
            os.remove(file)
        simple.SaveAnimation(path("animation.png"), view, ImageResolution=[320, 240],
            FrameWindow=[0, 2])  # without it, ParaView 5.13 writes the first alone
        files = sorted(glob.glob(path("animation*.png")))
        self.assertEqual(len(files), 3)
        frames = [read(file) for file in files]
        self.assert_different(frames[0], frames[1])
        view.ViewSize = [320, 240]
        for frame, elevation in zip(frames, (2.0, 8.0, 14.0)):
            view.SunElevation = elevation
            self.assert_alike(frame, pixels(view))

    def test_every_number_can_be_animated(self):
        view = make_view()
        for name in ("Intensity", "SunAzimuth", "SunElevation", "SunColor", "SunAngularRadius",
            "SourceRadius", "BackgroundGlow", "BackgroundGlowRadius", "BackgroundGlowFalloff",
            "ErrorTolerance", "LayerMargin", "SunUp", "SunNorth",
            "SunTimeOfDay", "SunTimeZone", "SunLatitude", "SunLongitude"):  # fmt: skip
            self.assertTrue(view.SMProxy.GetProperty(name).GetAnimateable(), name)
        for name in ("Density", "Decay", "Weight", "Exposure"):
            self.assertTrue(view.Model.SMProxy.GetProperty(name).GetAnimateable(), name)


class Pictures(Case):
    def test_a_screenshot_larger_than_the_view(self):
        large = make_view(size=(480, 360))
        add_pillars(large, COLUMNS, center=False)
        expected = pixels(large)
        view = make_view()
        add_pillars(view, COLUMNS, center=False)
        size = list(view.ViewSize)
        self.assert_alike(pixels(view, 3), expected)
        self.assertEqual(list(view.ViewSize), size)
        simple.SaveScreenshot(path("large.png"), view, ImageResolution=[480, 360])
        self.assert_alike(read(path("large.png")), expected)
        # a control: the same light in tiles
        tiled = make_view("RenderView")
        add_pillars(tiled, COLUMNS, center=False)
        godrays.enable(
            tiled.GetClientSideObject().GetRenderer(),
            light=[0.0, numpy.sin(numpy.radians(10.0)), -numpy.cos(numpy.radians(10.0))],
        )
        self.assert_different(pixels(tiled, 3), expected)

    def test_a_transparent_background(self):
        view = make_view()
        # ParaView finds alpha by one picture before black and one before white
        view.DarkenLightBackground = 0
        add_pillars(view)
        opaque = pixels(view)
        simple.SaveScreenshot(path("transparent.png"), view, TransparentBackground=1)
        reader = vtkPNGReader()
        reader.SetFileName(path("transparent.png"))
        reader.Update()
        values = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
        values = values.reshape(120, 160, -1)
        self.assertEqual(values.shape[2], 4)
        self.assertEqual(values[60, 80, 3], 255)  # a pillar
        self.assertEqual(values[5, 80, 3], 0)  # its shadow
        self.assert_alike(values[60:61, 80:81, :3], opaque[60:61, 80:81], 3)
        self.assert_alike(pixels(view), opaque)

    def test_two_views(self):
        layout = simple.CreateLayout("two")
        first = make_view()
        second = make_view("RenderView")
        simple.AssignViewToLayout(first, layout, 0)
        layout.SplitHorizontal(0, 0.5)
        simple.AssignViewToLayout(second, layout, 2)
        layout.SetSize(320, 120)
        for view in (first, second):
            add_pillars(view)
            view.OrientationAxesVisibility = 0
            simple.Render(view)
        alone, plain = pixels(first), pixels(second)
        width = min(alone.shape[1], plain.shape[1])  # ParaView gives one of them a pixel less
        self.assert_different(alone[:, :width], plain[:, :width], 40)
        simple.SaveScreenshot(path("two-views.png"), layout, SeparatorWidth=0)
        both = read(path("two-views.png"))
        self.assert_alike(both[:, : alone.shape[1]], alone)
        self.assert_alike(both[:, -plain.shape[1] :], plain)

        # two with rays, each with its own
        third = make_view(SunElevation=3.0, Preset="low-sun")
        add_pillars(third)
        low = pixels(third)
        other = make_view()
        add_pillars(other)
        self.assert_different(low, pixels(other), 20)
        self.assert_alike(pixels(first), alone)
        self.assert_alike(pixels(third), low)

    def test_comparative_view(self):
        def set_look(view):
            view.SunElevation, view.Preset = 6.0, "custom"
            view.Model.Density = 0.5
            view.Integrator = "Taps"
            view.Integrator.NumberOfTaps = 8

        widths = (0.2, 0.4)  # narrower than the glow about the sun
        expected = []
        for width, smooth in zip(widths, (0, 1)):  # ParaView does not smooth the first one's edges
            view = make_view(UseFXAA=smooth)
            set_look(view)
            middle, left, *_ = add_each_pillar(view)
            middle.Input.XLength = width
            left.GodRaysRole = "Ignored"
            expected.append(pixels(view))
        both = make_view("Comparative" + VIEW, (321, 120), Dimensions=[2, 1])
        set_look(both)
        middle, left, *_ = add_each_pillar(both)
        left.GodRaysRole = "Ignored"
        manager = simple.servermanager.ProxyManager().SMProxyManager
        cue = simple.servermanager._getPyProxy(
            manager.NewProxy("animation", "ComparativeAnimationCue")
        )
        cue.AnimatedProxy = middle.Input
        cue.AnimatedPropertyName = "XLength"
        cue.SMProxy.UpdateXRange(0, *widths)
        both.Cues = [cue]

        def halves():
            simple.Render(both)
            simple.SaveScreenshot(path("comparative.png"), both)
            shown = read(path("comparative.png"))
            return shown[:, :160], shown[:, -160:]

        for half, wanted in zip(halves(), expected):
            self.assert_alike(half, wanted)
        both.Model.Density = 0.9
        for half, wanted in zip(halves(), expected):
            self.assert_different(half, wanted)
        both.UseGodRays = 0
        for half, wanted in zip(halves(), expected):
            self.assert_different(half, wanted, 50)

    def test_stereo(self):
        view = make_view()
        add_pillars(view)
        mono = pixels(view)
        view.StereoRender = 1
        simple.SaveScreenshot(path("left.png"), view, StereoMode="Left Eye Only")
        simple.SaveScreenshot(path("right.png"), view, StereoMode="Right Eye Only")
        left, right = read(path("left.png")), read(path("right.png"))
        self.assert_different(left, right)
        plain = make_view("RenderView")
        add_pillars(plain)
        simple.SaveScreenshot(path("plain.png"), plain, StereoMode="Left Eye Only")
        self.assert_different(left, read(path("plain.png")), 40)
        view.StereoRender = 0
        self.assert_alike(pixels(view), mono)


main()
