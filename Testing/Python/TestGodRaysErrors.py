# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Properties of the wrapped classes, and what they tell: exceptions and warnings of Python."""

import datetime
import functools
import importlib.metadata
import inspect
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import warnings

import godrays
import numpy
from godrays._parameters import get_names
from godrays._properties import snake as to_snake
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow, vtkVersion
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkCamera, vtkRenderer, vtkRenderWindow

CLASSES = [getattr(godrays, name) for name in godrays.__all__ if name.startswith("vtkGodRays")]
MODELS = [each for each in CLASSES if issubclass(each, godrays.vtkGodRaysModel)]


def make(cls):
    """An instance, None of a class that has none."""
    try:
        return cls()
    except TypeError:
        return None


class Properties(unittest.TestCase):
    def test_each_getter_without_arguments_is_one(self):
        tried = changed = 0
        for cls in CLASSES:
            one = make(cls)
            if one is None:
                continue
            for method in vars(cls):
                name = method[3:]
                snake = to_snake(name)
                if not method.startswith("Get") or not isinstance(getattr(cls, snake, None), property):
                    continue
                if not re.match(rf"{method}\(self\)", getattr(cls, method).__doc__):
                    continue  # rays.light is that of GetLight(0)
                with self.subTest(f"{cls.__name__}.{snake}"):
                    value = getattr(one, method)()
                    got = getattr(one, snake)
                    self.assertTrue(got == value or got != got, (got, value))
                    tried += 1
                    if hasattr(cls, "Set" + name) and isinstance(value, (bool, int, float, tuple)):
                        if not isinstance(value, tuple) and not math.isfinite(value):
                            continue
                        setattr(one, snake, value)
                        self.assertEqual(getattr(one, method)(), value)
                        changed += 1
        print(f"{tried} properties of {len(CLASSES)} classes, {changed} of them set")
        self.assertGreater(tried, 200)
        self.assertGreater(changed, 180)

    def test_what_is_set_arrives(self):
        rays = godrays.vtkGodRaysPass()
        rays.intensity = 0.8
        self.assertEqual(rays.GetIntensity(), 0.8)
        rays.output = "scattering"
        self.assertEqual(rays.GetOutput(), rays.SCATTERING)
        rays.model.density = 0.5
        self.assertEqual(rays.GetModel().GetDensity(), 0.5)
        rays.model = fog = godrays.vtkGodRaysHomogeneousModel()
        self.assertIs(rays.GetModel(), fog)
        rays.model.scattering_coefficient = (1, 2, 3)
        self.assertEqual(fog.GetScatteringCoefficient(), (1, 2, 3))
        date = godrays.vtkGodRaysSunPosition()
        date.date_time = "2024-06-21T19:30+02:00"
        self.assertIn("2024-06-21", date.date_time)
        with self.assertRaises(AttributeError):
            rays.plan = "none"
        with self.assertRaisesRegex(ValueError, "output='bogus' is none of the constants"):
            rays.output = "bogus"

    def test_constructors_take_them_where_vtks_do(self):
        version = vtkVersion()
        if (version.GetVTKMajorVersion(), version.GetVTKMinorVersion()) < (9, 4):
            self.skipTest("VTK's constructors take properties since 9.4")
        rays = godrays.vtkGodRaysPass(intensity=0.5, output="scattering")
        self.assertEqual((rays.GetIntensity(), rays.GetOutput()), (0.5, rays.SCATTERING))
        self.assertIsInstance(rays, godrays.vtkGodRaysPass)
        with self.assertRaises(godrays.Error):
            godrays.vtkGodRaysPass(intensity=math.nan)
        with self.assertRaisesRegex(TypeError, "intensty"):
            godrays.vtkGodRaysPass(intensty=1)

    def test_documentation_is_that_of_c(self):
        pass_ = godrays.vtkGodRaysPass
        self.assertIn("Valid range: [0, 1e4]. Useful range: [0, 4]. Default is 1.", pass_.intensity.__doc__)
        self.assertIn("Defaults are 0.75 and 3.6", pass_.background_glow_falloff.__doc__)  # a group's second
        for function in (godrays.enable, godrays.shadows, godrays.sky, godrays.scatter, godrays.tone_map):
            for keyword, parameter in inspect.signature(function).parameters.items():
                if parameter.kind != parameter.VAR_KEYWORD:
                    self.assertRegex(function.__doc__, rf"(?m)^ *([a-z_]+, )*{keyword}(, [a-z_]+)*: \w",
                        function.__name__)

    def test_explicit_parameters_are_those_of_the_classes(self):
        keywords = set(godrays.enable.__kwdefaults__)
        of_pass = {to_snake(name) for name in get_names(godrays.vtkGodRaysPass())}
        of_models = set()
        for cls in MODELS:
            one = make(cls)
            of_models |= {to_snake(name) for name in get_names(one)} if one else set()
        # which tags volumes, and which is a short name
        self.assertEqual(keywords - of_pass - of_models, {"ambient_occlusion", "light_color", "medium", "shadows"})
        self.assertGreater(len(keywords), 50)
        sky = {to_snake(name) for name in get_names(godrays.vtkGodRaysSkyPass())}
        self.assertEqual(set(godrays.sky.__kwdefaults__) - sky, set())
        self.assertEqual(set(godrays.shadows.__kwdefaults__) - of_pass, set())


