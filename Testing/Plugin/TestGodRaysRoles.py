# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What blocks light, shines, or does neither: a role that every representation has."""

from plugin_testing import *


def make_scene(**properties):
    """A view with pillars, of which the middle one is in the way of the sun."""
    view = make_view(SunElevation=4.0, **properties)
    return view, add_each_pillar(view)


def role(representation):
    """The role of a representation's actor."""
    client = representation.GetClientSideObject()
    if hasattr(client, "GetActiveRepresentation"):
        client = client.GetActiveRepresentation()
    return godrays.vtkGodRaysPass.GetRole(client.GetActor())


class Roles(Case):
    def test_each_role(self):
        view, pillars = make_scene()
        middle = pillars[0]
        blocked = pixels(view)
        middle.GodRaysRole = "Ignored"
        through = pixels(view)
        self.assertIn("geometry rendered twice", rays(view).GetPlan())
        self.assert_different(through, blocked, 40)
        # behind the pillar is its shadow, or none
        self.assertGreater(through[5, 80].sum(), blocked[5, 80].sum() + 60)
        self.assertEqual(role(middle), godrays.vtkGodRaysPass.IGNORED)
        middle.GodRaysRole = "Automatic"
        self.assert_alike(pixels(view), blocked)
        self.assertEqual(role(middle), godrays.vtkGodRaysPass.AUTOMATIC)

        # the same by occluders, where nothing else blocks
        view.UntaggedPropsOcclude = 0
        for each in pillars[1:]:
            each.GodRaysRole = "Occluder"
        self.assert_alike(pixels(view), through)
        middle.GodRaysRole = "Occluder"
        self.assert_alike(pixels(view), blocked, 1)

    def test_data_that_shine(self):
        view, _ = make_scene(LightSource="What is tagged as a light")
        lamp = simple.Show(simple.Sphere(Radius=0.25, Center=[-0.5, 0.3, -2.0]), view)
        lamp.ColorArrayName = ["POINTS", ""]
        lamp.AmbientColor = lamp.DiffuseColor = [1.0, 0.8, 0.3]
        lamp.Ambient, lamp.Diffuse = 1.0, 0.0
        dark = pixels(view)
        self.assertIsNone(layer(view))
        lamp.GodRaysRole = "Light"
        self.assert_different(pixels(view), dark, 60)
        light = layer(view)
        self.assertGreater(light[:, :, 0].max(), 2 * light[:, :, 2].max())
        write(view, "PluginLamp")
        lamp.GodRaysRole = "Automatic"
        self.assert_alike(pixels(view), dark)

    def test_roles_follow_the_representation_type(self):
        view, (middle, *_) = make_scene()
        middle.GodRaysRole = "Ignored"
        through = pixels(view)
        for kind in ("Wireframe", "Points", "Surface With Edges", "3D Glyphs", "Surface"):
            middle.Representation = kind
            simple.Render(view)
            self.assertIn("geometry rendered twice", rays(view).GetPlan(), kind)
            self.assertEqual(role(middle), godrays.vtkGodRaysPass.IGNORED)
        self.assert_alike(pixels(view), through)

    def test_a_volume_and_a_slice(self):
        view = make_view(SunElevation=4.0)
        shown = add_volume(view)
        dimmed = pixels(view)
        shown.GodRaysRole = "Ignored"
        self.assert_different(pixels(view), dimmed, 10)
        for kind in ("Slice", "Outline"):
            shown.SetRepresentationType(kind)
            shown.GodRaysRole = "Automatic"
            simple.Render(view)
            once = "geometry rendered once" in rays(view).GetPlan()
            shown.GodRaysRole = "Ignored"
            simple.Render(view)
            self.assertTrue(once)
            self.assertIn("geometry rendered twice", rays(view).GetPlan(), kind)

    def test_all_kinds_of_data(self):
        image = simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4])
        plane = [0, 8, 0, 8, 0, 0]
        for data in (
            image,
            simple.Contour(Input=image, ContourBy=["POINTS", "RTData"], Isosurfaces=[150.0]),
            simple.Tetrahedralize(Input=image),
            simple.GroupDatasets(Input=[image, simple.Sphere(Radius=4)]),
            simple.HyperTreeGridRandom(),
            simple.Transform(Input=simple.Wavelet(WholeExtent=plane)),
        ):
            with self.subTest(data.SMProxy.GetXMLName()):
                view = make_view(SunElevation=4.0, CameraPosition=[0, 0, 40])
                shown = simple.Show(data, view)
                shown.GodRaysRole = "Ignored"
                simple.Render(view)
                self.assertIn("geometry rendered twice", rays(view).GetPlan())

    def test_axes_neither_block_nor_shine(self):
        view, pillars = make_scene()
        simple.Render(view)
        expected = layer(view)
        view.CenterAxesVisibility = 1
        view.OrientationAxesVisibility = 1
        view.AxesGrid.Visibility = 1
        pillars[0].DataAxesGrid.GridAxesVisibility = 1
        pillars[0].PolarAxes.Visibility = 1
        simple.Render(view)
        simple.Show(simple.Text(Text="Text"), view)
        simple.Render(view)
        self.assertLess(abs(layer(view) - expected).max(), 2e-3 * expected.max())

    def test_roles_end_with_their_representation(self):
        view, (middle, *_) = make_scene()
        middle.GodRaysRole = "Ignored"
        simple.Render(view)
        simple.Hide(middle.Input, view)
        simple.Render(view)
        simple.Delete(middle)
        with Messages() as messages:
            simple.Render(view)
        self.assertEqual(messages.text, "")


main()
