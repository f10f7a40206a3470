# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripts of README.md and Plugin/README.md do what these say, and what pages name is on the panel."""

import json
import pathlib
import re
import subprocess
import tempfile

from plugin_testing import *

ROOT = pathlib.Path(__file__).parents[2]
README = ROOT / "Plugin" / "README.md"
STEPS = ROOT / "Documentation" / "ParaView.md"
# What the front page's script leaves: names of the window, the sun, a picture without rays, one as its comment says.
LOOK = """
import json
facts = dict(label=view.SMProxy.GetXMLLabel(), sun=[view.SunAzimuth, view.SunElevation], place=view.PlaceSun)
view.UseGodRays = 0
SaveScreenshot("plain.png", view)
view.UseGodRays = 1
SAID
SaveScreenshot("said.png", view)
facts["said"] = [view.SunAzimuth, view.SunElevation]
with open("facts.json", "w") as file:
    json.dump(facts, file)
"""
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

        def run(script, told=""):
            with Messages() as messages:
                exec(compile(script.replace(PATH, PLUGIN), str(README), "exec"), names)
                view = names.get("view")
                if view:
                    simple.Render(view)
            self.assertIn(told, messages.text)
            self.assertEqual(messages.text.count("Warning"), 1 if told else 0, messages.text)

        run(first)
        view = names["view"]
        self.assertEqual(read("picture.png").shape, (1080, 1920, 3))
        self.assertIn("epipolar", rays(view).GetPlan())
        self.assertEqual(view.PlaceSun, 0)
        run(by_hand)
        self.assertEqual((view.SunAzimuth, view.SunElevation), (5.0, 12.0))
        run(sun, "no light reaches the picture (behind the camera)")
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


class FrontPage(Case):
    def test_its_script(self):
        """In a program of its own, that has nothing but what stands there: data are seen, and so are shafts."""
        text = (ROOT / "README.md").read_text(encoding="utf-8")
        code = re.search(r"## In ParaView\n[^#]*?```python\n(.*?)```", text, re.S).group(1)
        said = re.search(r"# .*or: (view\.SunElevation = (.*))", code)
        self.assertEqual(code.count('"GodRays.so"'), 1)
        script = code.replace('"GodRays.so"', repr(PLUGIN)) + LOOK.replace("SAID", said[1])
        environment = {k: v for k, v in os.environ.items() if k != "GODRAYS_SERVER_PORT"}
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "script.py").write_text(script, encoding="utf-8")
            done = subprocess.run(
                [os.environ["GODRAYS_PVBATCH"], "script.py"], cwd=folder, env=environment, text=True,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
            self.assertTrue(os.path.exists(os.path.join(folder, "facts.json")), done.stdout)
            self.assertNotRegex(done.stdout, "(?i)error|warn")
            facts = json.loads(pathlib.Path(folder, "facts.json").read_text())
            picture, plain, by_hand = (
                read(os.path.join(folder, name + ".png")) for name in ("cone", "plain", "said"))
        self.assertIn("in the window: " + facts["label"], code)
        self.assertEqual(facts["place"], 0)  # done
        self.assertEqual(facts["said"], [facts["sun"][0], float(said[2])])
        self.assertNotEqual(facts["sun"][1], float(said[2]))
        self.assert_different(picture, by_hand)

        background = plain[plain.shape[0] // 2, -1]
        data = abs(plain - background).max(axis=2) > 40
        data[: plain.shape[0] // 4, : plain.shape[1] // 4] = False  # the axes in the corner
        self.assertTrue(0.03 < data.mean() < 0.5, data.mean())
        # Data keep their colours, and stand out from what is around them.
        self.assertLess(abs(picture - plain)[data].mean(), 20)
        light = (picture - plain).max(axis=2)[~data]
        low, high = numpy.percentile(light, (10, 90))
        self.assertLess(low, 10)  # shadows
        self.assertGreater(high - low, 40)  # and what is lit between them


class Names(Case):
    """What pages name in bold letters is on the panel, or in the menu of views. What the first picture's steps have in
    slanted letters is a choice there, and what they have as code, in small letters alone, a preset."""

    def get_labels(self, proxy):
        iterator = proxy.NewPropertyIterator()
        iterator.UnRegister(None)
        labels = {}
        iterator.Begin()
        while not iterator.IsAtEnd():
            labels[iterator.GetProperty().GetXMLLabel()] = iterator.GetProperty()
            iterator.Next()
        return labels

    def test_of_pages(self):
        view = make_view()
        shown = simple.Show(simple.Sphere(), view)
        comparative = simple.CreateView("ComparativeGodRaysRenderView")
        labels = {**self.get_labels(view.SMProxy), **self.get_labels(shown.SMProxy)}
        names = {*labels, view.SMProxy.GetXMLLabel(), comparative.SMProxy.GetXMLLabel()}
        choices = {
            text for each in labels.values() for text in self.get_choices(each)}
        found = 0
        for page in README, STEPS:
            text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.S)
            for name in re.findall(r"\*\*(.+?)\*\*", text, re.S):
                found += 1
                self.assertIn(" ".join(name.split()), names, page.name)
        text = STEPS.read_text(encoding="utf-8")
        for choice in re.findall(r"(?<![*\w])\*([^*\n]+)\*(?![*\w])", text):
            found += 1
            self.assertIn(choice, choices)
        presets = labels["Preset"].FindDomain("vtkSMStringListDomain")
        presets = [presets.GetString(i) for i in range(presets.GetNumberOfStrings())]
        for preset in re.findall(r"`([a-z-]+)`", text):
            found += 1
            self.assertIn(preset, presets)
        self.assertGreater(found, 15)

    def get_choices(self, each):
        domain = each.FindDomain("vtkSMEnumerationDomain")
        return [domain.GetEntryText(i) for i in range(domain.GetNumberOfEntries())] if domain else []

    def test_of_groups(self):
        """The table of Plugin/README.md: groups in their order, and which are advanced."""
        text = README.read_text(encoding="utf-8")
        table = re.search(r"\| group \| what it has \|\n\|---\|---\|\n((?:\|.*\n)+)", text).group(1)
        expected = [row.split("|")[1].strip() for row in table.splitlines()]
        proxy = make_view().SMProxy
        groups = [proxy.GetPropertyGroup(i) for i in range(proxy.GetNumberOfPropertyGroups())]
        names = []
        for group in groups:
            if not group.GetXMLLabel().startswith("God Rays"):
                continue
            name = group.GetXMLLabel().replace("God Rays: ", "")
            shown = {
                group.GetProperty(i).GetPanelVisibility() for i in range(group.GetNumberOfProperties())}
            advanced = group.GetPanelVisibility() == "advanced" or "default" not in shown
            names.append(name + ", advanced" if advanced and name != "Advanced" else name)
        self.assertEqual(expected, names)
        self.assertTrue(advanced)  # the last one



main()
