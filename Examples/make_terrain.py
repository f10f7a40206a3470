# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Write the elevation models that come with matplotlib as VTK files in true metres.

    make_terrain.py FOLDER_OF_SAMPLE_DATA FOLDER_TO_WRITE_TO

writes jacksboro.vti (a ridge in the Appalachians, 90 m between samples, from the Shuttle Radar
Topography Mission) and topobathy.vts (the sea and the coast about Vancouver Island).
"""

import math
import pathlib
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkStructuredGrid
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLStructuredGridWriter


def degree_lengths(latitude):
    """The lengths of a degree to the east and to the north on the WGS 84 ellipsoid, in metres."""
    radius, eccentricity2 = 6378137.0, 0.00669437999014
    root = math.sqrt(1 - eccentricity2 * math.sin(math.radians(latitude)) ** 2)
    east = radius / root * math.cos(math.radians(latitude))
    north = radius * (1 - eccentricity2) / root**3
    return math.radians(east), math.radians(north)


def elevation_array(elevations):
    """Elevations in metres, rows from south to north, as an array of points."""
    array = numpy_to_vtk(numpy.ascontiguousarray(elevations, dtype=numpy.float32).ravel(), deep=1)
    array.SetName("Elevation")
    return array


def write(writer, data, path):
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    if not writer.Write():
        sys.exit(f"{path} could not be written")
    print(f"wrote {path}")


def write_jacksboro(source, path):
    """Rows run from north to south; in the file, ymin is the northern edge and ymax the southern."""
    with numpy.load(source) as file:
        elevations = file["elevation"][::-1]
        latitude = 0.5 * float(file["ymin"] + file["ymax"])
        east, north = degree_lengths(latitude)
        spacing = float(file["dx"]) * east, float(file["dy"]) * north
    image = vtkImageData()
    image.SetDimensions(elevations.shape[1], elevations.shape[0], 1)
    image.SetSpacing(*spacing, 1)
    image.GetPointData().SetScalars(elevation_array(elevations))
    write(vtkXMLImageDataWriter(), image, path)


def write_topobathy(source, path):
    """Rows run from south to north, evenly on a Mercator map: each has a latitude of its own."""
    with numpy.load(source) as file:
        elevations, longitude, latitude = file["topo"], file["longitude"], file["latitude"]
    east, north = degree_lengths(float(latitude.mean()))
    x, y = numpy.meshgrid((longitude - longitude[0]) * east, (latitude - latitude[0]) * north)
    points = vtkPoints()
    points.SetData(
        numpy_to_vtk(numpy.stack([x, y, elevations], -1).reshape(-1, 3), deep=1)
    )
    grid = vtkStructuredGrid()
    grid.SetDimensions(elevations.shape[1], elevations.shape[0], 1)
    grid.SetPoints(points)
    grid.GetPointData().SetScalars(elevation_array(elevations))
    write(vtkXMLStructuredGridWriter(), grid, path)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: make_terrain.py FOLDER_OF_SAMPLE_DATA FOLDER_TO_WRITE_TO")
    source, target = map(pathlib.Path, sys.argv[1:])
    target.mkdir(parents=True, exist_ok=True)
    write_jacksboro(source / "jacksboro_fault_dem.npz", target / "jacksboro.vti")
    write_topobathy(source / "topobathy.npz", target / "topobathy.vts")