class Errors(unittest.TestCase):
    def setUp(self):
        self.messages = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.messages)
        self.addCleanup(vtkOutputWindow.SetInstance, None)

    def test_a_property_raises_what_the_log_would_say(self):
        rays = godrays.vtkGodRaysPass()
        rays.SetIntensity(math.nan)
        said = self.messages.GetOutput()
        with self.assertRaises(godrays.Error) as caught:
            rays.intensity = math.nan
        self.assertIn(str(caught.exception), said)
        self.assertRegex(str(caught.exception), r"^Intensity must be a finite number in \[0, 10000\], not nan")
        self.assertEqual(self.messages.GetOutput(), said, "the log has it, too")
        self.assertEqual(rays.intensity, 1)

    def test_an_error_of_enable_and_sky_attaches_nothing(self):
        renderer = vtkRenderer()
        vtkRenderWindow().AddRenderer(renderer)
        with self.assertRaisesRegex(godrays.Error, "Intensity must be a finite"):
            godrays.enable(renderer, light=(0, 0, -1), intensity=math.inf)
        self.assertIsNone(renderer.GetPass())
        self.assertEqual(self.messages.GetOutput(), "")

    def test_raising_holds_for_any_method(self):
        rays = godrays.vtkGodRaysPass()
        with self.assertRaisesRegex(godrays.Error, "(?s)Intensity must.*LayerMargin must"):
            with godrays.raising():
                rays.SetIntensity(math.nan)
                rays.SetLayerMargin(math.nan)
                rays.SetIntensity(0.5)
        self.assertEqual(rays.intensity, 0.5)
        self.assertEqual(self.messages.GetOutput(), "")
        with self.assertRaises(KeyError), godrays.raising():  # is not hidden by another
            rays.SetIntensity(math.nan)
            {}["a"]
        self.assertIn("Intensity must", self.messages.GetOutput())

    def test_what_others_say_stays_in_their_log(self):
        with godrays.raising():
            vtkTrivialProducer().GetOutputPort(7)
        self.assertRegex(self.messages.GetOutput(), r"ERROR: In [^\n]*\nvtkTrivialProducer")
        self.assertIs(vtkOutputWindow.GetInstance(), self.messages)

    def test_a_frame_without_rays_is_a_warning(self):
        renderer = vtkRenderer()
        window = vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetSize(40, 30)
        window.AddRenderer(renderer)
        godrays.enable(renderer, light=(0, 0, -1))
        camera = vtkCamera()
        camera.SetPosition(math.nan, 0, 5)
        renderer.SetActiveCamera(camera)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            window.Render()
        told = [each for each in caught if each.category is godrays.GodRaysWarning]
        self.assertEqual(len(told), 1, caught)
        self.assertRegex(str(told[0].message), r"^The scene is drawn without god rays.*Position is not finite")
        self.assertEqual(told[0].filename, __file__)
        self.assertNotIn("vtkGodRays", self.messages.GetOutput())


