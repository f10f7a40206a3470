# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program godrays with files of every type."""

import json
import os
import pathlib
import re
import shutil
import struct
import sys
import unittest

import numpy
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import (
    vtkConeSource, vtkCubeSource, vtkPlaneSource, vtkSphereSource)

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import image_files
import sample_files
from program_testing import HEIGHT, WIDTH, ProgramTest, godrays


class Files(ProgramTest):
    def draw_each_type(self, *arguments):
        """Pictures of all files, by name, on a background that no data have. Volumes have a given camera and sun, as
        a choice takes 7 s in software: other tests leave it to the program."""
        groups, others = [], list(self.files)
        for middle, names in (0.75, "a.mha a.mhd a.nii a.pvti a.vti volume.vtk"), (5.5, "a.nhdr a.nrrd"):
            volumes = [self.folder / name for name in names.split()]
            others = [file for file in others if file not in volumes]
            groups.append((volumes, "--sun", "334,12", "--focal-point", f"{middle},{middle},{middle}",
                "--camera-position", f"{4.6 * middle},{-6.6 * middle},{middle}"))
        groups.append((others,))
        pictures = {}
        for files, *options in groups:
            drawn = self.draw_each(files, *options, *arguments, "--background", "#010203")
            pictures.update(zip((file.name for file in files), drawn))
        self.assertEqual(len(pictures), len(self.files))
        return pictures

    def test_every_type_is_drawn_with_rays(self):
        without, lit = self.draw_each_type("--no-rays"), self.draw_each_type()
        for name, plain in without.items():
            with self.subTest(name):
                self.assertGreater((plain != (1, 2, 3)).any(axis=2).mean(), 0.02, "empty")
                self.assertGreater(abs(lit[name] - plain).max(), 20, "no rays")

    def test_every_type_that_help_names_has_a_file(self):
        help_text = godrays("--help").stdout  # newer CLI11 breaks the line
        listed = re.search(r"^Reads ((?:\.\w+\s+)+)", help_text, re.MULTILINE).group(1)
        self.assertEqual(sorted(listed.split()), sorted({file.suffix.lower() for file in self.files}))

    def test_several_files_are_drawn_together(self):
        together = self.draw(self.mesh, self.folder / "a.gltf")
        self.assertGreater(abs(together - self.draw(self.mesh)).max(), 20)

    def test_a_georeferenced_picture_has_true_lengths(self):
        stats = godrays(
            self.hills, "--elevation-scale", 1, "--stats", "--size", "64x48", "--output",
            self.folder / "s.png").stdout
        # 23 steps of 0.001 degrees, about 60 degrees north
        east, north, up = map(float, re.search(r"([\d.]+) x ([\d.]+) x ([\d.]+)", stats).groups())
        self.assertAlmostEqual(east, 23 * 55.8, delta=2)
        self.assertAlmostEqual(north, 23 * 111.4, delta=2)
        self.assertLess(up, 201)  # samples without a value are left out

    def test_flat_and_stretched_elevations(self):
        default = self.draw(self.hills)
        self.assertGreater(abs(self.draw(self.hills, "--flat") - default).max(), 20)
        self.assertGreater(abs(self.draw(self.hills, "--elevation-scale", 9) - default).max(), 20)


    def write_obj(self, name, data, turn):
        """Write a surface whose points (x, y, z) are turned by a function."""
        points = [turn(*data.GetPoint(i)) for i in range(data.GetNumberOfPoints())]
        faces = []
        for i in range(data.GetNumberOfCells()):
            ids = data.GetCell(i).GetPointIds()  # of an object that serves the next cell, too
            faces.append("f " + " ".join(str(ids.GetId(j) + 1) for j in range(ids.GetNumberOfIds())) + "\n")
        path = self.folder / name
        path.write_text("".join("v {} {} {}\n".format(*point) for point in points) + "".join(faces))
        return path

    def write_stl(self, name, data, turn):
        """Write the same as triangles."""
        points = [turn(*data.GetPoint(i)) for i in range(data.GetNumberOfPoints())]
        lines = ["solid x"]
        for i in range(data.GetNumberOfCells()):
            ids = [data.GetCell(i).GetPointId(j) for j in range(data.GetCell(i).GetNumberOfPoints())]
            for b, c in zip(ids[1:], ids[2:]):
                lines += ["facet normal 0 0 0", "outer loop"]
                lines += ["vertex {} {} {}".format(*points[id]) for id in (ids[0], b, c)]
                lines += ["endloop", "endfacet"]
        path = self.folder / name
        path.write_text("\n".join([*lines, "endsolid x", ""]))
        return path

    def append_boxes(self, *bounds):
        parts = vtkAppendPolyData()
        for each in bounds:
            box = vtkCubeSource()
            box.SetBounds(each)
            parts.AddInputConnection(box.GetOutputPort())
        parts.Update()
        return parts.GetOutput()

    def test_the_axis_that_points_up_is_guessed_of_files_that_do_not_say_it(self):
        tower = vtkConeSource()  # along Z, with its foot at -1
        tower.SetResolution(16)
        tower.SetHeight(2)
        tower.SetRadius(0.5)
        tower.SetDirection(0, 0, 1)
        tower.Update()
        car = vtkCubeSource()  # long along Z, on four wheels
        car.SetBounds(-0.8, 0.8, 0.3, 1.5, -2, 2)
        parts = vtkAppendPolyData()
        parts.AddInputConnection(car.GetOutputPort())
        for x, z in (-0.7, -1.5), (0.7, -1.5), (-0.7, 1.5), (0.7, 1.5):
            wheel = vtkSphereSource()
            wheel.SetCenter(x, 0.3, z)
            wheel.SetRadius(0.3)
            parts.AddInputConnection(wheel.GetOutputPort())
        parts.Update()
        plane = self.append_boxes(
            (-0.03, 0.03, -2.4, -2.3, -0.03, 0.03), (-0.25, 0.25, -2.3, 2, -0.25, 0.25),  # nose and hull
            (-2, 2, -0.4, 0.4, -0.25, -0.2), (-0.04, 0.04, 1.4, 2, 0.2, 0.7))  # wings and fin
        person = self.append_boxes(
            (-0.3, -0.1, 0, 0.8, -0.1, 0.1), (0.1, 0.3, 0, 0.8, -0.1, 0.1),  # legs, arms, and the rest
            (-0.9, 0.9, 1.4, 1.5, -0.05, 0.05), (-0.25, 0.25, 0.8, 1.8, -0.12, 0.12))
        hills = vtkPlaneSource()
        hills.SetResolution(12, 12)
        hills.Update()

        def bent(x, y, z):
            return x, y, 0.1 * numpy.sin(6 * x) * numpy.sin(6 * y)

        def as_it_is(x, y, z):
            return x, y, z

        def y_up(x, y, z):
            return x, z, -y

        def z_up(x, y, z):
            return x, -z, y

        for name, data, turn, says in (
            ("tower.obj", tower.GetOutput(), as_it_is, "it stands along Z"),
            ("tower-y.obj", tower.GetOutput(), y_up, ""),
            ("car.obj", parts.GetOutput(), as_it_is, ""),
            ("plane.obj", plane, as_it_is, "it lies flat over X and Y"),
            ("plane-y.obj", plane, y_up, ""),
            ("plane-y.stl", plane, lambda x, y, z: (-x, z, y), "it lies flat over X and Z"),
            ("person.obj", person, as_it_is, ""),
            ("person.stl", person, z_up, ""),
            ("hills.obj", hills.GetOutput(), bent, "it lies flat over X and Y"),
            ("hills-y.obj", hills.GetOutput(), lambda *p: y_up(*bent(*p)), ""),
            ("tower.stl", tower.GetOutput(), as_it_is, ""),
            ("tower-y.stl", tower.GetOutput(), y_up, "it stands along Y"),
            ("car.stl", parts.GetOutput(), z_up, ""),
            ("hills.stl", hills.GetOutput(), bent, ""),
            ("hills-y.stl", hills.GetOutput(), lambda *p: y_up(*bent(*p)), "it lies flat over X and Z"),
        ):
            with self.subTest(name):
                write, usual = (self.write_obj, "Y") if name.endswith("obj") else (self.write_stl, "Z")
                path = write(name, data, turn)
                other = "Z" if usual == "Y" else "Y"
                guess = self.draw(path, told=[name, says, "--up " + usual] if says else [])
                right = self.draw(path, "--up", other if says else usual)
                self.assertTrue((guess == right).all())

    def test_points_are_drawn_as_spheres_of_the_size_of_their_gaps(self):
        """Of a cloud on a ball, much of the ball is covered, also from near."""
        directions = numpy.random.default_rng(1).normal(size=(400, 3))
        points = directions / numpy.linalg.norm(directions, axis=1)[:, None]
        ply = self.folder / "cloud.ply"
        ply.write_text(
            "ply\nformat ascii 1.0\nelement vertex 400\n" + "".join(
                f"property float {axis}\n" for axis in "xyz") + "end_header\n" +
            "".join("{} {} {}\n".format(*point) for point in points))
        document = json.loads(sample_files.gltf(embed=False)[0])
        data = points.astype("<f4").tobytes()
        document.update(
            meshes=[{"primitives": [{"attributes": {"POSITION": 0}, "mode": 0}]}],
            nodes=[{"mesh": 0}], scenes=[{"nodes": [0]}],
            buffers=[{"byteLength": len(data), "uri": "cloud.bin"}],
            bufferViews=[{"buffer": 0, "byteOffset": 0, "byteLength": len(data)}],
            accessors=[{"bufferView": 0, "componentType": 5126, "count": 400, "type": "VEC3",
                        "min": [-1, -1, -1], "max": [1, 1, 1]}])
        (self.folder / "cloud.bin").write_bytes(data)
        gltf = self.folder / "cloud.gltf"
        gltf.write_text(json.dumps(document))
        size = 400, 400
        x, y = numpy.meshgrid(numpy.linspace(-1, 1, size[0]), numpy.linspace(-1, 1, size[1]))
        for file in ply, gltf:
            for distance in (3, 6):
                picture = self.draw(
                    file, "--no-rays", "--background", "#010203", "--color", "white",
                    "--camera-position", f"0,0,{distance}", "--focal-point", "0,0,0",
                    "--view-angle", "50", size=size)
                radius = numpy.tan(numpy.arcsin(1 / distance)) / numpy.tan(numpy.radians(25))
                ball = numpy.hypot(x, y) < radius
                covered = (picture != (1, 2, 3)).any(axis=2)
                self.assertGreater(covered[ball].mean(), 0.5, (file.name, distance))

    def test_points_at_one_place_are_drawn(self):
        path = self.folder / "point.vtk"
        path.write_text(
            "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n1 2 3 1 2 3\n")
        picture = self.draw(path, "--no-rays", "--background", "#010203")
        self.assertTrue((picture != (1, 2, 3)).any())

    def test_triangle_strips_are_drawn_as_triangles(self):
        path = self.folder / "tube.ply"
        sample_files.write_strips_ply(path, as_triangles=True)
        arguments = ["--no-rays", "--no-ambient-occlusion", "--background", "black", "--sun", "300,30"]
        triangles = self.draw(path, *arguments)
        for name in ("strips.ply", "strips-big.ply", "strips-little.ply"):
            self.assertLess(abs(self.draw(self.folder / name, *arguments) - triangles).mean(), 1.0)


