# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The sun that a new view places where it makes the most shafts."""

from plugin_testing import *

ANGLES = ("SunAzimuth", "SunElevation")


def angles(view):
    return tuple(getattr(view, name) for name in ANGLES)


def place(view):
    """Where the sun of the last frame stands in the picture, from (0, 0) to (1, 1)."""
    direction = [0.0, 0.0, 0.0]
    client = view.GetClientSideObject()
    client.GetSun().GetDirection(client.GetRenderer().GetActiveCamera(), direction)
    x, y, w = clip(view, direction)
    return 0.5 + 0.5 * x / w, 0.5 + 0.5 * y / w


class Placed(Case):
    def assert_best(self, view):
        placer = rays(view).GetSunPlacer()
        pixel = 1.0 / min(view.ViewSize)  # a tenth of a degree is less
        for actual, expected in zip(place(view), placer.GetPlace()):
            self.assertAlmostEqual(actual, expected, delta=pixel)
        others = numpy.linspace(0.1, 0.9, 9), numpy.linspace(0.52, 0.92, 5)
        best = max(placer.GetScoreAt(x, y) for x in others[0] for y in others[1])
        self.assertGreater(placer.GetScore(), max(0.95 * best, 1.0))

    def test_a_new_view_places_it_once(self):
        self.assertEqual(simple.CreateView(VIEW).PlaceSun, 1)
        view = make_view(PlaceSun=1)
        simple.Render(view)  # of nothing
        self.assertEqual((view.PlaceSun, *angles(view)), (1, 0.0, 10.0))
        add_pillars(view, (-2.2, -1.6, 0.9), center=False)
        first = pixels(view)
        self.assertEqual(view.PlaceSun, 0)
        self.assertNotEqual(angles(view), (0.0, 10.0))
        self.assert_best(view)
        placed = angles(view)
        self.assertEqual(placed, tuple(round(angle, 1) for angle in placed))
        sun = view.GetClientSideObject().GetSun()
        self.assertEqual((sun.GetAzimuth(), sun.GetElevation()), placed)
        self.assertEqual(tuple(view.SunColor), (1.0, 0.85, 0.62))
        # the same in the next frame, and where the camera goes
        self.assert_alike(pixels(view), first)
        where = place(view)
        view.CameraPosition = [5, 1, 6]
        simple.Render(view)
        self.assertEqual(angles(view), placed)
        numpy.testing.assert_allclose(place(view), where, atol=1e-6)
        # shafts: a control without
        view.CameraPosition = [0, 0, 8]
        view.UseGodRays = 0
        self.assert_different(pixels(view), first, 40)

    def test_what_is_set_stays(self):
        for name, value in {
            "SunAzimuth": 7.0,
            "SunElevation": 25.0,
            "SunFrame": "World, Y up",
            "SunPosition": "Date and place",
        }.items():
            with self.subTest(name):
                view = make_view(PlaceSun=1)
                setattr(view, name, value)
                self.assertEqual(view.PlaceSun, 0)
                expected = angles(view)
                add_pillars(view)
                simple.Render(view)
                self.assertEqual((getattr(view, name), *angles(view)), (value, *expected))

    def test_a_colour_that_is_set_stays(self):
        view = make_view(PlaceSun=1, SunColor=[0.2, 1.0, 0.4])
        add_pillars(view)
        simple.Render(view)
        self.assertEqual((view.PlaceSun, tuple(view.SunColor)), (0, (0.2, 1.0, 0.4)))

    def test_again_in_the_world(self):
        view = make_view(SunFrame="World, Y up", SunAzimuth=40.0)
        add_pillars(view)
        view.CameraPosition = [5, 2, 6]
        simple.Render(view)
        self.assertEqual(view.SunAzimuth, 40.0)
        view.PlaceSun = 1
        simple.Render(view)
        self.assertEqual(view.PlaceSun, 0)
        self.assertEqual(view.SunFrame, "World, Y up")
        self.assert_best(view)
        placed = angles(view)
        view.CameraPosition = [4, 2, 7]
        simple.Render(view)
        self.assertEqual(angles(view), placed)

    def test_it_waits(self):
        for name, value, usual in (
            ("CameraParallelProjection", 1, 0),
            ("LightSource", "What is tagged as a light", "Sun"),
            ("UseGodRays", 0, 1),
        ):
            with self.subTest(name):
                view = make_view(PlaceSun=1)
                setattr(view, name, value)
                add_pillars(view)
                simple.Render(view)
                self.assertEqual((view.PlaceSun, *angles(view)), (1, 0.0, 10.0))
                setattr(view, name, usual)
                simple.Render(view)
                self.assertEqual(view.PlaceSun, 0)
                self.assert_best(view)

    def test_a_sky_over_it_has_its_sun(self):
        view = make_view(PlaceSun=1)
        add_pillars(view)  # the best place is among their lower ends, or would be
        view.CameraPosition, view.CameraFocalPoint = [0, 1.2, 8], [0, 1.2, 0]
        simple.Render(view)
        self.assertGreater(view.SunElevation, 0.5)
        view.UseSky = 1
        self.assertGreater(pixels(view).max(), 200)
        self.assertIn("light", rays(view).GetPlan())

    def test_behind_a_wall_it_has_its_usual_place(self):
        view = make_view(PlaceSun=1)
        simple.Show(simple.Box(XLength=50.0, YLength=50.0), view)
        simple.Render(view)
        self.assertEqual(view.PlaceSun, 0)
        numpy.testing.assert_allclose(place(view), (0.35, 0.75), atol=1.0 / 120)

    def test_comparative_views_share_it(self):
        both = make_view("Comparative" + VIEW, (321, 120), Dimensions=[2, 1])
        add_pillars(both, (-2.2, -1.6, 0.9), center=False)
        simple.Render(both)
        self.assertEqual(both.PlaceSun, 0)
        self.assertNotEqual(angles(both), (0.0, 10.0))
        views = vtk.vtkCollection()
        both.SMProxy.GetViews(views)
        suns = [view.GetClientSideObject().GetSun() for view in views]
        self.assertEqual(len(suns), 2)
        for sun in suns:
            self.assertEqual((sun.GetAzimuth(), sun.GetElevation()), angles(both))

    def test_a_state_has_it(self):
        view = make_view(PlaceSun=1)
        add_pillars(view, (-2.2, -1.6, 0.9), center=False)
        simple.Render(view)
        view.CameraPosition = [3, 1, 7]
        expected, placed = pixels(view), angles(view)
        file = os.path.join(TEMPORARY, "placed.pvsm")
        simple.SaveState(file)
        simple.ResetSession()
        simple.LoadState(file)
        view = simple.GetActiveViewOrCreate(VIEW)
        self.assert_alike(pixels(view), expected)
        self.assertEqual((view.PlaceSun, *angles(view)), (0, *placed))


main()