class Mistakes(unittest.TestCase):
    """What newcomers type: one message, with what there is or what is meant."""

    def setUp(self):
        self.renderer = vtkRenderer()

    def test_misspelt_names_are_guessed(self):
        atmosphere = "there is no atmosphere 'earth-haze'; did you mean earth-hazy? There are: earth-clear, earth-hazy"
        rays = godrays.vtkGodRaysPass()
        enable = functools.partial(godrays.enable, self.renderer)
        for error, words, call in (
            (TypeError, "no parameter intensty; did you mean intensity[?] There are: ", lambda: enable(intensty=1)),
            (TypeError, "no parameter ocluders; did you mean occluders[?]", lambda: enable(ocluders=[])),
            (TypeError, "render.. has no parameter backgroud; did you mean background[?]",
                lambda: godrays.render(vtkConeSource(), backgroud="red")),
            (TypeError, "visibility is a parameter of the model homogeneous; give", lambda: enable(visibility=5)),
            (ValueError, "no preset 'fogg'; did you mean fog[?]", lambda: enable(preset="fogg")),
            (ValueError, "no preset 3; there are: default", lambda: enable(preset=3)),
            (ValueError, "no model 'homogenous'; did you mean homog", lambda: enable(model="homogenous")),
            (ValueError, "no role 'occluders'; did you mean occluder[?]", lambda: godrays.tag(vtkActor(), "occluders")),
            (ValueError, "did you mean occlusion[?]", lambda: setattr(rays, "output", "occlusoin")),
            (ValueError, "intensity='big' should be a number", lambda: setattr(rays, "intensity", "big")),
            (ValueError, "intensity='big' should be a number", lambda: enable(intensity="big")),
            (ValueError, re.escape(atmosphere), lambda: godrays.sky(self.renderer, atmosphere="earth-haze")),
            (ValueError, "does not know 'densty'; did you mean dens", lambda: godrays.from_pmndrs({"densty": 1})),
        ):
            with self.subTest(words), self.assertRaisesRegex(error, words):
                call()
        self.assertIsNone(self.renderer.GetPass())
        with self.assertRaises(ValueError) as raised:
            godrays.sky(self.renderer, atmosphere="venus")
        self.assertNotIn("rayleigh", str(raised.exception))  # a constant, but no atmosphere

    def test_a_name_that_the_rays_have_not(self):
        """Those of the model are forwarded to it; others are errors, where VTK lets a class be extended."""
        rays = godrays.enable(self.renderer)
        rays.density = 0.4
        self.assertEqual((rays.density, rays.GetModel().density), (0.4, 0.4))
        with self.assertRaisesRegex(AttributeError, "visibility is of the model homogeneous, not of vtkGodRaysRadial"):
            rays.visibility = 100
        rays.SetModel(godrays.vtkGodRaysHomogeneousModel())
        with self.assertRaisesRegex(AttributeError, "density is of the model radial or published, not of"):
            rays.density
        if hasattr(godrays.vtkGodRaysPass, "override"):
            with self.assertRaisesRegex(AttributeError, "no property intensty; did you mean intensity"):
                godrays.vtkGodRaysPass().intensty = 2

    def test_a_number_out_of_range(self):
        """C++ clamps it; here it is an error, and nothing changes."""
        rays = godrays.enable(self.renderer, density=0.5, intensity=2)
        for name, value in {"intensity": -1, "density": 7, "background_glow": 2}.items():
            former = getattr(rays, name)
            for set_it in (functools.partial(setattr, rays, name), lambda x: godrays.enable(self.renderer, **{name: x})):
                with self.assertRaisesRegex(ValueError, rf"{name}={value} must be in .*; nothing is changed"):
                    set_it(value)
            self.assertEqual(getattr(rays, name), former)
        with self.assertRaisesRegex(ValueError, "density=9.0 must be in"):
            rays.density = numpy.float32(9)
        model = godrays.vtkGodRaysHomogeneousModel()
        model.world_unit_in_meters = 0  # which is no length, but a choice
        self.assertEqual(model.world_unit_in_meters, 0)
        self.assertEqual(godrays.sky(self.renderer, display_transfer="power_transfer").display_transfer,
            godrays.vtkGodRaysPass.POWER_TRANSFER)

    def test_a_model_by_its_name(self):
        rays = godrays.vtkGodRaysPass()
        rays.model = "homogeneous"
        self.assertIsInstance(rays.model, godrays.vtkGodRaysHomogeneousModel)
        with self.assertRaisesRegex(ValueError, "no model 'homogenous'; did you mean"):
            rays.model = "homogenous"

    def test_values_of_another_shape(self):
        cone = vtkConeSource()
        for words, call in (
            ("size=100 should be a width and a height of 1 to 16384 pixels", lambda: godrays.render(cone, 100)),
            ("size='9x9' should", lambda: godrays.render(cone, "9x9")),
            (r"size=\(nan, 4\) should", lambda: godrays.render(cone, (math.nan, 4))),
            (r"size=\(99999, 99999\) should", lambda: godrays.render(cone, (99999, 99999))),
            ("camera=3 should be a vtkCamera, or", lambda: godrays.render(cone, camera=3)),
            (r"camera=\(1, 2, 3\) should", lambda: godrays.render(cone, camera=(1, 2, 3))),
            ("zoom='2' should be a positive number", lambda: godrays.render(cone, zoom="2")),
            (r"background=\(255, 0, 0\) should be three numbers in \[0, 1\]",
                lambda: godrays.render(cone, background=(255, 0, 0))),
            ("no color '#zzzzzz'", lambda: godrays.render(cone, background="#zzzzzz")),
            (r"light=\(1, 0\) is no direction; say in three numbers", lambda: godrays.render(cone, light=(1, 0))),
            ("sun_at='top' should be a place", lambda: godrays.enable(self.renderer, sun_at="top")),
            (r"sun_at=\(400, 300\) should be a place", lambda: godrays.enable(self.renderer, sun_at=(400, 300))),
            ("sun=3 should be a vtkGodRaysSun, .azimuth, elevation.", lambda: godrays.sky(self.renderer, sun=3)),
            (r"sun=\(190, 98\) should be \(azimuth, ", lambda: godrays.enable(self.renderer, sun=(190, 98))),
            (r"sun=\(1, 2, 3\) should be \(azimuth, ", lambda: godrays.render(cone, sun=(1, 2, 3))),
            ("sun, light and sun_at each say where", lambda: godrays.render(cone, sun=(1, 2), light=(1, 2, 3))),
            ("light_color='nocolor'|no color 'nocolor'", lambda: godrays.render(cone, light_color="nocolor")),
            ("light_color is for lights: props shine",
                lambda: godrays.enable(self.renderer, light=vtkActor(), light_color="red")),
            ("color is in the place of scalars", lambda: godrays.render(cone, color="red", scalars="a")),
            (r"color=\(2, 0, 0\) should be three numbers", lambda: godrays.render(cone, color=(2, 0, 0))),
            (r"opacity=\[3\] should be in \[0, 1\]", lambda: godrays.render(cone, opacity=3)),
            ("no array 'temprature' of numbers; there are: Normals|no array", lambda: godrays.render(cone, scalars="temprature")),
            ("scalars has 5 numbers, where the data have", lambda: godrays.render(cone, scalars=[1, 2, 3, 4, 5])),
            ("cmap is for scalars, and the data have none", lambda: godrays.render(cone, cmap="viridis")),
            ("'2024-06-21T12:00' has no time zone: write", lambda: godrays.sun("2024-06-21T12:00", 48, 11)),
            ("has no time zone: write",
                lambda: godrays.sun(datetime.datetime(2024, 6, 21, 12), 48, 11)),
            ("below the horizon.*it does not rise on that day", lambda: godrays.sun("2024-12-21T12:00Z", 80, 0)),
            ("below the horizon.*it rises at", lambda: godrays.sun("2024-12-21T00:00Z", 48, 0)),
            ("no place at latitude 'a' and longitude 2: they are in", lambda: godrays.sun("2024-06-21T12:00", "a", 2)),
            ("None is no date with a time", lambda: godrays.sun(None, 1, 2)),
            ("light='middle' should be a place", lambda: godrays.scatter([[1.0]], light="middle")),
            ("density='thick' should be a finite number", lambda: godrays.from_pmndrs({"density": "thick"})),
        ):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                call()

    def test_things_of_another_kind(self):
        class Closed:
            renderer = None

        class Noted:  # as PyVista has it
            renderer = self.renderer
            _closed = True

        for error, words, call in (
            (TypeError, "needs a vtkImageData, not NoneType", lambda: godrays.to_array(None)),
            (TypeError, "needs a filter, a vtkAlgorithm, not NoneType", lambda: godrays.apply(None, [[1.0]])),
            (TypeError, "needs a dict of parameters, not NoneType", lambda: godrays.from_pmndrs(None)),
            (TypeError, "god rays need a vtkRenderer.*not NoneType", lambda: godrays.enable(None)),
            (ValueError, "the Closed has no renderer: it is closed", lambda: godrays.enable(Closed())),
            (ValueError, "the Noted has no renderer: it is closed", lambda: godrays.enable(Noted())),
            (ValueError, "there are no data", lambda: godrays.render([])),
            (TypeError, "color is for data; a vtk.*Actor has its own", lambda: godrays.render(vtkActor(), color="red")),
            (TypeError, "opacity is for data; a scene", lambda: godrays.render(self.renderer, opacity=0.5)),
            (TypeError, "show.. has no parameter transparent", lambda: godrays.show(None, transparent=True)),
            (TypeError, "turntable.. has no parameter transparent",
                lambda: godrays.turntable(None, "a.html", transparent=True)),
            (ValueError, "file='a.png' should end in .html", lambda: godrays.turntable(None, "a.png")),
            (ValueError, "views=1 should be a whole number", lambda: godrays.turntable(None, "a.html", views=1)),
            (ValueError, "views=2.5 should be a whole number", lambda: godrays.turntable(None, "a.html", views=2.5)),
            (godrays.Error, "is a directory", lambda: godrays.render("/")),
        ):
            with self.subTest(words), self.assertRaisesRegex(error, words):
                call()
        godrays.disable(Closed())  # has none

    def test_leaving_twice(self):
        window = vtkRenderWindow()
        window.AddRenderer(self.renderer)
        with godrays.enable(self.renderer, light=(0, 0, 1)) as rays:
            rays.__exit__(None, None, None)
        self.assertIsNone(self.renderer.GetPass())

    def test_what_is_offered(self):
        self.assertLessEqual({"enable", "render", "__version__"}, set(dir(godrays)))
        self.assertFalse({"annotations", "Any", "TYPE_CHECKING"} & set(dir(godrays)))


