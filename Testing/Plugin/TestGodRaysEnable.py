# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""God rays in ParaView's own render view, from Python."""

from plugin_testing import *


class Enable(Case):
    def test_as_in_the_view_of_the_plugin(self):
        angle = numpy.radians(10.0)
        sun = (0.0, numpy.sin(angle), -numpy.cos(angle))
        expected = make_view()
        add_pillars(expected)
        view = make_view("RenderView")
        middle, *_ = add_each_pillar(view)
        view.UseFXAA = expected.UseFXAA = 0  # which comes before the rays here, and after them there
        plain = pixels(view)
        enabled = godrays.enable(view, light=sun)
        self.assert_alike(pixels(view), pixels(expected), 1)
        self.assertIs(godrays.enable(view, ignored=[middle], intensity=0.9), enabled)
        self.assert_different(pixels(view), pixels(expected))
        godrays.disable(view)
        self.assert_alike(pixels(view), plain)

    def test_representations_and_lights(self):
        view = make_view("RenderView")
        middle, left, *_ = add_each_pillar(view)
        light = simple.AddLight(view=view)
        light.Coords = "Scene"
        light.Position = [0.0, 1.0, -4.0]
        plain = pixels(view)
        enabled = godrays.enable(view, light=[light, left], occluders=middle)
        self.assert_different(pixels(view), plain)
        self.assertEqual(enabled.GetNumberOfLights(), 1)
        self.assertIn("prop tagged LIGHT", enabled.GetPlan())
        godrays.tag(left, "automatic")
        simple.Render(view)
        self.assertNotIn("prop tagged LIGHT", enabled.GetPlan())

    def test_what_cannot_be(self):
        with self.assertRaisesRegex(ValueError, "set its properties"):
            godrays.enable(make_view())
        with self.assertRaisesRegex(TypeError, "render view"):
            godrays.enable(simple.CreateView("SpreadSheetView"))


main()