class MedicalImages(ProgramTest):
    def test_one_body_is_one_picture_in_every_storage(self):
        """Axes in random orders and directions, and the values as they are, as integers, and shifted."""
        random = numpy.random.default_rng(7)
        body = numpy.full((14, 12, 10), -1000, "i2")  # [k, j, i], of Hounsfield units
        body[1:13, 1:11, 1:9] = 60
        body[2:6, 2:4, 2:8] = 1200
        body[7:12, 5:9, 6:8] = 700
        turn = numpy.linalg.qr(random.normal(size=(3, 3)))[0]
        turn *= numpy.sign(numpy.linalg.det(turn))
        for name, axes in ("straight", numpy.diag((1.5, 1.0, 2.0))), ("oblique", turn * (1.5, 1.0, 2.0)):
            matrix = numpy.column_stack((axes, (-30, 20, 10)))
            middle = matrix @ (4.5, 5.5, 6.5, 1)
            arguments = [
                "--volume-preset", "ct-bone", "--no-rays", "--sun", "334,30", "--background", "#010203",
                "--camera-position", ",".join(map(str, middle + (30, -45, 15))),
                "--focal-point", ",".join(map(str, middle))]
            files = [self.folder / f"{name}.vti"]
            image_files.write_vti(files[0], body, matrix)

            def add(write, file, *extra, body=body, **more):
                order, flips = random.permutation(3), random.integers(0, 2, 3)
                files.append(self.folder / f"{name}-{file}")
                write(files[-1], *image_files.turned(body, matrix, order, flips), *extra, **more)

            add(image_files.write_mha, "body.mha")
            shifted = (body + 1024).astype("u2")
            add(image_files.write_mha, "shifted.mha", 1, -1024, body=shifted)
            add(image_files.write_nii, "shifted.nii", 1, -1024, body=shifted)
            add(image_files.write_nii, "scaled.nii", 0.5, -1024, body=2 * shifted)
            add(image_files.write_nii, "body.nii.gz")
            add(image_files.write_nii, "q.nii", form="q")
            add(image_files.write_nii, "another-q.nii", form="q")
            for space, encoding in (
                ("left-posterior-superior", "raw"), ("RAS", "raw"), ("left-anterior-superior", "raw"),
                ("LAS", "gzip"), ("right-anterior-superior", "gzip"),
            ):
                add(image_files.write_nrrd, f"{space}-{encoding}.nrrd", space, encoding)
            add(image_files.write_nrrd, "floats.nrrd", body=body.astype("f4"))
            wrong = self.folder / f"{name}-wrong.mha"
            image_files.write_mha(wrong, body, matrix * [[-1, 1, 1, -1], [1, 1, 1, 1], [1, 1, 1, 1]])
            first, *others, mirrored = self.draw_each([*files, wrong], *arguments)
            self.assertGreater((first != (1, 2, 3)).any(axis=2).mean(), 0.05)
            self.assertGreater(abs(mirrored - first).mean(), 1, "the control")
            for file, picture in zip(files[1:], others):
                with self.subTest(file.name):
                    self.assertLess(abs(picture - first).mean(), 0.2)
            surface, *others = self.draw_each(files[:3], "--isosurface", 300, *arguments[2:])
            self.assertGreater((surface != (1, 2, 3)).any(axis=2).mean(), 0.05)
            for other in others:
                self.assertLess(abs(other - surface).mean(), 0.5)

    def test_headers_that_place_nothing(self):
        values = numpy.zeros((10, 11, 12), "i2")
        path = self.folder / "flat.mha"
        image_files.write_mha(path, values, numpy.array([[1.0, 1, 0, 0], [0, 0, 0, 0], [0, 0, 1, 0]]) + 1e-12)
        self.fails(path, "--output", self.folder / "p.png", says=[path.name, "directions", "write it again"])


