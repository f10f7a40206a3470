# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Any two looks, and any two media, are told apart in three scenes, with defaults for all the rest."""

import itertools
import pathlib
import sys
import unittest

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Gallery"))

import default_scenes
import defaults
import godrays

SCENES = ("cones", "city", "molecule")
JUST_NOTICEABLE = 2.3  # [CIE 1976 L*a*b*], of fields side by side
SHARE = 0.3  # of the picture


def draw(scene, names):
    """What a scene looks like [L*a*b*] for each preset."""
    window, renderer = default_scenes.make(scene, (256, 180))
    pictures = {}
    for name in names:
        godrays.enable(renderer, preset=name)
        window.Render()
        pictures[name] = defaults.to_lab(defaults.read(window, "colour"))
        godrays.disable(renderer)
    window.Finalize()
    return pictures


def get_share(a, b):
    return (numpy.linalg.norm(a - b, axis=-1) > JUST_NOTICEABLE).mean()


class Presets(unittest.TestCase):
    def check(self, model, most):
        names = [model.GetPresetName(i) for i in range(model.GetNumberOfPresets())]
        self.assertLessEqual(len(names), most)
        for scene in SCENES:
            pictures = draw(scene, names)
            print(f"{scene}: {names}")
            for a, b in itertools.combinations(names, 2):
                share = get_share(pictures[a], pictures[b])
                print(f"  {a} and {b}: {share:.2f}")
                with self.subTest(scene, a=a, b=b):
                    self.assertGreater(share, SHARE)

    def test_looks(self):
        self.check(godrays.vtkGodRaysRadialModel, 8)

    def test_media(self):
        self.check(godrays.vtkGodRaysHomogeneousModel, 6)

    def test_what_is_not_to_be_told_apart(self):
        for scene in SCENES:
            twice = [draw(scene, ["default"])["default"] for _ in range(2)]
            self.assertLess(get_share(*twice), 0.01)

    def test_the_usual_one(self):
        presets = godrays.vtkGodRaysPresets
        names = [presets.GetPresetName(i) for i in range(presets.GetNumberOfPresets())]
        self.assertEqual(names[0], "default")
        usual, first = godrays.vtkGodRaysPass().GetModel(), presets.NewModel(names[0])
        self.assertEqual(usual.Describe(), first.Describe())
        published = [name for name in names if name.startswith("published:")]
        self.assertEqual(names[-len(published) :], published)
        model = godrays.vtkGodRaysPublishedModel
        self.assertEqual(len(published), model.GetNumberOfPresets())


if __name__ == "__main__":
    unittest.main()
