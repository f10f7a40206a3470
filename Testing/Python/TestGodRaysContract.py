# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What every model, integrator and source in CMake's lists has to do, with every other one that it goes with.

Their properties and ranges are those of their ParaView entries, which a test of the plugin holds to the
classes.
"""

import itertools
import os
import pathlib
import unittest
import xml.etree.ElementTree as ElementTree

import godrays
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow, vtkUnsignedCharArray
from vtkmodules.vtkCommonCore import VTK_FLOAT
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkVolume,
)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

ENTRIES = pathlib.Path(os.environ["GODRAYS_ENTRIES"])  # ParaView's, as CMake has written them


def classes(variable, suffix=""):
    """The classes of one of CMake's lists: words with their folders."""
    return [f"vtkGodRays{stem.split('/')[1]}{suffix}" for stem in os.environ[variable].split(",")]


MODELS = classes("GODRAYS_MODELS", "Model")
INTEGRATORS = classes("GODRAYS_INTEGRATORS", "Integrator")
SOURCES = [name for name in classes("GODRAYS_ALGORITHMS") if name.endswith("Source") and "Sky" not in name]
SIZES = {"SetCapacity": 50, "SetDimensions": 9, "SetResolution": 9, "SetTextureResolution": 16}  # of sources
PHASE_FUNCTIONS = ["ISOTROPIC", "RAYLEIGH", "HENYEY_GREENSTEIN", "CORNETTE_SHANKS", "SCHLICK"]  # and newer ones


def properties(name):
    """(setter, number of values, values to try) of each property of a class."""
    files = [ElementTree.parse(path) for path in sorted(ENTRIES.glob("*.xml"))]
    proxy = next(found for file in files for found in file.iterfind(f"*/*[@class='{name}']"))
    for element in proxy.iter():
        command = element.get("command", "")
        if not command.startswith("Set") or not element.tag.endswith("VectorProperty"):
            continue
        values = []
        for domain in element:
            if domain.tag.endswith("RangeDomain"):
                values = [float(domain.get(end).split()[0]) for end in ("min", "max")]
            elif domain.tag == "EnumerationDomain":
                values = [int(entry.get("value")) for entry in domain.iter("Entry")]
            elif domain.tag == "BooleanDomain":
                values = [0, 1]
        if element.tag == "IntVectorProperty":
            values = [int(value) for value in values]
        if command == "SetVerifyPixels":  # more than the picture has take minutes
            values = [0, 100]
        yield command, int(element.get("number_of_elements")), values


def make_small(name):
    """A source that is fast: its properties are there to be set."""
    source = getattr(godrays, name)()
    for command, count, _ in properties(name):
        if command in SIZES:
            getattr(source, command)(*[SIZES[command]] * count)
    return source


def arrays(source):
    """The numbers of a source's first output, at an early time."""
    source.UpdateTimeStep(0.02)
    data = source.GetOutputDataObject(0)
    found = [data.GetPointData().GetArray(i) for i in range(data.GetPointData().GetNumberOfArrays())]
    if data.IsA("vtkPointSet"):
        found.append(data.GetPoints().GetData())
    return [vtk_to_numpy(array).copy() for array in found if array]


