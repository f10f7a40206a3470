# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the program godrays: light, sky, colours, composition."""

import pathlib
import re
import sys
import unittest

import numpy
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter, vtkVertexGlyphFilter
from vtkmodules.vtkFiltersModeling import vtkLinearExtrusionFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource, vtkSuperquadricSource
from vtkmodules.vtkRenderingFreeType import vtkVectorText

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import sample_files
from program_testing import HEIGHT, WIDTH, ProgramTest, godrays


class Pictures(ProgramTest):
    def test_size(self):
        self.draw(self.mesh, "--size", "9x9")  # given again after it: the last one counts
        self.draw(self.mesh, size=(130, 70))

    def test_the_background_has_no_bands(self):
        """The levels of a gradient change by one or two within 4 x 4 pixels."""
        for background in [], ["--background", "#101820:#405070"]:
            picture = self.draw(self.mesh, "--no-rays", *background, size=(320, 240))
            corner = picture[:60, -60:]  # where there is neither sun nor data
            blocks = corner.reshape(15, 4, 15, 4, 3).swapaxes(1, 2).reshape(225, 16, 3)
            spread = blocks.max(axis=1) - blocks.min(axis=1)
            self.assertLessEqual(spread.max(), 2)
            self.assertGreater(spread.max(), 0)

    def test_jpeg(self):
        picture = self.folder / "p.jpg"
        done = godrays(self.mesh, "--size", "64x48", "--output", picture)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(picture.read_bytes()[:2], b"\xff\xd8")

    def test_a_picture_is_the_same_each_time(self):
        self.assertTrue((self.draw(self.mesh) == self.draw(self.mesh)).all())

    def test_options_change_the_picture(self):
        default = self.draw(self.mesh)
        for arguments in (
            ["--sun", "-10,12"], ["--light", "0,2,-2"], ["--light-color", "blue"],
            ["--light-size", "5"], ["--fill", "2"], ["--preset", "long-shafts"],
            ["--preset", "fog", "--optical-depth", "1"],
            ["--preset", "haze", "--world-unit", "300"], ["--intensity", "3"],
            ["--density", "0.5"], ["--decay", "0.9"], ["--weight", "0.1"],
            ["--exposure", "3"], ["--glow", "0"], ["--glow-angle", "60"],
            ["--show", "occlusion"], ["--show", "rays"], ["--camera-position", "0,-5,1"],
            ["--focal-point", "0.3,0,0"], ["--view-up", "1,0,0"], ["--view-angle", "60"],
            ["--parallel"], ["--up", "Y"], ["--background", "black"], ["--sky", "earth-clear"],
            ["--sky", "mars", "--world-unit", "1000"],
            ["--background", "#200000:navy"], ["--scalars", "none"], ["--colormap", "inferno"],
            ["--range", "0,9"], ["--color", "1,0,0"], ["--opacity", "0.3"], ["--edges"],
            ["--elevation-scale", "2"], ["--camera", "90,30"], ["--zoom", "1.5"],
            ["--sun-at", "0.2,0.8"],
        ):
            with self.subTest(arguments):
                # through the dust, a sun on the horizon of Mars is too faint; without a glow, it is hidden
                is_faint = "mars" in arguments or "--glow" in arguments
                told = ["nothing that can be seen"] if is_faint else ()
                self.assertGreater(abs(self.draw(self.mesh, *arguments, told=told) - default).max(), 8)

    def test_the_light_of_a_given_sun_is_where_it_should_be(self):
        """Looking north, a sun in the north-north-west is on the left of the middle."""
        camera = ["--camera-position", "0,-5,0", "--focal-point", "0,0,0", "--view-angle", "60"]
        for azimuth, side in ((340, -1), (20, 1)):
            rays = self.draw(self.mesh, "--sun", f"{azimuth},10", "--show", "rays", *camera).sum(2)
            row, column = numpy.unravel_index(rays.argmax(), rays.shape)
            self.assertGreater(side * (column - WIDTH / 2), 10)
            self.assertGreater(row, HEIGHT / 2)  # above the middle: rows begin at the foot

    def test_the_sun_of_a_date_and_place(self):
        # the example of the solar position algorithm: azimuth 194.34, elevation 39.89 degrees
        given = self.draw(
            self.mesh, "--date", "2003-10-17T12:30:30-07:00", "--place", "39.742476,-105.1786")
        # of single pixels of edges, others may be seen
        def share_that_differs(sun):
            return (abs(given - self.draw(self.mesh, "--sun", sun)) > 3).mean()
        self.assertLess(share_that_differs("194.34,39.888"), 1e-3)
        self.assertGreater(share_that_differs("194.34,36"), 0.1)
        self.assertGreater(share_that_differs("204,39.888"), 1e-3)  # the camera looks to the sun: other edges

    def test_the_physical_sky_reddens_and_goes_dark(self):
        camera = ["--camera-position", "0,-5,0.2", "--focal-point", "0,0,0.4", "--no-rays"]
        def light(*sun):
            picture = self.draw(self.mesh, "--sky", "earth-clear", *sun, *camera)
            return picture[-10:].mean((0, 1))  # of the uppermost rows
        noon, evening = light("--sun", "180,60"), light("--sun", "0,1")
        self.assertGreater(noon[2] / noon[0], 1.5)
        self.assertLess(evening[2] / evening[0], 1.2)
        night = light("--date", "2024-06-21T23:30+02:00", "--place", "30,11.575")
        self.assertLess(night.max(), 5)

    def test_every_camera_and_sun_gives_a_picture(self):
        for arguments in (
            ["--sun", "0,90"], ["--sun", "0,-90"], ["--light", "0,0,0"],
            ["--camera-position", "0,0,9"], ["--camera-position", "0,0,-9"],
            ["--sun", "90,5", "--parallel"], ["--light", "0,0,5", "--parallel"],
            ["--camera-position", "0,0,0", "--focal-point", "0,0,1"],
        ):
            with self.subTest(arguments):
                self.draw(self.mesh, *arguments, told=None)

    def test_a_sun_that_gives_no_shafts_is_told(self):
        noon = ["--date", "2024-06-21T12:00Z", "--place", "48,11"]
        for arguments, words in (
            (["--sun", "180,75"], ["out of the picture", "no shafts", "lower --sun"]),
            (noon, ["out of the picture", "leave out --date"]),
            (["--light", "0,9,50", "--camera-position", "0,-5,0"], ["the lamp", "out of the picture", "move --light"]),
            (["--sun", "0,-10"], ["below the horizon", "above 0"]),
            (["--parallel", "--sky", "earth-clear"], ["out of the picture", "to the horizon"]),
            (["--sun", "180,75", "--preset", "fog"], []),
            (["--preset", "fog", "--world-unit", "1e-6"], ["hardly shows", "optical depth"]),
            (["--preset", "fog", "--world-unit", "1e6"], ["hides the scene", "optical depth"]),
            (["--preset", "fog"], []),
            (["--intensity", "0.0001"], ["change nothing that can be seen", "larger Intensity"]),
            (["--sun", "180,75", "--no-rays"], []),
            (["--sun", "180,30"], []),
        ):
            with self.subTest(arguments):
                rays = self.draw(self.mesh, *arguments, told=words)
                if "out of the picture" in words:
                    without = self.draw(self.mesh, *arguments, "--no-rays")
                    self.assertLess(abs(rays - without).mean(), 2, "there are rays")

    def test_a_sun_that_is_chosen_is_above_the_horizon(self):
        """Where the horizon is not seen, it is a lamp."""
        for arguments in ([], ["--camera-position", "0,-3,0.5"], ["--camera-position", "0,-3,3"],
                          ["--camera-position", "0,-9,0", "--view-up", "1,0,0"], ["--parallel"]):
            for file in self.mesh, self.folder / "a.vtm", self.hills:
                with self.subTest((arguments, file.name)):
                    done = godrays(
                        file, *arguments, "--size", "96x64", "--stats", "--output",
                        self.folder / "p.png")
                    self.assertEqual((done.returncode, done.stderr), (0, ""))
                    light = re.search(r"light +(--\w+) (\S+) \(chosen\)", done.stdout)
                    self.assertTrue(light, done.stdout)
                    if light.group(1) == "--sun":
                        self.assertGreater(float(light.group(2).split(",")[1]), 0)


