# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What blocks light, shines, or does neither: by the view's lists, and by representation."""

from plugin_testing import *


def make_scene(**properties):
    """A view with pillars, of which the middle one is in the way of the sun."""
    view = make_view(SunElevation=4.0, **properties)
    return view, add_pillars(view)


def role(representation):
    """The role of a representation's actor."""
    client = representation.GetClientSideObject()
    if hasattr(client, "GetActiveRepresentation"):
        client = client.GetActiveRepresentation()
    return godrays.vtkGodRaysPass.GetRole(client.GetActor())


class Roles(Case):
    def test_lists_of_the_view(self):
        view, (middle, *others) = make_scene()
        blocked = pixels(view)
        view.Ignored = [middle]
        through = pixels(view)
        self.assertIn("geometry rendered twice", rays(view).GetPlan())
        self.assert_different(through, blocked, 40)
        # behind the pillar is its shadow, or none
        self.assertGreater(through[5, 80].sum(), blocked[5, 80].sum() + 60)
        self.assertEqual(role(middle), godrays.vtkGodRaysPass.IGNORED)
        view.Ignored = []
        self.assert_alike(pixels(view), blocked)
        self.assertEqual(role(middle), godrays.vtkGodRaysPass.AUTOMATIC)

        # the same by occluders, where nothing else blocks
        view.UntaggedPropsOcclude = 0
        view.Occluders = others
        self.assert_alike(pixels(view), through)
        view.Occluders = [middle] + others
        self.assert_alike(pixels(view), blocked, 1)

    def test_a_surface_that_shines(self):
        view, _ = make_scene(LightSource="What is tagged as a light")
        lamp = simple.Show(simple.Sphere(Radius=0.25, Center=[-0.5, 0.3, -2.0]), view)
        lamp.ColorArrayName = ["POINTS", ""]
        lamp.AmbientColor = lamp.DiffuseColor = [1.0, 0.8, 0.3]
        lamp.Ambient, lamp.Diffuse = 1.0, 0.0
        dark = pixels(view)
        self.assertIsNone(layer(view))
        view.Lights = [lamp]
        shining = pixels(view)
        self.assert_different(shining, dark, 60)
        light = layer(view)
        self.assertGreater(light[:, :, 0].max(), 2 * light[:, :, 2].max())
        write(view, "PluginLamp")
        view.Lights = []
        self.assert_alike(pixels(view), dark)
        lamp.Representation = "Surface (God Rays)"
        lamp.Role = "Light"
        self.assert_alike(pixels(view), shining)
        lamp.Role = "Automatic"
        self.assert_alike(pixels(view), dark)

    def test_the_role_of_a_representation(self):
        view, (middle, *_) = make_scene()
        blocked = pixels(view)
        middle.Representation = "Surface (God Rays)"
        self.assert_alike(pixels(view), blocked)
        middle.Role = "Ignored"
        through = pixels(view)
        self.assert_different(through, blocked, 40)
        # another type has no role
        middle.Representation = "Surface"
        self.assert_alike(pixels(view), blocked)
        middle.Representation = "Surface (God Rays)"
        self.assert_alike(pixels(view), through)
        # the view's lists come first, and leave it behind as it was
        view.Occluders = [middle]
        self.assert_alike(pixels(view), blocked, 1)
        view.Occluders = []
        self.assert_alike(pixels(view), through)

    def test_roles_follow_the_representation_type(self):
        view, (middle, *_) = make_scene()
        view.Ignored = [middle]
        through = pixels(view)
        for kind in ("Wireframe", "Points", "Surface With Edges", "3D Glyphs", "Surface"):
            middle.Representation = kind
            simple.Render(view)
            self.assertIn("geometry rendered twice", rays(view).GetPlan(), kind)
            self.assertEqual(role(middle), godrays.vtkGodRaysPass.IGNORED)
        self.assert_alike(pixels(view), through)

    def test_a_volume_and_a_slice(self):
        view = make_view(SunElevation=4.0)
        source = simple.Wavelet(WholeExtent=[-8, 8, -8, 8, -8, 8])
        data = simple.Transform(Input=source)
        data.Transform.Scale = [0.15, 0.15, 0.15]
        data.TransformAllInputVectors = 0
        image = simple.ResampleToImage(Input=data, SamplingDimensions=[24, 24, 24])
        shown = simple.Show(image, view)
        shown.SetRepresentationType("Volume")
        simple.ColorBy(shown, ("POINTS", "RTData"))
        dimmed = pixels(view)
        view.Ignored = [shown]
        self.assert_different(pixels(view), dimmed, 10)
        for kind in ("Slice", "Outline"):
            shown.SetRepresentationType(kind)
            view.Ignored = []
            simple.Render(view)
            once = "geometry rendered once" in rays(view).GetPlan()
            view.Ignored = [shown]
            simple.Render(view)
            self.assertTrue(once)
            self.assertIn("geometry rendered twice", rays(view).GetPlan(), kind)

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
        view.Ignored = [middle]
        simple.Render(view)
        simple.Hide(middle.Input, view)
        simple.Render(view)
        simple.Delete(middle)
        with Messages() as messages:
            simple.Render(view)
        self.assertEqual(messages.text, "")


main()