class Package(unittest.TestCase):
    def test_version(self):
        self.assertEqual(godrays.__version__, importlib.metadata.version("godrays"))
        self.assertRegex(godrays.__version__, r"^\d+\.\d+\.\d+$")

    def test_names(self):
        self.assertTrue({"enable", "sun", "sky", "tag", "disable", "render", "vtkGodRaysPass"} <=
            set(godrays.__all__))
        for name in godrays.__all__:
            self.assertTrue(getattr(godrays, name).__doc__, name)
        names = {}
        exec("from godrays import *", names)
        self.assertEqual(set(names) - {"__builtins__"}, set(godrays.__all__))

    def test_presets(self):
        presets = godrays.presets()
        self.assertEqual(list(presets)[0], "default")
        self.assertEqual(", ".join(presets), godrays.vtkGodRaysPresets.ListNames())
        self.assertGreater(min(map(len, presets.values())), 10)


class AnotherVTK(unittest.TestCase):
    """The VTK of this process is not the one that the package is built for, or PyVista's is not."""

    def run_python(self, code, files):
        """Run code in another Python, in which modules come first, texts by path."""
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                path = pathlib.Path(folder, name)
                path.parent.mkdir(exist_ok=True)
                path.write_text(text, encoding="utf-8")
            paths = [folder, str(pathlib.Path(godrays.__file__).parents[1]), os.environ.get("PYTHONPATH", "")]
            return subprocess.run([sys.executable, "-c", code], check=False, text=True, stderr=subprocess.PIPE,
                env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)}).stderr

    def test_an_import_beside_it_fails_in_one_line(self):
        version = "class vtkVersion:\n    def GetVTKVersion(self): return '9.0.2'\n"
        pair = "def vtk_backend(): return 'cvista'\n"
        cases = (  # what is there, what is told, the remedy
            ({"vtkmodules/__init__.py": "", "vtkmodules/vtkCommonCore.py": version},
                "this Python has VTK 9.0.2", "vtk=="),
            ({"vtkmodules/__init__.py": ""}, "No module named 'vtkmodules.vtkCommonCore'", "vtk=="),
            ({"pyvista.py": pair}, "PyVista runs on cvista: install godrays-cvista", "PYVISTA_VTK_BACKEND=vtkmodules"))
        for files, reason, remedy in cases:
            with self.subTest(reason):
                told = self.run_python(f"import {'pyvista, ' if 'pyvista.py' in files else ''}godrays", files)
                told = [line for line in told.splitlines() if not line.startswith((" ", "Traceback"))]
                self.assertEqual(len(told), 1, told)
                for words in (f"godrays {godrays.__version__} is built for vtk {vtkVersion().GetVTKVersion()[:3]}, but ",
                        reason, remedy):
                    self.assertIn(words, told[0])

    def test_pyvista_on_the_same_one_is_no_fault(self):
        for text in ("", "def vtk_backend(): return 'vtk'\n"):
            self.assertEqual(self.run_python("import pyvista, godrays", {"pyvista.py": text}), "")

    def test_its_objects_are_told_from_ours(self):
        base = type("vtkObjectBase", (), {"__module__": "cvista.vtkCommonCore"})
        other = type("vtkRenderer", (base,), {})()
        uses = {
            "enable": lambda: godrays.enable(other), "light": lambda: godrays.enable(vtkRenderer(), light=other),
            "sky": lambda: godrays.sky(vtkRenderer(), light=other), "tag": lambda: godrays.tag(other, "occluder"),
            "render": lambda: godrays.render(other), "apply": lambda: godrays.apply(other, [[0.0]]),
            "to_array": lambda: godrays.to_array(other)}
        for name, use in uses.items():
            with self.subTest(name), self.assertRaisesRegex(TypeError, "vtkRenderer of cvista: .* for vtkmodules"):
                use()


if __name__ == "__main__":
    unittest.main()