class Lighting(ProgramTest):
    CAMERA = ["--no-rays", "--background", "black", "--color", "white", "--camera-position", "3,-6,5",
              "--focal-point", "0,0,0"]

    def step(self):
        """A wall on a floor."""
        both = vtkAppendPolyData()
        for bounds in (-2, 2, -2, 2, -0.1, 0), (-2, 2, 1.9, 2, 0, 2):
            cube = vtkCubeSource()
            cube.SetBounds(bounds)
            cube.Update()
            both.AddInputData(cube.GetOutput())
        both.Update()
        path = self.folder / "step.vtp"
        sample_files.write(sample_files.vtkXMLPolyDataWriter(), both.GetOutput(), path)
        return path

    def test_ambient_occlusion_darkens_corners_alone(self):
        without, drawn = (
            self.draw(self.step(), *self.CAMERA, *option, size=(240, 180)).astype(float).mean(2)
            for option in (["--no-ambient-occlusion"], []))
        darker = without - drawn
        self.assertGreater(darker.max(), 15)
        self.assertLess(numpy.median(darker[without > 30]), 3)  # open surfaces
        self.assertTrue((darker > -2).all())
        self.assertTrue((darker[without == 0] == 0).all())  # the background

    def test_ambient_occlusion_is_of_opaque_surfaces(self):
        for file, *options in (self.mesh, "--opacity", 0.5), (self.folder / "cloud.vtp",):
            if not file.exists():
                self.write_cloud(file)
            with self.subTest(file.name):
                plain = self.draw(file, *options, "--no-rays", "--no-ambient-occlusion")
                self.assertTrue((plain == self.draw(file, *options, "--no-rays")).all())

    def write_cloud(self, path):
        sphere = vtkSphereSource()
        sphere.Update()
        points = vtkVertexGlyphFilter()
        points.SetInputData(sphere.GetOutput())
        points.Update()
        sample_files.write(sample_files.vtkXMLPolyDataWriter(), points.GetOutput(), path)

    def test_a_sun_behind_the_data_does_not_darken_them(self):
        """They are lit from the eye, wherever the sun is; with a physical sky the sun lights them."""
        suns = [["--sun", f"{azimuth},20"] for azimuth in (0, 180)]
        behind, before = (self.draw(self.step(), *self.CAMERA, *sun) for sun in suns)
        self.assertTrue((behind == before).all())
        sky = self.CAMERA[:1] + self.CAMERA[3:] + ["--sky", "earth-clear"]
        behind, before = (self.draw(self.step(), *sky, *sun) for sun in suns)
        self.assertGreater(abs(behind - before).max(), 20)


