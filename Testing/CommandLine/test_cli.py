# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program godrays (its path is in GODRAYS_PROGRAM): files of every type, options, errors."""

import gzip
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import (
    vtkConeSource, vtkCubeSource, vtkCylinderSource, vtkPlaneSource, vtkSphereSource,
    vtkSuperquadricSource)
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter, vtkXMLPolyDataWriter

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import sample_files

WIDTH, HEIGHT = 96, 72


def godrays(*arguments, timeout=60, **environment):
    done = subprocess.run(
        [os.environ["GODRAYS_PROGRAM"], *map(str, arguments)],
        capture_output=True, text=True, timeout=timeout, env={**os.environ, **environment})
    # It tells how far it is when that takes a while, as on a busy machine.
    done.stderr = re.sub(r"^reading .*: \d+ %\n", "", done.stderr, flags=re.MULTILINE)
    return done


class ProgramTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.files = sample_files.write_all(cls.folder)
        cls.mesh = cls.folder / "a.vtp"
        cls.hills = cls.folder / "a.tif"

    def draw(self, *arguments, size=(WIDTH, HEIGHT), told=()):
        """The picture that the program writes, as rows of RGB. It says one line with the words told, if
        there are any, and any line where that is None."""
        path = self.folder / "picture.png"
        path.unlink(missing_ok=True)
        done = godrays(*arguments, "--size", "{}x{}".format(*size), "--output", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        if told is not None:
            self.assertEqual(len(done.stderr.splitlines()), 1 if told else 0, done.stderr)
        for word in told or ():
            self.assertIn(word, done.stderr)
        return self.read(path, size)

    def draw_each(self, files, *arguments, size=(WIDTH, HEIGHT)):
        """The pictures that one program makes of several files; it says nothing."""
        done = godrays(
            "--each", *files, *arguments, "--size", "{}x{}".format(*size), "--output",
            self.folder / "of-each-{n}.png", timeout=300)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return [self.read(self.folder / f"of-each-{n + 1:04}.png", size) for n in range(len(files))]

    def read(self, path, size):
        """A picture in a file, which has this size, as rows of RGB."""
        reader = vtkPNGReader()
        reader.SetFileName(str(path))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetDimensions(), (*size, 1))
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
        return pixels.reshape(size[1], size[0], 3)

    def fails(self, *arguments, says=(), codes=(2, 3), **environment):
        """Run the program, which must end with one of the codes, 2 for options and 3 for files, and one
        line that says these words."""
        done = godrays(*arguments, **environment)
        self.assertIn(done.returncode, codes, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertTrue(done.stderr.startswith("godrays: "), done.stderr)
        for word in says:
            self.assertIn(word, done.stderr)


class Files(ProgramTest):
    def test_every_type_is_drawn_with_rays(self):
        without = self.draw_each(self.files, "--no-rays")
        alone = self.draw_each(
            self.files, "--no-rays", "--background", "#010203", "--color", "white")
        for file, plain, data in zip(self.files, without, alone):
            with self.subTest(file.name):
                self.assertGreater((data != (1, 2, 3)).any(axis=2).mean(), 0.02, "empty")
                self.assertGreater(abs(self.draw(file) - plain).max(), 20, "no rays")

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
        cells = [data.GetCell(i).GetPointIds() for i in range(data.GetNumberOfCells())]
        path = self.folder / name
        path.write_text("".join("v {} {} {}\n".format(*point) for point in points) + "".join(
            "f " + " ".join(str(ids.GetId(i) + 1) for i in range(ids.GetNumberOfIds())) + "\n"
            for ids in cells))
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
        tube = vtkCylinderSource()
        tube.SetCenter(0, 1.5, 0)
        tube.SetHeight(3)
        tube.SetRadius(1)
        tube.SetResolution(16)
        tube.CappingOff()
        tube.Update()
        path = self.folder / "tube.ply"
        sample_files.write(sample_files.vtkPLYWriter(), sample_files.filtered(
            sample_files.vtkTriangleFilter(), tube.GetOutput()), path)
        arguments = ["--no-rays", "--background", "black", "--sun", "300,30"]
        triangles = self.draw(path, *arguments)
        for name in ("strips.ply", "strips-big.ply", "strips-little.ply"):
            self.assertLess(abs(self.draw(self.folder / name, *arguments) - triangles).mean(), 1.0)


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
        plain = self.draw(self.folder / "a.gltf")
        shutil.copy(self.folder / "a.bmp", self.folder / "there.bmp")
        for binary in (False, True):
            name = "missing" + (".glb" if binary else ".gltf")
            path = self.write(name, binary, **self.textured("none/brick wall.png", "there.bmp"))
            drawn = self.draw(path, told=[name, "none/brick wall.png", "missing", "plain colour"])
            self.assertLess(abs(drawn - plain).max(), 3)

    def test_a_picture_whose_name_has_a_space_is_found(self):
        shutil.copy(self.folder / "a.png", self.folder / "a brick.png")
        path = self.write("space.gltf", **self.textured("a%20brick.png"))
        self.assertGreater(abs(self.draw(path) - self.draw(self.folder / "a.gltf")).max(), 20)

    def test_a_missing_buffer(self):
        path = self.write("buffer.gltf", buffers=[{"byteLength": 44, "uri": "none.bin"}])
        self.fails(path, "--output", "p.png", says=["buffer.gltf", "none.bin", "missing"])

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


class DamagedFiles(ProgramTest):
    def test_files_cut_off(self):
        cut = self.folder / "cut"
        for path in list(self.folder.iterdir()):
            if path.is_dir() and path != cut:
                shutil.copytree(path, cut / path.name)
        cut.mkdir(exist_ok=True)
        for name in ("a.raw", "values.raw", "triangles.bin", "colors.mtl"):
            shutil.copy(self.folder / name, cut)
        for file in self.files:
            if file.suffix == ".obj":
                continue  # a shorter text of this kind is as good as the whole
            with self.subTest(file.name):
                part = cut / file.name
                contents = file.read_bytes()
                part.write_bytes(contents[: len(contents) * 6 // 10])
                self.fails(part, "--output", self.folder / "p.png", says=[str(part)])

    def test_files_with_other_contents(self):
        for extension in sorted({file.suffix.lower() for file in self.files}):
            with self.subTest(extension):
                path = self.folder / ("other" + extension)
                path.write_text("This is a letter, not data.\n" * 20)
                self.fails(path, "--output", self.folder / "p.png", says=[str(path)])

    def test_cells_with_points_that_are_not_there(self):
        corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
        ply = "ply\nformat ascii 1.0\nelement vertex 3\n" + "".join(
            f"property float {axis}\n" for axis in "xyz")
        ply += "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        vtk = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET {}\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n"
        for name, text in (
            ("cells.obj", corners + "f 1 2 9\n"),
            ("cells.ply", ply + "0 0 0\n1 0 0\n0 1 0\n3 0 1 77\n"),
            ("lines.vtk", vtk.format("POLYDATA") + "LINES 1 3\n2 0 -5\n"),
            ("cells.vtk", vtk.format("UNSTRUCTURED_GRID") + "CELLS 1 4\n3 0 1 3\nCELL_TYPES 1\n5\n"),
        ):
            with self.subTest(name):
                path = self.folder / name
                path.write_text(text)
                self.fails(path, "--output", self.folder / "p.png", says=[name, "not there"])

    def test_headers_that_do_not_end(self):
        for text in ("P5\n# a comment without an end", "P2\n3", "P6 3 2 many", "P7\n3 2 255\n", "P"):
            for extension in (".pgm", ".ppm"):
                with self.subTest(text + extension):
                    path = self.folder / ("header" + extension)
                    path.write_text(text)
                    self.fails(path, "--output", self.folder / "p.png", says=[path.name, "no size"])

        path = self.folder / "header.nhdr"
        start = "NRRD0004\ntype: float\n"
        for text, words in (
            ("sizes: 2 2 2\nencoding: raw\ndata file: values.raw\n", "no dimension"),
            ("dimension: 3\nsizes: 2 2 2\nencoding: raw\ndata file: values.raw", "ends before its data"),
            ("dimension: 3\nsizes: 2 2 2\nencoding: raw\ndata file: values.raw\nmore\0\n\n", "ends before its data"),
            ("dimension: 3\nsizes: 2 2 2\nencoding: raw\ndata file: f%d 1 9 0\n", "number of files"),
        ):
            with self.subTest(text):
                path.write_text(start + text)
                self.fails(path, "--output", self.folder / "p.png", says=[path.name, words])

    def test_polygons_that_do_not_end(self):
        whole = (self.folder / "a.byu").read_text()
        path = self.folder / "polygons.byu"
        for text, words in (
            (whole.rsplit("-", 1)[0], "ends before its data"),
            (whole[:len(whole) // 2], "ends before its data"),
            ("1 many 240 720\n", "no number of points"),
        ):
            with self.subTest(words):
                path.write_text(text)
                self.fails(path, "--output", self.folder / "p.png", says=[path.name, words])

    def test_sizes_that_cannot_be(self):
        image = (self.folder / "a.vti").read_bytes()
        many = (self.folder / "a.pvtu").read_text()
        for name, contents, words in (
            ("size.vti", re.sub(rb'WholeExtent="0 (\d+) 0', rb'WholeExtent="0 \1 100000000', image, 1), []),
            ("components.pvtu", re.sub('NumberOfComponents="3"', 'NumberOfComponents="100000000"', many, 1),
             ["a size that cannot be"]),
        ):
            with self.subTest(name):
                path = self.folder / name
                path.write_bytes(contents if isinstance(contents, bytes) else contents.encode())
                self.fails(path, "--output", self.folder / "p.png", says=[name, *words])

    def test_coordinates_that_are_too_far(self):
        path = self.folder / "far.obj"
        path.write_text("v 0 0 0\nv 1e20 0 0\nv 0 1e20 0\nf 1 2 3\n")
        self.fails(path, "--output", self.folder / "p.png", says=["beyond 1e14", "larger unit"])

    def test_what_a_file_says_is_not_for_terminals(self):
        path = self.folder / "bell.vtk"
        path.write_bytes(
            b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 0\n"
            b"POINT_DATA 1\n\x1b[31m\x07\x1d\n")
        self.fails(path, "--output", self.folder / "p.png", says=["bell.vtk", "?[31m??"])

    def test_a_reader_that_fills_the_stack(self):
        path = self.folder / "cycle.gltf"
        path.write_text('{"asset":{"version":"2.0"},"nodes":[{"children":[0]}],"scene":0,'
                        '"scenes":[{"nodes":[0]}]}')
        self.fails(path, "--output", self.folder / "p.png", says=["cycle.gltf", "cannot be read"])

    def test_empty_file(self):
        for extension in (".vtp", ".stl", ".png"):
            path = self.folder / ("empty" + extension)
            path.touch()
            self.fails(path, "--output", "p.png", says=[str(path), "is empty"])

    def test_missing_file(self):
        self.fails("none.vtp", "--output", "p.png", says=["none.vtp", "no such file"])

    def test_directory(self):
        self.fails(self.folder, "--output", "p.png", says=["is a directory"])

    def test_unknown_type(self):
        path = self.folder / "a.xyz"
        path.write_text("1 2 3\n")
        self.fails(path, "--output", "p.png", says=["unknown type", ".vtp"])

    def test_no_regular_file(self):
        path = self.folder / "pipe.vtp"
        os.mkfifo(path)
        self.fails(path, "--output", "p.png", says=["no regular file"])

    @unittest.skipIf(os.geteuid() == 0, "the superuser may read every file")
    def test_unreadable_file(self):
        path = self.folder / "secret.vtp"
        shutil.copy(self.mesh, path)
        path.chmod(0)
        self.fails(path, "--output", "p.png", says=["permissions"])

    def test_names_that_are_not_what_they_seem(self):
        dash = self.folder / "-dash.obj"
        shutil.copy(self.folder / "a.obj", dash)
        picture = self.folder / "p.png"
        # as typed in its folder
        done = subprocess.run([os.environ["GODRAYS_PROGRAM"], dash.name], cwd=self.folder, capture_output=True,
            text=True, timeout=60)
        self.assertEqual((done.returncode, done.stderr), (
            2, "godrays: -dash.obj is no option; if the file is meant, name it ./-dash.obj; see godrays --help\n"))
        for name, words in (
            ("", ["name is empty"]), ("https://example.com/a.obj", ["an address", "on this machine"]),
        ):
            self.fails(name, "--output", picture, says=words, codes=[3])
        self.fails("--", "-none.obj", says=["no such file", "options before it"], codes=[3])
        text = self.folder / "text.stl"
        shutil.copy(self.folder / "a.obj", text)
        self.fails(text, "--output", picture, says=["or no .stl", "extension of its type"], codes=[3])

    def test_packed_files(self):
        volume = self.folder / "packed.nii.gz"
        volume.write_bytes(gzip.compress((self.folder / "a.nii").read_bytes()))
        self.assertTrue((self.draw(volume) == self.draw(self.folder / "a.nii")).all())
        mesh = self.folder / "packed.vtp.gz"
        mesh.write_bytes(gzip.compress(self.mesh.read_bytes()))
        self.fails(mesh, "--output", self.folder / "p.png", says=["packed.vtp.gz", "unpack it"], codes=[3])

    def write_volume(self, name, values):
        image = vtkImageData()
        image.SetDimensions(values.shape[::-1])
        image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
        image.GetPointData().GetScalars().SetName("values")
        writer = vtkXMLImageDataWriter()
        writer.SetFileName(str(self.folder / name))
        writer.SetInputData(image)
        writer.Write()
        return self.folder / name

    def test_voxels_that_are_no_numbers_are_left_out(self):
        values = numpy.full((12, 12, 12), 0.0)
        values[:, :, 5:] = 1.0
        lowest = self.write_volume("lowest.vti", values)
        values[:, :, :5] = numpy.nan
        values[6, 6, 6] = numpy.inf
        values[0, 0, 0] = 0.0
        self.assertTrue((self.draw(self.write_volume("nan.vti", values)) == self.draw(lowest)).all())
        nothing = self.write_volume("nothing.vti", numpy.full((4, 4, 4), numpy.nan))
        self.fails(nothing, "--output", "p.png", says=["nothing.vti", "nothing to draw"], codes=[3])

    def test_files_with_nothing_to_see(self):
        point = self.folder / "point.obj"
        point.write_text("v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n")
        empty = self.folder / "nothing.vtp"
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(empty))
        writer.SetInputData(vtkPolyData())
        writer.Write()
        for path in point, empty:
            self.fails(path, "--output", "p.png", says=[path.name, "nothing to draw"], codes=[3])

    def test_options_of_data_that_are_not_there(self):
        for option, words in (
            (["--time", 3], ["no file has time steps"]), (["--volume-preset", "ct-bone"], ["no volume is drawn"]),
            (["--volume-medium"], ["no volume is drawn"]),
        ):
            self.draw(self.mesh, *option, told=[str(option[0]), *words])
        self.fails(self.mesh, "--numbers", self.folder / "n.vti", says=["--preset"], codes=[2])
        self.fails(self.mesh, "--output=", says=["--output: needs a value"], codes=[2])

    def test_file_without_geometry(self):
        path = self.folder / "points.vtk"
        path.write_text("# vtk DataFile Version 3.0\nempty\nASCII\nDATASET POLYDATA\n")
        self.fails(path, "--output", "p.png", says=["nothing to draw"])

    def test_file_of_no_size(self):
        path = self.folder / "speck.obj"
        path.write_text("v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nf 1 2 3\n")
        self.fails(path, "--output", "p.png", says=["too near", "smaller unit"])

    def test_table(self):
        path = self.folder / "table.vtk"
        path.write_text(
            "# vtk DataFile Version 3.0\ntable\nASCII\nDATASET TABLE\nROW_DATA 1\n"
            "FIELD FieldData 1\nvalues 1 1 float\n7\n")
        self.fails(path, "--output", "p.png", says=["vtkTable", "no shape"])

    def test_a_good_file_does_not_hide_a_bad_one(self):
        self.fails(self.mesh, "none.vtp", "--output", "p.png", says=["none.vtp"])


class Arguments(ProgramTest):
    def test_values_that_cannot_be(self):
        for arguments, words in (
            (["--sun", "east"], ["--sun", "'east'", "AZIMUTH,ELEVATION"]),
            (["--sun", "1,2,3"], ["--sun"]),
            (["--sun", "1,"], ["--sun"]),
            (["--sun", "10,95"], ["--sun", "-90 to 90"]),
            (["--sun", "nan,1"], ["--sun"]),
            (["--sun", "1,2", "--light", "1,2,3"], ["--sun", "--light"]),
            (["--date", "2024-06-21T12:00Z"], ["--date", "--place"]),
            (["--place", "48,11"], ["--date", "--place"]),
            (["--date", "noon", "--place", "48,11"], ["--date", "'noon'", "2024-06-21T"]),
            (["--date", "2024-06-21T12:00Z", "--place", "48,190"], ["--place", "-180 to 180"]),
            (["--date", "2024-06-21T12:00Z", "--place", "48,11", "--sun", "1,2"], ["--sun"]),
            # sunrise and sunset of Munich on that day: 05:13 and 21:17
            (["--date", "2024-06-21T23:30+02:00", "--place", "48.137,11.575"],
             ["below the horizon", "05:1", "21:1"]),
            (["--date", "2024-12-21T12:00Z", "--place", "80,0"], ["below the horizon"]),
            (["--sky", "venus"], ["--sky", "'venus'", "earth-hazy"]),
            (["--sky", "mars", "--light", "1,2,3"], ["--sky", "--light"]),
            (["--sky", "mars", "--background", "red"], ["--sky", "--background"]),
            (["--light", "1,2"], ["--light", "X,Y,Z"]),
            (["--sun-at", "1,1", "--sun", "1,2"], ["--sun-at", "--sun"]),
            (["--camera", "1,2", "--focal-point", "1,2,3"], ["--camera", "--focal-point"]),
            (["--camera", "1,95"], ["--camera", "-90 to 90"]),
            (["--zoom", "0"], ["--zoom"]),
            (["--parallel-height", "2"], ["--parallel"]),
            (["--transparent", "--sky", "mars"], ["--transparent", "--sky"]),
            (["--turntable", "1.5"], ["--turntable", "whole"]),
            (["--turntable", "3"], ["--output", "{frame}"]),
            (["--film", "f.ogv"], ["--film", "--turntable"]),
            (["--time", "now"], ["--time"]),
            (["--quiet", "--verbose"], ["--quiet", "--verbose"]),
            (["--window", "1,0"], ["--window", "width"]),
            (["--volume-preset", "mri"], ["--volume-preset", "ct-skin-bone"]),
            (["--volume-medium", "--isosurface", "1"], ["--volume-medium", "--isosurface"]),
            (["--volume-medium", "--optical-depth", "1"], ["--optical-depth", "--preset"]),
            (["--volume-medium", "--preset", "low-sun"], ["--volume-medium", "haze"]),
            (["--light-color", "1,2,3"], ["--light-color", "r,g,b"]),
            (["--light-color", "nocolor"], ["--light-color"]),
            (["--light-size", "-1"], ["--light-size"]),
            (["--fill", "x"], ["--fill"]),
            (["--preset", "nonesuch"], ["--preset", "nonesuch", "default"]),
            (["--preset", "fog", "--decay", "0.9"], ["--decay", "looks", "--optical-depth"]),
            (["--optical-depth", "1"], ["--optical-depth", "medium"]),
            (["--preset", "fog", "--optical-depth", "0"], ["--optical-depth"]),
            (["--intensity", "-1"], ["--intensity", "0 to 10000"]),
            (["--density", "3"], ["--density", "0 to 2"]),
            (["--decay", "2"], ["--decay"]),
            (["--weight", "1e9"], ["--weight"]),
            (["--exposure", ""], ["--exposure"]),
            (["--preset", ""], ["--preset", "needs a value"]),
            (["--output", ""], ["--output", "needs a value"]),
            (["--isosurface", "1"], ["--isosurface", "3-D image"]),
            (["--glow", "1.5"], ["--glow", "0 to 1"]),
            (["--glow-angle", "200"], ["--glow-angle"]),
            (["--tolerance", "0"], ["--tolerance"]),
            (["--show", "all"], ["--show", "occlusion"]),
            (["--size", "100"], ["--size", "WIDTHxHEIGHT"]),
            (["--size", "0x100"], ["--size"]),
            (["--size", "100x100x3"], ["--size"]),
            (["--size", "99999x99999"], ["--size"]),
            (["--camera-position", "1,2"], ["--camera-position"]),
            (["--camera-position", "1,2,3", "--focal-point", "1,2,3"], ["the same"]),
            (["--view-up", "0,0,0"], ["--view-up"]),
            (["--view-angle", "0"], ["--view-angle"]),
            (["--up", "W"], ["--up", "X, Y or Z"]),
            (["--background", "nocolor"], ["--background"]),
            (["--background", "red:green:blue"], ["--background", "two"]),
            (["--scalars", "nonesuch"], ["--scalars", "nonesuch", "Elevation"]),
            (["--colormap", "nonesuch"], ["--colormap", "viridis"]),
            (["--range", "2,1"], ["--range"]),
            (["--color", "256,0,0"], ["--color"]),
            (["--opacity", "2"], ["--opacity"]),
            (["--elevation-scale", "0"], ["--elevation-scale"]),
            (["--nonesuch"], ["--nonesuch", "--help"]),
            (["--sun"], ["--sun"]),
        ):
            with self.subTest(arguments):
                self.fails(self.mesh, "--output", self.folder / "p.png", *arguments, says=words)

    def test_isosurface_outside_the_values(self):
        self.fails(
            self.folder / "a.vti", "--isosurface", 1e6, "--output", self.folder / "p.png",
            says=["--isosurface", "values are from"])

    def test_no_file(self):
        self.fails(says=["no file", "--help"])

    def test_output_that_cannot_be_written(self):
        self.fails(self.mesh, "--output", self.folder / "no" / "p.png", says=["no folder", "mkdir"])
        self.fails(self.mesh, "--output", self.folder / "p.gif", says=[".png"])
        folder = self.folder / "folder.png"
        folder.mkdir()
        self.fails(self.mesh, "--output", folder, says=["directory"])

    def test_output_that_is_a_file_to_be_read(self):
        picture = self.folder / "heights.png"
        shutil.copy(self.folder / "a.png", picture)
        (self.folder / "link.png").symlink_to(picture)
        (self.folder / "hard.png").hardlink_to(picture)
        before = picture.read_bytes()
        for output in (picture, f"{self.folder}/./heights.png", self.folder / "link.png",
                       self.folder / "hard.png"):
            self.fails(self.mesh, picture, "--output", output, says=["file to be read", "another name"])
            self.assertEqual(picture.read_bytes(), before)

    def test_a_picture_is_written_whole_or_not_at_all(self):
        folder = self.folder / "whole"
        folder.mkdir()
        target = folder / "target.png"
        link = folder / "p.png"
        link.symlink_to(target)
        for former in (None, b"the former picture"):
            if former:
                target.write_bytes(former)
            # Files end after 100 bytes, and the program is told so rather than killed.
            done = subprocess.run(
                [os.environ["GODRAYS_PROGRAM"], self.mesh, "--output", link],
                capture_output=True, text=True, restore_signals=False,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)))
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn("could not be written", done.stderr)
            self.assertEqual(target.read_bytes() if former else target.exists(), former or False)
            self.assertEqual(
                sorted(each.name for each in folder.iterdir()),
                ["p.png", "target.png"] if former else ["p.png"])
        self.assertEqual(godrays(self.mesh, "--output", link).returncode, 0)
        self.assertTrue(link.is_symlink())
        self.read(target, (1200, 800))
        self.assertEqual(len(list(folder.iterdir())), 2)

    def test_nothing_is_left_of_a_program_that_is_ended(self):
        former = b"the former picture"
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=number), tempfile.TemporaryDirectory() as name:
                folder = pathlib.Path(name)
                (folder / "p.png").write_bytes(former)
                program = subprocess.Popen(
                    [os.environ["GODRAYS_PROGRAM"], self.mesh, "--size", "3000x2000", "--output", folder / "p.png"],
                    stderr=subprocess.PIPE, text=True,
                    preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))  # shells ignore it behind
                while program.poll() is None and len(list(folder.iterdir())) < 2:
                    time.sleep(0.001)
                program.send_signal(number)
                told = program.communicate(timeout=60)[1]
                self.assertEqual(program.returncode, -number, told)
                self.assertEqual([each.name for each in folder.iterdir()], ["p.png"])
                self.assertEqual((folder / "p.png").read_bytes(), former)

    def test_nothing_is_left_of_a_copy_when_a_reader_crashes(self):
        """Of a file whose picture is missing there is a copy; its nodes go round in circles."""
        path = self.folder / "copied.gltf"
        path.write_text('{"asset":{"version":"2.0"},"nodes":[{"children":[0]}],"scene":0,'
                        '"scenes":[{"nodes":[0]}],"images":[{"uri":"none.png"}]}')
        with tempfile.TemporaryDirectory() as folder:
            self.fails(path, "--output", self.folder / "p.png", says=["cannot be read"], TMPDIR=folder)
            self.assertEqual(os.listdir(folder), [])

    def test_no_display(self):
        picture = self.folder / "p.png"
        no_display = {"says": ["xvfb-run"], "codes": [4]}
        self.fails(self.mesh, "--output", picture, **no_display, DISPLAY="")
        self.fails(self.mesh, "--output", picture, **no_display, DISPLAY=":987")
        self.fails(self.mesh, **no_display, DISPLAY="")

    def test_exit_codes_by_kind(self):
        picture = self.folder / "p.png"
        self.fails(self.mesh, "--nonesuch", codes=[2])
        self.fails(self.mesh, "--output", picture, "--scalars", "nonesuch", codes=[2])
        self.fails("none.vtp", "--output", picture, codes=[3])
        self.fails(self.mesh, "--output", self.folder / "no" / "p.png", codes=[3])

    def test_misspelt_names_are_guessed(self):
        for arguments, right in (
            (["--prest", "fog"], "--preset"), (["--isosruface=1"], "--isosurface"),
            (["--preset", "defualt"], "default"), (["--preset", "long-shaft"], "long-shafts"),
            (["--out", "a.png"], "--output"), (["--colormap", "virids"], "viridis"), (["--volume-preset", "ct-bon"], "ct-bone"),
        ):
            with self.subTest(arguments):
                self.fails(self.mesh, *arguments, says=[f"did you mean {right}?"], codes=[2])
        done = godrays(self.mesh, "--frobnicate")
        self.assertNotIn("did you mean", done.stderr)


