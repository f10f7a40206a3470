# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Examples/Science/clouds.py: files become extinction by the formula or are refused, and clouds make shafts."""

import contextlib
import io
import pathlib
import runpy
import struct
import subprocess
import sys
import tempfile
import unittest

import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "Examples" / "Science" / "clouds.py"
sys.path[:0] = [str(ROOT / "Testing" / "Python"), str(SCRIPT.parent)]

import cloud_field
import TestCookbook as cookbook


def netcdf(path, dimensions, variables):
    """Write NetCDF's classic format: {name: length}, {name: (dimensions, units, values)}."""

    def text(words):
        return struct.pack(">i", len(words)) + words.encode() + b"\0" * (-len(words) % 4)

    def header(begins):
        result = b"CDF\1" + struct.pack(">iii", 0, 10, len(dimensions))
        for name, length in dimensions.items():
            result += text(name) + struct.pack(">i", length)
        result += struct.pack(">iiii", 0, 0, 11, len(variables))
        for (name, (of, units, values)), begin in zip(variables.items(), begins):
            result += text(name) + struct.pack(f">{1 + len(of)}i", len(of), *map(list(dimensions).index, of))
            result += struct.pack(">ii", 12, 1) + text("units") + struct.pack(">i", 2) + text(units)
            result += struct.pack(">iii", 6, 8 * numpy.size(values), begin)  # doubles
        return result

    data = [numpy.asarray(values, ">f8").tobytes() for _, _, values in variables.values()]
    start = len(header([0] * len(data)))
    ends = start + numpy.cumsum([len(each) for each in data])
    path.write_bytes(header([start, *ends[:-1]]) + b"".join(data))


def shdom(path, x, y, z, water, radius):
    """Write what pyshdom reads: km, g/m^3 and um."""
    lines = ["# made by a test", "{} {} {}".format(*water.shape[::-1]), f"{x[1] - x[0]} {y[1] - y[0]}",
        " ".join(map(str, z)), "x,y,z,lwc,reff"]
    for (k, j, i), each in numpy.ndenumerate(water):
        if each > 0:
            lines.append(f"{i},{j},{k},{float(each)!r},{float(radius[k, j, i])!r}")
    path.write_text("\n".join(lines), encoding="utf-8")