class Composition(ProgramTest):
    def bulky_files(self):
        """Shapes that are not thin."""
        torus = vtkSuperquadricSource()
        torus.ToroidalOn()
        torus.SetThickness(0.5)
        cube = vtkCubeSource()
        for name, source in ("torus.vtp", torus), ("cube.vtp", cube):
            source.Update()
            sample_files.write(
                sample_files.vtkXMLPolyDataWriter(), source.GetOutput(), self.folder / name)
        return self.mesh, self.folder / "torus.vtp", self.folder / "cube.vtp"

    def test_the_data_fill_much_of_a_picture_of_any_size(self):
        files = self.bulky_files()
        plain = ["--no-rays", "--background", "#010203", "--color", "white"]
        for size in (300, 200), (320, 180), (200, 200), (150, 300):
            for file, picture in zip(files, self.draw_each(files, *plain, size=size)):
                with self.subTest((file.name, size)):
                    covered = (picture != (1, 2, 3)).any(axis=2)
                    # The torus is seen through its hole, and no wider than the picture.
                    self.assertGreater(covered.mean(), 0.18 if "torus" in file.name else 0.24)
                    self.assertLess(covered.mean(), 0.36)
                    edges = covered[0], covered[-1], covered[:, 0], covered[:, -1]
                    self.assertFalse(any(edge.any() for edge in edges), "cut off")

    def test_low_data_are_seen_whole_unless_they_are_gentle_ground(self):
        balls = vtkAppendPolyData()
        for i in range(25):
            ball = vtkSphereSource()
            ball.SetCenter(1.1 * (i % 5), 1.1 * (i // 5), 0)
            balls.AddInputConnection(ball.GetOutputPort())
        balls.Update()
        sample_files.write(sample_files.vtkXMLPolyDataWriter(), balls.GetOutput(), self.folder / "balls.vtp")
        sample_files.write(sample_files.vtkXMLStructuredGridWriter(), sample_files.structured_grid(),
            self.folder / "hills.vts")
        plain = ["--no-rays", "--background", "#010203", "--color", "white"]
        for name, height, is_whole in ("balls.vtp", 1, True), ("hills.vts", 0.25, True), ("hills.vts", 0.1, False):
            with self.subTest((name, height)):
                picture = self.draw(self.folder / name, "--elevation-scale", height, *plain, size=(300, 200))
                covered = (picture != (1, 2, 3)).any(axis=2)
                edges = covered[0], covered[-1], covered[:, 0], covered[:, -1]
                self.assertEqual(not any(edge.any() for edge in edges), is_whole)
                self.assertGreater(covered.mean(), 0.2 if is_whole else 0.36)
                self.assertLess(covered.mean(), 0.36 if is_whole else 0.8)
        done = godrays(self.folder / "balls.vtp", "--sun", "340,12", "--stats", "--output", self.folder / "sun.png")
        position = re.search(r"--camera-position (\S+)", done.stdout)[1].split(",")
        self.assertGreater(float(position[2]), 0)  # a sun that is given does not have them seen from below

    def test_letters_are_seen_from_the_front(self):
        for text in "VTK", "LFJ", "RPE":
            letters = vtkVectorText()
            letters.SetText(text)
            solid = vtkLinearExtrusionFilter()
            solid.SetInputConnection(letters.GetOutputPort())
            solid.SetVector(0, 0, 0.3)
            solid.SetExtrusionTypeToVectorExtrusion()
            place = vtkTransform()
            place.RotateX(90)  # upright, to be read from where y is least
            upright = vtkTransformFilter()
            upright.SetInputConnection(solid.GetOutputPort())
            upright.SetTransform(place)
            upright.Update()
            sample_files.write(sample_files.vtkXMLPolyDataWriter(), upright.GetOutput(), self.folder / "text.vtp")
            done = godrays(self.folder / "text.vtp", "--stats", "--output", self.folder / "text.png")
            position = re.search(r"--camera-position (\S+)", done.stdout)[1].split(",")
            self.assertLess(float(position[1]), -0.3, text)

    def test_the_sun_is_in_the_picture_beside_the_data(self):
        size = 300, 200
        files = self.bulky_files()
        plain = ["--no-rays", "--background", "#010203", "--color", "white"]
        for sun in [], ["--sun", "340,12"], ["--sun", "80,25"]:
            pictures = [self.draw_each(files, *sun, *arguments, size=size) for arguments in (
                ["--show", "occlusion"], plain, ["--show", "rays"])]
            for file, light, picture, rays in zip(files, *pictures):
                with self.subTest((file.name, sun)):
                    # The glow about the sun, where nothing is before it.
                    light = light.sum(axis=2)
                    self.assertGreater((light > 0.9 * light.max()).sum(), 10)
                    rows, columns = numpy.nonzero(light > 0.9 * light.max())
                    self.assertTrue(0.5 * size[1] < rows.mean() < 0.95 * size[1], rows.mean())
                    self.assertTrue(0.05 * size[0] < columns.mean() < 0.95 * size[0], columns.mean())
                    covered = (picture != (1, 2, 3)).any(axis=2)
                    rays = rays.sum(axis=2)
                    glare = rays > 0.5 * rays.max()
                    self.assertLess(glare[covered].mean(), 0.6 * glare[~covered].mean())


if __name__ == "__main__":
    unittest.main()
