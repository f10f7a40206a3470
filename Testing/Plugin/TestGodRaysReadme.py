# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripts of Plugin/README.md, one after the other, do what it says."""

import pathlib
import re

from plugin_testing import *

README = pathlib.Path(__file__).parents[2] / "Plugin" / "README.md"
PATH = "build-paraview/lib/paraview-5.11/plugins/GodRays/GodRays.so"


class Readme(Case):
    def test_its_scripts(self):
        text = README.read_text(encoding="utf-8")
        self.assertIn(PATH, text)
        scripts = re.findall("```python\n(.*?)```", text, re.DOTALL)
        first, by_hand, sun, sky, roles, plan, own_view = scripts
        os.chdir(TEMPORARY)
        names = {"__name__": "__main__"}
        first = first.replace("LoadPlugin", "# ")  # it is loaded

        def run(script):
            with Messages() as messages:
                exec(compile(script.replace(PATH, PLUGIN), str(README), "exec"), names)
                view = names.get("view")
                if view:
                    simple.Render(view)
            self.assertEqual(messages.text, "")

        run(first)
        view = names["view"]
        self.assertEqual(read("picture.png").shape, (1080, 1920, 3))
        self.assertIn("epipolar", rays(view).GetPlan())
        self.assertEqual(view.PlaceSun, 0)
        run(by_hand)
        self.assertEqual((view.SunAzimuth, view.SunElevation), (5.0, 12.0))
        run(sun)
        self.assertLess(abs(names["azimuth"] - 290.0), 15.0)  # in the north-west
        self.assertLess(abs(names["elevation"] - 15.0), 5.0)  # some hours before it sets
        run(sky)
        self.assertIn("sky: a new table", names["view"].GetClientSideObject().GetSkyPass().GetPlan())

        for name in ("lamp", "wall"):
            names[name] = simple.Show(simple.Sphere(Radius=0.1), view)
        smoke = names["smoke"] = simple.Show(simple.Wavelet(), view)
        simple.ColorBy(smoke, ("POINTS", "RTData"))
        smoke.SetRepresentationType("Volume")
        simple.AddLight(view=view)
        run(roles)
        self.assertEqual(rays(view).GetNumberOfLights(), 2)
        run(plan)
        self.assertIn("light:", names["plan"])

        names["view"] = simple.CreateView("RenderView")
        simple.Show(simple.Sphere(), names["view"])
        run(own_view)
        self.assertIn("light: directional", names["rays"].GetPlan())


main()
