# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The sources of scenes of the Python module godrays, with VTK's filters behind them."""

import subprocess
import sys
import unittest

import godrays
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkAssignAttribute, vtkPolyDataNormals
from vtkmodules.vtkFiltersGeneral import vtkWarpScalar
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkImagingCore import vtkImageDataStreamer


class Memory(unittest.TestCase):
    """What is beyond the memory of the process is refused with the number, before it is asked for."""

    CODE = """
import resource, sys
import godrays
from vtkmodules.vtkCommonDataModel import vtkImageData
large = 768 << 20
resource.setrlimit(resource.RLIMIT_DATA, (large, large))
name, settings, number = eval(sys.argv[1])
source = getattr(godrays, name)()
for setter, values in settings.items():
    getattr(source, setter)(*values)
if source.GetNumberOfInputPorts():
    image = vtkImageData()
    image.SetDimensions(4, 4, 4)
    image.AllocateScalars(10, 1)
    image.GetPointData().GetScalars().Fill(1)
    source.SetInputData(image)
try:
    with godrays.raising():
        source.Update()
    print("no error")
except godrays.Error as error:
    print(error, source.GetOutputDataObject(0).GetNumberOfPoints())
"""

    def test_sizes_beyond_it(self):
        for case in (
            ("vtkGodRaysTerrainSource", {"SetDimensions": (40000, 40000)}, "Dimensions"),
            ("vtkGodRaysTerrainSource", {"SetDimensions": (1000000, 1000000)}, "Dimensions"),
            ("vtkGodRaysSmokeSource", {"SetDimensions": (300, 300, 300)}, "Dimensions"),
            ("vtkGodRaysCloudLayerSource", {"SetResolution": (4096,)}, "Resolution"),
            ("vtkGodRaysCloudLayerSource", {"SetTextureResolution": (16384,)}, "TextureResolution"),
            ("vtkGodRaysSkySource", {"SetResolution": (16384,)}, "Resolution"),
            ("vtkGodRaysGridFilter", {"SetSize": (32768, 32768)}, "Size"),
        ):
            with self.subTest(case):
                ran = subprocess.run([sys.executable, "-c", self.CODE, repr(case)], capture_output=True, text=True)
                self.assertEqual(ran.returncode, 0, ran.stderr)
                self.assertRegex(ran.stdout,
                    rf"[.0-9e+]+ GiB of memory would be needed, where there are 0.75. Set a smaller {case[2]}. 0$")


class Terrain(unittest.TestCase):
    def test_a_surface_has_the_terrain_s_normals(self):
        terrain = godrays.vtkGodRaysTerrainSource()
        terrain.SetDimensions(401, 301)
        terrain.SetOctaves(3)
        surface = vtkWarpScalar()
        surface.SetInputConnection(terrain.GetOutputPort())
        surface.UseNormalOn()
        surface.SetNormal(0, 0, 1)
        normals = vtkAssignAttribute()
        normals.SetInputConnection(surface.GetOutputPort())
        normals.Assign("Normals", "NORMALS", "POINT_DATA")
        polygons = vtkDataSetSurfaceFilter()
        polygons.SetInputConnection(normals.GetOutputPort())
        polygons.Update()
        data = polygons.GetOutput()
        self.assertEqual(data.GetNumberOfCells(), 400 * 300)
        exact = vtk_to_numpy(data.GetPointData().GetNormals())
        points = vtk_to_numpy(data.GetPoints().GetData())
        heights = vtk_to_numpy(data.GetPointData().GetArray("Height"))
        self.assertLess(abs(points[:, 2] - heights).max(), 1e-6)
        # Those of the polygons' planes, on average, are nearly the same.
        averaged = vtkPolyDataNormals()
        averaged.SetInputData(data)
        averaged.SplittingOff()
        averaged.Update()
        planes = vtk_to_numpy(averaged.GetOutput().GetPointData().GetNormals())
        agreement = (exact * planes).sum(1)
        self.assertGreater(abs(agreement).min(), 0.99)
        self.assertGreater(abs(agreement).mean(), 0.9995)

    def test_streamed_it_is_the_same(self):
        terrain = godrays.vtkGodRaysTerrainSource()
        terrain.SetDimensions(100, 90)
        terrain.Update()
        whole = vtk_to_numpy(terrain.GetOutput().GetPointData().GetScalars()).copy()
        streamer = vtkImageDataStreamer()
        streamer.SetInputConnection(terrain.GetOutputPort())
        streamer.SetNumberOfStreamDivisions(7)
        terrain.Modified()
        streamer.Update()
        self.assertLess(terrain.GetOutput().GetNumberOfPoints(), 100 * 90 / 4)
        pieces = vtk_to_numpy(streamer.GetOutput().GetPointData().GetScalars())
        self.assertTrue((whole == pieces).all())


class Time(unittest.TestCase):
    def test_each_moves(self):
        for name in ("Smoke", "Fire", "CloudLayer"):
            with self.subTest(name):
                source = getattr(godrays, f"vtkGodRays{name}Source")()
                frames = []
                for time in (0.5, 1.0, 0.5):
                    source.UpdateTimeStep(time)
                    array = source.GetOutput().GetPointData().GetScalars()
                    frames.append(vtk_to_numpy(array).tobytes())
                self.assertNotEqual(frames[0], frames[1])
                self.assertEqual(frames[0], frames[2])


if __name__ == "__main__":
    unittest.main()
