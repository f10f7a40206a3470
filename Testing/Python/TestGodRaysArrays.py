# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and layers as arrays: render(), scatter(), the layers of a frame; the context manager; -m godrays."""

import base64
import importlib.util
import os
import pathlib
import pickle
import re
import shutil
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock

import browser_testing
import godrays
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkCylinderSource, vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOImage import vtkJPEGReader
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkRenderWindowInteractor,
)

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "CommandLine"))
import image_files
import sample_files

SIZE = (120, 90)
BEHIND = (0.1, 0.15, -1)


def make_scene():
    mapper = vtkPolyDataMapper()
    cone = vtkConeSource()
    cone.SetCenter(0.3, 0.5, 0)
    mapper.SetInputConnection(cone.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    renderer.GetActiveCamera().SetPosition(0, 0, 5)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    return window, renderer


def light_of(picture, without):
    return picture[..., :3].astype(float) - without[..., :3]


class Images(unittest.TestCase):
    def test_there_and_back(self):
        for kind in (numpy.uint8, numpy.float32, numpy.float64, numpy.int16):
            for shape in ((4, 7), (4, 7, 3), (1, 1)):
                array = numpy.arange(numpy.prod(shape)).reshape(shape).astype(kind)
                back = godrays.to_array(godrays.to_image(array))
                self.assertEqual((back.dtype, back.shape), (array.dtype, shape))
                self.assertTrue((back == array).all())
        image = godrays.to_image(numpy.array([[1.0, 2.0], [3.0, 4.0]]))
        self.assertEqual(image.GetScalarComponentAsDouble(0, 0, 0, 0), 3)  # VTK's origin: the lower left
        view = numpy.arange(24.0).reshape(4, 6)[:, ::2]
        self.assertTrue((godrays.to_array(godrays.to_image(view)) == view).all())
        for wrong in (numpy.zeros(3), numpy.zeros((0, 3)), numpy.array([["a"]]), [[1j]], numpy.zeros((1,) * 4)):
            with self.assertRaisesRegex(ValueError, "a picture is an array of numbers"):
                godrays.to_image(wrong)

    def test_scatter_is_the_sum_of_the_model(self):
        # a constant layer gives the gain, whatever the light [vtkGodRaysReferenceFilter]
        rays = godrays.scatter(
            numpy.full((5, 7), 0.5, "f4"), light=(0.5, 0.5), decay=1, weight=0.01, exposure=2,
            number_of_samples=50)
        self.assertEqual((rays.dtype, rays.shape), (numpy.float32, (5, 7)))
        self.assertAlmostEqual(float(rays.min()), 0.5 * 50 * 0.01 * 2, 6)
        self.assertAlmostEqual(float(rays.max()), 0.5 * 50 * 0.01 * 2, 6)
        # one bright square, upper right in the array as in the picture
        layer = numpy.zeros((60, 80, 3))
        layer[8:12, 62:66] = (1, 0.5, 0.25)
        place = (64 / 80, 50 / 60)
        rays = godrays.scatter(layer, place, density=1, error_tolerance=1e-4)
        self.assertEqual((rays.dtype, rays.shape), (numpy.float32, layer.shape))
        self.assertEqual(numpy.unravel_index(rays[..., 0].argmax(), (60, 80))[0] < 20, True)
        self.assertGreater(rays[:20, 50:].mean(), 5 * rays[40:, :30].mean())
        numpy.testing.assert_allclose(rays[..., 0], 2 * rays[..., 1], rtol=1e-3, atol=1e-4 * rays.max())
        reference = godrays.vtkGodRaysReferenceFilter()
        reference.SetLightPosition(*place)
        reference.density = 1
        exact = godrays.apply(reference, layer)
        error = numpy.sqrt(((rays - exact) ** 2).mean()) / exact.max()
        print(f"scatter() off the reference by {error:.1e} of the largest")
        self.assertLess(error, 5e-4)
        for wrong, words in ((((0.5,),), "a place in the picture"), (((0, 0, 0, 1),), "a place in the picture")):
            with self.assertRaisesRegex(ValueError, words):
                godrays.scatter(layer, *wrong)
        with self.assertRaisesRegex(godrays.Error, "Density must be a finite"):
            godrays.scatter(layer, place, density=numpy.nan)
        with self.assertRaises(godrays.Error):
            godrays.scatter(numpy.zeros((4, 4, 5)), place)  # five channels
        with self.assertRaisesRegex(ValueError, "method='magic' is none of the constants.*sweep"):
            godrays.scatter(layer, place, method="magic")

    def test_tone_map(self):
        shown = godrays.tone_map(numpy.full((2, 3), 0.18), exposure=1, curve="clamp")
        self.assertEqual((shown.dtype, shown.shape), (numpy.uint8, (2, 3)))
        self.assertEqual(set(shown.ravel()), {118})  # sRGB of 18 %: 117.6
        self.assertEqual(godrays.tone_map(numpy.ones((2, 3, 3))).shape, (2, 3, 3))


class Layers(unittest.TestCase):
    def test_the_right_way_up_and_as_vtk_has_them(self):
        window, renderer = make_scene()
        rays = godrays.enable(renderer, light=BEHIND)
        self.assertIsNone(rays.scattering)
        window.Render()
        for name in ("scattering", "occlusion"):
            layer = getattr(rays, name)
            self.assertEqual((layer.dtype, layer.shape), (numpy.float32, (90, 120, 3)))
            image = godrays.to_image(layer)
            expected = image.NewInstance()
            getattr(rays, f"Get{name.title()}Image")(expected)
            for x, y in ((0, 0), (5, 80), (119, 89)):
                self.assertEqual(expected.GetScalarComponentAsDouble(x, y, 0, 0), layer[89 - y, x, 0])
        # the sun's disc is above the centre, to the right: in the upper half, which comes first
        row, column = numpy.unravel_index(rays.occlusion[..., 0].argmax(), (90, 120))
        self.assertLess(row, 45)
        with self.assertRaises(AttributeError):
            rays.scattering = None

    def test_what_is_added_is_the_layer(self):
        window, renderer = make_scene()
        rays = godrays.enable(renderer, light=BEHIND, output="scattering", automatic_exposure=False)
        shown = godrays._render._read(window, False).astype(float)
        light = numpy.clip(rays.scattering, 0, 1)
        encoded = numpy.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055) * 255
        self.assertGreater(encoded.max(), 30)
        self.assertLess(numpy.abs(encoded - shown).max(), 2)