class Pictures(ProgramTest):
    def test_one_picture_in_every_storage_of_tiff(self):
        """Of colours and of heights, in strips and tiles, by each compression that the library has."""
        x, y = numpy.meshgrid(numpy.arange(48), numpy.arange(32))
        colors = numpy.stack([5 * x, 7 * y, 128 + 60 * numpy.sin(x / 9)], 2).astype("u1")
        names = {1: "none", 5: "lzw", 7: "jpeg", 8: "deflate", 32773: "packbits"}
        for channels, pixels in (3, colors), (1, colors[..., 2:]):
            cases = [(1, False), (1, True)] + [(each, tiled) for each in names if each > 1 for tiled in (False, True)]
            files = []
            for compression, tiled in cases:
                files.append(self.folder / f"{names[compression]}-{channels}-{'tiles' if tiled else 'strips'}.tif")
                image_files.write_tiff(files[-1], pixels, compression, tiled)
            mirrored = self.folder / "mirrored.tif"
            image_files.write_tiff(mirrored, pixels[:, ::-1], 1)
            first, *others, control = self.draw_each(
                [*files, mirrored], "--flat", "--no-rays", "--camera-position", "24,16,80", "--focal-point", "24,16,0",
                "--fill", "1", "--sun", "180,60")
            self.assertGreater(abs(control - first).mean(), 3, "the control")
            for file, picture in zip(files[1:], others):
                with self.subTest(file.name):
                    self.assertLess(abs(picture - first).mean(), 1.5)
        data = bytearray(files[0].read_bytes())
        at = data.index(struct.pack("<HHIH", 259, 3, 1, 1))
        data[at + 8 : at + 10] = struct.pack("<H", 34712)  # JPEG 2000
        path = self.folder / "unknown.tif"
        path.write_bytes(data)
        self.fails(path, "--output", self.folder / "p.png", says=[path.name, "compression 34712", "deflate"])

    def test_images_of_several_files(self):
        """A list of names, or a pattern of them, in MetaImage and NRRD."""
        values = numpy.random.default_rng(3).integers(0, 200, (8, 10, 12)).astype("i2")
        place = numpy.array([[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]])
        folder = self.folder / "slices"
        folder.mkdir()
        names = [f"slice{k:03}.raw" for k in range(5, 5 + 8)]
        for name, slice_ in zip(names, values):
            (folder / name).write_bytes(slice_.tobytes())
        listed, pattern = "LIST\n" + "\n".join(names) + "\n", "slice%03d.raw 5 12 1\n"
        image_files.write_mha(folder / "whole.mha", values, place)
        image_files.write_nrrd(folder / "whole.nrrd", values, place)
        files = [folder / "whole.mha"]
        for whole, end, field in ("whole.mha", ".mhd", "ElementDataFile = "), ("whole.nrrd", ".nhdr", "data file: "):
            header = (folder / whole).read_bytes()[: -values.nbytes].decode().replace("ElementDataFile = LOCAL\n", "")
            for name, text in ("list", listed), ("pattern", pattern):
                files.append(folder / (name + end))
                files[-1].write_text(header.rstrip("\n") + "\n" + field + text)
        arguments = ["--no-rays", "--sun", "300,20", "--camera-position", "30,-50,25", "--focal-point", "6,5,4"]
        first, *others = self.draw_each(files, *arguments)
        self.assertGreater(numpy.ptp(first), 50)
        for file, picture in zip(files[1:], others):
            with self.subTest(file.name):
                self.assertLess(abs(picture - first).mean(), 0.2)
        part = folder / names[3]
        for words, spoil in (
            ("is empty", lambda: part.write_bytes(b"")), ("there is no such file", part.unlink),
            ("no regular file", lambda: os.mkfifo(part)),
        ):
            spoil()
            for file in files[1:]:
                with self.subTest(file.name, words=words):
                    self.fails(file, "--output", folder / "p.png", says=[f"{part.name}: ", words], timeout=20)
        for range_ in ("1 9 0", "1 999999999 1", "1 9999999999999 1", "-5 3 1"):
            (folder / "many.mhd").write_text((folder / "pattern.mhd").read_text().replace("5 12 1", range_))
            self.fails(folder / "many.mhd", "--output", folder / "p.png", says=["many.mhd: says a number of files"])