class Pictures(ProgramTest):
    def test_size(self):
        self.draw(self.mesh, "--size", "9x9")  # given again after it: the last one counts
        self.draw(self.mesh, size=(130, 70))

    def test_the_background_has_no_bands(self):
        """In most blocks of 4 x 4 pixels the levels of a gradient vary, by one or two."""
        for background in [], ["--background", "#101820:#405070"]:
            picture = self.draw(self.mesh, "--no-rays", *background, size=(320, 240))
            corner = picture[:60, :60]  # where there is neither sun nor data
            blocks = corner.reshape(15, 4, 15, 4, 3).swapaxes(1, 2).reshape(225, 16, 3)
            spread = blocks.max(axis=1) - blocks.min(axis=1)
            self.assertLessEqual(spread.max(), 2)
            self.assertGreater((spread > 0).mean(), 0.8)

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
                # through the dust, a sun on the horizon of Mars is too faint
                told = ["nothing that can be seen"] if "mars" in arguments else ()
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
        self.assertGreater(share_that_differs("196.5,39.888"), 0.1)

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
                    self.assertGreater(covered.mean(), 0.24)
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
                    self.assertLess(glare[covered].mean(), 0.4 * glare[~covered].mean())


class Lists(ProgramTest):
    def test_presets(self):
        done = godrays("--list-presets")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = done.stdout.splitlines()
        self.assertIn("default", [line.split()[0] for line in lines])
        self.assertIn("fog", [line.split()[0] for line in lines])
        self.assertTrue(all(len(line.split()) > 1 for line in lines))

    def test_colormaps(self):
        self.assertIn("viridis", godrays("--list-colormaps").stdout.split())

    def test_numbers(self):
        """The command of Documentation/Numbers.md, and what a medium leaves of light."""
        page = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "Numbers.md"
        command = re.search(r"^    godrays (terrain.tif .*)$", page.read_text("utf-8"), re.M).group(1).split()
        path = self.folder / "haze.vti"
        command[command.index("haze.vti")] = path
        command[0] = self.hills
        done = godrays(*command, "--size", "96x72")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        reader = vtkXMLImageDataReader()
        reader.SetFileName(str(path))
        reader.Update()
        image = reader.GetOutput()
        self.assertEqual(image.GetDimensions(), (96, 72, 1))

        def array(name):
            return vtk_to_numpy(image.GetPointData().GetArray(name)).astype(float)

        seen = numpy.isfinite(array("Depth"))
        self.assertGreater(seen.mean(), 0.1)
        tau = 7.49e-4 * array("Distance_m")[seen]  # of haze
        numpy.testing.assert_allclose(array("OpticalDepth")[seen, 1], tau, 1e-4)
        numpy.testing.assert_allclose(array("Transmittance")[seen, 0], numpy.exp(-tau), 1e-4)
        numpy.testing.assert_allclose(array("MeteorologicalRange_m"), 3.912 / 7.49e-4, 1e-4)
        brightest = 1000 * (1 - 0.76**2) / (4 * numpy.pi * (1 - 0.76) ** 3)  # straight ahead, all of it
        self.assertGreater(array("Radiance").max(), 1e-3 * brightest)
        self.assertLess(array("Radiance").max(), brightest)
        self.fails(self.mesh, "--numbers", path, says=["--numbers", "medium"])
        fog = (self.mesh, "--preset", "fog", "--numbers")
        self.fails(*fog, "n.png", says=["--numbers", ".vti or .exr"])
        self.fails(*fog, self.folder / "none" / "n.vti", says=["--numbers", "no folder"])
        self.fails(*fog, path, "--no-rays", says=["--numbers", "--no-rays"])
        self.fails(*fog, path, "--irradiance", "1,-1,1", says=["--irradiance"])
        self.fails(self.mesh, "--irradiance", "1,1,1", says=["--irradiance", "--numbers"])
        exr = self.folder / "n.exr"
        done = godrays(*fog, exr, "--size", "96x72")
        if done.returncode == 0:  # built with OpenEXR
            self.assertEqual(exr.read_bytes()[:4], b"\x76\x2f\x31\x01")
            self.assertIn(b"Transmittance.G", exr.read_bytes())
        else:
            self.assertIn("OpenEXR", done.stderr)

    def test_help_and_version(self):
        self.assertIn("--sun", godrays("--help").stdout)
        self.assertRegex(godrays("--version").stdout, r"^godrays \d+\.\d+")

    def test_stats(self):
        arguments = [self.mesh, "--size", "64x48", "--output", self.folder / "s.png", "--stats"]
        text = godrays(*arguments).stdout
        for word in ("cells", "colours    by Elevation", "--camera-position", "--sun", "(chosen)",
                     "plan", "stage times", "scattering"):
            self.assertIn(word, text)
        error, largest = map(float, re.search(r"error +(\S+) .*largest ([^;]+);", text).groups())
        self.assertTrue(0 < error <= largest < 0.1, text)
        self.assertLess(error, 1 / 255)
        self.assertIn("--no-rays", godrays(*arguments, "--no-rays").stdout)

    def test_stats_tell_how_to_have_the_picture_again(self):
        text = godrays(
            self.mesh, "--size", f"{WIDTH}x{HEIGHT}", "--output", self.folder / "s.png",
            "--stats").stdout
        camera = re.search(r"camera     (.*)", text).group(1).split()
        light = re.search(r"light      (--sun \S+)", text).group(1).split()
        again = self.draw(self.mesh, *camera, *light)
        self.assertLess(abs(again - self.draw(self.mesh)).mean(), 1)


if __name__ == "__main__":
    unittest.main()