class Render(unittest.TestCase):
    def test_files_are_read_as_the_program_reads_them(self):
        """Files of every type that its tests have, and one body in the storages of medical images."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            files = sample_files.write_all(folder)
            self.assertGreater(len(files), 35)
            for file in files:
                with self.subTest(file.name):
                    picture = godrays.render(file, SIZE, background="#010203", rays=False).astype(int)
                    self.assertGreater((picture != (1, 2, 3)).any(axis=2).mean(), 0.02)
            body = numpy.zeros((14, 12, 10), "i2")
            body[2:12, 3:9, 4:6] = 1000
            body[3:6, 3:9, 2:5] = 700
            place = numpy.array([[1.5, 0, 0, -30], [0, 1.0, 0, 20], [0, 0, 2.0, 10]])
            pictures = []
            for write, end in (
                (image_files.write_vti, ".vti"), (image_files.write_mha, ".mha"), (image_files.write_nii, ".nii.gz"),
                (image_files.write_nrrd, ".nrrd"),
            ):
                write(folder / ("body" + end), body, place)
                pictures.append(godrays.render(folder / ("body" + end), SIZE, rays=False).astype(int))
            for other in pictures[1:]:
                self.assertLess(abs(other - pictures[0]).mean(), 0.2)
            self.assertGreater(abs(godrays.render(folder / "a.vti", SIZE, rays=False) - pictures[0]).mean(), 1)
            colors = [godrays.render(folder / "body.vti", SIZE, rays=False, cmap=each).astype(int)
                for each in ("viridis", "gray")]
            self.assertLess(abs(colors[0] - pictures[0]).mean(), 0.5)  # the program's
            self.assertGreater(abs(colors[1] - pictures[0]).mean(), 0.5)
            self.assertLess(numpy.ptp(colors[1][40:50, 55:65] - [[(6, 10, 20)]], axis=2).max(), 25)
            one, both = (godrays.render(each, SIZE, rays=False) for each in (files[0], files[:2]))
            self.assertGreater(abs(one.astype(int) - both).max(), 20)

    def test_data_of_each_kind(self):
        source = vtkSphereSource()
        source.Update()
        data = source.GetOutput()
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "sphere.ply")
            writer = vtkPLYWriter()
            writer.SetInputData(data)
            writer.SetFileName(file)
            writer.Write()
            pictures = [godrays.render(each, SIZE, light=(1, 0.2, -0.2))
                for each in (source, data, file, pathlib.Path(file), [data])]
            with self.assertRaisesRegex(godrays.Error, "nonesuch.ply: there is no such file"):
                godrays.render(os.path.join(folder, "nonesuch.ply"))
            broken = pathlib.Path(folder) / "broken.ply"
            broken.write_text("none")
            with self.assertRaisesRegex(godrays.Error, "broken.ply: cannot be read"):
                godrays.render(broken)
            with self.assertRaisesRegex(godrays.Error, "data.xyz: is of an unknown type; give one of .*[.]ply"):
                godrays.render(broken.rename(pathlib.Path(folder) / "data.xyz"))
            with self.assertRaisesRegex(godrays.Error, "is a directory"):
                godrays.render(folder)
            with self.assertRaisesRegex(ValueError, "scalars: there is no array 'none such'"):
                godrays.render(file, scalars="none such")
            with self.assertRaisesRegex(TypeError, "scalars of numbers are for data sets"):
                godrays.render(file, scalars=[1, 2])
            with self.assertRaisesRegex(ValueError, "cmap is for scalars"):
                godrays.render(file, cmap="viridis")
        for picture in pictures:
            self.assertEqual((picture.dtype, picture.shape), (numpy.uint8, (90, 120, 3)))
        for other in (pictures[1], pictures[4]):
            self.assertTrue((other == pictures[0]).all())
        self.assertTrue((pictures[2] == pictures[3]).all())
        self.assertLess(numpy.abs(pictures[2].astype(int) - pictures[0]).mean(), 10)  # without normals
        self.assertGreater(pictures[0].std(), 10)
        with self.assertRaisesRegex(TypeError, "not int"):
            godrays.render(5)
        with self.assertRaisesRegex(ValueError, "no points"):
            godrays.render(data.NewInstance())
        with self.assertRaisesRegex(ValueError, "of 1 to 16384 pixels"):
            godrays.render(data, (0, 5))

    def test_points_without_cells_are_seen(self):
        cloud = vtkPolyData()
        cloud.SetPoints(vtkPoints())
        for place in numpy.ndindex(4, 4, 4):
            cloud.GetPoints().InsertNextPoint(*place)
        shown = godrays.render(cloud, SIZE, rays=False, background=(0, 0, 0))
        self.assertGreater((shown.max(2) > 50).mean(), 0.01)
        for i in range(64):
            cloud.GetPoints().SetPoint(i, float("nan"), 0, 0)
        cloud.GetPoints().Modified()
        with self.assertRaisesRegex(ValueError, "no point of the data has finite coordinates"):
            godrays.render(cloud, SIZE)

    def test_whole_numbers_of_any_size(self):
        layer = numpy.zeros((20, 30), int)
        layer[8:12, 14:18] = 1
        shafts = godrays.scatter(layer, light=(0.5, 0.5))
        self.assertTrue((shafts == godrays.scatter(layer.astype(float), light=(0.5, 0.5))).all())
        self.assertGreater(shafts.max(), 0)

    def test_rays_are_seen_and_parameters_arrive(self):
        source = vtkCylinderSource()
        without = godrays.render(source, SIZE, rays=False)
        self.assertTrue((without == godrays.render(source, SIZE, rays=False)).all())
        light = light_of(godrays.render(source, SIZE), without)
        self.assertGreater((numpy.abs(light) > 4).mean(), 0.2)
        half = light_of(godrays.render(source, SIZE, intensity=0.3), without)
        self.assertLess(half.mean(), 0.8 * light.mean())
        fog = godrays.render(source, SIZE, "fog")
        self.assertGreater((fog != without).mean(), 0.5)
        left, right = (light_of(godrays.render(source, SIZE, sun_at=(x, 0.8)), without) for x in (0.1, 0.9))
        self.assertGreater(left[:, :40].mean(), 1.5 * left[:, 80:].mean())
        self.assertGreater(right[:, 80:].mean(), 1.5 * right[:, :40].mean())
        with self.assertRaisesRegex(TypeError, "no parameter densty"):
            godrays.render(source, SIZE, densty=1)

    def test_all_is_in_the_picture_the_right_way_up(self):
        cone = vtkConeSource()
        cone.SetDirection(0, 0, 1)  # the tip is up
        for size in ((120, 90), (60, 120)):
            picture = godrays.render(cone, size, rays=False, background=(0, 0, 0), transparent=True)
            self.assertEqual(picture.shape, (size[1], size[0], 4))
            seen = picture[..., 3] > 127
            rows, columns = numpy.nonzero(seen)
            self.assertTrue(0 < rows.min() and rows.max() < size[1] - 1)
            self.assertTrue(0 < columns.min() and columns.max() < size[0] - 1)
            middle = (rows.min() + rows.max()) // 2
            self.assertGreater(seen[middle:].sum(), 1.5 * seen[:middle].sum())
        self.assertEqual(set(picture[0, 0]), {0})
        pictures = []
        for i, up in enumerate("xyz"):
            cone.SetDirection(*(float(i == j) for j in range(3)))
            seen = godrays.render(cone, SIZE, rays=False, transparent=True, up=up)[..., 3] > 127
            pictures.append(seen)
            self.assertGreater(seen[45:].sum(), 1.5 * seen[:45].sum(), up)
        self.assertLess((pictures[0] != pictures[2]).mean(), 0.02)
        cone.SetDirection(0, 0, 1)
        with self.assertRaisesRegex(ValueError, "up='w' should be"):
            godrays.render(cone, SIZE, up="w")
        red = godrays.render(cone, SIZE, rays=False, background="tomato")
        self.assertEqual(tuple(red[0, 0]), (255, 99, 71))
        with self.assertRaisesRegex(ValueError, "no color 'nocolor'"):
            godrays.render(cone, SIZE, background="nocolor")

    def test_looks_of_data(self):
        """Each changes the pixels of the data as it says; the control is the picture without it."""
        source = vtkSphereSource()
        source.Update()
        data = source.GetOutput()
        height = vtk_to_numpy(data.GetPoints().GetData())[:, 2]
        array = numpy_to_vtk(height, deep=True)
        array.SetName("height")
        data.GetPointData().AddArray(array)
        cells = numpy_to_vtk(numpy.arange(data.GetNumberOfCells(), dtype=float), deep=True)
        cells.SetName("number")
        data.GetCellData().AddArray(cells)

        def middle(**look):
            picture = godrays.render(data, SIZE, rays=False, background=(0, 0, 0), **look)
            return picture[30:60, 45:75].astype(float)

        plain = middle()
        self.assertLess(numpy.ptp(plain, axis=2).max(), 2)  # white
        self.assertLess(middle(color="red")[..., 1:].max(), 3)
        self.assertLess(middle(opacity=0.3).mean(), 0.8 * plain.mean())
        by_name, by_numbers = (middle(scalars=each) for each in ("height", height))
        self.assertTrue((by_name == by_numbers).all())
        self.assertGreater(numpy.ptp(by_name, axis=2).mean(), 20)
        self.assertGreater(numpy.abs(by_name - middle(scalars="number")).mean(), 10)
        self.assertFalse(data.GetPointData().HasArray("scalars"), "the data are the user's")
        table = vtkLookupTable()
        table.SetNumberOfTableValues(2)
        table.SetTableValue(0, 0, 1, 0, 1)
        table.SetTableValue(1, 0, 0, 1, 1)
        two = middle(scalars="height", cmap=table)
        self.assertLess(two[..., 0].max(), 3)
        self.assertGreater(two[0, :, 2].mean(), 5 * two[0, :, 1].mean())  # the upper half is blue
        self.assertGreater(two[-1, :, 1].mean(), 5 * two[-1, :, 2].mean())
        if not importlib.util.find_spec("matplotlib"):
            with self.assertRaisesRegex(ValueError, "cmap='viridis' needs Matplotlib"):
                middle(scalars="height", cmap="viridis")
            return
        grey = middle(scalars="height", cmap="gray")
        self.assertLess(numpy.ptp(grey, axis=2).max(), 2)
        self.assertGreater(grey[0].mean(), grey[-1].mean() + 50)
        with self.assertRaisesRegex(ValueError, "no cmap 'viridi'; did you mean viridis"):
            middle(scalars="height", cmap="viridi")

    def test_a_sun_as_the_program_has_it(self):
        source = vtkCylinderSource()
        for up, direction in (("z", (0, 1, 0)), ("y", (0, 0, -1)), ("x", (0, 0, 1))):
            by_angles = godrays.render(source, SIZE, sun=(0, 0), up=up, camera=(0, 10))
            by_direction = godrays.render(source, SIZE, light=direction, up=up, camera=(0, 10))
            self.assertTrue((by_angles == by_direction).all(), up)

    def test_show(self):
        """What the window shows when its loop starts is the picture of render()."""
        seen = []

        class Interactor(vtkRenderWindowInteractor):
            def Start(self):
                seen.append(godrays._render._read(self.GetRenderWindow(), False))

        source = vtkCylinderSource()
        real = godrays._render.vtkRenderWindowInteractor
        godrays._render.vtkRenderWindowInteractor = Interactor
        self.addCleanup(setattr, godrays._render, "vtkRenderWindowInteractor", real)
        self.assertIsNone(godrays.show(source, SIZE, "low-sun", color="tan", sun_at=(0.4, 0.7)))
        expected = godrays.render(source, SIZE, "low-sun", color="tan", sun_at=(0.4, 0.7))
        self.assertLess(numpy.abs(seen[0].astype(int) - expected).mean(), 1)
        self.assertGreater(expected.std(), 10)

    def write_turntable(self, *arguments, **parameters):
        folder = self.enterContext(tempfile.TemporaryDirectory())
        path = pathlib.Path(folder, "turn.html")
        self.assertIsNone(godrays.turntable(arguments[0], path, *arguments[1:], **parameters))
        self.assertEqual([each.name for each in path.parent.iterdir()], ["turn.html"])
        return path

    def read_turntable(self, path):
        pictures = []
        for each in re.findall(r'src="data:image/jpeg;base64,([^"]+)"', path.read_text(encoding="utf-8")):
            reader = vtkJPEGReader()
            data = base64.b64decode(each, validate=True)
            reader.SetMemoryBuffer(data)
            reader.SetMemoryBufferLength(len(data))
            reader.Update()
            pictures.append(godrays.to_array(reader.GetOutput()).astype(int))
        return pictures

    def test_a_turntable_shows_views_all_around(self):
        """Each is the picture of render() of its camera; the control is that of another camera."""
        cone = vtkConeSource()
        options = {"preset": "low-sun", "sun": (190, 8)}
        path = self.write_turntable(cone, SIZE, views=5, **options)
        pictures = self.read_turntable(path)
        self.assertEqual(len(pictures), 5)
        expected = [godrays.render(cone, SIZE, camera=(72 * i - 60, 15), **options).astype(int) for i in range(5)]
        for i, picture in enumerate(pictures):
            self.assertLess(abs(picture - expected[i]).mean(), 3)
            self.assertGreater(abs(picture - expected[(i + 1) % 5]).mean(), 5)
        self.assertNotRegex(path.read_text(encoding="utf-8"), r'(src|href)="(?!data:)|https?:')

    def test_a_turntable_leaves_a_scene_as_it_was(self):
        window, renderer = make_scene()
        former = renderer.GetActiveCamera().GetPosition(), renderer.GetActiveCamera().GetClippingRange()
        self.assertEqual(len(self.read_turntable(self.write_turntable(renderer, (80, 60), light=BEHIND))), 36)
        camera = renderer.GetActiveCamera()
        self.assertEqual((camera.GetPosition(), camera.GetClippingRange()), former)
        self.assertIsNone(renderer.GetPass())
        self.assertIs(renderer.GetRenderWindow(), window)

    def test_a_turntable_has_at_most_5_megabytes(self):
        noise = numpy.random.default_rng(5).integers(0, 256, (600, 800, 3), dtype=numpy.uint8)
        limit = godrays._turntable._LARGEST
        with unittest.mock.patch.object(godrays._turntable, "_draw", lambda *_: [noise] * 10):
            size = self.write_turntable(None, (800, 600)).stat().st_size
        self.assertGreater(size, limit / 2)
        self.assertLessEqual(size, limit)
        best = 10 * len(base64.b64encode(godrays._render.encode(noise, ".jpg", 90)))
        self.assertGreater(best, limit)  # without another quality it would be larger
        with unittest.mock.patch.object(godrays._turntable, "_draw", lambda *_: [noise] * 2), \
                unittest.mock.patch.object(godrays._turntable, "_LARGEST", 100_000), \
                self.assertRaisesRegex(ValueError, "MB: give a smaller size or fewer views"):
            godrays.turntable(None, "turn.html")
        self.assertFalse(os.path.exists("turn.html"))

    def test_a_browser_turns_a_turntable(self):
        """By the mouse, a finger and keys; a click does not."""
        with browser_testing.open_phone() as phone:
            from selenium.webdriver.common.action_chains import ActionChains
            from selenium.webdriver.common.actions.action_builder import ActionBuilder
            from selenium.webdriver.common.actions.pointer_input import PointerInput

            path = self.write_turntable(vtkConeSource(), SIZE, views=12)
            self.assertEqual(browser_testing.find_faults(phone, path), [])

            def drag(kind, distance):
                actions = ActionBuilder(phone, mouse=PointerInput(kind, kind))
                actions.pointer_action.move_to_location(195, 400).pointer_down()
                actions.pointer_action.move_to_location(195 + distance, 400).pointer_up()
                actions.perform()
                found = phone.execute_script("return [...document.images].filter(each => each.offsetWidth).map("
                    "each => each.alt)")
                self.assertEqual(len(found), 1)
                return found[0]

            self.assertEqual(drag("mouse", 0), "View 1 of 12")
            self.assertEqual(drag("mouse", -130), "View 5 of 12")
            self.assertEqual(drag("touch", 65), "View 3 of 12")
            self.assertEqual(drag("touch", 130), "View 11 of 12")
            ActionChains(phone).send_keys("\ue014" * 3).perform()  # arrow to the right
            self.assertEqual(drag("mouse", 0), "View 2 of 12")

    def test_a_volume_of_data_is_seen_by_its_surface(self):
        self.assertGreater(godrays.render(vtkRTAnalyticSource(), SIZE).std(), 10)

    def test_a_scene_is_left_as_it_was(self):
        window, renderer = make_scene()
        window.Render()
        for target in (renderer, types.SimpleNamespace(renderer=renderer)):
            picture = godrays.render(target, (80, 60), light=BEHIND)
            self.assertEqual(picture.shape, (60, 80, 3))
            self.assertIsNone(renderer.GetPass())
            self.assertIs(renderer.GetRenderWindow(), window)
            self.assertTrue(window.HasRenderer(renderer))
            window.Render()

    def test_rays_that_a_scene_has_are_left_out_on_request(self):
        _, renderer = make_scene()
        without = godrays.render(renderer, (80, 60), rays=False)
        rays = godrays.enable(renderer, BEHIND)
        self.assertFalse((godrays.render(renderer, (80, 60), light=BEHIND) == without).all())
        self.assertTrue((godrays.render(renderer, (80, 60), rays=False) == without).all())
        self.assertIs(godrays.vtkGodRaysPass.Find(renderer), rays)

    def test_it_goes_to_another_process(self):
        picture = godrays.render(vtkSphereSource(), (20, 10))
        again = pickle.loads(pickle.dumps(picture))
        self.assertIs(type(again), type(picture))
        self.assertTrue((again == picture).all())
        with self.assertRaisesRegex(ValueError, r"'picture.gif' should end in [.]png or [.]jpg"):
            picture.save("picture.gif")

    def test_a_full_disk_keeps_the_former_file(self):
        code = "import godrays, pathlib, resource, signal, sys; file = pathlib.Path(sys.argv[1])\n" \
            "from vtkmodules.vtkFiltersSources import vtkSphereSource\n" \
            "from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow\n" \
            "signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n" \
            "picture = godrays.render(vtkSphereSource(), (80, 60))\n" \
            "window, renderer = vtkRenderWindow(), vtkRenderer()\n" \
            "window.SetOffScreenRendering(True); window.SetSize(80, 60); window.AddRenderer(renderer)\n" \
            "godrays.enable(renderer, light=(0, 0.1, -1), preset='haze')\n" \
            "window.Render(); resource.setrlimit(resource.RLIMIT_FSIZE, (300, 300))\n" \
            "for name in 'a.png', 'a.jpg', 'a.vti':\n" \
            "    (file / name).write_bytes(b'former')\n" \
            "    try: godrays.measure(window, file=file / name) if '.vti' in name else picture.save(file / name)\n" \
            "    except OSError: print(name, (file / name).read_bytes(), len(list(file.iterdir())))\n"
        with tempfile.TemporaryDirectory() as folder:
            ran = subprocess.run([sys.executable, "-c", code, folder], capture_output=True, text=True)
            self.assertEqual(ran.stdout, "a.png b'former' 1\na.jpg b'former' 2\na.vti b'former' 3\n", ran.stderr)
            with self.assertRaises(OSError):
                godrays.render(vtkSphereSource(), SIZE).save(pathlib.Path(folder) / "none" / "a.png")

    def test_it_shows_itself(self):
        picture = godrays.render(vtkSphereSource(), SIZE)
        png = picture._repr_png_()
        self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(int.from_bytes(png[16:20], "big"), 120)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "picture.png"
            picture.save(file)
            self.assertEqual(file.read_bytes(), png)
            for name in "picture.jpg", "picture.JPEG":
                picture.save(file.with_name(name))
                reader = vtkJPEGReader()
                reader.SetFileName(str(file.with_name(name)))
                reader.Update()
                off = godrays.to_array(reader.GetOutput()).astype(int) - picture
                self.assertLess(numpy.abs(off).mean(), 4)
            with self.assertRaisesRegex(ValueError, "should end in .png: the picture has an alpha"):
                godrays.render(vtkSphereSource(), SIZE, transparent=True).save(file.with_name("a.jpg"))
        self.assertIsNone((picture / 2)._repr_png_())  # numbers
        self.assertEqual(picture[:10, :20]._repr_png_()[19], 20)  # a part is a picture

    def test_a_server_that_ends_without_connections(self):
        """Xvfb -terminate ends where one without -noreset resets: between connections there must be one."""
        if vtkRenderWindow().GetClassName() != "vtkXOpenGLRenderWindow" or not shutil.which("Xvfb"):
            self.skipTest("there is no Xvfb, or this VTK can draw without a screen")
        code = "import godrays; from vtkmodules.vtkFiltersSources import vtkConeSource\n" \
            "for i in range(3): print(godrays.render(vtkConeSource(), (64, 48)).std() > 5)"
        with subprocess.Popen(["Xvfb", "-displayfd", "1", "-terminate", "-screen", "0", "640x480x24"],
                stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as server:
            self.addCleanup(server.kill)
            display = ":" + server.stdout.readline().strip()
            ran = subprocess.run([sys.executable, "-c", code], env={**os.environ, "DISPLAY": display},
                capture_output=True, text=True)
            self.assertEqual((ran.returncode, ran.stdout), (0, "True\n" * 3), ran.stderr)
            self.assertEqual(server.wait(20), 0)

    def test_without_a_screen(self):
        if vtkRenderWindow().GetClassName() != "vtkXOpenGLRenderWindow":
            self.skipTest("this VTK can draw without a screen")
        code = "import godrays; from vtkmodules.vtkFiltersSources import vtkConeSource\n" \
            "try: godrays.render(vtkConeSource())\nexcept godrays.Error as error: print(error)"
        environment = {**os.environ, "DISPLAY": ":987"}
        ran = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True)
        if ran.returncode == 0 and not ran.stdout:
            self.skipTest("this VTK finds another way to draw")
        self.assertRegex(ran.stdout, "needs a screen.*DISPLAY=:987.*xvfb-run")
        self.assertEqual(ran.returncode, 0, ran.stderr)


class With(unittest.TestCase):
    def test_rays_end_with_the_block(self):
        window, renderer = make_scene()
        for target in (renderer, window, types.SimpleNamespace(renderer=renderer)):
            with godrays.enable(target, light=BEHIND) as rays:
                self.assertIs(renderer.GetPass(), rays)
                window.Render()
                self.assertGreater(rays.scattering.max(), 0)
            self.assertIsNone(renderer.GetPass())
        with self.assertRaises(KeyError), godrays.enable(renderer, light=BEHIND):
            {}["a"]
        self.assertIsNone(renderer.GetPass())
        with self.assertRaisesRegex(godrays.Error, "on no renderer"), rays:
            pass


class Program(unittest.TestCase):
    def test_python_m(self):
        folder = pathlib.Path(godrays.__file__).parents[4]
        if not os.access(folder / "bin" / "godrays", os.X_OK):
            self.skipTest("the program is not built")
        ran = subprocess.run(
            [sys.executable, "-m", "godrays", "--version"], capture_output=True, text=True, check=True)
        self.assertIn(godrays.__version__, ran.stdout)
        ran = subprocess.run([sys.executable, "-m", "godrays", "nonesuch.ply"], capture_output=True, text=True)
        self.assertNotEqual(ran.returncode, 0)
        self.assertIn("nonesuch.ply", ran.stderr)


if __name__ == "__main__":
    unittest.main()