class Scene:
    """A cone before a sun, in a small window."""

    def __init__(self):
        cone = vtkConeSource()
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(cone.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        self.renderer = vtkRenderer()
        self.renderer.AddActor(actor)
        self.renderer.GetActiveCamera().SetPosition(0, 0, 5)
        self.renderer.ResetCameraClippingRange()
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(48, 36)
        self.window.AddRenderer(self.renderer)
        sun = vtkLight()
        sun.SetPosition(0.1, 0.3, -1)
        self.rays = godrays.vtkGodRaysPass()
        self.rays.AddLight(sun)
        self.rays.SetPrecision(godrays.vtkGodRaysPass.SINGLE)

    def suit(self, model):
        """Have what a model needs: for one of data, a volume of some."""
        if not model.IsA("vtkGodRaysVolumeModel"):
            return
        image = vtkImageData()
        image.SetDimensions(9, 9, 9)
        image.SetSpacing(0.2, 0.2, 0.2)
        image.SetOrigin(-0.8, -0.8, -0.8)
        image.AllocateScalars(VTK_FLOAT, 1)
        image.GetPointData().GetScalars().Fill(1)
        opacity = vtkPiecewiseFunction()
        opacity.AddPoint(0, 0.2)
        opacity.AddPoint(2, 0.2)
        mapper = vtkGPUVolumeRayCastMapper()
        mapper.SetInputData(image)
        volume = vtkVolume()
        volume.SetMapper(mapper)
        volume.GetProperty().SetScalarOpacity(opacity)
        godrays.tag(volume, "medium")
        self.renderer.AddVolume(volume)
        self.renderer.ResetCameraClippingRange()

    def pixels(self):
        self.window.Render()
        data = vtkUnsignedCharArray()
        self.window.GetRGBACharPixelData(0, 0, 47, 35, 1, data)
        return vtk_to_numpy(data).copy()

    def light(self):
        """What was scattered, None if nothing."""
        image = vtkImageData()
        if not self.rays.GetScatteringImage(image):
            return None
        return vtk_to_numpy(image.GetPointData().GetScalars())


class Contract(unittest.TestCase):
    def setUp(self):
        self.messages = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.messages)
        self.addCleanup(vtkOutputWindow.SetInstance, None)

    def said(self):
        """What VTK has said since."""
        text = self.messages.GetOutput()
        self.messages = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.messages)
        return text

    def for_each_pair(self, test):
        """Call test(scene, model, integrator) for each model with each integrator that supports it."""
        for model_name, name in itertools.product(MODELS, INTEGRATORS):
            model, integrator = getattr(godrays, model_name)(), getattr(godrays, name)()
            if not integrator.Supports(model):
                continue
            if hasattr(model, "SetUp"):
                model.SetUp(0, 1, 0)  # the sun is above the horizon
            with self.subTest(model=model_name, integrator=name):
                scene = Scene()
                scene.rays.SetModel(model)
                scene.rays.SetIntegrator(integrator)
                test(scene, model, integrator)

    def test_every_class_is_wrapped_with_documentation(self):
        self.assertGreaterEqual(len(SOURCES), 4)
        for name in (*MODELS, *INTEGRATORS, *SOURCES):
            with self.subTest(name):
                self.assertGreater(len(getattr(godrays, name).__doc__), 200)

    def test_every_model_has_integrators_and_every_integrator_a_model(self):
        for name in MODELS:
            rays = godrays.vtkGodRaysPass()
            rays.SetModel(getattr(godrays, name)())
            self.assertTrue(rays.GetIntegrator().Supports(rays.GetModel()), name)
        for name in INTEGRATORS:
            integrator = getattr(godrays, name)()
            self.assertTrue(any(integrator.Supports(getattr(godrays, each)()) for each in MODELS), name)

    def test_they_draw_the_same_every_time_and_leave_nothing_behind(self):
        def test(scene, model, integrator):
            scene.suit(model)
            without = scene.pixels()
            scene.rays.Attach(scene.renderer)
            scene.rays.SetIntensity(1e4)
            drawn = scene.pixels()
            self.assertFalse((drawn == without).all(), "draws nothing: " + scene.rays.GetPlan())
            self.assertTrue((scene.pixels() == drawn).all(), "another frame")
            light = scene.light()
            self.assertTrue(numpy.isfinite(light).all())
            self.assertGreater(light.max(), 0)
            scene.rays.Detach(scene.renderer)
            self.assertTrue((scene.pixels() == without).all(), "after Detach()")
            other = Scene()
            other.suit(model)
            other.rays.SetModel(model)
            other.rays.SetIntegrator(integrator)
            other.rays.SetIntensity(1e4)
            other.rays.Attach(other.renderer)
            self.assertTrue((other.pixels() == drawn).all(), "in another window")
            self.assertEqual(self.said(), "")

        self.for_each_pair(test)

    def test_they_survive_the_ends_of_their_ranges(self):
        def try_all(scene, each):
            name = each.GetClassName()
            fresh = getattr(godrays, name)()
            for command, count, values in properties(name):
                for value in values:
                    getattr(each, command)(*[value] * count)
                    scene.window.Render()
                    light = scene.light()
                    if light is not None:
                        self.assertTrue(numpy.isfinite(light).all(), (command, value))
                        self.assertGreaterEqual(light.min(), 0, (command, value))
                former = getattr(fresh, "Get" + command[3:])()
                getattr(each, command)(*(former if count > 1 else (former,)))

        def test(scene, model, integrator):
            scene.rays.Attach(scene.renderer)
            try_all(scene, model)
            try_all(scene, integrator)
            said = self.said()  # at most a warning with its remedy
            self.assertNotIn("ERROR", said)
            self.assertEqual("Warning" in said, "Set " in said or "Use " in said, said)

        self.for_each_pair(test)

    def test_sources_are_the_same_every_time_and_survive_the_ends_of_their_ranges(self):
        for name in SOURCES:
            with self.subTest(name):
                made = arrays(make_small(name))
                self.assertTrue(made and all(array.size for array in made), "empty")
                for one, other in zip(made, arrays(make_small(name))):
                    self.assertTrue((one == other).all(), "another time")
                for command, count, values in properties(name):
                    for value in values if command not in SIZES else ():
                        source = make_small(name)
                        getattr(source, command)(*[value] * count)
                        for array in arrays(source):
                            self.assertTrue(numpy.isfinite(array).all(), (command, value))
                for error in self.said().split("ERROR: ")[1:]:  # has a remedy
                    self.assertRegex(error, r"[.] (Take|Move|Set|Use) ")

    def test_classes_and_paraview_have_the_same_phase_functions(self):
        for name in ("vtkGodRaysHomogeneousModel", "vtkGodRaysAtmosphereModel", "vtkGodRaysAtmosphere",
                     "vtkGodRaysGridFilter", "vtkGodRaysSingleScatteringReference"):
            wrapped = getattr(godrays, name)
            self.assertEqual([getattr(wrapped, each) for each in PHASE_FUNCTIONS], [0, 1, 2, 3, 4], name)
            self.assertIs(type(wrapped.SCHLICK), wrapped.PhaseFunctionType, name)
        last = godrays.vtkGodRaysGridFilter().GetPhaseFunctionMaxValue()
        self.assertEqual(godrays.vtkGodRaysAtmosphere().GetMiePhaseFunctionMaxValue(), last)
        for name, setter in (("vtkGodRaysHomogeneousModel", "SetPhaseFunction"),
                             ("vtkGodRaysHomogeneousModel", "SetSecondPhaseFunction"),
                             ("vtkGodRaysMediumFilter", "SetPhaseFunction"),
                             ("vtkGodRaysMediumFilter", "SetGasPhaseFunction")):
            values = next(values for command, _, values in properties(name) if command == setter)
            self.assertEqual(values, list(range(last + 1)), (name, setter))
        model = godrays.vtkGodRaysHomogeneousModel()
        model.SetPhaseFunction(model.CORNETTE_SHANKS)
        self.assertIn("Cornette-Shanks 0.6", model.Describe())
        model.SetPhaseFunction(model.RAYLEIGH)
        self.assertIn("Rayleigh,", model.Describe())

    def test_every_preset_draws(self):
        presets = godrays.vtkGodRaysPresets
        for i in range(presets.GetNumberOfPresets()):
            preset = presets.GetPresetName(i)
            with self.subTest(preset=preset):
                scene = Scene()
                model = presets.NewModel(preset)
                scene.rays.SetModel(model)
                self.assertTrue(scene.rays.ApplyPreset(preset))
                self.assertGreater(len(presets.GetPresetDescription(i)), 10)
                scene.rays.Attach(scene.renderer)
                scene.window.Render()
                light = scene.light()
                self.assertTrue(numpy.isfinite(light).all())
                self.assertGreater(light.max(), 0)
                self.assertEqual(self.said(), "")


if __name__ == "__main__":
    unittest.main()
