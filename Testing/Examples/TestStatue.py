# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The window of the example Statue in Python, run by a user who is a program.

What each slider does to the light is checked in C++; here, that each is connected.
Usage: TestStatue.py Statue.py [program]
"""

import os
import runpy
import subprocess
import sys
import unittest

import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

EXAMPLE = sys.argv[1]


class User(vtk.vtkGenericRenderWindowInteractor):
    """Has no event loop: Start() calls a function that sends the events."""

    act = None

    def Start(self):
        type(self).act(self)

    def renderer(self):
        return self.GetRenderWindow().GetRenderers().GetFirstRenderer()

    def model(self):
        return self.renderer().GetPass().GetModel()

    def sliders(self):
        return [
            prop for prop in self.renderer().GetViewProps()
            if isinstance(prop, vtk.vtkSliderRepresentation2D)
        ]  # fmt: skip

    def click(self, slider):
        """Click on the left part of a slider, to which its knob then jumps."""
        ends = [
            slider.GetPoint1Coordinate().GetComputedDisplayValue(self.renderer()),
            slider.GetPoint2Coordinate().GetComputedDisplayValue(self.renderer()),
        ]
        self.SetEventInformation(round(0.8 * ends[0][0] + 0.2 * ends[1][0]), ends[0][1])
        self.InvokeEvent("LeftButtonPressEvent")
        self.InvokeEvent("LeftButtonReleaseEvent")

    def press(self, key):
        self.SetKeySym(key)
        self.InvokeEvent("KeyPressEvent")

    def light(self):
        """The light scattered in the last frame, over all pixels and colours."""
        image = vtk.vtkImageData()
        self.renderer().GetPass().GetScatteringImage(image)
        return vtk_to_numpy(image.GetPointData().GetScalars()).sum(dtype=float)


vtk.vtkRenderWindowInteractor = User  # for the example


class Window(unittest.TestCase):
    def run_example(self, act):
        User.act = act
        sys.argv = [EXAMPLE, "800x600"]
        sys.path.insert(0, os.path.dirname(EXAMPLE))
        runpy.run_path(EXAMPLE)

    def test_sliders(self):
        clicked = []

        def act(user):
            for slider in user.sliders():
                with self.subTest(slider.GetTitleText()):
                    light = user.light()
                    user.click(slider)
                    value = getattr(user.model(), "Get" + slider.GetTitleText())()
                    self.assertAlmostEqual(value, slider.GetValue(), delta=0.5)
                    self.assertLess(slider.GetValue(), slider.GetMaximumValue() / 2 + 0.4)
                    self.assertNotEqual(user.light(), light)
                    clicked.append(slider.GetTitleText())

        self.run_example(act)
        self.assertEqual(
            clicked, ["Exposure", "Decay", "Density", "Weight", "NumberOfSamples"])

    def test_keys(self):
        def act(user):
            light = user.light()
            user.InvokeEvent("TimerEvent")
            self.assertEqual(user.light(), light)
            user.press("g")
            self.assertEqual(user.model().GetFormulationAsString(), "gianassi")
            self.assertNotEqual(user.light(), light)
            user.press("g")
            user.press("space")
            user.InvokeEvent("TimerEvent")
            self.assertNotEqual(user.light(), light)

        self.run_example(act)

    def test_models(self):
        def draw(model):
            return subprocess.run(
                [sys.executable, EXAMPLE, "Statue-model-py.png", "400x300", model],
                stderr=subprocess.PIPE, text=True)  # fmt: skip

        ring = vtk.vtkSuperquadricSource()  # through which light is seen: a ball would hide it
        ring.ToroidalOn()
        writer = vtk.vtkSTLWriter()
        writer.SetInputConnection(ring.GetOutputPort())
        writer.SetFileName("Statue-ring-py.stl")
        writer.Write()
        result = draw("Statue-ring-py.stl")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        result = draw("missing.obj")
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"^Statue: missing.obj cannot be read; check its name.*\n$")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