class CloudField(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        random = numpy.random.default_rng(3)
        self.x, self.y = 0.1 * numpy.arange(5), 0.2 * numpy.arange(4)  # [km]
        self.z = numpy.array([0.5, 0.6, 0.8, 1.3])
        self.water = numpy.maximum(random.uniform(-0.5, 1.0, (4, 4, 5)), 0)  # [g/m^3]
        self.radius = random.uniform(5, 15, (4, 4, 5))  # [um]
        self.beta = 1.5 * self.water / self.radius  # [1/m]: 1e-3 kg/g over 1000 kg/m^3 and 1e-6 m/um
        self.sizes = {"z": 4, "y": 4, "x": 5}
        self.axes = {"z": (["z"], "km", self.z), "y": (["y"], "km", self.y), "x": (["x"], "km", self.x)}

    def write(self, name="lwc", units="g m-3", values=None, radius=True, **others):
        path = self.folder / "field.nc"
        variables = {name: (["z", "y", "x"], units, self.water if values is None else values), **others}
        if radius:
            variables["reff"] = (["z", "y", "x"], "um", self.radius)
        netcdf(path, self.sizes, {**self.axes, **variables})
        return path

    def check(self, field, expected):
        numpy.testing.assert_allclose(field.extinction, expected, rtol=1e-6, atol=0)
        for axis, km in zip(field.axes, (self.x, self.y, self.z)):
            numpy.testing.assert_allclose(axis, 1000 * km, rtol=1e-6)

    def test_files_give_the_formula(self):
        of_netcdf = cloud_field.read(self.write())
        self.check(of_netcdf, self.beta)
        path = self.folder / "field.txt"
        shdom(path, self.x, self.y, self.z, self.water, self.radius)
        of_text = cloud_field.read(path)
        self.check(of_text, self.beta)
        grid = of_netcdf.to_grid()
        self.assertIsInstance(grid, vtk.vtkRectilinearGrid)
        scalars = vtk_to_numpy(grid.GetPointData().GetScalars())
        numpy.testing.assert_allclose(scalars, self.beta.ravel(), rtol=1e-6)
        # 0.5 to 1.3 km, by hand
        depths = (50 * self.beta[0] + 150 * self.beta[1] + 350 * self.beta[2] + 250 * self.beta[3])
        numpy.testing.assert_allclose(of_text.optical_depths(), depths, rtol=1e-6)
        self.assertIn(f"{depths.mean():.4g} in the mean", of_text.describe())

        lines = path.read_text(encoding="utf-8").splitlines()
        path.write_text("\n".join([*lines[:2], f"{lines[2]} {lines[3]}", *lines[4:]]), encoding="utf-8")
        self.check(cloud_field.read(path), self.beta)  # as pyshdom's own files have them
        # SHDOM's own has temperatures
        points = [line.split(",") for line in lines[5:]]
        points = [" ".join([*(str(int(each) + 1) for each in point[:3]), *point[3:]]) for point in points]
        path.write_text("\n".join(["2", *lines[1:4], "290 289 288 285", *points]), encoding="utf-8")
        self.check(cloud_field.read(path), self.beta)

    def test_units(self):
        self.check(cloud_field.read(self.write(units="kg/m3", values=self.water / 1000)), self.beta)
        self.check(cloud_field.read(self.write(radius=False), radius=8e-6), 1.5 * self.water / 8)
        profile = numpy.array([1.1, 1.05, 1.0, 0.9])
        ratio = self.water / profile[:, None, None]  # [g/kg]
        path = self.write("QC", "g/kg", ratio, RHO=(["z"], "kg m^-3", profile))
        self.check(cloud_field.read(path), self.beta)
        air = numpy.broadcast_to(profile[:, None, None], ratio.shape)
        path = self.write("QC", "1", ratio / 1000, rho=(["z", "y", "x"], "kg m**-3", air))
        self.check(cloud_field.read(path), self.beta)

    def test_times(self):
        self.sizes["time"] = 2
        self.axes["time"] = (["time"], "seconds since 2000-01-01", [0.0, 60.0])
        path = self.folder / "field.nc"
        both = numpy.stack([self.water, 2 * self.water[::-1]])
        netcdf(path, self.sizes, {**self.axes, "QN": (["time", "z", "y", "x"], "g/m3", both)})
        self.check(cloud_field.read(path), 1.5 * both[0] / 10)
        self.check(cloud_field.read(path, time=1), 1.5 * both[1] / 10)
        self.refuse("--time is from 0 to 1", path, time=2)

    def test_reanalysis_on_pressures(self):
        self.axes = {"level": (["level"], "hPa", [794.95, 898.76, 1013.25]),  # standard: 2000, 1000 and 0 m
            "latitude": (["latitude"], "degrees_north", [60.5, 60.25, 60.0, 59.5]),
            "longitude": (["longitude"], "degrees_east", [10.0, 10.25, 10.5, 10.75, 11.0])}
        self.sizes = {"level": 3, "latitude": 4, "longitude": 5}
        path = self.folder / "field.nc"
        netcdf(path, self.sizes, {**self.axes, "clwc": (["level", "latitude", "longitude"], "kg kg**-1",
            self.water[:3] / 1000)})
        field = cloud_field.read(path)
        numpy.testing.assert_allclose(field.axes[2], [0, 1000, 2000], atol=1)
        density = numpy.array([1.2250, 1.1117, 1.0066])[:, None, None]  # of the standard's tables
        expected = 1.5 * self.water[2::-1, ::-1] / 10 * density
        numpy.testing.assert_allclose(field.extinction, expected, rtol=2e-4)
        width, depth = (axis[-1] - axis[0] for axis in field.axes[:2])
        self.assertAlmostEqual(depth, 111195, delta=1)
        self.assertAlmostEqual(width, 111195 * numpy.cos(numpy.deg2rad(60.0625)), delta=1)
        self.assertEqual(len(field.supposed), 5)
        grid = field.to_grid()
        scalars = vtk_to_numpy(grid.GetPointData().GetScalars())
        numpy.testing.assert_allclose(scalars, field.extinction.ravel(), rtol=1e-6)
        numpy.testing.assert_allclose(grid.GetBounds()[4:], (0, 2000), atol=1)

    def refuse(self, cause, path, **options):
        with self.assertRaisesRegex(cloud_field.FieldError, cause):
            cloud_field.read(path, **options)

    def test_bad_files_are_refused(self):
        self.refuse("cannot be read", self.folder / "none.nc")
        self.refuse("no variable of a customary name .* lwp, reff by --variable", self.write("lwp"))
        self.refuse("no variable ql", self.write(), variable="ql")
        self.refuse("'K', which is no content of water", self.write(units="K"))
        self.refuse("--time is from 0 to 0", self.write(), time=3)
        self.refuse("no liquid water", self.write(values=0 * self.water))
        self.refuse("missing everywhere", self.write(values=numpy.nan * self.water))
        self.radius[self.water > 0] = 0
        self.refuse("no effective radius above 0", self.write())
        path = self.write()
        whole = path.read_bytes()
        path.write_bytes(whole[:90])
        self.refuse("no variables that VTK can read", path)
        text = self.folder / "field.txt"
        for words, cause in (
            ("a picture", "neither NetCDF nor a cloud"),
            ("2 2 1\n1 1\n1 2\n0 0 0 1 1", "must be 2 or more"),
            ("2 2 9e99\n1 1\n1 2\n0 0 0 1 1", "in all at most"),
            ("2 2 2\n1 1\n2 1\n0 0 0 1 1", "must be 2 and rise"),
            ("2 2 2\n1 1\n1 2\n0 0 0 1", "fewer than five"),
            ("2 2 2\n1 1\n1 2\n0 0 7 1 1", "points outside"),
            ("2 2 2\n1 1\n1 2\n0 0 nan 1 1", "points outside"),
        ):
            text.write_text(words, encoding="utf-8")
            self.refuse(cause, text)
        text.write_bytes(b"\x89PNG\xff")
        self.refuse("neither NetCDF nor text", text)
        command = [sys.executable, str(SCRIPT), str(self.folder / "a.png"), "--field", str(text)]
        ended = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertEqual(ended.returncode, 1)
        self.assertEqual(ended.stderr.count("\n"), 1)
        self.assertIn("neither NetCDF nor text", ended.stderr)
        self.assertFalse((self.folder / "a.png").exists())

    def draw(self, *arguments):
        former = sys.argv
        sys.argv = [str(SCRIPT), str(self.folder / "a.png"), "160x90", *arguments]
        try:
            with contextlib.redirect_stdout(io.StringIO()) as said:
                return runpy.run_path(str(SCRIPT)), said.getvalue()
        finally:
            sys.argv = former

    def test_unlike_levels_are_drawn(self):
        scene, said = self.draw("--field", str(self.write()))
        scene["window"].Finalize()
        self.assertIn("cloud cover: 1.000 of", said)
        self.assertRegex(scene["rays"].GetPlan(), r"a grid resampled to 5 x 4 x 9 points, off by \d")

    def test_clouds_make_shafts(self):
        import godrays

        scene, said = self.draw("--spacing", "140")
        self.assertIn("cloud cover: ", said)
        window, renderer, model = scene["window"], scene["renderer"], scene["rays"].model

        def look():
            """The picture; transmittance and radiance to each pixel, from the top as in it."""
            picture, found = cookbook.read(window).astype(float), godrays.measure(renderer)
            return picture, found["Transmittance"].min(2)[::-1], found["Radiance"].mean(2)[::-1]

        picture, through, _ = look()
        scene["clouds"].VisibilityOff()
        without, air, _ = look()
        model.scattering_orders = 0  # once: clouds scatter light into the air about them, too
        open_air = look()[2]
        scene["clouds"].VisibilityOn()
        radiance = look()[2]
        scene["clouds"].VisibilityOff()
        cloudy = numpy.pad(through < 0.999 * air, 2)
        steps = [slice(each, each - 4 or None) for each in range(5)]
        clear = ~numpy.any([cloudy[row, column] for row in steps for column in steps], axis=0)
        # No cloud is before what is seen, nor in two pixels about it: what differs there is shadow.
        shadow, lost = (without - picture).mean(2)[clear], (open_air - radiance)[clear]
        print(f"{clear.mean():.2f} of the picture is beside clouds; shafts take {shadow.mean():.1f} of 255 levels "
            f"of it, {numpy.quantile(shadow, 0.95):.1f} where they are deepest", flush=True)
        self.assertGreater(clear.mean(), 0.3)
        self.assertGreater(shadow.mean(), 5)
        self.assertGreater(numpy.quantile(shadow, 0.95), 20)
        self.assertGreaterEqual(lost.min(), 0)
        cloud = through < 0.1 * air
        self.assertGreater(cloud.mean(), 0.05)
        self.assertGreater(picture.mean(2)[cloud].max(), 200)  # lit white
        scene["clouds"].VisibilityOn()
        model.data_scale = 1e-6  # too thin for shadows in the air; those on the ground are of the volume's opacity
        scene["rays"].surface_shadows = False
        thin, _, _ = look()
        scene["clouds"].VisibilityOff()
        without, _, _ = look()
        window.Finalize()
        self.assertLess(numpy.abs(thin - without).mean(), 0.5)


if __name__ == "__main__":
    unittest.main()