class Elevations(ProgramTest):
    ARGUMENTS = [
        "--no-rays", "--sun", "300,20", "--elevation-scale", "1", "--camera-position", "3000,-2000,1500",
        "--focal-point", "600,600,0", "--background", "#010203"]

    def write(self, name, **tags):
        path = self.folder / name
        sample_files.write_geotiff(path, **{"spacing": (50, 50), "geographic": False, **tags})
        return path

    def test_one_ground_is_one_picture_in_every_storage(self):
        foot, survey = 0.3048, 1200 / 3937
        ground = sample_files.heights()[::-1].copy()  # from north to south
        ground[:4, :4] = numpy.nan

        def item(name, value):
            return f'<Item name="{name}" sample="0" role="{name}">{value}</Item>'

        def metadata(*items):
            return "<GDALMetadata>" + "".join(items) + "</GDALMetadata>"

        cases = (  # the heights that are stored, and the tags
            ("minimum", numpy.where(numpy.isnan(ground), numpy.float32(-3.4e38), ground), {"no_data": "-3.4e38"}),
            ("not told", numpy.where(numpy.isnan(ground), -3.4028235e38, ground), {"no_data": None}),
            ("another", numpy.where(numpy.isnan(ground), 1e6, ground), {"no_data": "-9999"}),
            ("rounded", numpy.where(numpy.isnan(ground), numpy.float32(0.1) - 9999, ground),
             {"no_data": repr(0.1 - 9999)}),
            ("feet up", ground / foot, {"keys": {4099: 9002}}),
            ("feet, GDAL", ground / survey, {"metadata": metadata(item("unittype", "US survey foot"))}),
            ("feet", ground, {"keys": {3076: 9002}, "spacing": (50 / foot, 50 / foot)}),
            ("survey", ground, {"keys": {3076: 9003}, "spacing": (50 / survey, 50 / survey)}),
            ("scaled", (ground - 100) / 0.25,
             {"metadata": metadata(item("scale", 0.25), item("offset", 100))}),
            ("matrix", ground, {"matrix": (50, 0, 0, 7, 0, -50, 0, 9, 0, 0, 0, 0, 0, 0, 0, 1)}),
        )
        files = [self.write("ground.tif", values=ground)]
        for name, values, tags in cases:
            files.append(self.write(f"{name}.tif", values=values, **tags))
        done = godrays("--each", *files, *self.ARGUMENTS, "--size", "96x72", "--output", self.folder / "g-{n}.png",
            timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        told = done.stderr.splitlines()
        self.assertEqual(len(told), 2, told)
        for line, name in zip(told, ("not told", "another")):
            self.assertIn(name + ".tif: some heights cannot be", line)
        first, *others = [self.read(self.folder / f"g-{n + 1:04}.png", (96, 72)) for n in range(len(files))]
        self.assertGreater((first != (1, 2, 3)).any(axis=2).mean(), 0.04)
        for (name, *_), picture in zip(cases, others):
            with self.subTest(name):
                self.assertLess(abs(picture - first).mean(), 0.5)
        control = self.write("control.tif", values=ground / foot)
        self.assertGreater(abs(self.draw(control, *self.ARGUMENTS) - first).mean(), 1, "heights in feet")

    def test_a_picture_is_as_high_in_every_type(self):
        first, *others = self.draw_each(
            [self.folder / name for name in ("a.png", "a.tiff", "a.pgm", "a.jpg")], "--no-rays", "--sun", "300,20",
            "--camera-position", "40,-30,30", "--focal-point", "12,12,0")
        for other in others:
            self.assertLess(abs(other - first).mean(), 0.5)

    def test_rows_northwards_and_turned_grids(self):
        ground = sample_files.heights()[::-1].copy()
        files = (  # and where their first sample lies in the picture of the first one
            (self.write("north-up.tif", values=ground), (0, 0)),
            (self.write("matrix-up.tif", values=ground[::-1], matrix=(
                50, 0, 0, 0, 0, 50, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1)), (0, 1150)),
            (self.write("negative.tif", values=ground[::-1], spacing=(50, -50)), (0, 1150)),
            # Columns to the north and rows to the east
            (self.write("turned.tif", values=ground[::-1].T, matrix=(
                0, 50, 0, 0, 50, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1)), (1150, 0)))
        pictures = []
        for path, (x, y) in files:
            pictures.append(self.draw(  # from above the south-east
                path, *self.ARGUMENTS[:5], "--background", "#010203", "--focal-point", f"{575 - x},{575 - y},0",
                "--camera-position", f"{1575 - x},{-1025 - y},3000"))
        for (path, _), picture in zip(files, pictures):
            with self.subTest(path.name):
                self.assertLess(abs(picture - pictures[0]).mean(), 0.5)
        self.assertGreater(abs(pictures[0][:, ::-1] - pictures[0]).mean(), 1, "the control")


class Gltf(ProgramTest):
    def write(self, name, binary=False, **changes):
        """Write a.gltf or a.glb with other members of the document."""
        document = json.loads(sample_files.gltf(embed=binary)[0])
        document.update(changes)
        path = self.folder / name
        text = json.dumps(document).encode()
        if binary:
            sample_files.write_glb_parts(path, text, sample_files.gltf(embed=True)[1])
        else:
            path.write_bytes(text)
        return path

    def textured(self, *uris):
        """The members of a document whose first material has pictures."""
        document = json.loads(sample_files.gltf(embed=False)[0])
        document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
        for mesh in document["meshes"]:
            mesh["primitives"][0]["attributes"]["TEXCOORD_0"] = 2
        document["accessors"].append(
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC2"})
        return {
            "materials": document["materials"], "meshes": document["meshes"],
            "accessors": document["accessors"], "images": [{"uri": uri} for uri in uris],
            "textures": [{"source": i} for i in range(len(uris))]}

    def test_a_missing_picture_leaves_a_plain_colour(self):
        arguments = ["--fill", "1", "--no-ambient-occlusion"]  # else weaker for data with pictures
        plain = self.draw(self.folder / "a.gltf", *arguments)
        shutil.copy(self.folder / "a.bmp", self.folder / "there.bmp")
        for binary in (False, True):
            name = "missing" + (".glb" if binary else ".gltf")
            path = self.write(name, binary, **self.textured("none/brick wall.png", "there.bmp"))
            drawn = self.draw(
                path, *arguments, told=[name, "none/brick wall.png", "missing", "plain colour"])
            self.assertLess(abs(drawn - plain).max(), 3)

    def test_a_picture_whose_name_has_a_space_is_found(self):
        shutil.copy(self.folder / "a.png", self.folder / "a brick.png")
        path = self.write("space.gltf", **self.textured("a%20brick.png"))
        self.assertGreater(abs(self.draw(path) - self.draw(self.folder / "a.gltf")).max(), 20)

    def test_a_picture_that_is_cut_off(self):
        random = numpy.random.default_rng(2).integers(0, 255, (40, 40, 3)).astype("u1")
        for name, data in ("noise.png", sample_files.png(random)), ("a.jpg", (self.folder / "a.jpg").read_bytes()):
            (self.folder / ("cut-" + name)).write_bytes(data[: len(data) // 2])
            path = self.write("cut.gltf", **self.textured("cut-" + name))
            self.fails(path, "--output", "p.png", says=["cut-" + name])

    def test_a_missing_buffer(self):
        path = self.write("buffer.gltf", buffers=[{"byteLength": 44, "uri": "none.bin"}])
        self.fails(path, "--output", "p.png", says=["buffer.gltf", "none.bin", "missing"])

    FACING = [
        "--no-rays", "--fill", "1", "--no-ambient-occlusion", "--background", "#010203", "--focal-point", "0,0,0", "--view-angle", "40", "--sun", "180,20"]
    WHOLE = (-1, 1, -1, 1, 0)

    def plates(self, name, *plates):
        path = self.folder / name
        sample_files.write_plates(path, *plates)
        return path

    def write_surroundings(self):
        path = self.folder / "grey.hdr"
        path.write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16 +X 32\n" + 512 * b"\x80\x80\x80\x80")
        return path

    def test_one_grey_is_shown_as_one(self):
        """Factors and colours of vertices are linear, and pictures are encoded."""
        def to_linear(value):
            return ((value / 255 + 0.055) / 1.055) ** 2.4

        grey = to_linear(170)

        def corners(number, channels, kind):
            values = numpy.full((4, channels), number)
            values[:, 3:] = 1
            return (values * (numpy.iinfo(kind).max if kind[0] == "u" else 1) + 0.5 * (kind[0] == "u")).astype(kind)

        def texture(value, channels):
            pixels = numpy.full((4, 4, channels), value, "u1")
            pixels[..., 1 if channels == 2 else 3:] = 255
            return pixels

        contents = {
            "factor": {"factor": (grey, grey, grey, 1)},
            **{f"colors-{kind}-{channels}": {"colors": corners(grey, channels, kind)}
               for kind in ("f4", "u2") for channels in (3, 4)},
            "colors-u1-4": {"colors": corners(grey, 4, "u1")},
            "factor-colors": {"factor": (0.8, 0.8, 0.8, 1), "colors": corners(grey / 0.8, 4, "f4")},
            **{f"texture-{channels}": {"texture": texture(170, channels)} for channels in (1, 2, 3, 4)},
            "factor-texture": {"factor": [grey / to_linear(220)] * 3 + [1], "texture": texture(220, 3)},
            "colors-texture": {"colors": corners(grey / to_linear(220), 3, "f4"), "texture": texture(220, 3)},
        }
        surroundings = ["--hdri", self.write_surroundings()]
        for mode, members, place, *more in (
            ("unlit", {"extensions": {"KHR_materials_unlit": {}}}, "0,0,4"),
            ("lit", {}, "3,0,3"),  # where there is no highlight
            ("surrounded", {}, "3,0,3", *surroundings),
        ):
            files = [
                self.plates(f"{name}-{mode}{suffix}", {"corners": self.WHOLE, **content, **members})
                for name, content in [*contents.items(), ("control", {"texture": texture(90, 3)})]
                for suffix in (".gltf", ".glb")]
            arguments = [*(each for each in self.FACING if not more or each not in ("--background", "#010203")), *more]
            seen = [
                picture[HEIGHT // 2, WIDTH // 2]
                for picture in self.draw_each(files, *arguments, "--camera-position", place)]
            for file, color in zip(files, seen):
                with self.subTest(file.name):
                    if "control" in file.name:
                        self.assertGreater(abs(color - seen[0]).max(), 30)
                    elif mode == "unlit":
                        self.assertLessEqual(abs(color - 170).max(), 1, color)
                    else:
                        self.assertLessEqual(abs(color - seen[0]).max(), 5 if more else 1, color)

    def test_alpha_is_as_the_material_says(self):
        """A texture, factor or colours with an opacity: OPAQUE has none of it, and MASK cuts, from shadows, too."""
        grey = numpy.full((8, 8, 4), 180, "u1")
        halves = grey.copy()
        halves[:, :4, 3] = 100
        halves[:, 4:, 3] = 200
        right = (0, 1, -1, 1, 0)
        pale = numpy.array([(1, 1, 1, 0.2)] * 4, "f4")
        cut, whole = {"alphaMode": "MASK"}, {"corners": self.WHOLE, "texture": grey[..., :3]}
        nothing = {"corners": right, "texture": grey[..., :3], "factor": (1, 1, 1, 0.3), **cut}
        behind = {"corners": (-3, 3, -3, 3, -1.5), "factor": (0.5, 0.1, 0.1, 1)}
        frame = [  # which gives all scenes one size, and a light for data with pictures
            {"corners": (x, x + 0.2, y, y + 0.2, z), "texture": grey[..., :3], "factor": (0.1, 0.5, 0.1, 1)}
            for x, y, z in ((-2.2, -1.2, 0), (2, 1, -1))]
        half = {**whole, "corners": right}
        cases = {
            "whole": (whole, whole), "half": (half, half), "none": (nothing, None),
            "opaque-texture": ({**whole, "texture": halves}, whole),
            "opaque-factor": ({**whole, "factor": (1, 1, 1, 0.3)}, whole),
            "opaque-colors": ({**whole, "colors": pale}, whole),
            "mask": ({**whole, "texture": halves, **cut}, half),
            "mask-cutoff": ({**whole, "texture": halves, **cut, "alphaCutoff": 0.2}, whole),
            "mask-factor": ({**whole, "texture": halves, "factor": (1, 1, 1, 0.7), **cut}, half),
            "mask-colors": ({**whole, "colors": pale, **cut, "alphaCutoff": 0.1}, whole),
            "mask-all": ({**whole, "texture": halves, **cut, "alphaCutoff": 0.9}, None),
        }
        for name, arguments in (
            ("plain", [*self.FACING]),
            ("shadows", ["--preset", "fog", "--shadows", *self.FACING]),
            ("surrounded", ["--hdri", self.write_surroundings(), *self.FACING[:4], *self.FACING[6:]]),
            ("rays", ["--preset", "fog", "--tolerance", "0.01", "--light", "-1.2,0.4,-3", *self.FACING[1:-2]]),
        ):
            arguments += ["--camera-position", "0,0,4"]
            files, expected = [], []
            for case, (plate, as_is) in cases.items():
                for drawn, first in (files, plate), (expected, as_is):
                    drawn.append(self.plates(
                        f"{name}-{case}-{drawn is files}.glb", *([first] if first else []),
                        *([] if name == "rays" else [behind]), *frame))
            pictures = self.draw_each(files, *arguments)
            others = self.draw_each(expected, *arguments)
            self.assertGreater(abs(pictures[0] - pictures[1]).mean(), 1, "the control")
            for case, picture, other in zip(cases, pictures, others):
                with self.subTest(name, case=case):
                    self.assertLess(abs(picture - other).mean(), 0.15)

    def test_opacity_is_one_however_it_is_told(self):
        """BLEND has that of a factor, of vertices or of a texture."""
        half = numpy.full((4, 4, 4), 255, "u1")
        half[..., 3] = 102
        blend = {"corners": self.WHOLE, "alphaMode": "BLEND", "extensions": {"KHR_materials_unlit": {}}}
        files = [self.plates(f"blend-{i}.glb", {**blend, **members}) for i, members in enumerate((
            {"factor": (1, 1, 1, 0.4)}, {"colors": numpy.array([(1, 1, 1, 0.4)] * 4, "f4")}, {"texture": half},
            {"texture": half, "factor": (1, 1, 1, 0.5)}))]
        *seen, control = [picture[HEIGHT // 2, WIDTH // 2] for picture in self.draw_each(
            files, *self.FACING, "--camera-position", "0,0,4")]
        for color in seen:
            self.assertLessEqual(abs(color - (0.4 * 255 + 0.6 * numpy.array((1, 2, 3)))).max(), 2)
        self.assertGreater(abs(control - seen[0]).max(), 30, "the control")

    def test_what_cannot_be_read_has_its_name(self):
        for binary in (False, True):
            for extension, name in (
                ("KHR_draco_mesh_compression", "Draco"), ("EXT_meshopt_compression", "meshopt")
            ):
                path = self.write(
                    "packed" + (".glb" if binary else ".gltf"), binary,
                    extensionsUsed=[extension], extensionsRequired=[extension])
                self.fails(path, "--output", "p.png", says=[path.name, name, "without compression"])
        old = self.write("old.gltf", asset={"version": "1.0"})
        self.fails(old, "--output", "p.png", says=["old.gltf", "glTF 1", "convert"])
        old = self.folder / "old.glb"
        old.write_bytes(b"glTF" + struct.pack("<4I", 1, 40, 20, 0) + b"{}".ljust(20))
        self.fails(old, "--output", "p.png", says=["old.glb", "glTF 1", "convert"])


if __name__ == "__main__":
    unittest.main()
