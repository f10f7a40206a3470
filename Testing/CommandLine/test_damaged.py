# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program godrays with files that are damaged, or that have nothing to see."""

import gzip
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from program_testing import ProgramTest, godrays


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

    def test_files_that_others_name(self):
        """A pipe hangs a reader, and an empty or missing file is told by its own name."""
        folder = self.folder / "named"
        folder.mkdir()
        pipe, empty = folder / "pipe", folder / "empty"
        os.mkfifo(pipe)
        empty.touch()
        texts = {
            "a.mhd": (self.folder / "a.mhd").read_text().replace("a.raw", "{}"),
            "a.nhdr": (self.folder / "a.nhdr").read_text().replace("values.raw", "{}"),
            "a.vtm": re.sub('file="[^"]*"', 'file="{}"', (self.folder / "a.vtm").read_text(), 1),
            "a.pvtu": re.sub('Source="[^"]*"', 'Source="{}"', (self.folder / "a.pvtu").read_text(), 1),
            "a.gltf": (self.folder / "a.gltf").read_text().replace("triangles.bin", "{}"),
        }
        for name, text in texts.items():
            for part, words in (("pipe", "no regular file"), ("empty", "is empty"), ("none", "")):
                with self.subTest(name, part=part):
                    self.assertIn("{}", text)
                    (folder / name).write_text(text.replace("{}", part))
                    self.fails(folder / name, "--output", folder / "p.png", says=[part, words], timeout=20)
        (folder / "a.obj").write_text("mtllib pipe empty none\nv 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n")
        done = godrays(folder / "a.obj", "--size", "64x48", "--output", folder / "p.png", timeout=20)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 3, lines)
        for line, part in zip(lines, ("pipe", "empty", "none")):
            self.assertIn(f"{part}: ", line)
            self.assertIn("plain colour", line)
        (folder / "short.gltf").write_text(texts["a.gltf"].replace("{}", "short.bin"))
        (folder / "short.bin").write_bytes(bytes(30))
        self.fails(folder / "short.gltf", "--output", folder / "p.png", says=["short.bin: is shorter"])

        light = folder / "cut.hdr"
        light.write_bytes((self.folder / "a.hdr").read_bytes()[:20000])
        picture = folder / "cut.png"
        self.draw(self.mesh)
        picture.write_bytes((self.folder / "picture.png").read_bytes()[:1500])
        for option, files in ("--hdri", (light, pipe, empty)), ("--reference", (picture, pipe, empty)):
            for file in files:
                with self.subTest(option, file=file.name):
                    self.fails(self.mesh, option, file, "--size", "96x72", "--output", folder / "p.png",
                        says=[f"{option}: ", file.name], codes=[3], timeout=20)

        packed = folder / "packed.nrrd"
        packed.write_bytes((self.folder / "a.nrrd").read_bytes().replace(b"encoding: raw", b"encoding: bzip2"))
        self.fails(packed, "--output", folder / "p.png", says=["encoding bzip2, which VTK cannot read", "gzip"])

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

    def test_lengths_beyond_the_end(self):
        whole = (self.folder / "a.3ds").read_bytes()
        path = self.folder / "long.3ds"
        for contents in (whole[:-1], whole[:2] + bytes((0, 0, 0, 64)) + whole[6:]):
            path.write_bytes(contents)
            self.fails(path, "--output", self.folder / "p.png", says=[path.name, "is shorter than it says"])

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

    def test_broken_numbers_take_no_range(self):
        arguments = [
            "--no-rays", "--camera-position", "30,-50,25", "--focal-point", "6,6,6", "--sun", "300,20"]
        values = numpy.random.default_rng(5).normal(20, 3, (12, 12, 12))
        highest = numpy.unravel_index(values.argmax(), values.shape)
        whole = self.draw(self.write_volume("whole.vti", values), *arguments)
        for number in (1e299, 9.96921e36, 1e9):  # another array's, netCDF's for what is missing, and another unit's
            broken = values.copy()
            broken[highest] = number
            path = self.write_volume("broken.vti", broken)
            drawn = self.draw(path, *arguments, told=["values", "far beyond", "--range"])
            self.assertLess(abs(drawn - whole).mean(), 2)
        long = numpy.geomspace(1e-9, 1e3, values.size).reshape(values.shape)  # no gap: all have a part
        self.draw(self.write_volume("long.vti", long), *arguments)
        self.draw(path, "--range", "10,30", *arguments)

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


if __name__ == "__main__":
    unittest.main()
